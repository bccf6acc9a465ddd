//! The coordinates of the vertices, as integers over their common denominator.

use crate::cbor::{Cbor, Integer};
use crate::int::{Int, gcd};
use crate::refusal::{Checked, Larger};
use crate::ring::Element;
use crate::row::Corner;
use num_bigint::{BigInt, Sign};
use std::collections::BTreeMap;

/// Stands for a coefficient that is in `large`.
const LARGE: i64 = i64::MIN;

pub struct Vertices {
    /// The common denominator; zero until it is read.
    pub(crate) denominator: BigInt,
    small_denominator: Option<i64>,
    dimension: usize,
    degree: usize,
    /// `dimension * degree` coefficients for each vertex.
    small: Vec<i64>,
    large: BTreeMap<usize, BigInt>,
    count: u32,
}

impl Vertices {
    pub(crate) fn new(dimension: usize, degree: usize) -> Vertices {
        Vertices {
            denominator: BigInt::ZERO,
            small_denominator: None,
            dimension,
            degree,
            small: Vec::new(),
            large: BTreeMap::new(),
            count: 0,
        }
    }

    pub(crate) fn read_denominator(&mut self, cbor: &mut Cbor) -> Checked {
        self.denominator = cbor.big()?;
        let is_positive = self.denominator.sign() == Sign::Plus;
        ensure!(
            is_positive,
            Denominator,
            cbor.place(),
            self.denominator.clone()
        );
        self.small_denominator = i64::try_from(&self.denominator).ok();
        Ok(())
    }

    pub fn count(&self) -> u32 {
        self.count
    }

    /// Reads all vertices. `check` sees each one after it is read.
    pub(crate) fn read(
        &mut self,
        cbor: &mut Cbor,
        mut check: impl FnMut(&Vertices, u32) -> Checked,
    ) -> Checked {
        let count = cbor.array()?;
        let coordinates = u64::try_from(self.dimension).unwrap_or(u64::MAX);
        let coefficients = u64::try_from(self.degree).unwrap_or(u64::MAX);
        // The denominator and all coefficients have no common divisor.
        let mut divisor = self.denominator.clone();
        let one = BigInt::from(1);
        for _ in 0..count {
            cbor.array_of(coordinates)?;
            for _ in 0..coordinates {
                if self.degree > 1 {
                    cbor.array_of(coefficients)?;
                }
                for _ in 0..coefficients {
                    let coefficient = cbor.integer()?;
                    if divisor != one {
                        divisor = gcd(&coefficient.clone().into(), &divisor);
                    }
                    self.push(coefficient);
                }
            }
            ensure!(self.count < u32::MAX - 1, VertexRange, cbor.place());
            self.count += 1;
            check(self, self.count - 1)?;
        }
        ensure!(divisor == one, Canonical, cbor.place());
        Ok(())
    }

    fn push(&mut self, coefficient: Integer) {
        match coefficient {
            Integer::Small(value) if value != LARGE => self.small.push(value),
            large => {
                self.large.insert(self.small.len(), large.into());
                self.small.push(LARGE);
            }
        }
    }

    #[inline(always)]
    fn coefficient<T: Int>(&self, index: usize, value: i64) -> Result<T, Larger> {
        if value == LARGE {
            T::of(self.large.get(&index).ok_or(Larger)?)
        } else {
            Ok(T::of_small(value))
        }
    }

    /// The coordinates of a vertex, times the denominator; in the plane the third one is zero.
    #[inline(always)]
    pub(crate) fn get<T: Int, const N: usize>(
        &self,
        vertex: u32,
    ) -> Result<[Element<T, N>; 3], Larger> {
        let degree = if N <= 2 { N } else { self.degree };
        let size = self.dimension * degree;
        let start = usize::try_from(vertex).map_err(|_| Larger)? * size;
        let small = self.small.get(start..start + size).ok_or(Larger)?;
        let mut point: [Element<T, N>; 3] = Default::default();
        let mut indices = start..;
        for (coordinate, values) in point.iter_mut().zip(small.chunks_exact(degree)) {
            for ((slot, &value), index) in coordinate.0.iter_mut().zip(values).zip(&mut indices) {
                *slot = self.coefficient(index, value)?;
            }
        }
        Ok(point)
    }

    /// The coordinates of a corner, times the denominator.
    #[inline(always)]
    pub(crate) fn point<T: Int, const N: usize>(
        &self,
        corner: Corner,
    ) -> Result<[Element<T, N>; 3], Larger> {
        let mut point: [Element<T, N>; 3] = self.get(corner.vertex)?;
        if corner.is_shifted() {
            let denominator = match self.small_denominator {
                Some(denominator) => T::of_small(denominator),
                None => T::of(&self.denominator)?,
            };
            for (coordinate, shift) in point.iter_mut().zip(corner.shift) {
                if let Some(constant) = coordinate.0.first_mut() {
                    constant.add_product(&denominator, &T::of_small(shift.into()))?;
                }
            }
        }
        Ok(point)
    }
}
