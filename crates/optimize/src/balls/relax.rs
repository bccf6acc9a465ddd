//! Vertices in the middle of their neighbours, after Tutte, with the corners of a polyhedron fixed.
//!
//! A vertex in an edge has its neighbours in the edge, one in a face those in the boundary, and one inside all.
//! In a face this is an embedding (Tutte 1963); inside it need not be one.

use super::remains::{Edge, Remains};
use std::collections::BTreeMap;

type Point = [f64; 3];

/// The number of rounds. Each moves every vertex once.
const ROUNDS: usize = 2_000;

/// Moves all vertices that are in fewer than three faces. `faces_at` has the faces of each vertex of the boundary.
pub fn relax(
    remains: &Remains,
    faces_at: &BTreeMap<usize, Vec<usize>>,
    points: &mut BTreeMap<usize, Point>,
) {
    let free = |count: usize| {
        let number = move |vertex: usize| faces_at.get(&vertex).map_or(0, Vec::len);
        move |vertex: &usize| number(*vertex) == count
    };
    settle(remains.ridges(), free(2), points);
    settle(remains.edges.keys(), free(1), points);
    settle(remains.valences.keys(), free(0), points);
}

/// Moves the vertices that are free along these edges.
fn settle<'e>(
    edges: impl Iterator<Item = &'e Edge>,
    is_free: impl Fn(&usize) -> bool,
    points: &mut BTreeMap<usize, Point>,
) {
    let mut neighbours: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for &(a, b) in edges {
        for (from, to) in [(a, b), (b, a)] {
            if is_free(&from) {
                neighbours.entry(from).or_default().push(to);
            }
        }
    }
    for _ in 0..ROUNDS {
        for (vertex, around) in &neighbours {
            let share = 1.0 / around.len() as f64;
            let sum = |k: usize| around.iter().map(|v| points[v][k]).sum::<f64>();
            let middle = [0, 1, 2].map(|k| share * sum(k));
            points.insert(*vertex, middle);
        }
    }
}
