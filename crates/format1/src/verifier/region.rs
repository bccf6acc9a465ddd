//! The boundary of a region: it does not meet itself, and nothing is outside of it.
//!
//! Called by [`super::geometry::CHECKS`], after orientation and mates. That these
//! two checks make the simplices of a mesh an embedded triangulation is
//! Theorem 4 of docs/soundness.md. Let N(x) be the number of simplices that contain
//! a point x off all facets. Behind every facet that is not in the boundary is another simplex, so N changes
//! at the boundary alone, by one. If N is zero directly outside of all of it, N is never
//! more than one.

use super::extent::Extents;
use super::integer::Integer;
use super::matrix::{cross, determinant};
use super::ring::Element;
use super::tiling::Tiling;
use super::{Refusal, apart, mates};
use crate::certificate::Domain;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// A facet with the mate `[]`. Its corners, as vertices, stand in an order in which
/// (b - a) × (c - a) points out of its simplex.
pub(super) struct Triangle {
    simplex: usize,
    facet: usize,
    pub(super) corners: [usize; 3],
}

impl Triangle {
    fn name(&self) -> (usize, usize) {
        (self.simplex, self.facet)
    }

    /// The corners that the other triangle does not have.
    pub(super) fn without(&self, other: &Triangle) -> Vec<usize> {
        let own = self.corners.into_iter();
        own.filter(|corner| !other.corners.contains(corner))
            .collect()
    }

    /// The edges, each from its lesser end.
    fn edges(&self) -> [(usize, usize); 3] {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)].map(|(p, q)| (p.min(q), p.max(q)))
    }
}

/// All facets in the boundary of a region, none of any other domain. With
/// det > 0, the corners f_1, f_2, f_3 but the i-th have det(f_1 - x_i, f_2 - x_i, f_3 - x_i)
/// of the sign (-1)^i, which is positive where the normal points away from x_i.
fn boundary(tiling: &Tiling) -> Result<Vec<Triangle>, Refusal> {
    let mut triangles = Vec::new();
    if tiling.certificate.claim.domain != Domain::Region {
        return Ok(triangles);
    }
    tiling.each_row(|simplex, places, mates| {
        for facet in (0..4).filter(|&i| mates::is_boundary(mates.get(i))) {
            let others = [0, 1, 2].map(|k| k + usize::from(k >= facet));
            let [a, b, c] = others.map(|k| places.get(k)[0] as usize);
            let corners = if facet % 2 == 0 { [a, b, c] } else { [a, c, b] };
            triangles.push(Triangle {
                simplex,
                facet,
                corners,
            });
        }
        Ok(())
    })?;
    Ok(triangles)
}

/// |f| ∩ |g| is the convex hull of the corners that f and g have in common, which are
/// not three, for any two facets f and g in the boundary.
pub(super) fn check_boundary_apart(tiling: &Tiling) -> Result<(), Refusal> {
    let triangles = boundary(tiling)?;
    let extents = Extents::new(tiling, &triangles)?;
    let (cost, mut spent) = (tiling.product().saturating_mul(COST), 0);
    extents.each_close_pair(tiling.limit, |f, g| {
        spend(tiling, &mut spent, cost)?;
        let (f, g) = (&triangles[f], &triangles[g]);
        match apart::meet_in_common_corners(tiling, &extents, f, g)? {
            true => Ok(()),
            false => Err(Refusal::BoundaryMeets {
                first: f.name().min(g.name()),
                second: f.name().max(g.name()),
                shared: 3 - f.without(g).len(),
            }),
        }
    })
}

/// Products for one pair that is looked at exactly, mostly a few dozens.
const COST: u64 = 64;

fn spend(tiling: &Tiling, spent: &mut u64, cost: u64) -> Result<(), Refusal> {
    *spent = spent.saturating_add(cost);
    match *spent <= tiling.limit {
        true => Ok(()),
        false => Err(Refusal::Work {
            of: "for the facets in the boundary",
            found: *spent,
            limit: tiling.limit,
        }),
    }
}

