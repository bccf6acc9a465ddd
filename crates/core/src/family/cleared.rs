//! A family with its denominators cleared: polynomials over one ring of coefficients.
//!
//! Coordinates and lattice are multiplied by one positive integer, the Gram matrix by another. So
//! no sign changes, and over the rationals all coefficients are integers.

use super::Family;
use crate::tiling::{Corner, Polytope, SimplexId};
use acutile_exact::geometry::{RingElement, Simplex, linear};
use acutile_exact::number::Number;
use acutile_exact::polynomial::{Coefficient, Polynomial};
use malachite::{Integer, Rational};

/// A cleared family.
#[derive(Clone, Debug)]
pub struct Cleared<'f, C, const D: usize> {
    /// The family itself.
    pub family: &'f Family<D>,
    /// The Gram matrix, times a positive number.
    pub gram: [[Polynomial<C>; D]; D],
    /// The adjugate of the Gram matrix, which measures covectors.
    pub cogram: [[Polynomial<C>; D]; D],
    /// The coordinates of the vertices, times `unit`.
    pub vertices: Vec<[Polynomial<C>; D]>,
    /// The domain, where it is a polytope, times `unit`.
    pub polytope: Option<Polytope<Polynomial<C>>>,
    /// One lattice step.
    pub unit: Polynomial<C>,
}

/// A number that is cleared of its denominators as a coefficient.
pub type Convert<C> = fn(Number) -> C;

/// For the rationals.
pub fn to_integer(number: Number) -> Integer {
    let value = number.to_rational().cloned().unwrap_or_default();
    Integer::try_from(value).expect("the number is cleared of its denominator")
}

/// For number fields.
pub fn to_number(number: Number) -> Number {
    number
}

impl<'f, C: Coefficient, const D: usize> Cleared<'f, C, D> {
    /// Clears a family; `convert` takes its numbers to the coefficients of the result.
    pub fn new(family: &'f Family<D>, convert: Convert<C>) -> Self {
        let scaled = |p: &Polynomial, unit: &Number| p.map(|c| convert(c * unit));
        let metric = family.frame.gram.iter().flatten();
        let metric_unit = unit_of(metric);
        let polytope = family.frame.domain.polytope();
        let corners = polytope.iter().flat_map(|p| p.vertices.iter().flatten());
        let unit = unit_of(corners.chain(family.vertices.iter().flatten()));
        let gram = family.frame.gram.each_ref();
        let gram = gram.map(|row| row.each_ref().map(|p| scaled(p, &metric_unit)));
        let vertices = family.vertices.iter();
        Cleared {
            cogram: linear::cofactors(&gram),
            gram,
            vertices: vertices
                .map(|v| v.each_ref().map(|p| scaled(p, &unit)))
                .collect(),
            polytope: polytope.map(|polytope| polytope.map(|p| scaled(p, &unit))),
            unit: Polynomial::constant(convert(unit)),
            family,
        }
    }

    /// The coordinates of a corner.
    pub fn position(&self, corner: &Corner<D>) -> [Polynomial<C>; D] {
        let vertex = &self.vertices[corner.vertex.index()];
        std::array::from_fn(|k| match corner.shift[k] {
            0 => vertex[k].clone(),
            shift => vertex[k].plus(&self.unit.times(&self.unit.integer(i64::from(shift)))),
        })
    }

    /// The corners of a simplex.
    pub fn corners(&self, simplex: SimplexId) -> &'f [Corner<D>] {
        let first = simplex.index() * (D + 1);
        &self.family.corners[first..=first + D]
    }

    /// A simplex with cleared coordinates.
    pub fn simplex(&self, simplex: SimplexId) -> Simplex<Polynomial<C>, D> {
        let corners = self.corners(simplex).iter();
        let corners: Vec<[Polynomial<C>; D]> = corners.map(|c| self.position(c)).collect();
        Simplex::new(&corners)
    }
}

/// The least positive integer that clears the coefficients.
fn unit_of<'p>(polynomials: impl Iterator<Item = &'p Polynomial>) -> Number {
    let coefficients = polynomials.flat_map(|p| p.terms().iter().map(|(_, c)| c));
    Number::from(Rational::from(Number::common_denominator(coefficients)))
}
