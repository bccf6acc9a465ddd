//! Points modulo a lattice, exactly.
//!
//! Every double is m 2^q with integers m and q. Let e be the smallest q, or 0 if that is
//! less. Then X = 2^-e x has integer entries. Let the change to basis coordinates be M / d with
//! an integer matrix M and d > 0. Then f = x M / d = N / Q with N = X M and Q = 2^-e d. So basis
//! coordinates of all points are integers over one denominator. The lattice vector that takes a
//! point to the cell is the floor of N / Q. Two points with equal remainders differ by a lattice vector.

use super::error::MeshError;
use acutile_core::tiling::SHIFT_LIMIT;
use acutile_core::tiling::coordinates::decompose;
use acutile_exact::geometry::{Scalar, linear};
use acutile_exact::number::common_denominator;
use malachite::base::num::arithmetic::traits::{DivMod, Floor};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};
use std::collections::HashMap;
use std::hash::Hash;

/// The different points modulo the lattice.
pub struct Identified {
    /// Q, positive.
    pub denominator: Integer,
    /// N for each vertex; 0 <= N < Q in the directions of the lattice.
    pub numerators: Vec<[Integer; 3]>,
    /// The point that each vertex was first seen at.
    pub representatives: Vec<u32>,
    /// The vertex of each point, and the lattice vector from the vertex to the point;
    /// `u32::MAX` for a point that is not used.
    pub places: Vec<(u32, [i32; 3])>,
}

/// The points that are used, modulo the first `rank` basis vectors; with `merge` points that
/// differ by a lattice vector become one vertex. Row k of `inverse` gives basis coordinate k.
///
/// # Errors
/// Where a point is too many lattice vectors away from the origin.
pub fn identify(
    points: &[[f64; 3]],
    used: &[bool],
    inverse: &[[Rational; 3]; 3],
    rank: usize,
    merge: bool,
) -> Result<Identified, MeshError> {
    let d = common_denominator(inverse.iter().flatten());
    let scale = Rational::from(&d);
    let matrix = inverse.each_ref().map(|row| {
        // An integer, for d is a multiple of the denominator.
        row.each_ref().map(|x| (x * &scale).floor())
    });
    let dyadic_points = || {
        points
            .iter()
            .zip(used)
            .filter(|(_, used)| **used)
            .flat_map(|(p, _)| p)
    };
    let exponent = dyadic_points()
        .map(|&x| decompose(x).1)
        .min()
        .unwrap_or(0)
        .min(0);
    let widest = dyadic_points()
        .map(|&x| width(x, exponent))
        .max()
        .unwrap_or(0);
    let denominator = Integer::from(d) << exponent.unsigned_abs();
    let entries = matrix.iter().flatten();
    let factor = entries.map(|x| x.significant_bits()).max().unwrap_or(0);
    let job = Job {
        points,
        used,
        matrix,
        denominator,
        exponent,
        rank,
        merge,
    };
    // A sum of three products has two bits more, and a sign.
    if widest + factor + 3 < 127 && job.denominator.significant_bits() < 127 {
        job.run::<i128>()
    } else {
        job.run::<Integer>()
    }
}

/// The bits of 2^-exponent x.
fn width(x: f64, exponent: i32) -> u64 {
    let (m, q) = decompose(x);
    match m {
        0 => 0,
        _ => {
            u64::from(64 - m.unsigned_abs().leading_zeros()) + (q - exponent).unsigned_abs() as u64
        }
    }
}

struct Job<'a> {
    points: &'a [[f64; 3]],
    used: &'a [bool],
    matrix: [[Integer; 3]; 3],
    denominator: Integer,
    exponent: i32,
    rank: usize,
    merge: bool,
}

