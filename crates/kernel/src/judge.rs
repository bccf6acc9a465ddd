//! The checks of one simplex, in the order of the statements.
//!
//! A check decides by the numbers of [`crate::rules`]. Where the products of a comparison do not
//! fit, the comparison alone is made with larger integers.

use crate::refusal::{Checked, Place, Value};
use crate::ring::{Ring, Vector, each};
use crate::rules::{Angle, Rules, Sphere};
use std::cmp::Ordering::{Equal, Greater, Less};

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
    ) -> Checked<(R::Element, u32)> {
        let (rules, ring) = (self.rules, &self.rules.ring);
        let normals = rules.normals(edges)?;
        let determinant = ring.inner(&edges[0], &normals[0])?;
        // Rule O: det E > 0.
        let is_positive = ring.sign(&determinant)? == Greater;
        ensure!(is_positive, Orientation, Place::Simplex(simplex), ring.value(&determinant));
        let mut attained = 0;
        if rules.acute || rules.nonobtuse || !rules.angles.is_empty() {
            attained |= self.check_angles(&rules.angles(&normals)?, simplex)?;
        }
        if !rules.ratios.is_empty() || rules.needs_mates() {
            let sphere = rules.sphere(edges, &normals, &determinant)?;
            attained |= self.check_ratios(&sphere, simplex)?;
            for (mate, facet) in mates.iter().zip(0..) {
                if let Some(mate) = mate {
                    self.check_mate(&sphere, mate, Place::Facet(simplex, facet))?;
                }
            }
        }
        Ok((determinant, attained))
    }

    /// The result, or the one with larger integers where it does not fit.
    fn or_next<V>(&self, found: Checked<V>, again: impl FnOnce(&Rules<R::Next>) -> Checked<V>) -> Checked<V> {
        match (found, self.next) {
            (Err(stop), Some(next)) if stop.is_larger() => again(next),
            (found, _) => found,
        }
    }

    fn check_angles(&self, angles: &[Angle<R>; 6], simplex: u64) -> Checked<u32> {
        let rules = self.rules;
        let angles = || angles.iter().take(if rules.is_plane { 3 } else { 6 });
        let place = |angle: &Angle<R>| Place::Angle(simplex, angle.facets.0, angle.facets.1);
        for angle in angles() {
            // `acute`: the cosine is positive. `nonobtuse`: it is not negative.
            let is_acute = !rules.acute || angle.sign == Greater;
            ensure!(is_acute, NotAcute, place(angle), self.value(angle)?);
            let is_nonobtuse = !rules.nonobtuse || angle.sign != Less;
            ensure!(is_nonobtuse, NotNonobtuse, place(angle), self.value(angle)?);
        }
        let mut attained = 0;
        for (bound, index) in rules.angles.iter().zip(0..) {
            let mut found = None;
            for angle in angles() {
                let ordering = rules.compare_angle(angle, index);
                let ordering = self.or_next(ordering, |next| {
                    next.compare_angle(
                        &next.angle(angle.facets, R::next(&angle.c), &R::next(&angle.x), &R::next(&angle.y))?,
                        index,
                    )
                })?;
                // The largest angle compares as the largest of all orderings does, and so on.
                let is_first =
                    found.is_none_or(|(first, _)| if bound.is_smallest { ordering < first } else { ordering > first });
                if is_first {
                    found = Some((ordering, angle));
                }
            }
            if let Some((ordering, angle)) = found {
                let is_allowed = bound.relation.allows(ordering);
                ensure!(is_allowed, AngleBound, place(angle), self.value(angle)?);
                attained |= u32::from(ordering == Equal) << bound.statement;
            }
        }
        Ok(attained)
    }

    /// c² / (x y), with the sign of the cosine.
    #[cold]
    fn value(&self, angle: &Angle<R>) -> Checked<Value> {
        let [mut square, lengths] = angle.squares.clone()?;
        if angle.sign == Less {
            square = self.rules.ring.minus(&R::Element::default(), &square)?;
        }
        Ok(self.rules.ring.quotient(&square, &lengths))
    }

    fn check_ratios(&self, sphere: &Sphere<R>, simplex: u64) -> Checked<u32> {
        let rules = self.rules;
        let mut attained = 0;
        for (bound, index) in rules.ratios.iter().zip(0..) {
            let ordering = rules.compare_ratio(sphere, index);
            let ordering = self.or_next(ordering, |next| next.compare_ratio(&sphere.next(), index))?;
            let value = || rules.ratio(sphere).map(|[x, y]| rules.ring.quotient(&x, &y));
            let is_allowed = bound.relation.allows(ordering);
            ensure!(is_allowed, RatioBound, Place::Simplex(simplex), value()?);
            attained |= u32::from(ordering == Equal) << bound.statement;
        }
        Ok(attained)
    }

    /// `Delaunay`: a mate's corner outside of the common facet is outside of the circumsphere;
    /// `weakly Delaunay`: it is not inside. The difference of the powers of two spheres through
    /// the common facet is an affine function that is zero on the facet. The two other corners are
    /// on different sides of it. So the condition says the same from both sides.
    fn check_mate(&self, sphere: &Sphere<R>, x: &Vector<R>, place: Place) -> Checked {
        let rules = self.rules;
        let sign = rules.power(sphere, x).and_then(|power| rules.ring.sign(&power));
        let sign =
            self.or_next(sign, |next| next.ring.sign(&next.power(&sphere.next(), &each(x, |x| Ok(R::next(x)))?)?))?;
        let power = || rules.power(sphere, x);
        let value = || power().map(|power| rules.ring.quotient(&power, &sphere.determinant));
        ensure!(!rules.delaunay || sign == Greater, NotDelaunay, place, value()?);
        ensure!(!rules.weakly_delaunay || sign != Less, NotWeaklyDelaunay, place, value()?);
        Ok(())
    }
}

impl<R: Ring> Sphere<R> {
    fn next(&self) -> Sphere<R::Next> {
        Sphere {
            centre: self.centre.each_ref().map(R::next),
            determinant: R::next(&self.determinant),
            shortest: R::next(&self.shortest),
        }
    }
}
