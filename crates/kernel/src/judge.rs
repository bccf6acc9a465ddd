//! The checks of one simplex, in the order of the statements.
//!
//! A check decides by the numbers of [`crate::rules`]. Where the products of a comparison do not
//! fit, the comparison alone is made with larger integers.

use crate::refusal::{Larger, Place, Stop, Value};
use crate::ring::{Ring, Vector, each};
use crate::rules::{Angle, Bound, Found, Rules, Sphere};
use std::cmp::Ordering::{self, Equal, Greater, Less};

/// The rules in one ring, and in the next larger one for the comparisons that need it.
pub(crate) struct Judge<'r, R: Ring> {
    pub(crate) rules: &'r Rules<R>,
    pub(crate) next: Option<&'r Rules<R::Next>>,
}

impl<R: Ring> Judge<'_, R> {
    /// Checks everything that is claimed of one simplex and of the corners of its mates, all seen
    /// from its first corner. Returns its determinant and the set of the bounds that it attains.
    pub(crate) fn check(
        &self,
        edges: &[Vector<R>; 3],
        mates: &[Option<Vector<R>>; 4],
        simplex: u64,
    ) -> Result<(R::Element, u32), Stop> {
        let ring = &self.rules.ring;
        let normals = self.rules.normals(edges)?;
        let determinant = ring.inner(&edges[0], &normals[0])?;
        // Rule O: det E > 0.
        let value = || Value::Quotient(ring.coefficients(&determinant), vec![1.into()]);
        let is_positive = ring.sign(&determinant)? == Greater;
        ensure!(is_positive, Orientation, Place::Simplex(simplex), value());
        let mut attained = 0;
        if self.rules.acute || self.rules.nonobtuse || !self.rules.angles.is_empty() {
            attained |= self.check_angles(&normals, simplex)?;
        }
        if !self.rules.ratios.is_empty() || self.rules.needs_mates() {
            let sphere = self.rules.sphere(edges, &normals)?;
            if !self.rules.ratios.is_empty() {
                attained |= self.check_ratios(&sphere, &determinant, simplex)?;
            }
            for (facet, mate) in mates.iter().enumerate() {
                if let Some(mate) = mate {
                    self.check_mate(&sphere, &determinant, mate, Place::Facet(simplex, facet))?;
                }
            }
        }
        Ok((determinant, attained))
    }

    /// The determinant, without further checks, where the products of three edges may not fit.
    pub(crate) fn determinant(
        &self,
        edges: &[Vector<R>; 3],
    ) -> Result<<R::Next as Ring>::Element, Larger> {
        let normal = self.rules.first_normal(edges)?;
        match (self.rules.ring.inner(&edges[0], &normal), &self.next) {
            (Err(Larger), Some(next)) => {
                let (edge, normal) = (edges[0].each_ref(), normal.each_ref());
                next.ring.inner(&edge.map(R::next), &normal.map(R::next))
            }
            (determinant, _) => determinant.map(|determinant| R::next(&determinant)),
        }
    }

    #[inline(always)]
    fn check_angles(&self, normals: &[Vector<R>; 3], simplex: u64) -> Result<u32, Stop> {
        let angles = self.rules.angles(normals)?;
        let count = if self.rules.is_plane { 3 } else { 6 };
        let mut signs = [Equal; 6];
        for (angle, sign) in angles.iter().zip(&mut signs).take(count) {
            *sign = self.rules.ring.sign(&angle.c)?;
            let place = Place::Angle(simplex, angle.facets.0, angle.facets.1);
            // `acute`: the cosine is positive. `nonobtuse`: it is not negative.
            let is_acute = !self.rules.acute || *sign == Greater;
            ensure!(is_acute, NotAcute, place, self.rules.squared_cosine(angle)?);
            let is_nonobtuse = !self.rules.nonobtuse || *sign != Less;
            ensure!(
                is_nonobtuse,
                NotNonobtuse,
                place,
                self.rules.squared_cosine(angle)?
            );
        }
        let mut found = Found::default();
        if !self.rules.angles.is_empty() {
            for (angle, sign) in angles.iter().zip(signs).take(count) {
                found.join(self.compare_angle(angle, sign)?);
            }
        }
        let mut attained = 0;
        for bound in &self.rules.angles {
            // The largest angle is more than the bound if some angle is; the smallest angle is
            // less than the bound if some angle is.
            let ordering = if bound.is_largest && found.greater & bound.bit != 0 {
                Greater
            } else if !bound.is_largest && found.less & bound.bit != 0 {
                Less
            } else if found.equal & bound.bit != 0 {
                Equal
            } else if bound.is_largest {
                Less
            } else {
                Greater
            };
            let is_allowed = bound.relation.allows(ordering);
            if !is_allowed {
                let (place, value) = self.witness(&angles, bound, ordering, simplex)?;
                ensure!(is_allowed, AngleBound, place, value);
            }
            attained |= if ordering == Equal { bound.bit } else { 0 };
        }
        Ok(attained)
    }

    /// An angle that compares like this with the bound, and its squared cosine.
    #[cold]
    fn witness(
        &self,
        angles: &[Angle<R>; 6],
        bound: &Bound<R::Element>,
        ordering: Ordering,
        simplex: u64,
    ) -> Result<(Place, Value), Larger> {
        for angle in angles.iter().take(if self.rules.is_plane { 3 } else { 6 }) {
            let mut expected = Found::default();
            expected.add(ordering, bound.bit);
            let found = self.compare_angle(angle, self.rules.ring.sign(&angle.c)?)?;
            if found.less & expected.less
                | found.equal & expected.equal
                | found.greater & expected.greater
                != 0
            {
                let place = Place::Angle(simplex, angle.facets.0, angle.facets.1);
                return Ok((place, self.rules.squared_cosine(angle)?));
            }
        }
        Ok((Place::Simplex(simplex), Value::Nothing))
    }

    /// How an angle compares with the bounds.
    #[inline(always)]
    fn compare_angle(&self, angle: &Angle<R>, sign: Ordering) -> Result<Found, Larger> {
        let found = self
            .rules
            .compare_squares(sign, &angle.c, &angle.x, &angle.y);
        self.or_next(found, |next| {
            let (c, x, y) = (R::next(&angle.c), R::next(&angle.x), R::next(&angle.y));
            next.compare_squares(sign, &c, &x, &y)
        })
    }

    /// The result, or the one with larger integers where it does not fit.
    #[inline(always)]
    fn or_next<V>(
        &self,
        found: Result<V, Larger>,
        again: impl FnOnce(&Rules<R::Next>) -> Result<V, Larger>,
    ) -> Result<V, Larger> {
        match (found, &self.next) {
            (Err(Larger), Some(next)) => again(next),
            (found, _) => found,
        }
    }

    #[inline(always)]
    fn check_ratios(
        &self,
        sphere: &Sphere<R>,
        determinant: &R::Element,
        simplex: u64,
    ) -> Result<u32, Stop> {
        let found = self.rules.compare_ratios(sphere, determinant);
        let found = self.or_next(found, |next| {
            next.compare_ratios(&sphere.next(), &R::next(determinant))
        })?;
        for bound in &self.rules.ratios {
            let ordering = if found.less & bound.bit != 0 {
                Less
            } else if found.equal & bound.bit != 0 {
                Equal
            } else {
                Greater
            };
            let is_allowed = bound.relation.allows(ordering);
            if !is_allowed {
                let [radius, length] = self.rules.ratio(sphere, determinant)?;
                let [p, q] = [radius, length].map(|value| self.rules.ring.coefficients(&value));
                let value = Value::Quotient(p, q);
                ensure!(is_allowed, RatioBound, Place::Simplex(simplex), value);
            }
        }
        Ok(found.equal)
    }

    /// `Delaunay`: a mate's corner outside of the common facet is outside of the circumsphere;
    /// `weakly Delaunay`: it is not inside. The difference of the powers of two spheres through
    /// the common facet is an affine function that is zero on the facet. The two other corners are
    /// on different sides of it. So the condition says the same from both sides.
    #[inline(always)]
    fn check_mate(
        &self,
        sphere: &Sphere<R>,
        determinant: &R::Element,
        x: &Vector<R>,
        place: Place,
    ) -> Result<(), Stop> {
        let ring = &self.rules.ring;
        let found = self.rules.power(sphere, determinant, x);
        let sign = self.or_next(found.and_then(|power| ring.sign(&power)), |next| {
            let x = each(x, |x| Ok(R::next(x)))?;
            let power = next.power(&sphere.next(), &R::next(determinant), &x)?;
            next.ring.sign(&power)
        })?;
        let value = || -> Result<Value, Larger> {
            let power = self.rules.power(sphere, determinant, x)?;
            let [p, q] = [&power, determinant].map(|value| ring.coefficients(value));
            Ok(Value::Quotient(p, q))
        };
        let is_outside = !self.rules.delaunay || sign == Greater;
        ensure!(is_outside, NotDelaunay, place, value()?);
        let is_not_inside = !self.rules.weakly_delaunay || sign != Less;
        ensure!(is_not_inside, NotWeaklyDelaunay, place, value()?);
        Ok(())
    }
}
