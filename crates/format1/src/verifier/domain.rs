//! The domain's boundary: the listed faces are the facets of a convex polytope,
//! and the tiling keeps to them.
//!
//! P is the convex hull of the domain's vertices, in the last k coordinates. The
//! domain is P times the span of the first D - k basis vectors. For a face f with
//! the vertices w_0, w_1, … in their order,
//! h_f(x) = det(w_1 - w_0, …, w_(k-1) - w_0, x - w_0).
//! Coordinates are N times too large, values of h_f N^k times. That the checks
//! make P the intersection of the half-spaces of its faces is in docs/soundness.md.

use super::matrix::{Matrix, cofactors, determinant};
use super::ring::Element;
use super::tiling::{Tiling, number};
use super::{Refusal, mates};
use crate::certificate::Number;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// P, with the coordinates of its vertices read.
pub(super) struct Polytope<'c> {
    pub(super) faces: &'c [Vec<usize>],
    /// N w for each vertex w.
    pub(super) vertices: Matrix,
}

impl Polytope<'_> {
    /// k
    pub(super) fn dimension(&self) -> usize {
        self.vertices.first().map_or(0, Vec::len)
    }

    /// N times the vectors from vertex `from` to the others.
    fn edges(&self, from: usize, to: &[usize]) -> Matrix {
        let origin = &self.vertices[from];
        to.iter()
            .map(|&w| difference(&self.vertices[w], origin))
            .collect()
    }
}

fn difference(x: &[Element], origin: &[Element]) -> Vec<Element> {
    let pairs = x.iter().zip(origin);
    pairs.map(|(x, o)| x.clone().minus(o)).collect()
}

/// h_f(x) = n · (x - w_0), where n holds the cofactors of the last row of h_f.
struct Plane<'t> {
    tiling: &'t Tiling<'t>,
    face: usize,
    normal: Vec<Element>,
    origin: &'t [Element],
}

impl<'t> Plane<'t> {
    fn new(tiling: &'t Tiling, polytope: &'t Polytope, face: usize) -> Plane<'t> {
        let (corners, k) = (&polytope.faces[face], polytope.dimension());
        let mut rows = polytope.edges(corners[0], &corners[1..k]);
        rows.push(vec![Element::default(); k]);
        Plane {
            tiling,
            face,
            normal: cofactors(&tiling.ring, &rows).pop().unwrap_or_default(),
            origin: &polytope.vertices[corners[0]],
        }
    }

    /// h_f(x), where the last k coordinates of a point are those of x.
    fn value(&self, point: &[Element]) -> Element {
        let x = &point[point.len() - self.origin.len()..];
        let ring = &self.tiling.ring;
        ring.dot(&self.normal, &difference(x, self.origin))
    }

    fn sign(&self, point: &[Element]) -> Result<Ordering, Refusal> {
        let scale = self.tiling.scale.pow(self.origin.len());
        let of = || format!("side of a point with respect to face {}", self.face);
        self.tiling.sign(&self.value(point), &scale, of)
    }

    /// h_f(x) for a refusal.
    fn number(&self, point: &[Element]) -> Number {
        let scale = self.tiling.scale.pow(self.origin.len());
        number(&self.value(point), &scale)
    }

    /// s_f: the sign of h_f at the first vertex of P that is not one of f;
    /// `Equal` where there is none.
    fn side(&self, polytope: &Polytope) -> Result<Ordering, Refusal> {
        let corners = &polytope.faces[self.face];
        match (0..polytope.vertices.len()).find(|w| !corners.contains(w)) {
            Some(w) => self.sign(&polytope.vertices[w]),
            None => Ok(Ordering::Equal),
        }
    }
}

fn each_plane<'t>(
    tiling: &'t Tiling,
    check: impl Fn(&'t Polytope, Plane<'t>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let Some(polytope) = &tiling.polytope else {
        return Ok(());
    };
    (0..polytope.faces.len()).try_for_each(|f| check(polytope, Plane::new(tiling, polytope, f)))
}

/// Each face f is a facet of P: h_f is zero at the vertices of f and has one
/// strict sign s_f at all others, of which there is one.
pub(super) fn check_facets(tiling: &Tiling) -> Result<(), Refusal> {
    each_plane(tiling, |polytope, plane| {
        let side = plane.side(polytope)?;
        for (vertex, point) in polytope.vertices.iter().enumerate() {
            let expected = match polytope.faces[plane.face].contains(&vertex) {
                true => Ordering::Equal,
                false => side,
            };
            if side == Ordering::Equal || plane.sign(point)? != expected {
                return Err(Refusal::FaceNotFacet {
                    face: plane.face,
                    vertex,
                    value: plane.number(point),
                });
            }
        }
        Ok(())
    })
}

