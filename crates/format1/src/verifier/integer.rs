//! Integers of any length: in 128 bits of the machine while they fit, else by num-bigint.
//!
//! No operation wraps or loses a bit: each is one of i128 that answers `None` on overflow,
//! and then it is done by num-bigint. Called by everything that computes; it knows no field.

use num_bigint::{BigInt, Sign};
use num_traits::ToPrimitive;
use std::borrow::Cow;
use std::cmp::Ordering;
use std::mem;
use std::ops::Mul;

/// An integer, in the only form that it has: hence the derived equality is that of values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Integer(Form);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Form {
    Small(i128),
    /// No i128 has this value.
    Large(BigInt),
}

use Form::{Large, Small};

impl Integer {
    pub(super) const ZERO: Integer = Integer(Small(0));
    pub(super) const ONE: Integer = Integer(Small(1));

    pub(super) fn big(&self) -> Cow<'_, BigInt> {
        match &self.0 {
            Small(x) => Cow::Owned(BigInt::from(*x)),
            Large(x) => Cow::Borrowed(x),
        }
    }

    pub(super) fn into_big(self) -> BigInt {
        match self.0 {
            Small(x) => BigInt::from(x),
            Large(x) => x,
        }
    }

    pub(super) fn is_zero(&self) -> bool {
        matches!(self.0, Small(0))
    }

    /// How it compares with zero.
    pub(super) fn sign(&self) -> Ordering {
        match &self.0 {
            Small(x) => x.cmp(&0),
            Large(x) => x.sign().cmp(&Sign::NoSign),
        }
    }

    /// The bits of its absolute value.
    pub(super) fn bits(&self) -> u64 {
        match &self.0 {
            Small(x) => u64::from(i128::BITS - x.unsigned_abs().leading_zeros()),
            Large(x) => x.bits(),
        }
    }

    pub(super) fn pow(&self, exponent: usize) -> Integer {
        (0..exponent).fold(Integer::ONE, |power, _| &power * self)
    }

    /// The greatest integer that is at most self / 2^bits.
    pub(super) fn shifted_down(&self, bits: u64) -> Integer {
        match &self.0 {
            Small(x) => Integer(Small(x >> bits.min(127))),
            Large(x) => Integer::from(x >> bits),
        }
    }

    /// self ± x y
    #[inline]
    pub(super) fn add_product(&mut self, minus: bool, x: &Integer, y: &Integer) {
        if let (Small(sum), Small(x), Small(y)) = (&mut self.0, &x.0, &y.0)
            && let Some(product) = small_product(*x, *y)
            && let Some(next) = small_sum(minus, *sum, product)
        {
            *sum = next;
            return;
        }
        self.add_large_product(minus, x, y);
    }

    #[cold]
    fn add_large_product(&mut self, minus: bool, x: &Integer, y: &Integer) {
        self.add(minus, &(x * y));
    }

    /// self ± x
    #[inline]
    pub(super) fn add(&mut self, minus: bool, x: &Integer) {
        if let (Small(sum), Small(x)) = (&mut self.0, &x.0)
            && let Some(next) = small_sum(minus, *sum, *x)
        {
            *sum = next;
            return;
        }
        let sum = mem::take(self).into_big();
        *self = Integer::from(match (minus, &x.0) {
            (true, Small(x)) => sum - *x,
            (true, Large(x)) => sum - x,
            (false, Small(x)) => sum + *x,
            (false, Large(x)) => sum + x,
        });
    }
}

#[inline]
fn small_sum(minus: bool, x: i128, y: i128) -> Option<i128> {
    match minus {
        true => x.checked_sub(y),
        false => x.checked_add(y),
    }
}

/// x y; where both have 64 bits it is one instruction that cannot overflow.
#[inline]
fn small_product(x: i128, y: i128) -> Option<i128> {
    match (i64::try_from(x), i64::try_from(y)) {
        (Ok(x), Ok(y)) => Some(i128::from(x) * i128::from(y)),
        _ => x.checked_mul(y),
    }
}

impl From<BigInt> for Integer {
    fn from(x: BigInt) -> Integer {
        match x.to_i128() {
            Some(small) => Integer(Small(small)),
            None => Integer(Large(x)),
        }
    }
}

impl From<i64> for Integer {
    fn from(x: i64) -> Integer {
        Integer(Small(i128::from(x)))
    }
}

impl Default for Integer {
    fn default() -> Integer {
        Integer::ZERO
    }
}

impl Mul for &Integer {
    type Output = Integer;

    #[inline]
    fn mul(self, other: &Integer) -> Integer {
        match (&self.0, &other.0) {
            (Small(x), Small(y)) => match small_product(*x, *y) {
                Some(product) => Integer(Small(product)),
                None => Integer(Large(BigInt::from(*x) * *y)),
            },
            (Large(x), Small(y)) | (Small(y), Large(x)) => Integer::from(x * *y),
            (Large(x), Large(y)) => Integer::from(x * y),
        }
    }
}

impl Ord for Integer {
    fn cmp(&self, other: &Integer) -> Ordering {
        match (&self.0, &other.0) {
            (Small(x), Small(y)) => x.cmp(y),
            _ => self.big().cmp(&other.big()),
        }
    }
}

impl PartialOrd for Integer {
    fn partial_cmp(&self, other: &Integer) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests;
