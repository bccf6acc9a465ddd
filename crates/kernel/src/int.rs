//! Integers of three sizes with the same operations. None wraps: a result that does not fit is [`Stop::LARGER`].

use crate::refusal::{Checked, Stop};
use num_bigint::BigInt;
use num_traits::{CheckedAdd, CheckedSub};
use std::cmp::Ordering;

pub trait Int: Clone + Default + Ord + From<i64> + Into<BigInt> + CheckedAdd + CheckedSub {
    /// The price of a product in units of work; zero where it depends on the factors.
    const PRICE: u64;

    fn of(value: &BigInt) -> Checked<Self>;
    /// The number of bits of the absolute value.
    fn length(&self) -> u64;
    /// floor(self / 2^dropped), where this fits 64 bits.
    fn top(&self, dropped: u64) -> Checked<i64>;

    /// The value, where it has 128 bits.
    fn wide(&self) -> Checked<i128>;

    fn big(&self) -> BigInt {
        self.clone().into()
    }

    fn sign(&self) -> Ordering {
        self.cmp(&Self::default())
    }

    fn plus(&self, other: &Self) -> Checked<Self> {
        self.checked_add(other).ok_or_else(|| Stop::LARGER)
    }

    fn minus(&self, other: &Self) -> Checked<Self> {
        self.checked_sub(other).ok_or_else(|| Stop::LARGER)
    }

    /// self + x y
    fn add_product(&mut self, x: &Self, y: &Self) -> Checked;
}

macro_rules! machine {
    ($int:ty, $bits:literal, $price:literal) => {
        impl Int for $int {
            const PRICE: u64 = $price;

            fn of(value: &BigInt) -> Checked<Self> {
                value.try_into().map_err(|_| Stop::LARGER)
            }

            fn length(&self) -> u64 {
                u64::from($bits - self.unsigned_abs().leading_zeros())
            }

            fn top(&self, dropped: u64) -> Checked<i64> {
                i64::try_from(self >> dropped.min($bits - 1)).map_err(|_| Stop::LARGER)
            }

            fn wide(&self) -> Checked<i128> {
                Ok((*self).into())
            }

            fn add_product(&mut self, x: &Self, y: &Self) -> Checked {
                let product = match (i64::try_from(*x), i64::try_from(*y)) {
                    // This fits 128 bits, and takes one instruction.
                    (Ok(x), Ok(y)) if $bits > 64 => <$int>::from(x) * <$int>::from(y),
                    _ => x.checked_mul(*y).ok_or_else(|| Stop::LARGER)?,
                };
                *self = self.plus(&product)?;
                Ok(())
            }
        }
    };
}

machine!(i64, 64, 1);
machine!(i128, 128, 4);

impl Int for BigInt {
    const PRICE: u64 = 0;

    fn of(value: &BigInt) -> Checked<Self> {
        Ok(value.clone())
    }

    fn length(&self) -> u64 {
        self.bits()
    }

    fn top(&self, dropped: u64) -> Checked<i64> {
        i64::of(&(self >> dropped))
    }

    fn wide(&self) -> Checked<i128> {
        i128::of(self)
    }

    fn add_product(&mut self, x: &Self, y: &Self) -> Checked {
        *self += x * y;
        Ok(())
    }
}
