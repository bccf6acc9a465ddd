//! Two triangles have nothing in common but their common corners.
//!
//! Each answer "yes" is a linear functional that is strictly less at all points of
//! the one set than at all points of the other: then their convex hulls are
//! disjoint, whatever the functional is. That the functionals tried are
//! enough, so that "no" is right as well, is in docs/soundness.md, section 8.

use super::Refusal;
use super::extent::Extents;
use super::integer::Integer;
use super::matrix::cross;
use super::region::Triangle;
use super::ring::Element;
use super::tiling::Tiling;
use std::cmp::Ordering;

type Vector = Vec<Element>;

/// |f| ∩ |g| is the convex hull of the corners that f and g have in common, as vertices.
///
/// - None: the triangles are disjoint.
/// - One, v: were there another common point y, the ray from v through y would leave
///   the one triangle at the edge opposite to v, no later than it leaves the
///   other. So it suffices that either such edge misses the other triangle.
/// - Two: the triangles lie in different planes, or on different sides of their edge.
/// - Three: never.
pub(super) fn meet_in_common_corners(
    tiling: &Tiling,
    extents: &Extents,
    f: &Triangle,
    g: &Triangle,
) -> Result<bool, Refusal> {
    let is_apart = |p: &[usize], q: &[usize]| -> Result<bool, Refusal> {
        Ok(extents.are_apart(p, q) || is_separated(tiling, p, q)?)
    };
    let (rest_f, rest_g) = (f.without(g), g.without(f));
    match rest_f.len() {
        3 => is_apart(&f.corners, &g.corners),
        2 => Ok(is_apart(&rest_f, &g.corners)? && is_apart(&rest_g, &f.corners)?),
        1 => is_unfolded(tiling, f, rest_f[0], rest_g[0]),
        _ => Ok(false),
    }
}

/// The triangles e ∪ p and e ∪ q with the common edge e = (b, c) meet in e alone, where
/// f = e ∪ p: the normals (c - b) × (p - b) and (c - b) × (q - b) do not have the same direction.
fn is_unfolded(tiling: &Tiling, f: &Triangle, p: usize, q: usize) -> Result<bool, Refusal> {
    let mut edge = f.corners.iter().copied().filter(|&corner| corner != p);
    let (Some(b), Some(c)) = (edge.next(), edge.next()) else {
        return Ok(false);
    };
    let along = vector(tiling, b, c);
    let normal = |x: usize| cross(&tiling.ring, &along, &vector(tiling, b, x));
    let (n_p, n_q) = (normal(p), normal(q));
    for entry in cross(&tiling.ring, &n_p, &n_q) {
        if sign(tiling, &entry)? != Ordering::Equal {
            return Ok(true);
        }
    }
    let product = tiling.ring.dot(&n_p, &n_q);
    Ok(sign(tiling, &product)? == Ordering::Less)
}

/// One of these functionals is strictly less at p than at q, or the reverse, where p and q are
/// the corners of a triangle or the ends of a segment, one of them of a triangle: the normals n of
/// the triangles, n × e for all edges e, and e × e' for an edge e of p and e' of q.
fn is_separated(tiling: &Tiling, p: &[usize], q: &[usize]) -> Result<bool, Refusal> {
    let ring = &tiling.ring;
    let (edges_p, edges_q) = (edges(tiling, p), edges(tiling, q));
    for plane in [&edges_p, &edges_q].into_iter().filter(|e| e.len() == 3) {
        let normal = cross(ring, &plane[0], &plane[1]);
        for edge in plane.iter().chain(&edges_p).chain(&edges_q) {
            if separates(tiling, &cross(ring, &normal, edge), p, q)? {
                return Ok(true);
            }
        }
        if separates(tiling, &normal, p, q)? {
            return Ok(true);
        }
    }
    for e in &edges_p {
        for e_q in &edges_q {
            if separates(tiling, &cross(ring, e, e_q), p, q)? {
                return Ok(true);
            }
        }
    }
    Ok(false)
}

/// w · y - w · x has one strict sign for all x in p and y in q.
fn separates(tiling: &Tiling, w: &[Element], p: &[usize], q: &[usize]) -> Result<bool, Refusal> {
    let at = |&vertex: &usize| tiling.ring.dot(w, &tiling.vertices[vertex]);
    let (at_p, at_q): (Vector, Vector) = (p.iter().map(at).collect(), q.iter().map(at).collect());
    let mut first = None;
    for x in &at_p {
        for y in &at_q {
            let side = sign(tiling, &y.clone().minus(x))?;
            if side == Ordering::Equal || *first.get_or_insert(side) != side {
                return Ok(false);
            }
        }
    }
    Ok(first.is_some())
}

/// The vectors from each point to the next, cyclically; a segment has one.
fn edges(tiling: &Tiling, points: &[usize]) -> Vec<Vector> {
    let next = points.iter().cycle().skip(1);
    let all = points.iter().zip(next).map(|(&b, &c)| vector(tiling, b, c));
    all.take(if points.len() == 2 { 1 } else { points.len() })
        .collect()
}

/// N times the vector from one vertex to another.
pub(super) fn vector(tiling: &Tiling, from: usize, to: usize) -> Vector {
    let pairs = tiling.vertices[to].iter().zip(&tiling.vertices[from]);
    pairs.map(|(y, x)| y.clone().minus(x)).collect()
}

fn sign(tiling: &Tiling, value: &Element) -> Result<Ordering, Refusal> {
    let of = || "position of two facets in the boundary, scaled".to_owned();
    tiling.sign(value, &Integer::ONE, of)
}
