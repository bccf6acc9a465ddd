//! Where things are, in doubles: to search by, never to decide by.

use crate::tiling::{Corner, Facet, Tiling};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;

/// Coordinates of the vertices and the Gram matrix as doubles.
pub struct Places<const D: usize> {
    vertices: Vec<[f64; D]>,
    pub gram: [[f64; D]; D],
    pub rank: usize,
}

/// A box in basis coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Extent<const D: usize> {
    pub low: [f64; D],
    pub high: [f64; D],
}

/// A box is enlarged by this part of its coordinates, far more than a double can be off.
const SLACK: f64 = 1e-9;

impl<const D: usize> Places<D> {
    pub fn of(tiling: &Tiling<D>) -> Self {
        let vertex = |index: u32| tiling.position(&Corner::of(index)).map(|x| x.approximate());
        Places {
            vertices: (0..tiling.vertices.len() as u32).map(vertex).collect(),
            gram: tiling
                .frame
                .gram
                .each_ref()
                .map(|row| row.each_ref().map(Number::approximate)),
            rank: tiling.frame.rank(),
        }
    }

    pub fn position(&self, corner: &Corner<D>) -> [f64; D] {
        let vertex = &self.vertices[corner.vertex.index()];
        std::array::from_fn(|k| vertex[k] + f64::from(corner.shift[k]))
    }

    pub fn squared_distance(&self, a: &[f64; D], b: &[f64; D]) -> f64 {
        linear::square(&self.gram, &linear::subtract(a, b))
    }

    /// The lattice vector next to `b - a`.
    pub fn shift_between(&self, a: &[f64; D], b: &[f64; D]) -> [i32; D] {
        std::array::from_fn(|k| {
            if k < self.rank {
                // A cast saturates; a facet so far away is not near.
                (b[k] - a[k]).round() as i32
            } else {
                0
            }
        })
    }

    /// A box that certainly holds all these corners.
    pub fn extent(&self, corners: &[Corner<D>]) -> Extent<D> {
        let mut extent = Extent {
            low: [f64::INFINITY; D],
            high: [f64::NEG_INFINITY; D],
        };
        for point in corners.iter().map(|corner| self.position(corner)) {
            for k in 0..D {
                let slack = SLACK * (1.0 + point[k].abs());
                extent.low[k] = extent.low[k].min(point[k] - slack);
                extent.high[k] = extent.high[k].max(point[k] + slack);
            }
        }
        extent
    }
}

/// The corners of a facet, in the order of the simplex.
pub fn facet_corners<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> Vec<Corner<D>> {
    let corners = tiling.simplex(facet.simplex).iter().enumerate();
    corners
        .filter(|(k, _)| *k != usize::from(facet.opposite))
        .map(|(_, corner)| *corner)
        .collect()
}

/// The mean of some points.
pub fn mean<const D: usize>(points: &[[f64; D]]) -> [f64; D] {
    std::array::from_fn(|k| points.iter().map(|p| p[k]).sum::<f64>() / points.len() as f64)
}
