//! The common parts of recipes: exact numbers, explicit lists of tetrahedra, and the field of a
//! few numbers.

use super::CatalogError;
use acutile_core::tiling::{Frame, PointSet, Tiling};
use acutile_exact::number::{Field, Number};
use malachite::Rational;

/// n/d
pub fn fraction(numerator: i64, denominator: i64) -> Number {
    Number::from(Rational::from_signeds(numerator, denominator))
}

/// Points with coordinates n/`denominator` in a lattice with a rational Gram matrix.
pub fn rational_points<const D: usize>(
    gram: [[i64; D]; D],
    denominator: i64,
    points: &[[i64; D]],
) -> PointSet<D> {
    PointSet {
        frame: Frame::space(
            Field::rationals(),
            gram.map(|row| row.map(|x| fraction(x, 1))),
        ),
        points: points
            .iter()
            .map(|p| p.map(|x| fraction(x, denominator)))
            .collect(),
    }
}

/// x/y for a y that is not zero.
pub fn quotient(x: &Number, y: &Number) -> Result<Number, CatalogError> {
    x.divide(y).ok_or(CatalogError::Degenerate)
}

/// The field of the first number that is not rational, else Q.
pub fn common_field<'a>(mut numbers: impl Iterator<Item = &'a Number>) -> Field {
    numbers
        .find_map(Number::field)
        .cloned()
        .unwrap_or_else(Field::rationals)
}

/// The tiling by these tetrahedra with integer corners in Cartesian coordinates, periodic
/// under `period` Z³.
pub fn cubic_tiling(period: i64, tetrahedra: &[[[i64; 3]; 4]]) -> Tiling<3> {
    let square = |i: usize, j: usize| fraction(if i == j { period * period } else { 0 }, 1);
    let gram = std::array::from_fn(|i| std::array::from_fn(|j| square(i, j)));
    let position = |point: [i64; 3]| point.map(|x| fraction(x, period));
    let tetrahedra: Vec<Vec<_>> = tetrahedra
        .iter()
        .map(|corners| corners.map(position).to_vec())
        .collect();
    Tiling::from_positions(Frame::space(Field::rationals(), gram), &tetrahedra)
}
