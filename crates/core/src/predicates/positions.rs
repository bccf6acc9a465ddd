//! A tiling from simplices that are given by the positions of their corners, oriented by exact signs.

use super::{Model, Orientation};
use crate::tiling::{Corner, Frame, Tiling};
use acutile_exact::number::Number;
use std::collections::BTreeMap;

impl<const D: usize> Tiling<D> {
    /// The tiling of these simplices, D + 1 positions each, in basis coordinates.
    /// Positions that differ by a lattice vector become one vertex, decided exactly;
    /// it is the one with 0 <= x < 1 in the directions of the lattice. Simplices that
    /// are negatively oriented get their last two corners exchanged.
    pub fn from_positions(frame: Frame<D>, simplices: &[Vec<[Number; D]>]) -> Self {
        let rank = frame.rank();
        let mut indices: BTreeMap<[Number; D], u32> = BTreeMap::new();
        let mut vertices = Vec::new();
        let mut corners = Vec::with_capacity(simplices.len() * (D + 1));
        for position in simplices.iter().flatten() {
            let (vertex, shift) = split(position, rank);
            let index = *indices
                .entry(vertex.clone())
                .or_insert(vertices.len() as u32);
            if index as usize == vertices.len() {
                vertices.push(vertex);
            }
            corners.push(Corner {
                vertex: index,
                shift,
            });
        }
        let mut tiling = Tiling {
            frame,
            vertices: vertices.into(),
            corners,
        };
        tiling.orient();
        tiling
    }

    /// Exchanges the last two corners of every negatively oriented simplex; returns
    /// their indices.
    pub fn orient(&mut self) -> Vec<usize> {
        let negative = Model::new(self)
            .prepare(Orientation)
            .failing(|signs| signs.none_negative());
        for index in &negative {
            let end = (index + 1) * (D + 1);
            self.corners.swap(end - 2, end - 1);
        }
        negative
    }
}

/// A position as a vertex of the cell and a lattice vector.
fn split<const D: usize>(position: &[Number; D], rank: usize) -> ([Number; D], [i32; D]) {
    let shift: [i32; D] = std::array::from_fn(|k| if k < rank { floor(&position[k]) } else { 0 });
    let vertex =
        std::array::from_fn(|k| &position[k] - &Number::from(malachite::Rational::from(shift[k])));
    (vertex, shift)
}

/// The largest integer that is not more than x; a double proposes, exact
/// comparisons decide.
fn floor(x: &Number) -> i32 {
    let integer = |n: i32| Number::from(malachite::Rational::from(n));
    let mut floor = x.approximate().floor() as i32;
    while *x < integer(floor) {
        floor -= 1;
    }
    while *x >= integer(floor + 1) {
        floor += 1;
    }
    floor
}
