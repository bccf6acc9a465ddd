//! Condition X for one pair: two facets meet in the hull of their common corners.
//!
//! **Rule.** Let w be a linear functional that takes one value c at all common corners, greater values at the other
//! corners of g, and smaller values at the other corners of f. Then f and g meet in the hull of the common corners.
//! *Proof.* At a common point w ≤ c and w ≥ c, so w = c. A convex combination of corners with w ≤ c has this value only
//! if all its corners have it. ∎ Without common corners, w is smaller on all of f than on all of g.
//!
//! The *rays* are the vectors on which w must be positive: the differences g_j - f_i, or with the
//! first common corner as the origin, the other corners of g and the negatives of those of f.
//! A functional proves that a pair is right, and the way to find it needs no trust. The functionals
//! tried here suffice for facets that are not flat, so a refusal is right as well.
//!
//! **The plane.** A segment ab is replaced by the triangle with the corners 0, (a, 1), (b, 1).
//! These triangles meet in the hull of their common corners exactly if the segments do.

use crate::refusal::{Checked, Stop};
use crate::ring::{Ring, Vector, each, zip};
use std::cmp::Ordering;

/// Whether f and g meet in the hull of their first `common` corners, which are the same.
pub(crate) fn only_in_common<R: Ring>(ring: &R, common: usize, [f, g]: &[[Vector<R>; 3]; 2]) -> Checked<bool> {
    let ([f0, f1, f2], [g0, g1, g2]) = (f, g);
    let to = |x: &_, y: &_| ring.difference(x, y);
    let (zero, one) = (R::Element::default, ring.integer(1)?);
    let x = &[one.clone(), zero(), zero()];
    let y = &[zero(), one.clone(), zero()];
    let z = &[zero(), zero(), one];
    match common {
        // 0 is beyond some side of P = g - f. If P is a solid, the normal of the side is that of f or g, or orthogonal
        // to an edge of each. Otherwise f and g are parallel. Then their normal separates them, or they lie in a plane
        // and the side is parallel to an edge: w vanishes on this edge and on an axis that is not in the plane.
        0 => {
            let rays = each(f, |x| each(g, |y| to(x, y)))?;
            let pairs = [(f0, f1), (f0, f2), (g0, g1), (g0, g2), (f1, f2), (g1, g2)];
            let (rays, edges) = (rays.as_flattened(), each(&pairs, |(x, y)| to(x, y))?);
            Ok(is_sum_positive(ring, rays) || is_some_positive(ring, rays, &edges, &[x, y, z])?)
        }
        // The cone of the four rays has an apex. If it is a solid with three sides, w is the same on its three edges.
        // If it has four, w is the product of its diagonals: the sum of the normals of its sides. If it lies in a
        // plane, w is the same on its two edges and vanishes on an axis that is not in the plane.
        1 => {
            let rays = [to(f1, f0)?, to(f2, f0)?, to(g0, g1)?, to(g0, g2)?];
            let [a, b, c, d] = &rays;
            let pairs = [(a, b), (c, d), (a, c), (a, d), (b, c), (b, d)];
            let edges = each(&pairs, |(x, y)| to(x, y))?;
            Ok(is_sum_positive(ring, &rays) || is_some_positive(ring, &rays, &edges, &[x, y, z])?)
        }
        // Half-planes with the edge e through p and q. If det(e, p, q) ≠ 0, w = e × (p + q) serves:
        // w · -p = w · q. Otherwise w vanishes on e and on an axis.
        2 => {
            let rays = [to(f2, f0)?, to(g0, g2)?];
            let [opposite, q] = &rays;
            is_some_positive(ring, &rays, &[to(f0, f1)?], &[&to(opposite, q)?, x, y, z])
        }
        _ => Ok(false),
    }
}

/// Whether the product of an edge and another vector, or of two edges, or its negative, is positive on all rays.
fn is_some_positive<R: Ring>(
    ring: &R,
    rays: &[Vector<R>],
    edges: &[Vector<R>],
    others: &[&Vector<R>],
) -> Checked<bool> {
    let mut answer = Ok(false);
    for (k, x) in edges.iter().enumerate() {
        for y in others.iter().copied().chain(edges.iter().take(k)) {
            ring.work().add(6 * ring.price());
            match is_positive(ring, rays, &ring.cross(x, y)?)? {
                Some(true) => return Ok(true),
                Some(false) => {}
                // Another functional may be decided.
                None => answer = Err(Stop::LARGER),
            }
        }
    }
    answer
}

/// Whether the sum of the rays is positive on all rays. It serves for most pairs, at little cost.
fn is_sum_positive<R: Ring>(ring: &R, rays: &[Vector<R>]) -> bool {
    let sum = |sum: Vector<R>, ray| zip(&sum, ray, |x, y| ring.plus(x, y));
    let sum = rays.iter().try_fold(Default::default(), sum);
    sum.and_then(|w| is_positive(ring, rays, &w)) == Ok(Some(true))
}

/// Whether w, or its negative, is positive on all rays. `None` if a sign is undecided.
fn is_positive<R: Ring>(ring: &R, rays: &[Vector<R>], w: &Vector<R>) -> Checked<Option<bool>> {
    let mut first = None;
    for ray in rays {
        ring.work().add(3 * ring.price());
        let Ok(sign) = ring.sign(&ring.inner(w, ray)?).decided() else { return Ok(None) };
        if sign == Ordering::Equal || *first.get_or_insert(sign) != sign {
            return Ok(Some(false));
        }
    }
    Ok(Some(true))
}