/// For k = 3 the vertices of a face stand in the order of a convex polygon: for all
/// consecutive p, q and every other t, the turn det(q - p, t - p, n) has one
/// strict sign. In the plane of f, (q - p) x (t - p) = λ n in coordinates, so the
/// determinant is λ n · n, and λ is positive where p, q, t turn like w_0, w_1, w_2.
pub(super) fn check_polygons(tiling: &Tiling) -> Result<(), Refusal> {
    each_plane(tiling, |polytope, plane| {
        let corners = &polytope.faces[plane.face];
        if polytope.dimension() != 3 {
            return Ok(());
        }
        for (p, q) in sides(corners) {
            for &t in corners.iter().filter(|&&t| t != p && t != q) {
                let mut rows = polytope.edges(p, &[q, t]);
                rows.push(plane.normal.clone());
                let turn = determinant(&tiling.ring, &rows);
                let of = || format!("turn at vertex {q} of face {}", plane.face);
                if tiling.sign(&turn, &tiling.scale.pow(4), of)? != Ordering::Greater {
                    return Err(Refusal::FaceNotConvex {
                        face: plane.face,
                        vertices: (p, q, t),
                    });
                }
            }
        }
        Ok(())
    })
}

/// The pairs of vertices that follow one another, cyclically.
fn sides(corners: &[usize]) -> impl Iterator<Item = (usize, usize)> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().copied().zip(next.copied())
}

/// Every ridge of P that is in a face is in exactly two: with the faces distinct
/// facets, all facets of P are listed, for they are connected through ridges.
pub(super) fn check_closed(tiling: &Tiling) -> Result<(), Refusal> {
    let Some(polytope) = &tiling.polytope else {
        return Ok(());
    };
    let mut count = BTreeMap::new();
    for face in polytope.faces {
        for ridge in ridges(face, polytope.dimension()) {
            *count.entry(ridge).or_insert(0) += 1;
        }
    }
    match count.into_iter().find(|(_, faces)| *faces != 2) {
        Some((ridge, faces)) => Err(Refusal::FacesNotClosed { ridge, faces }),
        None => Ok(()),
    }
}

/// For k = 1 the empty set, for k = 2 each vertex, for k = 3 each side.
fn ridges(face: &[usize], k: usize) -> Vec<Vec<usize>> {
    match k {
        1 => vec![vec![]],
        2 => face.iter().map(|&w| vec![w]).collect(),
        _ => sides(face).map(|(p, q)| vec![p.min(q), p.max(q)]).collect(),
    }
}

/// Every vertex v of the tiling is in the domain: s_f h_f(v) >= 0 for all f.
pub(super) fn check_inside(tiling: &Tiling) -> Result<(), Refusal> {
    each_plane(tiling, |polytope, plane| {
        let side = plane.side(polytope)?;
        for (vertex, point) in tiling.vertices.iter().enumerate() {
            let sign = plane.sign(point)?;
            if sign != Ordering::Equal && sign != side {
                return Err(Refusal::VertexOutside {
                    vertex,
                    face: plane.face,
                    value: plane.number(point),
                });
            }
        }
        Ok(())
    })
}

/// mate(s, i) = f implies that the facet lies in face f: h_f = 0 at its corners.
/// That no other facet lies in the boundary follows: its mate would be outside.
pub(super) fn check_boundary(tiling: &Tiling) -> Result<(), Refusal> {
    let Some(polytope) = &tiling.polytope else {
        return Ok(());
    };
    let all = 0..polytope.faces.len();
    let planes: Vec<Plane> = all.map(|f| Plane::new(tiling, polytope, f)).collect();
    tiling.each_row(|simplex, corners, mates| {
        for (facet, own) in mates.iter().enumerate() {
            let Some(face) = mates::face(own) else {
                continue;
            };
            for corner in corners.without(facet) {
                let point = tiling.vertex(corner);
                if planes[face].sign(point)? != Ordering::Equal {
                    return Err(Refusal::BoundaryFacet {
                        simplex,
                        facet,
                        face,
                        value: planes[face].number(point),
                    });
                }
            }
        }
        Ok(())
    })
}

/// k! vol P, N^k times too large: the sum over the faces f of the pyramids with
/// the apex o, a fixed vertex of P. Each is cut into the simplices o, w_0, w_i, …,
/// w_(i+k-2), whose determinants all have the sign s_f or are zero.
pub(super) fn volume(tiling: &Tiling, polytope: &Polytope) -> Result<Element, Refusal> {
    let (k, apex) = (polytope.dimension(), 0);
    let mut sum = Element::default();
    for (f, face) in polytope.faces.iter().enumerate() {
        let side = Plane::new(tiling, polytope, f).side(polytope)?;
        for i in 1..=face.len() - k + 1 {
            let corners = [&face[i..i + k - 1], &[apex]].concat();
            let pyramid = determinant(&tiling.ring, &polytope.edges(face[0], &corners));
            sum = match side {
                Ordering::Less => sum.minus(&pyramid),
                _ => sum.plus(&pyramid),
            };
        }
    }
    Ok(sum)
}
