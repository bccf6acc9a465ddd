//! Integers of 256 bits: for predicates whose values are known to fit.
//!
//! Arithmetic is modulo 2^256, in two's complement. Whoever uses it has proved that
//! no value, final or intermediate, reaches 2^255 (see [`super::bound`]); then
//! nothing wraps and the results are those of the integers.

use super::{Scalar, Sign};
use malachite::Integer;
use std::cmp::Ordering;

/// An integer from -2^255 to 2^255 - 1, least significant word first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct I256(pub [u64; 4]);

impl I256 {
    /// The integer 0.
    pub const ZERO: I256 = I256([0; 4]);

    /// x² compared with d y², where both are less than 2^255.
    fn compare_squares_within(x: &Self, y: &Self, d: &Self) -> Ordering {
        x.times(x).minus(&y.times(y).times(d)).sign()
    }

    /// Whether the integer is negative.
    pub fn is_negative(&self) -> bool {
        (self.0[3] as i64) < 0
    }
}

impl From<i128> for I256 {
    fn from(value: i128) -> Self {
        let sign = (value >> 127) as u64;
        I256([value as u64, (value >> 64) as u64, sign, sign])
    }
}

impl From<&I256> for Integer {
    fn from(value: &I256) -> Self {
        Integer::from_twos_complement_limbs_asc(&value.0)
    }
}

impl Scalar for I256 {
    fn integer(&self, value: i64) -> Self {
        I256::from(i128::from(value))
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        let mut sum = [0; 4];
        let mut carry = false;
        for k in 0..4 {
            let (s, first) = self.0[k].overflowing_add(other.0[k]);
            let (s, second) = s.overflowing_add(u64::from(carry));
            (sum[k], carry) = (s, first | second);
        }
        I256(sum)
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        let mut difference = [0; 4];
        let mut borrow = false;
        for k in 0..4 {
            let (d, first) = self.0[k].overflowing_sub(other.0[k]);
            let (d, second) = d.overflowing_sub(u64::from(borrow));
            (difference[k], borrow) = (d, first | second);
        }
        I256(difference)
    }

    /// Schoolbook, without the words from 2^256 on. A column sum stays below 2^128:
    /// (2^64 - 1)² + 2 (2^64 - 1) = 2^128 - 1.
    #[inline]
    fn times(&self, other: &Self) -> Self {
        let mut product = [0u64; 4];
        for i in 0..4 {
            let mut carry = 0;
            for j in 0..4 - i {
                let column = u128::from(self.0[i]) * u128::from(other.0[j])
                    + u128::from(product[i + j])
                    + u128::from(carry);
                product[i + j] = column as u64;
                carry = (column >> 64) as u64;
            }
        }
        I256(product)
    }

    fn sign(&self) -> Sign {
        match (self.is_negative(), self.0 == [0; 4]) {
            (true, _) => Ordering::Less,
            (false, true) => Ordering::Equal,
            (false, false) => Ordering::Greater,
        }
    }

    /// In integers without bound.
    fn compare_squares(x: &Self, y: &Self, d: &Self) -> Ordering {
        let [x, y, d] = [x, y, d].map(Integer::from);
        Integer::compare_squares(&x, &y, &d)
    }

    fn approximate(&self) -> f64 {
        let size = if self.is_negative() {
            I256::ZERO.minus(self)
        } else {
            *self
        };
        let value = size
            .0
            .iter()
            .rev()
            .fold(0.0, |sum, &word| sum * 2f64.powi(64) + word as f64);
        if self.is_negative() { -value } else { value }
    }
}

/// Machine integers, for predicates whose values are known to fit.
impl Scalar for i128 {
    fn integer(&self, value: i64) -> Self {
        i128::from(value)
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn sign(&self) -> Sign {
        self.cmp(&0)
    }

    /// In 256 bits: x² and d y² must be less than 2^255.
    fn compare_squares(x: &Self, y: &Self, d: &Self) -> Ordering {
        let [x, y, d] = [x, y, d].map(|n| I256::from(*n));
        I256::compare_squares_within(&x, &y, &d)
    }

    fn approximate(&self) -> f64 {
        *self as f64
    }
}
