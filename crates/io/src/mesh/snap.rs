//! Vertices that nearly differ by a lattice vector, moved to the exact image of one.
//!
//! Distances are computed in doubles, because they only select the vertices that are moved.
//! A note names every move, and the proof is about the moved mesh.

use super::error::MeshError;
use super::identify::Identified;
use super::lattice::Basis;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::HashMap;

/// A node that was moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// The number of the node in the file.
    pub node: u64,
    /// Where the file has it.
    pub from: [f64; 3],
    /// Where it is now, exactly, in Cartesian coordinates.
    pub to: [Rational; 3],
    /// How far it was moved, about.
    pub distance: f64,
}

/// Moves every vertex that is within `tolerance` of a lattice translate of an earlier vertex
/// that stays where it is onto the nearest such translate. Gives for each vertex that was moved the
/// vertex it now is, and the lattice vector from that one.
///
/// # Errors
/// Where the tolerance is not small against the lattice.
pub fn snap(
    found: &Identified,
    basis: &Basis,
    inverse: &[[Rational; 3]; 3],
    tolerance: f64,
) -> Result<HashMap<u32, (u32, [i32; 3])>, MeshError> {
    let points: Vec<[f64; 3]> = fractions(found);
    let grid = Grid::new(basis, inverse, tolerance, &points)?;
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    let mut moved = HashMap::new();
    for (vertex, point) in (0u32..).zip(&points) {
        let near = grid.neighbours(point);
        let candidates = near.iter().filter_map(|cell| cells.get(cell)).flatten();
        let images = candidates.filter_map(|&other| {
            let (distance, shift) = grid.image(point, &points[other as usize])?;
            Some((distance, (other, shift)))
        });
        match images.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((_, image)) => drop(moved.insert(vertex, image)),
            None => cells.entry(grid.cell(point)).or_default().push(vertex),
        }
    }
    Ok(moved)
}

fn fractions(found: &Identified) -> Vec<[f64; 3]> {
    let double = |x: &malachite::Integer| {
        Number::from(Rational::from_integers_ref(x, &found.denominator)).approximate()
    };
    found
        .numerators
        .iter()
        .map(|row| row.each_ref().map(double))
        .collect()
}

/// Cells in basis coordinates, each at least as large as the tolerance.
struct Grid {
    /// Cells in each direction of the lattice; the cell's size in other directions.
    counts: [i64; 3],
    sizes: [f64; 3],
    rank: usize,
    vectors: [[f64; 3]; 3],
    tolerance: f64,
}

/// More cells in a direction are of no use.
const MOST_CELLS: f64 = 1e6;

impl Grid {
    /// A step of length t changes basis coordinate k by at most t |row k of the inverse|.
    fn new(
        basis: &Basis,
        inverse: &[[Rational; 3]; 3],
        tolerance: f64,
        points: &[[f64; 3]],
    ) -> Result<Self, MeshError> {
        let approximate = |x: &Rational| Number::from(x.clone()).approximate();
        let reach = inverse.each_ref().map(|row| {
            let squares = row.iter().map(|x| approximate(x).powi(2));
            tolerance * squares.sum::<f64>().sqrt()
        });
        if reach[..basis.rank].iter().any(|&r| r.is_nan() || r > 0.25) {
            return Err(MeshError::of_file(format!(
                "the tolerance {tolerance} is more than a quarter of the lattice's width"
            )));
        }
        let span = |k: usize| {
            if k < basis.rank {
                1.0
            } else {
                let low = points.iter().map(|point| point[k]).fold(f64::MAX, f64::min);
                let high = points.iter().map(|point| point[k]).fold(f64::MIN, f64::max);
                (high - low).max(f64::MIN_POSITIVE)
            }
        };
        let sizes: [f64; 3] = std::array::from_fn(|k| reach[k].max(span(k) / MOST_CELLS) * 1.001);
        Ok(Grid {
            counts: sizes.map(|size| (1.0 / size).floor().max(1.0) as i64),
            sizes,
            rank: basis.rank,
            vectors: basis
                .vectors
                .each_ref()
                .map(|row| row.each_ref().map(Number::approximate)),
            tolerance,
        })
    }

    fn cell(&self, point: &[f64; 3]) -> [i64; 3] {
        std::array::from_fn(|k| {
            if k < self.rank {
                ((point[k] * self.counts[k] as f64) as i64).rem_euclid(self.counts[k])
            } else {
                (point[k] / self.sizes[k]).floor() as i64
            }
        })
    }

    /// The cell and those around it, across the sides of the lattice's cell, none twice.
    fn neighbours(&self, point: &[f64; 3]) -> Vec<[i64; 3]> {
        let centre = self.cell(point);
        let mut cells = Vec::with_capacity(27);
        for step in 0..27 {
            let steps = [step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1];
            let cell = std::array::from_fn(|k| {
                if k < self.rank {
                    (centre[k] + steps[k]).rem_euclid(self.counts[k])
                } else {
                    centre[k].saturating_add(steps[k])
                }
            });
            if !cells.contains(&cell) {
                cells.push(cell);
            }
        }
        cells
    }

    /// The lattice vector that takes `other` next to `point`, if it comes near enough, with
    /// the distance.
    fn image(&self, point: &[f64; 3], other: &[f64; 3]) -> Option<(f64, [i32; 3])> {
        let shift: [i32; 3] = std::array::from_fn(|k| {
            if k < self.rank {
                (point[k] - other[k]).round() as i32
            } else {
                0
            }
        });
        let step: [f64; 3] = std::array::from_fn(|k| point[k] - other[k] - f64::from(shift[k]));
        let cartesian = |j: usize| (0..3).map(|k| step[k] * self.vectors[k][j]).sum::<f64>();
        let distance = (0..3).map(|j| cartesian(j).powi(2)).sum::<f64>().sqrt();
        (distance <= self.tolerance).then_some((distance, shift))
    }
}
