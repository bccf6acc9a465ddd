//! Lengths, ranges and order: what can be said without reading a number.
//!
//! After these checks every index of the certificate points at something, so
//! the later ones may follow it. D is the dimension, r the rank of the lattice.

use super::cbor::Lists;
use super::document::Document;
use super::{Limits, Refusal};
use crate::certificate::{Domain, Polytope, Statement};
use std::collections::BTreeSet;

/// A check of the certificate as it stands.
pub(super) type Check = fn(&Document, &Limits) -> Result<(), Refusal>;

/// All of them; the later ones rely on the earlier ones.
pub(super) const CHECKS: &[(&str, Check)] = &[
    ("dimension", check_dimension),
    ("statements", check_statements),
    ("tcp_domain", check_tcp_domain),
    ("delaunay_domain", check_delaunay_domain),
    ("gram_shape", check_gram_shape),
    ("gram_symmetric", check_gram_symmetric),
    ("prism_dimension", check_prism_dimension),
    ("region_dimension", check_region_dimension),
    ("domain_vertices", check_domain_vertices),
    ("face_count", check_face_count),
    ("face_lengths", check_face_lengths),
    ("face_vertices", check_face_vertices),
    ("faces_distinct", check_faces_distinct),
    ("domain_vertices_used", check_domain_vertices_used),
    ("simplex_count", check_simplex_count),
    ("vertices", check_vertices),
    ("corners", check_corners),
    ("vertices_used", check_vertices_used),
    ("mates", check_mates),
];

/// D is 2 or 3.
fn check_dimension(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    match certificate.claim.dimension {
        2 | 3 => Ok(()),
        found => Err(Refusal::Dimension { found }),
    }
}

/// The first statement is the tiling, of which all others speak; their kinds
/// strictly increase, so none is repeated.
fn check_statements(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let statements = &certificate.claim.statements;
    if statements.first() != Some(&Statement::FaceToFaceTiling) {
        return Err(Refusal::Statements { index: 0 });
    }
    let increases = |pair: &[Statement]| {
        pair[0] < pair[1] && std::mem::discriminant(&pair[0]) != std::mem::discriminant(&pair[1])
    };
    match statements.windows(2).position(|pair| !increases(pair)) {
        Some(index) => Err(Refusal::Statements { index: index + 1 }),
        None => Ok(()),
    }
}

/// TCP speaks of tetrahedra around edges, none of which is in a boundary.
fn check_tcp_domain(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let claim = &certificate.claim;
    let fits = claim.dimension == 3 && claim.domain == Domain::Space;
    match fits || !claim.statements.contains(&Statement::Tcp) {
        true => Ok(()),
        false => Err(Refusal::TcpDomain {}),
    }
}

/// The local condition of Delaunay implies the global one where the domain is convex.
fn check_delaunay_domain(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let claim = &certificate.claim;
    let is_delaunay = |s: &Statement| matches!(s, Statement::Delaunay | Statement::WeaklyDelaunay);
    match claim.domain == Domain::Region && claim.statements.iter().any(is_delaunay) {
        false => Ok(()),
        true => Err(Refusal::DelaunayDomain {}),
    }
}

/// The Gram matrix is D rows of D.
fn check_gram_shape(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let claim = &certificate.claim;
    let square = claim.gram.len() == claim.dimension
        && claim.gram.iter().all(|row| row.len() == claim.dimension);
    if square {
        Ok(())
    } else {
        Err(Refusal::GramShape {})
    }
}

/// G_ij = G_ji, as the same text: over a reducible polynomial, different
/// coefficients can have the same value, which nobody needs to write.
fn check_gram_symmetric(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
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

/// A prism is a polygon times a line: D = 3.
fn check_prism_dimension(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let claim = &certificate.claim;
    match matches!(claim.domain, Domain::Prism(_)) && claim.dimension != 3 {
        false => Ok(()),
        true => Err(Refusal::PrismDimension {}),
    }
}

/// A region is filled by tetrahedra: D = 3.
fn check_region_dimension(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let claim = &certificate.claim;
    match claim.domain == Domain::Region && claim.dimension != 3 {
        false => Ok(()),
        true => Err(Refusal::RegionDimension {}),
    }
}

/// The polytope of the domain, and k = D - r, its dimension.
fn polytope<'d>(certificate: &'d Document) -> Option<(&'d Polytope, usize)> {
    let polytope = certificate.claim.domain.polytope()?;
    let k = certificate.claim.dimension - rank_of_lattice(certificate);
    Some((polytope, k))
}

