//! Lengths, ranges and order: what can be said without reading a number.
//!
//! After these checks every index of the certificate points at something, so
//! the later ones may follow it. D is the dimension, r the rank of the lattice.

use super::{Limits, Refusal};
use crate::certificate::{Certificate, Mate, Place, Statement};

/// A check of the certificate as it stands.
pub(super) type Check = fn(&Certificate, &Limits) -> Result<(), Refusal>;

/// All of them; the later ones rely on the earlier ones.
pub(super) const CHECKS: &[(&str, Check)] = &[
    ("dimension", check_dimension),
    ("statements", check_statements),
    ("gram_shape", check_gram_shape),
    ("gram_symmetric", check_gram_symmetric),
    ("simplex_count", check_simplex_count),
    ("vertices", check_vertices),
    ("corners", check_corners),
    ("vertices_used", check_vertices_used),
    ("mates", check_mates),
];

/// D is 2 or 3.
fn check_dimension(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    match certificate.claim.dimension {
        2 | 3 => Ok(()),
        found => Err(Refusal::Dimension { found }),
    }
}

/// The first statement is the tiling, of which all others speak; their kinds
/// strictly increase, so none is repeated.
fn check_statements(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    let statements = &certificate.claim.statements;
    if statements.first() != Some(&Statement::FaceToFaceTiling) {
        return Err(Refusal::Statements { index: 0 });
    }
    match statements
        .windows(2)
        .position(|pair| rank(&pair[0]) >= rank(&pair[1]))
    {
        Some(index) => Err(Refusal::Statements { index: index + 1 }),
        None => Ok(()),
    }
}

fn rank(statement: &Statement) -> u8 {
    match statement {
        Statement::FaceToFaceTiling => 0,
        Statement::Acute => 1,
        Statement::Nonobtuse => 2,
        Statement::DihedralBelow(_) => 3,
        Statement::Delaunay => 4,
        Statement::WeaklyDelaunay => 5,
    }
}

/// The Gram matrix is D rows of D.
fn check_gram_shape(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    let claim = &certificate.claim;
    let square = claim.gram.len() == claim.dimension
        && claim.gram.iter().all(|row| row.len() == claim.dimension);
    if square {
        Ok(())
    } else {
        Err(Refusal::GramShape {})
    }
}

/// G_ij = G_ji. Numbers have one notation each, so texts may be compared.
fn check_gram_symmetric(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    let gram = &certificate.claim.gram;
    for (row, entries) in gram.iter().enumerate() {
        for column in 0..row {
            if entries[column] != gram[column][row] {
                return Err(Refusal::GramAsymmetric { row, column });
            }
        }
    }
    Ok(())
}

/// 1 <= number of simplices <= limit. No claim follows from nothing.
fn check_simplex_count(certificate: &Certificate, limits: &Limits) -> Result<(), Refusal> {
    let (found, limit) = (certificate.witness.simplices.len(), limits.simplices);
    match found {
        0 => Err(Refusal::NoSimplices {}),
        _ if found > limit => Err(Refusal::TooManySimplices { found, limit }),
        _ => Ok(()),
    }
}

/// Each vertex has D coordinates.
fn check_vertices(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    let expected = certificate.claim.dimension;
    for (vertex, coordinates) in certificate.witness.vertices.iter().enumerate() {
        let found = coordinates.len();
        if found != expected {
            return Err(Refusal::VertexLength {
                vertex,
                found,
                expected,
            });
        }
    }
    Ok(())
}

/// Each simplex has D + 1 corners, each `[v, s_1, …, s_r]` with 0 <= v < the
/// number of vertices and |s_k| < 2^31.
fn check_corners(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    let expected = certificate.claim.dimension + 1;
    for (simplex, corners) in certificate.witness.simplices.iter().enumerate() {
        let found = corners.len();
        if found != expected {
            return Err(Refusal::SimplexLength {
                simplex,
                found,
                expected,
            });
        }
        for (corner, place) in corners.iter().enumerate() {
            check_place(certificate, simplex, corner, place)?;
        }
    }
    Ok(())
}

fn check_place(
    certificate: &Certificate,
    simplex: usize,
    corner: usize,
    place: &Place,
) -> Result<(), Refusal> {
    let (found, expected) = (place.0.len(), 1 + rank_of_lattice(certificate));
    if found != expected {
        return Err(Refusal::CornerLength {
            simplex,
            corner,
            found,
            expected,
        });
    }
    let (found, vertices) = (place.0[0], certificate.witness.vertices.len());
    if !is_index(found, vertices) {
        return Err(Refusal::VertexRange {
            simplex,
            corner,
            found,
            vertices,
        });
    }
    match first_far(&place.0[1..]) {
        Some(found) => Err(Refusal::ShiftRange {
            simplex,
            corner,
            found,
        }),
        None => Ok(()),
    }
}

/// Each vertex is a corner of some simplex: it belongs to the tiling.
fn check_vertices_used(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    let mut used = vec![false; certificate.witness.vertices.len()];
    for place in certificate.witness.simplices.iter().flatten() {
        used[place.0[0] as usize] = true;
    }
    match used.iter().position(|used| !used) {
        Some(vertex) => Err(Refusal::UnusedVertex { vertex }),
        None => Ok(()),
    }
}

/// Each simplex has a row of D + 1 mates, each `[t, j, u_1, …, u_r]` with t a
/// simplex, 0 <= j <= D and |u_k| < 2^31.
fn check_mates(certificate: &Certificate, _: &Limits) -> Result<(), Refusal> {
    let witness = &certificate.witness;
    let (found, expected) = (witness.mates.len(), witness.simplices.len());
    if found != expected {
        return Err(Refusal::MatesLength { found, expected });
    }
    let expected = certificate.claim.dimension + 1;
    for (simplex, row) in witness.mates.iter().enumerate() {
        let found = row.len();
        if found != expected {
            return Err(Refusal::MateRowLength {
                simplex,
                found,
                expected,
            });
        }
        for (facet, mate) in row.iter().enumerate() {
            check_mate(certificate, simplex, facet, mate)?;
        }
    }
    Ok(())
}

fn check_mate(
    certificate: &Certificate,
    simplex: usize,
    facet: usize,
    mate: &Mate,
) -> Result<(), Refusal> {
    let (found, expected) = (mate.0.len(), 2 + rank_of_lattice(certificate));
    if found != expected {
        return Err(Refusal::MateLength {
            simplex,
            facet,
            found,
            expected,
        });
    }
    let exists = is_index(mate.0[0], certificate.witness.simplices.len())
        && is_index(mate.0[1], certificate.claim.dimension + 1);
    if !exists {
        return Err(Refusal::MateRange {
            simplex,
            facet,
            found: mate.0.clone(),
        });
    }
    match first_far(&mate.0[2..]) {
        Some(found) => Err(Refusal::MateShiftRange {
            simplex,
            facet,
            found,
        }),
        None => Ok(()),
    }
}

fn rank_of_lattice(certificate: &Certificate) -> usize {
    certificate.claim.domain.rank(certificate.claim.dimension)
}

fn is_index(value: i64, length: usize) -> bool {
    usize::try_from(value).is_ok_and(|index| index < length)
}

/// The first entry that is not between -2^31 and 2^31. All sums of shifts that
/// the kernel forms have at most three terms, so they fit in 64 bits (and in a
/// double, for readers in other languages).
fn first_far(shift: &[i64]) -> Option<i64> {
    const BOUND: u64 = 1 << 31;
    shift
        .iter()
        .copied()
        .find(|entry| entry.unsigned_abs() >= BOUND)
}
