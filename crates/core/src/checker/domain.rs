//! The hypotheses about a domain with a boundary: that it is a convex polytope, that
//! the tiles lie in it, and which facets lie in its boundary.
//!
//! Let P be the convex hull of the polytope's vertices. A face whose vertices lie in a
//! plane that leaves all other vertices strictly on one side spans a facet of P. If
//! the faces so given close up, every ridge in exactly two of them, then they are all
//! facets of P, for the facets of a polytope are connected through ridges; so P is the
//! intersection of their half-spaces (docs/soundness.md, section on domains).

use super::defect::Defect;
use super::findings::Findings;
use super::hypotheses::Unsided;
use crate::tiling::{Facet, Matching, Plane, Polytope, SimplexId, Tiling};
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;
use std::collections::{BTreeMap, BTreeSet};

/// Hypothesis D. The faces are the facets of a convex polytope. Gives their planes,
/// none for all of space.
pub fn check_domain<const D: usize>(tiling: &Tiling<D>, findings: &mut Findings) -> Vec<Plane> {
    let Some(polytope) = tiling.frame.domain.polytope() else {
        return Vec::new();
    };
    check_ridges(polytope, findings);
    let mut planes = Vec::with_capacity(polytope.faces.len());
    for face in 0..polytope.faces.len() {
        match polytope.plane(face) {
            Some(plane) => {
                check_supporting(polytope, face, &plane, findings);
                planes.push(plane);
            }
            None => findings.add(Defect::FaceWithoutPlane { face }),
        }
    }
    planes
}

/// The face's own vertices lie in its plane, all others strictly inside.
fn check_supporting(polytope: &Polytope, face: usize, plane: &Plane, findings: &mut Findings) {
    for (vertex, point) in polytope.vertices.iter().enumerate() {
        let value = plane.value(point);
        let expected = if polytope.faces[face].contains(&vertex) {
            Sign::Equal
        } else {
            Sign::Greater
        };
        if value.sign() != expected {
            findings.add(Defect::FaceNotSupporting {
                face,
                vertex,
                value,
            });
        }
    }
    if polytope.dimension() == 3 && !is_convex_cycle(polytope, face) {
        findings.add(Defect::FaceNotConvex { face });
    }
}

/// Whether the corners of a face of a polyhedron are in the cyclic order of a convex
/// polygon: seen from a fixed vertex o off its plane, every other corner t is on the
/// same side of every side pq, which is the sign of det(q - p, t - p, o - p).
fn is_convex_cycle(polytope: &Polytope, face: usize) -> bool {
    let corners = &polytope.faces[face];
    let Some(apex) = (0..polytope.vertices.len()).find(|v| !corners.contains(v)) else {
        return false;
    };
    let n = corners.len();
    let mut signs = (0..n).flat_map(|i| {
        let (p, q) = (corners[i], corners[(i + 1) % n]);
        let others = corners.iter().filter(move |&&t| t != p && t != q);
        others.map(move |&t| side(polytope, p, q, t, apex))
    });
    let first = signs.next();
    first.is_some_and(|first| first.is_ne() && signs.all(|sign| sign == first))
}

fn side(polytope: &Polytope, p: usize, q: usize, t: usize, apex: usize) -> Sign {
    let base = &polytope.vertices[p];
    let row =
        |v: usize| -> [Number; 3] { std::array::from_fn(|k| &polytope.vertices[v][k] - &base[k]) };
    acutile_exact::geometry::linear::determinant(&[row(q), row(t), row(apex)]).sign()
}

/// Every ridge, an end of a side or an edge of a face, lies in exactly two faces; an
/// interval has two ends.
fn check_ridges(polytope: &Polytope, findings: &mut Findings) {
    let mut uses: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
    for face in &polytope.faces {
        for ridge in ridges(face, polytope.dimension()) {
            *uses.entry(ridge).or_default() += 1;
        }
    }
    for (ridge, count) in uses {
        if count != 2 {
            findings.add(Defect::RidgeNotShared {
                ridge,
                faces: count,
            });
        }
    }
}

