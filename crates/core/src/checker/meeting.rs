//! A region with its boundary facets, and the places where they should not meet.

use super::boundary::{BoundaryFacet, Scale};
use super::shared::Shared;
use crate::tiling::{Matching, SimplexId, Tiling};
use acutile_exact::geometry::Scalar;

/// A region and its boundary facets.
pub(super) struct Region<'t, S, const D: usize> {
    pub tiling: &'t Tiling<D>,
    pub scale: Scale<'t, S, D>,
    pub boundary: Vec<BoundaryFacet<D>>,
    pub shared: Shared,
}

impl<'t, S: Scalar, const D: usize> Region<'t, S, D> {
    pub fn new(tiling: &'t Tiling<D>, matching: &Matching<D>, scale: Scale<'t, S, D>) -> Self {
        let used_once = matching.mismatches.iter().filter(|m| m.uses.len() == 1);
        let boundary = used_once.map(|m| BoundaryFacet::new(tiling, m.uses[0].0));
        Region {
            tiling,
            scale,
            boundary: boundary.collect(),
            shared: Shared::of(matching),
        }
    }
}

/// The findings of the checks of a region.
pub(super) struct Found<const D: usize> {
    /// Pairs of boundary facets that meet where they should not.
    pub meeting: Vec<Meeting<D>>,
    /// Boundary facets, by their indices, with the simplices directly outside, moved by lattice vectors.
    pub covered: Vec<CoveredFacet<D>>,
}

/// A boundary facet, by its index, and the simplices directly outside.
pub(super) type CoveredFacet<const D: usize> = (usize, Vec<(SimplexId, [i32; D])>);

/// Two boundary facets, by their indices, the second moved by a lattice vector.
#[derive(Clone, Copy)]
pub(super) struct Meeting<const D: usize> {
    pub facets: (usize, usize),
    pub by: [i32; D],
}
