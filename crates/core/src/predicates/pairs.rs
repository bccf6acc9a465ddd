//! The in-sphere predicate for all pairs of neighbours of a tiling.

use super::model::Prepared;
use super::polynomials::InSphere;
use crate::tiling::Matching;
use acutile_exact::geometry::Sign;

impl<const D: usize> Prepared<'_, InSphere, D> {
    /// The simplices, in order, that fail with a neighbour: for which
    /// `is_right(simplex, neighbour, sign)` is false, where `sign` is that of the power of the
    /// neighbour's opposite corner with respect to the simplex's circumsphere.
    ///
    /// Each pair of neighbours is tested from one side. Let p and q be the powers of a point
    /// with respect to the circumspheres of A and B, with apexes a and b over the common facet.
    /// p - q is affine and vanishes on the facet: p - q = c h for an affine h that is positive on
    /// the side of A. Then p(b) = c h(b) and q(a) = -c h(a), as q(b) = p(a) = 0, and both have
    /// the sign of -c, because b is on the other side.
    pub fn failing_pairs(
        &self,
        matching: &Matching<D>,
        is_right: impl Fn(usize, usize, Sign) -> bool + Sync,
    ) -> Vec<usize> {
        let tiling = self.model.tiling;
        let failing = self.model.by_chunks(|simplices| {
            let facets = simplices.flat_map(|simplex| (0..=D).map(move |k| (simplex, k)));
            let pairs = facets.filter_map(|(simplex, opposite)| {
                let mate = matching.neighbour(simplex, opposite)?;
                let neighbour = mate.simplex as usize;
                let is_first = (simplex, opposite) < (neighbour, usize::from(mate.opposite));
                let apex = is_first.then(|| matching.apex(tiling, simplex, opposite))??;
                Some(((simplex, neighbour), apex))
            });
            let mut failing = Vec::new();
            self.for_each_with(pairs, |(simplex, neighbour), signs| {
                if !is_right(simplex, neighbour, signs.get(0)) {
                    failing.push(simplex);
                }
            });
            failing
        });
        failing.concat()
    }
}
