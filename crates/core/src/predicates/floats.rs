//! Edges in doubles with a proved bound of their error, side by side for many simplices.
//!
//! Let u = 2^-53. Coordinates x are at most X and known up to 3 u X, and shifts s have at most S steps of
//! length h. The edge (x_b - x_a) + (s_b - s_a) h is rounded in at most three operations, each by u times a
//! result of at most 2 X + S h. h itself is rounded by u h. All together is less than delta = 16 u (2 X + S
//! h). Where coordinates and h are integers and 2 X + S h < 2^52, edges are exact and delta = 0.

use crate::parallel;
use crate::tiling::coordinates::Form;
use crate::tiling::{Corner, Tiling};
use acutile_exact::geometry::bound::ROUNDOFF;
use acutile_exact::number::Number;
use std::borrow::Cow;

/// The vertices of a tiling as doubles.
#[derive(Clone, Debug)]
pub struct Floats<'a, const D: usize> {
    points: Cow<'a, [[f64; D]]>,
    /// One lattice step.
    unit: f64,
    /// delta
    pub(super) error: f64,
    /// Whether coordinates and lattice step are integers, and edges exact.
    pub(super) is_integral: bool,
    /// S: the error holds for corners whose shifts differ by no more.
    steps: i32,
}

impl<'a, const D: usize> Floats<'a, D> {
    /// The vertices of `tiling`, times a positive number, for its simplices and their
    /// neighbours.
    pub fn new(tiling: &'a Tiling<D>) -> Self {
        let shifts = tiling.corners.iter().flat_map(|c| c.shift);
        // Four times, for a corner of a neighbour that is moved next to a simplex. Shifts have
        // 25 bits.
        Floats::within(tiling, 4 * shifts.map(i32::abs).max().unwrap_or(0))
    }

    /// The same for corners whose shifts differ by no more than `steps`.
    pub fn within(tiling: &'a Tiling<D>, steps: i32) -> Self {
        let (points, unit, is_integral): (Cow<[[f64; D]]>, f64, bool) = match tiling.vertices.form()
        {
            Form::Integers {
                numerators,
                denominator,
            } => {
                let points = numerators.iter().map(|x| x.map(|n| n as f64)).collect();
                (Cow::Owned(points), *denominator as f64, true)
            }
            Form::Doubles(points) => (Cow::Borrowed(points), 1.0, false),
            Form::Numbers(points) => {
                let approximate = |x: &[Number; D]| x.each_ref().map(Number::approximate);
                let points = parallel::map(points.len(), |k| approximate(&points[k]));
                (Cow::Owned(points), 1.0, false)
            }
        };
        let largest = points
            .iter()
            .flatten()
            .fold(0.0, |m: f64, x| m.max(x.abs()));
        let reach = 2.0 * largest + f64::from(steps) * unit;
        let is_integral = is_integral && reach < 2f64.powi(52);
        let error = 16.0 * ROUNDOFF * reach + 2f64.powi(-1000);
        Floats {
            points,
            unit,
            error: if is_integral { 0.0 } else { error },
            is_integral,
            steps,
        }
    }

    /// Whether the error holds for edges between these corners and the first.
    #[inline(always)]
    pub fn cover(&self, corners: &[Corner<D>], apex: &Corner<D>) -> bool {
        let first = corners[0].shift;
        let is_near =
            |corner: &Corner<D>| (0..D).all(|k| (corner.shift[k] - first[k]).abs() <= self.steps);
        corners.iter().all(is_near) && is_near(apex)
    }

    /// The vector from one corner to another, up to delta in each entry.
    #[inline(always)]
    pub fn difference(&self, from: &Corner<D>, to: &Corner<D>) -> [f64; D] {
        let [a, b] = [from, to].map(|corner| &self.points[corner.vertex.index()]);
        let mut difference = [0.0; D];
        for k in 0..D {
            let steps = f64::from(to.shift[k] - from.shift[k]);
            difference[k] = (b[k] - a[k]) + steps * self.unit;
        }
        difference
    }

    /// The edges of a simplex from its first corner.
    #[inline(always)]
    pub fn edges(&self, corners: &[Corner<D>]) -> [[f64; D]; D] {
        // One check of the length, and none in the loop.
        let corners = &corners[..D + 1];
        let mut edges = [[0.0; D]; D];
        for k in 0..D {
            edges[k] = self.difference(&corners[0], &corners[k + 1]);
        }
        edges
    }
}

/// The number of simplices that are filtered together.
pub const BATCH: usize = 16;

/// The edges of some simplices, and the vector to a further point, each entry of all of
/// them side by side.
#[derive(Clone, Debug)]
pub struct Batch<const D: usize> {
    edges: [[[f64; BATCH]; D]; D],
    points: [[f64; BATCH]; D],
}

impl<const D: usize> Default for Batch<D> {
    fn default() -> Self {
        Batch {
            edges: [[[0.0; BATCH]; D]; D],
            points: [[0.0; BATCH]; D],
        }
    }
}

impl<const D: usize> Batch<D> {
    /// Puts a simplex, and perhaps a further corner, to this place.
    #[inline(always)]
    pub fn put(
        &mut self,
        place: usize,
        floats: &Floats<D>,
        corners: &[Corner<D>],
        apex: Option<&Corner<D>>,
    ) {
        let edges = floats.edges(corners);
        for i in 0..D {
            for k in 0..D {
                self.edges[i][k][place] = edges[i][k];
            }
        }
        if let Some(apex) = apex {
            let point = floats.difference(&corners[0], apex);
            for k in 0..D {
                self.points[k][place] = point[k];
            }
        }
    }

    /// The edges of one of the simplices.
    #[inline(always)]
    pub fn edges(&self, place: usize) -> [[f64; D]; D] {
        let mut edges = [[0.0; D]; D];
        for i in 0..D {
            for k in 0..D {
                edges[i][k] = self.edges[i][k][place];
            }
        }
        edges
    }

    /// The vector to its further point.
    #[inline(always)]
    pub fn point(&self, place: usize) -> [f64; D] {
        let mut point = [0.0; D];
        for k in 0..D {
            point[k] = self.points[k][place];
        }
        point
    }
}
