//! A tiling from simplices that are given by the positions of their corners, oriented by exact signs.

use super::{Model, Orientation};
use crate::tiling::dimension::same;
use crate::tiling::{Corner, Frame, SimplexId, Tiling, cell_of};
use acutile_exact::number::Number;
use std::collections::BTreeMap;

impl<const D: usize> Tiling<D> {
    /// The tiling of these simplices, D + 1 positions each, in basis coordinates.
    /// Positions that differ by a lattice vector become one vertex, decided exactly;
    /// it is the one with 0 <= x < 1 in the directions of the lattice. Simplices that
    /// are negatively oriented get their last two corners exchanged. A position more than
    /// [`CELL_LIMIT`](crate::tiling::CELL_LIMIT) cells away becomes a vertex as it is.
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
                vertex: index.into(),
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
    pub fn orient(&mut self) -> Vec<SimplexId> {
        let negative = match D {
            2 => negative_in_plane(same(self)),
            _ => negative_in_space(same(self)),
        };
        for index in &negative {
            let end = (index.index() + 1) * (D + 1);
            self.corners.swap(end - 2, end - 1);
        }
        negative
    }
}

#[inline(never)]
fn negative_in_plane(tiling: &Tiling<2>) -> Vec<SimplexId> {
    negative(tiling)
}

#[inline(never)]
fn negative_in_space(tiling: &Tiling<3>) -> Vec<SimplexId> {
    negative(tiling)
}

/// The negatively oriented simplices.
fn negative<const D: usize>(tiling: &Tiling<D>) -> Vec<SimplexId> {
    Model::new(tiling)
        .prepare(Orientation)
        .failing(|signs| signs.none_negative())
}

/// A position as a vertex of the cell and a lattice vector. One beyond the limit of cells stays.
fn split<const D: usize>(position: &[Number; D], rank: usize) -> ([Number; D], [i32; D]) {
    let shift = cell_of(position, rank).unwrap_or([0; D]);
    let vertex =
        std::array::from_fn(|k| &position[k] - &Number::from(malachite::Rational::from(shift[k])));
    (vertex, shift)
}
