//! The 543 cells of the 600-cell without a vertex of one cell, placed in a tetrahedron.
//!
//! A vertex is named by its inner products with the four vertices of the missing cell: its *place*.
//! The permutations of the four vertices are symmetries, and permute the entries of places.
//! A point is an average of the four corners of the tetrahedron, with weights that are permuted along
//! with places. So one row of a table places an orbit.

use super::without;
use crate::CatalogError;
use acutile_exact::geometry::cell600::{self, Golden};
use std::collections::HashMap;

/// The weights of a point sum to this.
pub const UNIT: i64 = 96_000;

/// For each vertex of the missing cell the rank of its inner product with the vertex, from -4 to 4.
pub type Place = [i8; 4];

/// A point in numerators over [`UNIT`].
pub type Point = [i64; 3];

/// An orbit of vertices: the place of one of them, and its weights at the corners, which sum to [`UNIT`].
pub struct Orbit {
    pub place: Place,
    pub weights: [i64; 4],
}

/// Which permutations of the corners are symmetries.
#[derive(Clone, Copy)]
pub enum Symmetry {
    All,
    /// Those that keep corner 0.
    KeepFirst,
}

/// The cells, each corner by its place.
pub fn cells() -> Result<Vec<[Place; 4]>, CatalogError> {
    let vertices = cell600::vertices();
    let missing = cell600::cells()[0];
    let place = |vertex: usize| {
        let mut place = [0; 4];
        for (rank, corner) in place.iter_mut().zip(missing) {
            *rank = rank_of(cell600::inner(&vertices[vertex], &vertices[corner]))?;
        }
        Some(place)
    };
    let places = |cell: [usize; 4]| {
        let [a, b, c, d] = cell.map(place);
        Some([a?, b?, c?, d?])
    };
    let cells = without(&missing).into_iter().map(places);
    cells.collect::<Option<_>>().ok_or(CatalogError::Degenerate)
}

/// The rank of an inner product of two vertices among the nine that occur.
pub(super) fn rank_of(product: Golden) -> Option<i8> {
    const POSITIVE: [Golden; 5] = [[0, 0], [-2, 2], [2, 0], [0, 2], [4, 0]];
    let find = |product: Golden| (0..).zip(POSITIVE).find(|(_, known)| *known == product);
    match find(product) {
        Some((rank, _)) => Some(rank),
        None => find(product.map(|x| -x)).map(|(rank, _): (i8, _)| -rank),
    }
}

/// The tetrahedra of a piece with these corners.
pub fn tetrahedra(
    cells: &[[Place; 4]],
    table: &[Orbit],
    symmetry: Symmetry,
    corners: [[i64; 3]; 4],
) -> Result<Vec<[Point; 4]>, CatalogError> {
    let weights = weights(table, symmetry);
    let point = |place: &Place| -> Result<Point, CatalogError> {
        let weights = weights
            .get(place)
            .ok_or(CatalogError::NoOrbit(place.to_vec()))?;
        let sum = |axis: usize| (0..4).map(|k| weights[k] * corners[k][axis]).sum();
        Ok([0, 1, 2].map(sum))
    };
    let tetrahedron = |cell: &[Place; 4]| {
        let [a, b, c, d] = cell.each_ref().map(point);
        Ok([a?, b?, c?, d?])
    };
    cells.iter().map(tetrahedron).collect()
}

/// The weights of all places of the orbits.
fn weights(table: &[Orbit], symmetry: Symmetry) -> HashMap<Place, [i64; 4]> {
    let mut weights = HashMap::new();
    for orbit in table {
        debug_assert_eq!(orbit.weights.iter().sum::<i64>(), UNIT);
        for order in orders(symmetry) {
            weights.insert(
                order.map(|k| orbit.place[k]),
                order.map(|k| orbit.weights[k]),
            );
        }
    }
    weights
}

fn orders(symmetry: Symmetry) -> Vec<[usize; 4]> {
    let codes = (0..256).map(|code| [0, 2, 4, 6].map(|shift| code >> shift & 3));
    let is_order = |order: &[usize; 4]| (0..4).all(|k| order.contains(&k));
    let is_symmetry = |order: &[usize; 4]| match symmetry {
        Symmetry::All => true,
        Symmetry::KeepFirst => order[0] == 0,
    };
    codes
        .filter(|order| is_order(order) && is_symmetry(order))
        .collect()
}