/// Each vertex of the domain has k coordinates.
fn check_domain_vertices(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let Some((polytope, expected)) = polytope(certificate) else {
        return Ok(());
    };
    let mut lengths = polytope.vertices.iter().map(Vec::len).enumerate();
    match lengths.find(|(_, found)| *found != expected) {
        Some((vertex, found)) => Err(Refusal::DomainVertexLength {
            vertex,
            found,
            expected,
        }),
        None => Ok(()),
    }
}

/// A polytope of dimension k has at least k + 1 facets.
fn check_face_count(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    match polytope(certificate) {
        Some((polytope, k)) if polytope.faces.len() <= k => Err(Refusal::FaceCount {
            found: polytope.faces.len(),
            least: k + 1,
        }),
        _ => Ok(()),
    }
}

/// A face has one vertex for k = 1, two for k = 2, at least three for k = 3.
fn check_face_lengths(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let Some((polytope, k)) = polytope(certificate) else {
        return Ok(());
    };
    let mut lengths = polytope.faces.iter().map(Vec::len).enumerate();
    match lengths.find(|(_, found)| *found < k || (*found > k && k < 3)) {
        Some((face, found)) => Err(Refusal::FaceLength { face, found }),
        None => Ok(()),
    }
}

/// The vertices of a face exist and are distinct.
fn check_face_vertices(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let Some((polytope, _)) = polytope(certificate) else {
        return Ok(());
    };
    for (face, corners) in polytope.faces.iter().enumerate() {
        let mut seen = BTreeSet::new();
        let is_new = |w: &usize| *w < polytope.vertices.len() && seen.insert(*w);
        if let Some(at) = corners.iter().map(is_new).position(|is_new| !is_new) {
            let found = corners[at];
            return Err(Refusal::FaceVertices { face, found });
        }
    }
    Ok(())
}

/// No two faces have the same vertices.
fn check_faces_distinct(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let faces = polytope(certificate).map_or(&[][..], |(polytope, _)| &polytope.faces);
    let mut seen = BTreeSet::new();
    let is_new = |face: &Vec<usize>| seen.insert(face.iter().copied().collect::<BTreeSet<usize>>());
    match faces.iter().map(is_new).position(|is_new| !is_new) {
        Some(face) => Err(Refusal::FaceRepeated { face }),
        None => Ok(()),
    }
}

/// Each vertex of the domain is in a face.
fn check_domain_vertices_used(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let Some((polytope, _)) = polytope(certificate) else {
        return Ok(());
    };
    let used: BTreeSet<&usize> = polytope.faces.iter().flatten().collect();
    match (0..polytope.vertices.len()).find(|vertex| !used.contains(vertex)) {
        Some(vertex) => Err(Refusal::UnusedDomainVertex { vertex }),
        None => Ok(()),
    }
}

/// 1 <= number of simplices <= limit. No claim follows from nothing.
fn check_simplex_count(certificate: &Document, limits: &Limits) -> Result<(), Refusal> {
    let (found, limit) = (certificate.witness.simplices.len(), limits.simplices);
    match found {
        0 => Err(Refusal::NoSimplices {}),
        _ if found > limit => Err(Refusal::TooManySimplices { found, limit }),
        _ => Ok(()),
    }
}

/// Each vertex has D coordinates.
fn check_vertices(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let expected = certificate.claim.dimension;
    let vertices = &certificate.witness.vertices;
    vertices.each(|vertex, coordinates| match coordinates.len() {
        found if found == expected => Ok(()),
        found => Err(Refusal::VertexLength {
            vertex,
            found,
            expected,
        }),
    })
}

/// Each simplex has D + 1 corners, each `[v, s_1, …, s_r]` with 0 <= v < the
/// number of vertices and |s_k| < 2^31.
fn check_corners(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let simplices = &certificate.witness.simplices;
    simplices.each(|simplex, corners| check_row_of_corners(certificate, simplex, corners))
}