/// N = 0 directly outside of each facet in the boundary. Around an edge that exactly two of them have
/// there is nothing else of the boundary, so N is the same outside of both; hence one of each class suffices.
pub(super) fn check_covering(tiling: &Tiling) -> Result<(), Refusal> {
    let triangles = boundary(tiling)?;
    let first = first_of_classes(&triangles);
    let extents = Extents::new(tiling, &triangles)?;
    let (cost, mut spent) = (tiling.product().saturating_mul(COST), 0);
    for from in first {
        spend(tiling, &mut spent, triangles.len() as u64)?;
        let ahead = (0..triangles.len()).filter(|&t| extents.may_be_ahead(from, t));
        let start = &triangles[from];
        // Where the ray begins at the inner side, N is one more there than outside.
        let mut outside = match first_sign(tiling, &normal(tiling, start))? {
            Ordering::Less => -1,
            _ => 0,
        };
        for t in ahead {
            spend(tiling, &mut spent, cost)?;
            outside += crossing(tiling, start, &triangles[t])?;
        }
        if outside != 0 {
            let (simplex, facet) = start.name();
            return Err(Refusal::Covering {
                simplex,
                facet,
                outside,
            });
        }
    }
    Ok(())
}

/// The first triangle of each class: two are in one class if they share an edge that
/// no third one has.
fn first_of_classes(triangles: &[Triangle]) -> Vec<usize> {
    let mut around: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for (t, triangle) in triangles.iter().enumerate() {
        for edge in triangle.edges() {
            around.entry(edge).or_default().push(t);
        }
    }
    let mut seen = vec![false; triangles.len()];
    let mut first = Vec::new();
    for start in 0..triangles.len() {
        if seen[start] {
            continue;
        }
        first.push(start);
        let mut reached = vec![start];
        while let Some(t) = reached.pop() {
            if std::mem::replace(&mut seen[t], true) {
                continue;
            }
            let at_edges = triangles[t].edges().map(|edge| &around[&edge]);
            reached.extend(at_edges.into_iter().filter(|ts| ts.len() == 2).flatten());
        }
    }
    first
}

/// (b - a) × (c - a), which points out.
fn normal(tiling: &Tiling, triangle: &Triangle) -> Vec<Element> {
    let [a, b, c] = triangle.corners;
    let (along, across) = (apart::vector(tiling, a, b), apart::vector(tiling, a, c));
    cross(&tiling.ring, &along, &across)
}

/// How the ray from the centroid m of `start` in the direction d = (1, ε, ε²) passes a
/// triangle: 1 if it leaves through it, -1 if it enters, 0 if it misses it, for all small ε > 0.
///
/// With A = a - m, B = b - m, C = c - m and Δ = det(A, B, C) ≠ 0, d = αA + βB + γC with
/// γ Δ = d · (A × B), and so on. The ray meets the triangle where α, β and γ are positive,
/// and then d · n has the sign of Δ. The sign of d · w is that of the first entry of w
/// that is not zero. Where Δ = 0, the plane of the triangle contains m, and no further
/// point of the ray.
fn crossing(tiling: &Tiling, start: &Triangle, triangle: &Triangle) -> Result<i64, Refusal> {
    let ring = &tiling.ring;
    let [a, b, c] = triangle.corners.map(|v| from_centroid(tiling, start, v));
    let rows = vec![a, b, c];
    let of = || "side of a centroid with respect to a facet in the boundary".to_owned();
    let side = tiling.sign(&determinant(ring, &rows), &Integer::ONE, of)?;
    for (x, y) in [(0, 1), (1, 2), (2, 0)] {
        if first_sign(tiling, &cross(ring, &rows[x], &rows[y]))? != side {
            return Ok(0);
        }
    }
    Ok(match side {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    })
}

/// 3 N (v - m) = 3 N v - N f_1 - N f_2 - N f_3, for the centroid m of f.
fn from_centroid(tiling: &Tiling, f: &Triangle, v: usize) -> Vec<Element> {
    let mut sum = vec![Element::default(); 3];
    for corner in f.corners {
        let to = apart::vector(tiling, corner, v);
        sum = sum.into_iter().zip(&to).map(|(s, x)| s.plus(x)).collect();
    }
    sum
}

/// The sign of the first entry that is not zero.
fn first_sign(tiling: &Tiling, w: &[Element]) -> Result<Ordering, Refusal> {
    for entry in w {
        let of = || "direction of a facet in the boundary, scaled".to_owned();
        let sign = tiling.sign(entry, &Integer::ONE, of)?;
        if sign != Ordering::Equal {
            return Ok(sign);
        }
    }
    Ok(Ordering::Equal)
}

#[cfg(test)]
mod tests;
