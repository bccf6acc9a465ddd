//! A tiling with its denominators cleared, so that every predicate is a polynomial
//! over a ring: integers for rational data, field elements otherwise.
//!
//! Coordinates are multiplied by one positive integer, the Gram matrix by another.
//! Both are positive, so no sign changes: a determinant of coordinates is scaled
//! by unit^D, an inner product of normals by positive powers of both.

use crate::geometry::{Scalar, Simplex, linear};
use crate::number::Number;
use crate::tiling::{Corner, Tiling};
use malachite::base::num::arithmetic::traits::{Floor, Lcm};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};

/// The cleared coordinates of a tiling.
#[derive(Clone, Debug)]
pub struct Model<'a, S, const D: usize> {
    /// The tiling itself, for corners and for exact values in messages.
    pub tiling: &'a Tiling<D>,
    /// One lattice step: the integer that clears the coordinates.
    pub unit: S,
    /// Vertex coordinates times `unit`.
    pub vertices: Vec<[S; D]>,
    /// A positive multiple of the Gram matrix.
    pub gram: [[S; D]; D],
    /// Its adjugate, which measures covectors.
    pub cogram: [[S; D]; D],
    /// A value of the ring as an element of the field.
    pub to_number: fn(&S) -> Number,
    /// A number with integer coefficients as a value of the ring.
    pub from_number: fn(&Number) -> S,
}

impl<'a, S: Scalar, const D: usize> Model<'a, S, D> {
    fn new(
        tiling: &'a Tiling<D>,
        to_number: fn(&S) -> Number,
        from_number: fn(&Number) -> S,
    ) -> Self {
        let field = &tiling.frame.field;
        let clear = |x: &Number, scale: &Integer| {
            from_number(&(x * &field.rational(Rational::from(scale))))
        };
        let unit = common_denominator(tiling.vertices.iter().flatten());
        let metric = common_denominator(tiling.frame.gram.iter().flatten());
        let gram = tiling
            .frame
            .gram
            .each_ref()
            .map(|row| row.each_ref().map(|x| clear(x, &metric)));
        Model {
            tiling,
            vertices: tiling
                .vertices
                .iter()
                .map(|vertex| vertex.each_ref().map(|x| clear(x, &unit)))
                .collect(),
            cogram: linear::cofactors(&gram),
            gram,
            to_number,
            from_number,
            unit: clear(&field.integer(1), &unit),
        }
    }

    /// Scaled coordinates of a corner.
    pub fn position(&self, corner: &Corner<D>) -> [S; D] {
        let vertex = &self.vertices[corner.vertex as usize];
        std::array::from_fn(|k| match corner.shift[k] {
            0 => vertex[k].clone(),
            shift => vertex[k].plus(&self.unit.times(&self.unit.integer(i64::from(shift)))),
        })
    }

    /// The simplex with this index.
    pub fn simplex(&self, index: usize) -> Simplex<S, D> {
        let corners: Vec<[S; D]> = self
            .tiling
            .simplex(index)
            .iter()
            .map(|corner| self.position(corner))
            .collect();
        Simplex::new(&corners)
    }
}

impl<'a, const D: usize> Model<'a, Integer, D> {
    /// The model of a tiling over the rationals.
    pub fn rational(tiling: &'a Tiling<D>) -> Self {
        let to_number = |x: &Integer| Number::from(Rational::from(x));
        // Exact, for the number is an integer.
        let from_number = |x: &Number| x.to_rational().map_or(Integer::ZERO, |value| value.floor());
        Model::new(tiling, to_number, from_number)
    }
}

impl<'a, const D: usize> Model<'a, Number, D> {
    /// The model of a tiling over any field.
    pub fn algebraic(tiling: &'a Tiling<D>) -> Self {
        Model::new(tiling, Number::clone, Number::clone)
    }
}

/// The least common multiple of all coefficients' denominators.
fn common_denominator<'n>(numbers: impl Iterator<Item = &'n Number>) -> Integer {
    let mut lcm = Natural::ONE;
    for coefficient in numbers.flat_map(|number| number.coefficients()) {
        let denominator = coefficient.denominator_ref();
        if *denominator != Natural::ONE {
            lcm = lcm.lcm(denominator);
        }
    }
    Integer::from(lcm)
}
