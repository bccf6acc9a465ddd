//! The in-sphere predicate for all pairs of neighbours of a tiling.

use super::model::Prepared;
use super::polynomials::InSphere;
use crate::tiling::{Facet, Matching, SimplexId};
use acutile_exact::geometry::Sign;

impl<const D: usize> Prepared<'_, InSphere, D> {
    /// The simplices, in order, that fail with a neighbour: those for which `is_right(simplex, neighbour,
    /// sign)` is false. Here `sign` is that of the power of the neighbour's opposite corner with respect to
    /// the simplex's circumsphere.
    ///
    /// Each pair of neighbours is tested from one side. Let p and q be the powers of a point with respect
    /// to the circumspheres of A and B, with apexes a and b over the common facet. The function p - q is
    /// affine and vanishes on the facet. So p - q = c h for an affine h that is positive on the side of A.
    /// Then p(b) = c h(b) and q(a) = -c h(a), as q(b) = p(a) = 0, and both have the sign of -c, because b
    /// is on the other side.
    pub fn failing_pairs(
        &self,
        matching: &Matching<D>,
        is_right: impl Fn(SimplexId, SimplexId, Sign) -> bool + Sync,
    ) -> Vec<SimplexId> {
        let tiling = self.model.tiling;
        let failing = self.model.by_chunks(|simplices| {
            let simplices = simplices.map(SimplexId::at);
            let facets = simplices.flat_map(|s| (0..=D).map(move |k| Facet::new(s, k)));
            let pairs = facets.filter_map(|facet| {
                let mate = matching.neighbour(facet)?;
                let apex = (facet < mate).then(|| matching.apex(tiling, facet))??;
                Some(((facet.simplex, mate.simplex), apex))
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
