//! The certificate of a system of patches, and the kernel's verdict.

use super::{Patch, System, Tile};
use crate::format::patches as format;
use crate::predicates::Model;
use crate::proved::{NotProved, hexadecimal};
use crate::quality::{DihedralAngle, Ranges, exact_ranges};
use crate::statement::{Relation, Statement};
use crate::tiling::{Corner, Tiling};
use crate::transcribe::Written;
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;
use acutile_kernel::{Limits, Verified, verify};
use malachite::Integer;

/// A certificate of the kind `patches` that the kernel has confirmed.
#[derive(Debug)]
pub struct Theorem {
    pub(super) certificate: Vec<u8>,
    pub(super) verified: Verified,
    pub(super) statements: Vec<Statement>,
}

impl Theorem {
    /// The certificate in CBOR.
    pub fn certificate(&self) -> &[u8] {
        &self.certificate
    }

    /// The kernel's verdict.
    pub fn verified(&self) -> &Verified {
        &self.verified
    }

    /// The kernel's verdict alone.
    pub fn into_verified(self) -> Verified {
        self.verified
    }

    /// The SHA-256 of the certificate, in hexadecimal digits.
    pub fn sha256(&self) -> String {
        hexadecimal(&self.verified.sha256)
    }

    /// The statements of the claim.
    pub fn statements(&self) -> &[Statement] {
        &self.statements
    }
}

/// Proves a system: the largest angle is computed from the pieces, and the kernel decides.
///
/// # Errors
/// [`NotProved::Unconfirmed`] if the kernel refuses the certificate.
pub fn prove(system: &System, limits: &Limits) -> Result<Theorem, NotProved> {
    confirm(system, statements(system), limits)
}

/// Proves that all cells over all mosaics have their angles and ratios in these ranges.
///
/// # Errors
/// As [`prove`]; a cell may be out of a range.
pub fn prove_bounds(
    system: &System,
    ranges: &Ranges,
    limits: &Limits,
) -> Result<Theorem, NotProved> {
    let Ranges {
        radius_edge,
        smallest_dihedral,
        largest_dihedral,
    } = ranges;
    let statements = vec![
        Statement::FaceToFaceTiling,
        Statement::LargestAngle(Relation::AtMost, largest_dihedral.max.clone()),
        Statement::LargestAngle(Relation::AtLeast, largest_dihedral.min.clone()),
        Statement::SmallestAngle(Relation::AtMost, smallest_dihedral.max.clone()),
        Statement::SmallestAngle(Relation::AtLeast, smallest_dihedral.min.clone()),
        Statement::RadiusEdge(Relation::AtMost, radius_edge.max.clone()),
        Statement::RadiusEdge(Relation::AtLeast, radius_edge.min.clone()),
    ];
    confirm(system, statements, limits)
}

fn confirm(
    system: &System,
    statements: Vec<Statement>,
    limits: &Limits,
) -> Result<Theorem, NotProved> {
    let certificate = format::to_bytes(&certificate(system, &statements));
    let verified = verify(&mut certificate.as_slice(), limits)
        .map_err(|refusal| NotProved::Unconfirmed(refusal.into()))?;
    Ok(Theorem {
        certificate,
        verified,
        statements,
    })
}

/// The statements to be proved. The largest angle is that of the pieces.
fn statements(system: &System) -> Vec<Statement> {
    let mut statements = vec![Statement::FaceToFaceTiling];
    if let Some(largest) = largest_angle(system) {
        match largest.signed_square.sign() {
            Sign::Greater => statements.push(Statement::Acute),
            Sign::Equal => statements.push(Statement::Nonobtuse),
            Sign::Less => {}
        }
        statements.push(Statement::LargestAngle(Relation::Maximum, largest));
    }
    statements.extend([Statement::Delaunay, Statement::Tcp]);
    statements
}

fn largest_angle(system: &System) -> Option<DihedralAngle> {
    let angles = system.tiles.iter().filter_map(|tile| {
        let piece = system.piece(tile);
        Some(exact_ranges(&Model::new(&piece))?.largest_dihedral.max)
    });
    angles.max()
}

/// The certificate of a system as data.
pub fn certificate(system: &System, statements: &[Statement]) -> format::Certificate {
    let written = Written::of(&all_numbers(system));
    let tiles = system.tiles.iter();
    let statements = statements.iter();
    format::Certificate {
        claim: format::Claim {
            field: written.numerals.field(),
            gram: written.gram(),
            rank: system.rank,
            tiles: tiles
                .clone()
                .map(|tile| written_tile(tile, &written))
                .collect(),
            statements: statements.map(|s| written.numerals.statement(s)).collect(),
        },
        witness: tiles
            .map(|tile| written_patch(&tile.patch, &written))
            .collect(),
    }
}

/// A tiling with all numbers of the system, for which the smallest field is looked for.
fn all_numbers(system: &System) -> Tiling<3> {
    let padded =
        |x: &Vec<Number>| std::array::from_fn(|k| x.get(k).cloned().unwrap_or_else(Number::zero));
    let Some(first) = system.tiles.first() else {
        return Tiling {
            frame: crate::tiling::Frame::space(system.field.clone(), system.gram.clone()),
            vertices: Vec::new().into(),
            corners: Vec::new(),
        };
    };
    let points = system.tiles.iter().flat_map(|tile| {
        let rows = tile.corners.iter().chain(&tile.patch.offsets).map(padded);
        rows.chain(tile.patch.vertices.iter().cloned())
    });
    Tiling {
        vertices: points.collect::<Vec<[Number; 3]>>().into(),
        ..system.piece(first)
    }
}

fn written_tile(tile: &Tile, written: &Written<3>) -> format::Tile {
    let denominator = written.numerals.denominator(tile.corners.iter().flatten());
    format::Tile {
        vertices: numerators(&tile.corners, &denominator, written),
        classes: tile.classes.clone(),
        denominator,
    }
}

fn written_patch(patch: &Patch, written: &Written<3>) -> format::Patch {
    let denominator = written
        .numerals
        .denominator(patch.vertices.iter().flatten());
    let corners = |corners: &[Corner<3>]| corners.iter().copied().map(corner).collect();
    format::Patch {
        offsets: numerators(&patch.offsets, &denominator, written),
        vertices: numerators(&patch.vertices, &denominator, written),
        pyramids: patch
            .pyramids
            .iter()
            .map(|pyramid| format::Pyramid {
                apex: corner(pyramid.apex),
                polygon: corners(&pyramid.polygon),
            })
            .collect(),
        simplices: patch.simplices.iter().map(|row| row.map(corner)).collect(),
        denominator,
    }
}

fn numerators<'n, R: AsRef<[Number]> + 'n>(
    rows: impl IntoIterator<Item = &'n R>,
    denominator: &Integer,
    written: &Written<3>,
) -> Vec<Vec<crate::format::Number>> {
    let numerator = |x: &Number| written.numerals.numerator(x, denominator);
    let rows = rows.into_iter();
    rows.map(|row| row.as_ref().iter().map(numerator).collect())
        .collect()
}

fn corner(corner: Corner<3>) -> crate::format::Corner {
    crate::format::Corner {
        vertex: corner.vertex.number(),
        shift: corner.shift,
    }
}