fn ridges(face: &[usize], dimension: usize) -> Vec<Vec<usize>> {
    match dimension {
        1 => vec![Vec::new()],
        2 => face.iter().map(|&v| vec![v]).collect(),
        _ => (0..face.len())
            .map(|i| {
                let (p, q) = (face[i], face[(i + 1) % face.len()]);
                vec![p.min(q), p.max(q)]
            })
            .collect(),
    }
}

/// Hypothesis I. Every vertex lies in the domain. Gives for each vertex the faces in
/// which it lies.
pub fn check_inside<const D: usize>(
    tiling: &Tiling<D>,
    planes: &[Plane],
    findings: &mut Findings,
) -> Vec<Vec<usize>> {
    let mut faces = vec![Vec::new(); tiling.vertices.len()];
    if planes.is_empty() {
        return faces;
    }
    for (vertex, point) in tiling.vertices.iter().enumerate() {
        for (face, plane) in planes.iter().enumerate() {
            let value = plane.value(tiling.frame.cross_section(&point));
            match value.sign() {
                Sign::Greater => {}
                Sign::Equal => faces[vertex].push(face),
                Sign::Less => findings.add(Defect::VertexOutside {
                    vertex,
                    face,
                    value,
                }),
            }
        }
    }
    faces
}

/// Hypothesis F. Every facet is shared, up to a lattice vector, by exactly two
/// simplices on opposite sides of it, or it belongs to one and lies in a face of the
/// domain, or it belongs to one and the domain is a region.
pub fn check_facets<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    faces_of_vertices: &[Vec<usize>],
    findings: &mut Findings,
) {
    check_facets_beside(
        tiling,
        matching,
        faces_of_vertices,
        &BTreeSet::new(),
        &Unsided::default(),
        findings,
    );
}

/// The same for a tiling with duplicate simplices, and with flat or negative ones. Facets that would
/// be right without the surplus, or after turning, are consequences.
pub(super) fn check_facets_beside<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    faces_of_vertices: &[Vec<usize>],
    surplus: &BTreeSet<SimplexId>,
    unsided: &Unsided,
    findings: &mut Findings,
) {
    for mismatch in &matching.mismatches {
        let is_first = |(facet, _): &&(Facet, bool)| !surplus.contains(&facet.simplex);
        let uses: Vec<(Facet, bool)> = mismatch.uses.iter().filter(is_first).copied().collect();
        let facets: Vec<Facet> = uses.iter().map(|(facet, _)| *facet).collect();
        if facets.len() < mismatch.uses.len() {
            // Without the duplicates the facet is matched, or boundary.
            let is_right = match uses[..] {
                [a, b] => a.1 != b.1,
                _ => uses.len() < 2,
            };
            if is_right {
                let code = if mismatch.uses.len() == 2 {
                    "same-side"
                } else {
                    "overused-facet"
                };
                findings.add_consequence(code, 1);
                continue;
            }
        }
        match facets[..] {
            [_] if tiling.frame.domain.is_region() => {}
            [facet] => {
                if face_of(tiling, facet, faces_of_vertices).is_none() {
                    findings.add(Defect::UnmatchedFacet { facet });
                }
            }
            [a, b] if unsided.explains(a.simplex, b.simplex) => {
                findings.add_consequence("same-side", 1);
            }
            [a, b] => findings.add(Defect::SameSide { facets: (a, b) }),
            _ => findings.add(Defect::OverusedFacet { facets }),
        }
    }
}

/// The face in which all corners of a facet lie.
fn face_of<const D: usize>(
    tiling: &Tiling<D>,
    facet: Facet,
    faces_of_vertices: &[Vec<usize>],
) -> Option<usize> {
    let corners = tiling.simplex(facet.simplex).iter().enumerate();
    let mut faces = corners
        .filter(|(i, _)| *i != usize::from(facet.opposite))
        .map(|(_, corner)| &faces_of_vertices[corner.vertex.index()]);
    let first = faces.next()?;
    let others: Vec<&Vec<usize>> = faces.collect();
    first
        .iter()
        .copied()
        .find(|face| others.iter().all(|list| list.contains(face)))
}
