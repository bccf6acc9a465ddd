//! Simplices beyond a threshold of quality, in tilings that need not be valid.

use super::findings::Findings;
use super::statements::{list_not_above, list_not_below, list_not_below_ratio};
use crate::predicates::Model;
use crate::statement::Requirement;
use crate::tiling::{SimplexId, Tiling};

/// The defects of the simplices that do not fulfil `dihedral<B`, `dihedral>B` or `radius-edge<B`. The
/// simplices in `left_out` are flat or negatively oriented, and have no angles. The indices of
/// the defects are those in the second list.
pub fn offenders<const D: usize>(
    tiling: &Tiling<D>,
    left_out: &[SimplexId],
    requirements: &[Requirement],
    limit: usize,
) -> (Findings, Vec<SimplexId>) {
    let mut findings = Findings::new(limit);
    if requirements.is_empty() {
        return (findings, Vec::new());
    }
    let (part, kept) = tiling.without(left_out);
    if part.is_empty() {
        return (findings, kept);
    }
    let model = Model::new(&part);
    for requirement in requirements {
        match requirement {
            Requirement::DihedralBelow(bound) => list_not_below(&model, bound, &mut findings),
            Requirement::DihedralAbove(bound) => list_not_above(&model, bound, &mut findings),
            Requirement::RadiusEdgeBelow(bound) => {
                list_not_below_ratio(&model, bound, &mut findings);
            }
            _ => {}
        }
    }
    (findings, kept)
}
