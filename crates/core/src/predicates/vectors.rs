//! The vectors of a simplex from its first corner.

use crate::tiling::Corner;
use acutile_exact::geometry::Scalar;

/// The edges of a simplex, and the vector to a further point, from its first corner.
#[derive(Clone, Debug)]
pub struct Vectors<B, const D: usize> {
    pub edges: [[B; D]; D],
    pub point: [B; D],
    /// All of them are to be multiplied by 2^exponent.
    pub exponent: i32,
}

impl<const D: usize> Vectors<i128, D> {
    /// The same in the unit with the greatest exponent.
    pub fn reduced(mut self) -> Self {
        let entries = || self.edges.as_flattened().iter().chain(&self.point);
        let zeros = entries().fold(0, |all, x| all | x).trailing_zeros();
        // Zeros only have 128 of them.
        let zeros = zeros.min(127);
        let entries = self.edges.as_flattened_mut().iter_mut();
        entries.chain(&mut self.point).for_each(|x| *x >>= zeros);
        self.exponent += zeros as i32;
        self
    }
}

/// The vectors from the first corner, given the coordinates of the vertices.
#[inline(always)]
pub(super) fn vectors<B: Scalar, const D: usize>(
    corners: &[Corner<D>],
    apex: &Corner<D>,
    at: impl Fn(usize, usize) -> B,
    unit: B,
) -> Vectors<B, D> {
    let from = corners[0];
    let vector = |to: &Corner<D>| -> [B; D] {
        std::array::from_fn(|k| {
            let difference = at(to.vertex.index(), k).minus(&at(from.vertex.index(), k));
            match to.shift[k] - from.shift[k] {
                0 => difference,
                shift => difference.plus(&unit.times(&unit.integer(i64::from(shift)))),
            }
        })
    };
    Vectors {
        edges: std::array::from_fn(|k| vector(&corners[k + 1])),
        point: vector(apex),
        exponent: 0,
    }
}
