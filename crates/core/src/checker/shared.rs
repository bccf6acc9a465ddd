//! Simplices that lie on one side of a common facet. They overlap, and what their other facets do to each
//! other is a consequence.

use crate::tiling::{Matching, SimplexId};
use std::collections::{BTreeMap, BTreeSet};

/// For each simplex the facets that it has on the same side as another simplex, by the index of the
/// mismatch, and the side.
#[derive(Default)]
pub(super) struct Shared(BTreeMap<SimplexId, BTreeSet<(usize, bool)>>);

impl Shared {
    pub fn of<const D: usize>(matching: &Matching<D>) -> Self {
        let mut shared = Shared::default();
        for (index, mismatch) in matching.mismatches.iter().enumerate() {
            for side in [false, true] {
                let uses = mismatch.uses.iter().filter(|(_, of)| *of == side);
                let simplices: Vec<SimplexId> = uses.map(|(facet, _)| facet.simplex).collect();
                for simplex in simplices.iter().filter(|_| simplices.len() > 1) {
                    shared.0.entry(*simplex).or_default().insert((index, side));
                }
            }
        }
        shared
    }

    /// Whether two different simplices lie on one side of a common facet.
    pub fn is_between(&self, s: SimplexId, t: SimplexId) -> bool {
        match (self.0.get(&s), self.0.get(&t)) {
            (Some(s_facets), Some(t_facets)) => s != t && !s_facets.is_disjoint(t_facets),
            _ => false,
        }
    }
}
