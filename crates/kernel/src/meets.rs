//! Condition X for one pair: two facets meet in the hull of their common corners.
//!
//! **Rule.** Let w be a linear functional that takes one value c at all common corners, greater values
//! at the other corners of g, and smaller values at the other corners of f.
//! Then f and g meet in the hull of the common corners.
//! *Proof.* At a common point w ≤ c and w ≥ c, so w = c.
//! A convex combination of corners with w ≤ c has the value c only if it uses corners with w = c alone. ∎
//! Without common corners, w is smaller on all of f than on all of g.
//!
//! A *ray* is a vector on which w must be positive. If there is a common corner, it is the origin, and the rays are
//! the other corners of g and the negatives of those of f. Otherwise they are all differences g_j - f_i.
//! So a functional accepts a pair, and the way to find it needs no trust.
//! The functionals tried here suffice for facets that are not flat, so a refusal is right as well.
//!
//! **The plane.** A segment ab is replaced by the triangle with the corners 0, (a, 1), (b, 1).
//! These triangles meet in the hull of their common corners exactly if the segments do.

use crate::limits::Work;
use crate::refusal::Larger;
use crate::ring::{Ring, Vector, each};
use std::cmp::Ordering;

pub(crate) struct Meets<'r, R: Ring> {
    ring: &'r R,
    work: &'r Work,
    pub(crate) rounding: Option<Rounding<R::Element>>,
}

/// For coordinates that are not exact.
pub(crate) struct Rounding<E> {
    /// A bound on the errors of det(x, y, z), for vectors as below.
    pub(crate) slack: E,
    /// The length of the vectors along the axes: comparable with that of the others.
    pub(crate) length: E,
}

type Triangle<R> = [Vector<R>; 3];

impl<'r, R: Ring> Meets<'r, R> {
    pub(crate) fn new(ring: &'r R, work: &'r Work) -> Self {
        Meets {
            ring,
            work,
            rounding: None,
        }
    }

    /// Whether f and g meet in the hull of their first `common` corners, which are the same.
    pub(crate) fn only_in_common(
        &self,
        common: usize,
        f: &Triangle<R>,
        g: &Triangle<R>,
    ) -> Result<bool, Larger> {
        let ([origin, f1, f2], [_, g1, g2]) = (f, g);
        let from_origin = |x| self.ring.difference(origin, x);
        match common {
            0 => self.triangles(f, g),
            1 => self.cones(
                [from_origin(f1)?, from_origin(f2)?],
                [from_origin(g1)?, from_origin(g2)?],
            ),
            2 => self.half_planes(&from_origin(f1)?, &from_origin(f2)?, &from_origin(g2)?),
            _ => Ok(false),
        }
    }

    /// Two triangles. They are disjoint if 0 is beyond some side of the convex set P = g - f.
    ///
    /// If P is a solid, the normal of the side is that of f or of g, or orthogonal to an edge of each.
    /// Otherwise f and g are parallel. Then their normal separates them, or they lie in one plane and the
    /// side is parallel to an edge: w vanishes on this edge and on an axis that is not in the plane.
    fn triangles(&self, f: &Triangle<R>, g: &Triangle<R>) -> Result<bool, Larger> {
        let rays = each(f, |x| each(g, |y| self.ring.difference(x, y)))?;
        let (e, h) = (self.edges(f)?, self.edges(g)?);
        let ([e0, e1, _], [h0, h1, _]) = (&e, &h);
        let crossed = e.iter().flat_map(|x| h.iter().map(move |y| (x, y)));
        let pairs = [(e0, e1), (h0, h1)].into_iter().chain(crossed);
        let on_axes = e.iter().chain(&h).flat_map(|x| self.on_axes(x));
        let functionals = pairs.map(|(x, y)| self.cross(x, y)).chain(on_axes);
        self.is_some_positive(rays.as_flattened(), functionals)
    }

