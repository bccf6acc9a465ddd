//! The coordinates of the vertices, as integers over their common denominator.

use crate::cbor::Cbor;
use crate::int::Int;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::Element;
use crate::row::Corner;
use num_bigint::BigInt;
use num_integer::Integer;
use std::collections::BTreeMap;

/// Stands for a coefficient that is in `large`, or else for itself.
const LARGE: i64 = i64::MIN;

#[derive(Default)]
pub struct Vertices {
    /// The common denominator; zero until it is read.
    pub(crate) denominator: BigInt,
    /// The greatest common divisor of the denominator and all coefficients so far.
    divisor: BigInt,
    dimension: usize,
    degree: usize,
    /// `dimension * degree` coefficients for each vertex.
    small: Vec<i64>,
    large: BTreeMap<usize, BigInt>,
    pub(crate) count: u32,
}

impl Vertices {
    pub(crate) fn new(dimension: usize, degree: usize) -> Vertices {
        Vertices { dimension, degree, ..Vertices::default() }
    }

    pub(crate) fn read_denominator(&mut self, cbor: &mut Cbor) -> Checked {
        self.denominator = cbor.big()?;
        self.divisor = self.denominator.clone();
        let is_positive = self.denominator > BigInt::ZERO;
        ensure!(is_positive, Denominator, cbor.place(), self.denominator.clone());
        Ok(())
    }

    /// Reads one vertex.
    pub(crate) fn read(&mut self, cbor: &mut Cbor) -> Checked {
        cbor.array_of(self.dimension)?;
        for _ in 0..self.dimension {
            if self.degree > 1 {
                cbor.array_of(self.degree)?;
            }
            for _ in 0..self.degree {
                let coefficient = cbor.integer()?;
                if self.divisor != BigInt::from(1) {
                    let coefficient = coefficient.clone().map_or_else(|large| large, BigInt::from);
                    self.divisor = self.divisor.gcd(&coefficient);
                }
                self.small.push(coefficient.as_ref().copied().unwrap_or(LARGE));
                if let Err(large) = coefficient {
                    self.large.insert(self.small.len() - 1, large);
                }
            }
        }
        ensure!(self.count < u32::MAX, VertexRange, cbor.place());
        self.count += 1;
        Ok(())
    }

    /// The denominator and all coefficients have no common divisor.
    pub(crate) fn check_lowest(&self, place: Place) -> Checked {
        ensure!(self.divisor == BigInt::from(1), Canonical, place);
        Ok(())
    }

    /// The coordinates of a corner, times the denominator; in the plane the third one is zero.
    pub(crate) fn point<T: Int, const N: usize>(&self, corner: Corner) -> Checked<[Element<T, N>; 3]> {
        let degree = if N <= 2 { N } else { self.degree };
        let size = self.dimension * degree;
        let start = usize::try_from(corner.vertex).map_err(|_| Stop::LARGER)? * size;
        let small = self.small.get(start..start + size).ok_or_else(|| Stop::LARGER)?;
        let mut point: [Element<T, N>; 3] = Default::default();
        let mut index = start;
        for (coordinate, values) in point.iter_mut().zip(small.chunks_exact(degree)) {
            for (slot, &value) in coordinate.0.iter_mut().zip(values) {
                *slot = match value {
                    LARGE => self.large.get(&index).map_or_else(|| Ok(T::from(LARGE)), T::of)?,
                    value => T::from(value),
                };
                index += 1;
            }
        }
        if corner.shift != [0; 3] {
            let denominator = T::of(&self.denominator)?;
            for (coordinate, shift) in point.iter_mut().zip(corner.shift) {
                let constant = coordinate.0.first_mut().ok_or_else(|| Stop::LARGER)?;
                constant.add_product(&denominator, &T::from(shift.into()))?;
            }
        }
        Ok(point)
    }
}