impl Job<'_> {
    fn run<W: Whole>(self) -> Result<Identified, MeshError> {
        let matrix = self
            .matrix
            .each_ref()
            .map(|row| row.each_ref().map(W::from_integer));
        let unit = W::from_integer(&self.denominator);
        let mut vertices: HashMap<[W; 3], u32> = HashMap::new();
        let mut found = Identified {
            denominator: self.denominator.clone(),
            numerators: Vec::new(),
            representatives: Vec::new(),
            places: vec![(u32::MAX, [0; 3]); self.points.len()],
        };
        for (index, point) in self
            .points
            .iter()
            .enumerate()
            .filter(|(i, _)| self.used[*i])
        {
            let scaled = point.map(|x| {
                let (m, q) = decompose(x);
                W::shifted(m, (q - self.exponent).unsigned_abs())
            });
            let mut shift = [0; 3];
            let mut numerators = matrix.each_ref().map(|row| linear::dot(&scaled, row));
            for k in 0..self.rank {
                let (floor, rest) = numerators[k].divide(&unit);
                shift[k] = floor
                    .filter(|floor| floor.unsigned_abs() <= SHIFT_LIMIT.unsigned_abs())
                    .ok_or_else(|| too_far(point))?;
                numerators[k] = rest;
            }
            let next = found.numerators.len() as u32;
            let vertex = if self.merge {
                *vertices.entry(numerators.clone()).or_insert(next)
            } else {
                next
            };
            if vertex == next {
                found.numerators.push(numerators.map(W::into_integer));
                found.representatives.push(index as u32);
            }
            found.places[index] = (vertex, shift);
        }
        Ok(found)
    }
}

fn too_far(point: &[f64; 3]) -> MeshError {
    let [x, y, z] = point;
    MeshError::limit(format!(
        "the node at ({x}, {y}, {z}) is more than {SHIFT_LIMIT} lattice vectors away from the origin"
    ))
}

/// Integers that are wide enough.
trait Whole: Scalar + Eq + Hash {
    fn from_integer(value: &Integer) -> Self;
    fn into_integer(self) -> Integer;
    /// m 2^bits
    fn shifted(m: i64, bits: u32) -> Self;
    /// The floor of a quotient, if it is small, and what remains.
    fn divide(&self, unit: &Self) -> (Option<i32>, Self);
}

/// The caller has shown that all values have less than 127 bits.
impl Whole for i128 {
    fn from_integer(value: &Integer) -> Self {
        i128::try_from(value).unwrap_or(0)
    }

    fn into_integer(self) -> Integer {
        Integer::from(self)
    }

    fn shifted(m: i64, bits: u32) -> Self {
        match m {
            0 => 0,
            _ => i128::from(m) << bits,
        }
    }

    fn divide(&self, unit: &Self) -> (Option<i32>, Self) {
        let floor = self.div_euclid(*unit);
        (i32::try_from(floor).ok(), self.rem_euclid(*unit))
    }
}

impl Whole for Integer {
    fn from_integer(value: &Integer) -> Self {
        value.clone()
    }

    fn into_integer(self) -> Integer {
        self
    }

    fn shifted(m: i64, bits: u32) -> Self {
        Integer::from(m) << bits
    }

    fn divide(&self, unit: &Self) -> (Option<i32>, Self) {
        let (floor, rest) = self.div_mod(unit);
        (i32::try_from(&floor).ok(), rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_double_is_what_its_parts_say() {
        for x in [1.0, -0.1, 3e300, 5e-324, -2.5e-310, 0.0, f64::MAX] {
            let (m, q) = decompose(x);
            let value = match q {
                0.. => Rational::from(m) << q,
                _ => Rational::from(m) >> q.unsigned_abs(),
            };
            assert_eq!(Ok(value), Rational::try_from(x));
        }
    }

    #[test]
    fn wide_and_narrow_integers_agree() {
        let inverse = |a: i64, b: i64| {
            let entry = |i, j| Rational::from_signeds(if i == j { a } else { 1 }, b);
            std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
        };
        let mut points = vec![[0.25, -3.5, 7.0], [1e-3, 2.0, -0.75], [1.25, -2.5, 8.0]];
        let narrow = identify(&points, &[true; 3], &inverse(2, 1), 3, true).expect("near");
        points.push([1e-200, 0.0, 0.0]);
        let wide = identify(&points, &[true; 4], &inverse(2, 1), 3, true).expect("near");
        assert_eq!(narrow.places, wide.places[..3]);
        assert_eq!(narrow.numerators.len(), 2);
        assert_eq!(wide.numerators.len(), 3);
        for (a, b) in narrow.numerators.iter().zip(&wide.numerators) {
            for k in 0..3 {
                let left = Rational::from_integers_ref(&a[k], &narrow.denominator);
                assert_eq!(left, Rational::from_integers_ref(&b[k], &wide.denominator));
            }
        }
    }
}
