//! Certificates of the kind `patches`: one theorem about all tilings that a system of patches builds, periodic or not.
//!
//! [`crate::patch`] checks each piece with its pyramids, [`crate::walls`] compares the sides,
//! [`crate::joins`] finds all pairs of sides that can meet and checks the statements for the cells.
//! docs/soundness.md, section 10, has the proof.

use crate::cbor::Cbor;
use crate::claim::{Claim, Domain, Property, integers};
use crate::corners;
use crate::patch::Patch;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::Exact;
use crate::root::Root;
use crate::rules::Rules;
use crate::tiling::{Facts, check_statements};
use crate::valences;
use crate::walls::{System, sides};
use num_bigint::BigInt;
use num_integer::Integer;
use std::rc::Rc;

/// Reads and checks the rest of a certificate whose claim has been read.
pub(crate) fn verify<const N: usize>(mut cbor: Cbor, claim: Claim) -> Checked<Facts> {
    let Domain::Mosaics((rank, tiles)) = &claim.domain else { return Err(Stop::LARGER) };
    let root = Root::new(&claim.field, &cbor.work)?;
    let ring = Exact::<BigInt, N>::new(&Rc::new(root), &cbor.work)?;
    let rules = Rules::new(&ring, &claim).map_err(|stop| stop.at(Place::Field))?;
    check_statements(&claim)?;
    // b_i · b_j = 0 for i <= r < j: two entries of the upper triangle by rows.
    let mixed = if *rank == 1 { [1, 2] } else { [2, 4] };
    let is_zero =
        |k: usize| claim.gram.get(k).is_some_and(|x| integers(std::slice::from_ref(x)).all(|c| *c == BigInt::ZERO));
    ensure!(mixed.into_iter().all(is_zero), GramBlocks, Place::Field);
    let count = cbor.array()?;
    let is_complete = usize::try_from(count).is_ok_and(|count| count == tiles.len());
    ensure!(is_complete, TileCount, Place::Witness, count);
    let (mut simplices, mut cells) = (0, 0);
    let read = |tile| Patch::read::<N>(&mut cbor, &claim, tile, &mut simplices, &mut cells);
    let patches = tiles.iter().map(read);
    let patches = patches.collect::<Checked<Vec<_>>>()?;
    let (bytes, sha256) = cbor.finish()?;
    let scale = patches.iter().fold(BigInt::from(1), |scale, patch| scale.lcm(&patch.vertices.denominator));
    let vertices = patches.iter().map(|patch| patch.vertices.count).fold(0, u32::saturating_add);
    let rows = patches.iter().map(|patch| u64::try_from(patch.rows.len()).unwrap_or(u64::MAX)).sum();
    let mut system = System { ring, rules, rank: *rank, scale, patches, sides: Vec::new() };
    system.sides = sides(&system)?;
    let angles = if *rank == 1 { corners::check(&system)? } else { Default::default() };
    let joins = system.check_cells(&claim)?;
    if claim.has(Property::Tcp) {
        valences::check(&system, &joins, &angles)?;
    }
    let (boundary_facets, peak_facets, peak_edges) = (0, 0, 0);
    Ok(Facts { claim, vertices, simplices: rows, boundary_facets, peak_facets, peak_edges, bytes, sha256 })
}
