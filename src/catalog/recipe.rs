//! What recipes share: exact numbers, explicit lists of tetrahedra, and the field of a
//! few numbers.

use super::CatalogError;
use crate::geometry::{Sign, Simplex};
use crate::number::{Field, Number};
use crate::tiling::{Corner, Frame, PointSet, Tiling};
use malachite::Rational;
use std::collections::HashMap;

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

/// The square Z^3 / period in Cartesian coordinates: the tiling by these tetrahedra with
/// integer corners, periodic under `period` Z³, each turned to positive orientation.
pub fn cubic_tiling(period: i64, tetrahedra: &[[[i64; 3]; 4]]) -> Tiling<3> {
    let mut vertices = Vec::new();
    let mut known = HashMap::new();
    let mut corners = Vec::new();
    for tetrahedron in tetrahedra {
        for point in tetrahedron {
            let place = point.map(|x| x.rem_euclid(period));
            let vertex = *known.entry(place).or_insert_with(|| {
                vertices.push(place.map(|x| fraction(x, period)));
                vertices.len() as u32 - 1
            });
            corners.push(Corner {
                vertex,
                shift: point.map(|x| x.div_euclid(period) as i32),
            });
        }
    }
    let square = |i: usize, j: usize| fraction(if i == j { period * period } else { 0 }, 1);
    let gram = std::array::from_fn(|i| std::array::from_fn(|j| square(i, j)));
    oriented(Tiling {
        frame: Frame::space(Field::rationals(), gram),
        vertices,
        corners,
    })
}

/// Exchanges two corners of every negatively oriented simplex.
pub fn oriented<const D: usize>(mut tiling: Tiling<D>) -> Tiling<D> {
    for index in 0..tiling.len() {
        let corners: Vec<_> = tiling
            .simplex(index)
            .iter()
            .map(|c| tiling.position(c))
            .collect();
        if Simplex::new(&corners).determinant.sign() == Sign::Less {
            tiling.corners.swap(index * (D + 1), index * (D + 1) + 1);
        }
    }
    tiling
}
