//! Certificates of the kind `patches`: one theorem about all tilings that a system of patches builds, periodic or not.
//!
//! [`crate::patch`] checks each piece with its pyramids, [`crate::walls`] compares the sides,
//! [`crate::joins`] finds all pairs of sides that can meet and checks the statements for the cells.
//! docs/soundness.md, section 10, has the proof.

use crate::cbor::Cbor;
use crate::claim::{Property, integers};
use crate::corners;
use crate::limits::{Limits, Work};
use crate::patch::{Head, Patch};
use crate::refusal::{Checked, Place};
use crate::ring::Exact;
use crate::root::Root;
use crate::rules::Rules;
use crate::tiling::{Facts, check_statements};
use crate::valences;
use crate::walls::{Parts, System, sides};
use num_bigint::BigInt;
use num_integer::Integer;
use std::rc::Rc;

/// Reads and checks the rest of a certificate whose claim has been read.
pub(crate) fn verify<const N: usize>(mut cbor: Cbor, head: Head, limits: &Limits, work: &Rc<Work>) -> Checked<Facts> {
    let ring = Exact::<BigInt, N>::new(&Rc::new(Root::new(&head.claim.field, work)?), work)?;
    let rules = Rules::new(&ring, &head.claim).map_err(|stop| stop.at(Place::Field))?;
    check_statements(&head.claim, false)?;
    // It would be about each mosaic, and the cells differ.
    let inside = head.claim.statements.iter().position(|statement| statement.property == Property::NotDelaunay);
    ensure!(inside.is_none(), StatementDomain, Place::Statement(inside.unwrap_or(0)));
    // b_i · b_j = 0 for i <= r < j: two entries of the upper triangle by rows.
    let mixed = if head.rank == 1 { [1, 2] } else { [2, 4] };
    let is_zero = |k: usize| {
        head.claim.gram.get(k).is_some_and(|x| integers(std::slice::from_ref(x)).all(|c| *c == BigInt::ZERO))
    };
    ensure!(mixed.into_iter().all(is_zero), GramBlocks, Place::Field);
    let count = cbor.array()?;
    let is_complete = usize::try_from(count).is_ok_and(|count| count == head.tiles.len());
    ensure!(is_complete, TileCount, Place::Witness, count);
    let (mut simplices, mut cells) = (0, 0);
    let read = |tile| Patch::read::<N>(&mut cbor, &head, tile, limits, work, &mut simplices, &mut cells);
    let patches = head.tiles.iter().map(read);
    let patches = patches.collect::<Checked<Vec<_>>>()?;
    let (bytes, sha256) = cbor.finish()?;
    let scale = patches.iter().fold(BigInt::from(1), |scale, patch| scale.lcm(&patch.vertices.denominator));
    let vertices = patches.iter().map(|patch| patch.vertices.count).fold(0, u32::saturating_add);
    let rows = patches.iter().map(|patch| u64::try_from(patch.rows.len()).unwrap_or(u64::MAX)).sum();
    let parts = Parts { ring, rules, rank: head.rank, scale, patches };
    let system = System { sides: sides(&parts)?, parts };
    let angles = if head.rank == 1 { corners::check(&system)? } else { Default::default() };
    let joins = system.check_cells(&head.claim)?;
    if head.claim.has(Property::Tcp) {
        valences::check(&system, &joins, &angles)?;
    }
    let ((boundary_facets, peak_facets, peak_edges), claim) = ((0, 0, 0), head.claim);
    Ok(Facts { claim, vertices, simplices: rows, boundary_facets, peak_facets, peak_edges, bytes, sha256 })
}