    /// Two cones with the apex 0 and the generators a, b and c, d.
    ///
    /// Cramer's rule: t₂ a - t₁ b = -s₂ c + s₁ d, for the determinants below. If one of them is not zero,
    /// this is the only relation up to a factor. A common point would be a relation without negative
    /// coefficients, so there is none if two coefficients have opposite signs.
    ///
    /// If all four are zero, the cones lie in a plane. Two rays span the cone of all rays.
    /// w vanishes on the difference of these two, and on an axis that is not in the plane.
    fn cones(&self, [a, b]: [Vector<R>; 2], [c, d]: [Vector<R>; 2]) -> Result<bool, Larger> {
        let (n, m) = (self.cross(&a, &b)?, self.cross(&c, &d)?);
        let (s1, s2) = (self.sign(&n, &c)?, self.sign(&n, &d)?);
        let (t1, t2) = (self.sign(&m, &a)?, self.sign(&m, &b)?);
        let reverse = |sign: Option<Ordering>| sign.map(Ordering::reverse);
        let relation = [t2, reverse(t1), reverse(s2), s1];
        let has = |sign| relation.contains(&sign);
        if has(Some(Ordering::Less)) && has(Some(Ordering::Greater)) {
            return Ok(true);
        }
        let minus = |x| self.ring.difference(x, &Default::default());
        let rays = [minus(&a)?, minus(&b)?, c, d];
        let [a, b, c, d] = &rays;
        let pairs = [(a, b), (a, c), (a, d), (b, c), (b, d), (c, d)];
        let differences = each(&pairs, |(x, y)| self.ring.difference(x, y))?;
        let on_axes = differences.iter().flat_map(|x| self.on_axes(x));
        let in_plane = self.is_some_positive(&rays, on_axes)?;
        if in_plane || !has(None) {
            Ok(in_plane)
        } else {
            Err(Larger)
        }
    }

    /// Two half-planes with the common edge e, through the points p and q.
    ///
    /// If det(e, p, q) ≠ 0, w = e × (p + q) serves: w · -p = w · q = det(e, p, q).
    /// Otherwise they lie in a plane. w vanishes on e, and on an axis that is not in the plane.
    fn half_planes(&self, e: &Vector<R>, p: &Vector<R>, q: &Vector<R>) -> Result<bool, Larger> {
        let opposite = self.ring.difference(p, &Default::default())?;
        let sum = self.ring.difference(&opposite, q)?;
        let functionals = [self.cross(e, &sum)].into_iter().chain(self.on_axes(e));
        self.is_some_positive(&[opposite, q.clone()], functionals)
    }

    /// Whether one of the functionals, or its negative, is positive on all rays.
    fn is_some_positive(
        &self,
        rays: &[Vector<R>],
        functionals: impl Iterator<Item = Result<Vector<R>, Larger>>,
    ) -> Result<bool, Larger> {
        let mut answer = Ok(false);
        for w in functionals {
            match self.has_one_sign(&w?, rays)? {
                Some(true) => return Ok(true),
                Some(false) => {}
                None => answer = Err(Larger),
            }
        }
        answer
    }

    /// Nothing if a sign is undecided.
    fn has_one_sign(&self, w: &Vector<R>, rays: &[Vector<R>]) -> Result<Option<bool>, Larger> {
        let mut all = Ordering::Equal;
        for ray in rays {
            let Some(sign) = self.sign(w, ray)? else {
                return Ok(None);
            };
            if sign == Ordering::Equal || sign == all.reverse() {
                return Ok(Some(false));
            }
            all = sign;
        }
        Ok(Some(all != Ordering::Equal))
    }

    /// Nothing if the sign is undecided; an error if a product does not fit.
    fn sign(&self, w: &Vector<R>, x: &Vector<R>) -> Result<Option<Ordering>, Larger> {
        self.work.add(3 * self.ring.price());
        let (ring, value) = (self.ring, self.ring.inner(w, x)?);
        let Some(Rounding { slack, .. }) = &self.rounding else {
            return Ok(ring.sign(&value).ok());
        };
        let is_positive = ring.compare(&value, slack)? == Ordering::Greater;
        let is_negative = ring.sign(&ring.plus(&value, slack)?)? == Ordering::Less;
        Ok(match (is_positive, is_negative) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            _ => None,
        })
    }

    fn cross(&self, x: &Vector<R>, y: &Vector<R>) -> Result<Vector<R>, Larger> {
        self.work.add(6 * self.ring.price());
        self.ring.cross(x, y)
    }

    /// The products of a vector and each axis.
    fn on_axes(&self, [x, y, z]: &Vector<R>) -> [Result<Vector<R>, Larger>; 3] {
        let zero = R::Element::default;
        let plus = |x: &R::Element| match &self.rounding {
            Some(Rounding { length, .. }) => self.ring.times(x, length),
            None => Ok(x.clone()),
        };
        let minus = |x| self.ring.minus(&zero(), &plus(x)?);
        let functional = |[x, y, z]: [Result<R::Element, Larger>; 3]| Ok([x?, y?, z?]);
        [
            functional([Ok(zero()), plus(z), minus(y)]),
            functional([minus(z), Ok(zero()), plus(x)]),
            functional([plus(y), minus(x), Ok(zero())]),
        ]
    }

    fn edges(&self, [a, b, c]: &Triangle<R>) -> Result<[Vector<R>; 3], Larger> {
        let to = |x, y| self.ring.difference(x, y);
        Ok([to(a, b)?, to(b, c)?, to(c, a)?])
    }
}
