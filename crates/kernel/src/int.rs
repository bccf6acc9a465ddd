//! Integers of three sizes with the same operations. None wraps: a result that does not fit is
//! [`Larger`].

use crate::refusal::Larger;
use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

pub trait Int: Clone + Default + PartialEq {
    /// The next larger integers.
    type Next: Int;
    /// The price of one product in units of work, where it does not depend on the factors.
    const PRICE: u64;

    fn of(value: &BigInt) -> Result<Self, Larger>;
    fn of_small(value: i64) -> Self;
    fn big(&self) -> BigInt;
    /// The value, if it has 128 bits.
    fn small(&self) -> Option<i128>;
    fn plus(&self, other: &Self) -> Result<Self, Larger>;
    fn minus(&self, other: &Self) -> Result<Self, Larger>;
    /// self + x y
    fn add_product(&mut self, x: &Self, y: &Self) -> Result<(), Larger>;
    fn sign(&self) -> Ordering;
    fn next(&self) -> Self::Next;
    /// The number of bits of the absolute value.
    fn bits(&self) -> u64;
    /// floor(self / 2^dropped), where this fits 64 bits.
    fn top(&self, dropped: u64) -> Result<i64, Larger>;
    /// The price of a product that depends on the factors.
    fn price(_x: &Self, _y: &Self) -> u64 {
        0
    }
}

macro_rules! machine {
    ($int:ty, $next:ty, $bits:literal, $price:literal) => {
        impl Int for $int {
            type Next = $next;
            const PRICE: u64 = $price;

            fn of(value: &BigInt) -> Result<Self, Larger> {
                value.try_into().map_err(|_| Larger)
            }

            #[inline(always)]
            fn of_small(value: i64) -> Self {
                value.into()
            }

            fn big(&self) -> BigInt {
                (*self).into()
            }

            #[inline(always)]
            fn small(&self) -> Option<i128> {
                Some((*self).into())
            }

            #[inline(always)]
            fn plus(&self, other: &Self) -> Result<Self, Larger> {
                self.checked_add(*other).ok_or(Larger)
            }

            #[inline(always)]
            fn minus(&self, other: &Self) -> Result<Self, Larger> {
                self.checked_sub(*other).ok_or(Larger)
            }

            #[inline(always)]
            fn add_product(&mut self, x: &Self, y: &Self) -> Result<(), Larger> {
                let product = x.checked_mul(*y).ok_or(Larger)?;
                *self = self.checked_add(product).ok_or(Larger)?;
                Ok(())
            }

            #[inline(always)]
            fn sign(&self) -> Ordering {
                self.cmp(&0)
            }

            #[inline(always)]
            fn next(&self) -> $next {
                (*self).into()
            }

            #[inline(always)]
            fn bits(&self) -> u64 {
                u64::from($bits - self.unsigned_abs().leading_zeros())
            }

            #[inline(always)]
            fn top(&self, dropped: u64) -> Result<i64, Larger> {
                // The shift of a negative number rounds down, too.
                let shift = dropped.min($bits - 1);
                i64::try_from(self >> shift).map_err(|_| Larger)
            }
        }
    };
}

machine!(i64, i128, 64, 1);
machine!(i128, BigInt, 128, 4);

impl Int for BigInt {
    type Next = BigInt;
    const PRICE: u64 = 0;

    fn of(value: &BigInt) -> Result<Self, Larger> {
        Ok(value.clone())
    }

    fn of_small(value: i64) -> Self {
        value.into()
    }

    fn big(&self) -> BigInt {
        self.clone()
    }

    fn small(&self) -> Option<i128> {
        self.try_into().ok()
    }

    fn plus(&self, other: &Self) -> Result<Self, Larger> {
        Ok(self + other)
    }

    fn minus(&self, other: &Self) -> Result<Self, Larger> {
        Ok(self - other)
    }

    fn add_product(&mut self, x: &Self, y: &Self) -> Result<(), Larger> {
        *self += x * y;
        Ok(())
    }

    fn sign(&self) -> Ordering {
        BigInt::sign(self).cmp(&Sign::NoSign)
    }

    fn next(&self) -> BigInt {
        self.clone()
    }

    fn bits(&self) -> u64 {
        BigInt::bits(self)
    }

    fn top(&self, dropped: u64) -> Result<i64, Larger> {
        i64::try_from(self >> dropped).map_err(|_| Larger)
    }

    /// The products of words, and something for the memory.
    fn price(x: &BigInt, y: &BigInt) -> u64 {
        50 + (1 + x.bits() / 64) * (1 + y.bits() / 64)
    }
}

/// The greatest common divisor, not negative.
pub(crate) fn gcd(x: &BigInt, y: &BigInt) -> BigInt {
    let (mut x, mut y) = (x.clone(), y.clone());
    while BigInt::sign(&y) != Sign::NoSign {
        (x, y) = (y.clone(), x % y);
    }
    BigInt::from(x.magnitude().clone())
}
