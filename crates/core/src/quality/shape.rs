//! Congruence classes of simplices.
//!
//! Two simplices are congruent exactly when their corners can be numbered so that
//! all squared edge lengths agree. The normal form is the smallest list of squared
//! edge lengths over all numberings, compared exactly.

use crate::tiling::{SimplexId, Tiling};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use std::collections::BTreeMap;

/// A congruence class of simplices.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Squared lengths of the edges 01, 02, …, 0D, 12, … of its normal form.
    pub squared_edges: Vec<Number>,
    /// The simplices of this class, by index.
    pub members: Vec<SimplexId>,
}

/// The congruence classes of the simplices, in the order of their first members.
pub fn shapes<const D: usize>(tiling: &Tiling<D>) -> Vec<Shape> {
    let numberings = permutations(D + 1);
    let mut classes: BTreeMap<Vec<Number>, Vec<SimplexId>> = BTreeMap::new();
    let mut normal_forms: BTreeMap<Vec<Number>, Vec<Number>> = BTreeMap::new();
    for simplex in tiling.indices() {
        let edges = squared_edges(tiling, simplex);
        let form = normal_forms
            .entry(edges)
            .or_insert_with_key(|edges| normal_form(edges, D + 1, &numberings));
        classes.entry(form.clone()).or_default().push(simplex);
    }
    let mut shapes: Vec<Shape> = classes
        .into_iter()
        .map(|(squared_edges, members)| Shape {
            squared_edges,
            members,
        })
        .collect();
    shapes.sort_by_key(|shape| shape.members[0]);
    shapes
}

/// The index of the class of each of `count` simplices.
pub fn kinds(shapes: &[Shape], count: usize) -> Vec<usize> {
    let mut kinds = vec![0; count];
    for (kind, shape) in shapes.iter().enumerate() {
        for member in &shape.members {
            kinds[member.index()] = kind;
        }
    }
    kinds
}

/// Squared lengths of the edges 01, 02, …, 12, … of a simplex.
pub fn squared_edges<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> Vec<Number> {
    let corners: Vec<[Number; D]> = tiling
        .simplex(simplex)
        .iter()
        .map(|corner| tiling.position(corner))
        .collect();
    let mut squares = Vec::new();
    for (i, a) in corners.iter().enumerate() {
        for b in &corners[i + 1..] {
            squares.push(linear::square(&tiling.frame.gram, &linear::subtract(b, a)));
        }
    }
    squares
}

/// The normal form of a simplex with this number of corners and these squared edges 01, 02, …:
/// equal exactly for congruent simplices.
pub fn congruence_form(edges: &[Number], corners: usize) -> Vec<Number> {
    normal_form(edges, corners, &permutations(corners))
}

fn normal_form(edges: &[Number], corners: usize, numberings: &[Vec<usize>]) -> Vec<Number> {
    let index = |i: usize, j: usize| {
        let (low, high) = (i.min(j), i.max(j));
        low * (2 * corners - low - 1) / 2 + (high - low - 1)
    };
    let renumbered = |order: &Vec<usize>| -> Vec<Number> {
        (0..corners)
            .flat_map(|i| (i + 1..corners).map(move |j| (i, j)))
            .map(|(i, j)| edges[index(order[i], order[j])].clone())
            .collect()
    };
    numberings.iter().map(renumbered).min().unwrap_or_default()
}

/// All permutations of 0, …, n - 1.
pub fn permutations(n: usize) -> Vec<Vec<usize>> {
    (0..n).fold(vec![Vec::new()], |shorter, last| {
        shorter
            .iter()
            .flat_map(|order: &Vec<usize>| {
                (0..=order.len()).map(move |place| {
                    let mut longer = order.clone();
                    longer.insert(place, last);
                    longer
                })
            })
            .collect()
    })
}
