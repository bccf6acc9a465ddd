//! Sets of boundary facets that lie against each other, and the two sides of each.

use super::meeting::{Meeting, Region};
use crate::anatomy::Union;
use crate::tiling::Corner;
use acutile_exact::geometry::Scalar;
use std::collections::{BTreeMap, BTreeSet};

/// Sets of facets that lie against each other, through pairs and through common ridges.
pub(super) struct Interfaces(Union);

impl Interfaces {
    pub fn of<S: Scalar, const D: usize>(region: &Region<S, D>, pairs: &[Meeting<D>]) -> Self {
        let mut union = Union::new(region.boundary.len());
        let facets = pairs.iter().map(|pair| pair.facets);
        let involved: BTreeSet<usize> = facets.flat_map(|(f, g)| [f, g]).collect();
        let mut at_ridge: BTreeMap<Vec<Corner<D>>, usize> = BTreeMap::new();
        for &facet in &involved {
            for ridge in region.boundary[facet].ridges() {
                match at_ridge.get(&ridge) {
                    Some(&other) => union.join(facet, other),
                    None => drop(at_ridge.insert(ridge, facet)),
                }
            }
        }
        for pair in pairs {
            union.join(pair.facets.0, pair.facets.1);
        }
        Interfaces(union)
    }

    pub fn groups<const D: usize>(&mut self, pairs: &[Meeting<D>]) -> Vec<Vec<Meeting<D>>> {
        let mut groups: BTreeMap<usize, Vec<Meeting<D>>> = BTreeMap::new();
        for &pair in pairs {
            let group = groups.entry(self.0.first(pair.facets.0)).or_default();
            group.push(pair);
        }
        groups.into_values().collect()
    }
}

/// The facets of an interface by side: facets of a pair are on different sides, and facets with a common
/// ridge on the same one.
pub(super) fn two_sides<S: Scalar, const D: usize>(
    region: &Region<S, D>,
    pairs: &[Meeting<D>],
) -> [Vec<usize>; 2] {
    let mut opposite: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (f, g) in pairs.iter().map(|pair| pair.facets) {
        opposite.entry(f).or_default().push(g);
        opposite.entry(g).or_default().push(f);
    }
    let mut at_ridge: BTreeMap<Vec<Corner<D>>, Vec<usize>> = BTreeMap::new();
    for &facet in opposite.keys() {
        for ridge in region.boundary[facet].ridges() {
            at_ridge.entry(ridge).or_default().push(facet);
        }
    }
    let mut side: BTreeMap<usize, usize> = BTreeMap::new();
    for &start in opposite.keys() {
        if side.contains_key(&start) {
            continue;
        }
        side.insert(start, 0);
        let mut waiting = vec![start];
        while let Some(facet) = waiting.pop() {
            let here = side[&facet];
            let across = opposite[&facet].iter().map(|&other| (other, 1 - here));
            let ridges = region.boundary[facet].ridges();
            let beside = ridges.flat_map(|ridge| at_ridge[&ridge].clone());
            for (other, there) in across.chain(beside.map(|other| (other, here))) {
                if side
                    .insert(other, side.get(&other).copied().unwrap_or(there))
                    .is_none()
                {
                    waiting.push(other);
                }
            }
        }
    }
    let of = |wanted: usize| {
        let on_side = side.iter().filter(move |(_, side)| **side == wanted);
        on_side.map(|(facet, _)| *facet).collect()
    };
    [of(0), of(1)]
}
