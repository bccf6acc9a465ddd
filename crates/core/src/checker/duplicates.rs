//! Simplices with the same corners, up to the lattice.

use super::defect::Defect;
use super::findings::Findings;
use crate::tiling::{Corner, SimplexId, Tiling, VertexId, difference};
use std::collections::{BTreeMap, BTreeSet};

/// Reports each set of simplices with the same corners; gives all but the first of each set.
pub(super) fn check_duplicates<const D: usize>(
    tiling: &Tiling<D>,
    findings: &mut Findings,
) -> BTreeSet<SimplexId> {
    let mut surplus = BTreeSet::new();
    for simplices in duplicates(tiling) {
        surplus.extend(simplices[1..].iter().copied());
        findings.add(Defect::Duplicates { simplices });
    }
    surplus
}

/// Simplices whose sorted vertices have the same sum are compared by their corners.
fn duplicates<const D: usize>(tiling: &Tiling<D>) -> Vec<Vec<SimplexId>> {
    let key = |corners: &[Corner<D>]| {
        let vertices = corners
            .iter()
            .map(|corner| u64::from(corner.vertex.number()));
        let mixed = vertices.map(|v| (v + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ v << 7);
        mixed.fold(0u64, u64::wrapping_add)
    };
    let mut keys: Vec<(u64, SimplexId)> = tiling
        .indices()
        .zip(tiling.simplices())
        .map(|(simplex, corners)| (key(corners), simplex))
        .collect();
    keys.sort_unstable();
    let mut sets = Vec::new();
    for alike in keys.chunk_by(|a, b| a.0 == b.0).filter(|run| run.len() > 1) {
        let mut by_form: BTreeMap<Vec<(VertexId, [i32; D])>, Vec<SimplexId>> = BTreeMap::new();
        for &(_, simplex) in alike {
            let form = normal_form(tiling.simplex(simplex));
            by_form.entry(form).or_default().push(simplex);
        }
        sets.extend(by_form.into_values().filter(|set| set.len() > 1));
    }
    sets.sort();
    sets
}

/// The corners sorted, moved so that the first has no shift.
fn normal_form<const D: usize>(corners: &[Corner<D>]) -> Vec<(VertexId, [i32; D])> {
    let mut form: Vec<_> = corners.iter().map(|c| (c.vertex, c.shift)).collect();
    form.sort_unstable();
    let origin = form.first().map_or([0; D], |first| first.1);
    for (_, shift) in &mut form {
        *shift = difference(*shift, origin);
    }
    form
}