/// The corners of one simplex.
pub(super) fn check_row_of_corners(
    certificate: &Document,
    simplex: usize,
    corners: &Lists,
) -> Result<(), Refusal> {
    let (found, expected) = (corners.len(), certificate.claim.dimension + 1);
    if found != expected {
        return Err(Refusal::SimplexLength {
            simplex,
            found,
            expected,
        });
    }
    let mut places = corners.iter().enumerate();
    places.try_for_each(|(corner, place)| check_place(certificate, simplex, corner, place))
}

fn check_place(
    certificate: &Document,
    simplex: usize,
    corner: usize,
    place: &[i64],
) -> Result<(), Refusal> {
    let (found, expected) = (place.len(), 1 + rank_of_lattice(certificate));
    if found != expected {
        return Err(Refusal::CornerLength {
            simplex,
            corner,
            found,
            expected,
        });
    }
    let (found, vertices) = (place[0], certificate.witness.vertices.len());
    if !is_index(found, vertices) {
        return Err(Refusal::VertexRange {
            simplex,
            corner,
            found,
            vertices,
        });
    }
    match first_far(&place[1..]) {
        Some(found) => Err(Refusal::ShiftRange {
            simplex,
            corner,
            found,
        }),
        None => Ok(()),
    }
}

/// Each vertex is a corner of some simplex: it belongs to the tiling.
fn check_vertices_used(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let mut used = vec![false; certificate.witness.vertices.len()];
    certificate.witness.simplices.each(|_, corners| {
        for place in corners.iter() {
            let vertex = place
                .first()
                .and_then(|vertex| used.get_mut(*vertex as usize));
            vertex.into_iter().for_each(|used| *used = true);
        }
        Ok(())
    })?;
    match used.iter().position(|used| !used) {
        Some(vertex) => Err(Refusal::UnusedVertex { vertex }),
        None => Ok(()),
    }
}

/// Each simplex has a row of D + 1 mates, each `[t, j, u_1, …, u_r]` with t a
/// simplex, 0 <= j <= D and |u_k| < 2^31; or, where the domain has a polytope, `[f]`
/// with f a face; or, where it is a region, `[]`.
fn check_mates(certificate: &Document, _: &Limits) -> Result<(), Refusal> {
    let witness = &certificate.witness;
    let (found, expected) = (witness.mates.len(), witness.simplices.len());
    if found != expected {
        return Err(Refusal::MatesLength { found, expected });
    }
    let mates = &witness.mates;
    mates.each(|simplex, row| check_row_of_mates(certificate, simplex, row))
}

/// The mates of the facets of one simplex.
pub(super) fn check_row_of_mates(
    certificate: &Document,
    simplex: usize,
    mates: &Lists,
) -> Result<(), Refusal> {
    let (found, expected) = (mates.len(), certificate.claim.dimension + 1);
    if found != expected {
        return Err(Refusal::MateRowLength {
            simplex,
            found,
            expected,
        });
    }
    let mut mates = mates.iter().enumerate();
    mates.try_for_each(|(facet, mate)| check_mate(certificate, simplex, facet, mate))
}

fn check_mate(
    certificate: &Document,
    simplex: usize,
    facet: usize,
    mate: &[i64],
) -> Result<(), Refusal> {
    let (found, expected) = (mate.len(), 2 + rank_of_lattice(certificate));
    let domain = &certificate.claim.domain;
    let faces = domain.polytope().map_or(0, |polytope| polytope.faces.len());
    let in_boundary = match domain {
        Domain::Space => None,
        Domain::Slab(_) | Domain::Prism(_) | Domain::Solid(_) => Some(1),
        Domain::Region => Some(0),
    };
    if found != expected && Some(found) != in_boundary {
        return Err(Refusal::MateLength {
            simplex,
            facet,
            found,
            expected,
        });
    }
    let exists = match mate {
        [] => true,
        [face] => is_index(*face, faces),
        _ => {
            is_index(mate[0], certificate.witness.simplices.len())
                && is_index(mate[1], certificate.claim.dimension + 1)
        }
    };
    if !exists {
        return Err(Refusal::MateRange {
            simplex,
            facet,
            found: mate.to_vec(),
        });
    }
    match first_far(mate.get(2..).unwrap_or_default()) {
        Some(found) => Err(Refusal::MateShiftRange {
            simplex,
            facet,
            found,
        }),
        None => Ok(()),
    }
}

fn rank_of_lattice(certificate: &Document) -> usize {
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
