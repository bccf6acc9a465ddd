//! Integers of 128, 256 and 512 bits: for predicates whose values are known to fit.
//!
//! Arithmetic is modulo 2^(64 N), in two's complement. A product takes the lower half of each factor as a
//! signed integer. So few machine multiplications are enough: 1, 4 and 16. The caller must have proved two
//! bounds (see [`super::bound`]). No value, final or intermediate, needs more than all bits, and no factor
//! of a product needs more than half of them. Then the results are those of the integers. Debug builds look
//! at each factor.

use super::{RingElement, Scalar, Sign};
use malachite::Integer;
use std::cmp::Ordering;

/// An integer of 128 bits, factors have 64.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct I128(pub i128);

/// An integer from -2^(64 N - 1) to 2^(64 N - 1) - 1, N even, least significant word first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide<const N: usize>(pub [u64; N]);

/// 256 bits, factors have 128.
pub type I256 = Wide<4>;
/// 512 bits, factors have 256.
pub type I512 = Wide<8>;

impl<const N: usize> Wide<N> {
    /// The integer 0.
    pub const ZERO: Self = Wide([0; N]);

    /// Whether the integer is negative.
    pub fn is_negative(&self) -> bool {
        (self.0[N - 1] as i64) < 0
    }

    /// The sum, if it fits.
    #[inline]
    pub fn checked_sum(&self, other: &Self) -> Option<Self> {
        let sum = self.plus(other);
        let [a, b, c] = [self, other, &sum].map(Wide::is_negative);
        (a != b || a == c).then_some(sum)
    }

    /// Whether the integer fits in the lower half.
    fn is_half(&self) -> bool {
        let sign = sign_word(self.0[N / 2 - 1]);
        self.0[N / 2..].iter().all(|word| *word == sign)
    }
}

/// All ones for a negative number with this highest word, else zero.
#[inline(always)]
fn sign_word(word: u64) -> u64 {
    ((word as i64) >> 63) as u64
}

#[inline(always)]
fn add(x: u64, y: u64, carry: bool) -> (u64, bool) {
    let (s, first) = x.overflowing_add(y);
    let (s, second) = s.overflowing_add(u64::from(carry));
    (s, first | second)
}

#[inline(always)]
fn subtract(x: u64, y: u64, borrow: bool) -> (u64, bool) {
    let (d, first) = x.overflowing_sub(y);
    let (d, second) = d.overflowing_sub(u64::from(borrow));
    (d, first | second)
}

impl<const N: usize> From<i128> for Wide<N> {
    #[inline(always)]
    fn from(value: i128) -> Self {
        let mut words = [(value >> 127) as u64; N];
        words[0] = value as u64;
        words[1] = (value >> 64) as u64;
        Wide(words)
    }
}

impl From<I256> for I512 {
    #[inline(always)]
    fn from(value: I256) -> Self {
        let [a, b, c, d] = value.0;
        let sign = sign_word(d);
        Wide([a, b, c, d, sign, sign, sign, sign])
    }
}

impl<const N: usize> From<&Wide<N>> for Integer {
    fn from(value: &Wide<N>) -> Self {
        Integer::from_twos_complement_limbs_asc(&value.0)
    }
}

impl<const N: usize> RingElement for Wide<N> {
    fn integer(&self, value: i64) -> Self {
        Wide::from(i128::from(value))
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        let mut sum = [0; N];
        let mut carry = false;
        for k in 0..N {
            (sum[k], carry) = add(self.0[k], other.0[k], carry);
        }
        Wide(sum)
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        let mut difference = [0; N];
        let mut borrow = false;
        for k in 0..N {
            (difference[k], borrow) = subtract(self.0[k], other.0[k], borrow);
        }
        Wide(difference)
    }

    /// Schoolbook for the lower halves X and Y as numbers without sign. A column sum stays
    /// below 2^128: (2^64 - 1)² + 2 (2^64 - 1) = 2^128 - 1. With H = 2^(32 N), x = X - H if x is
    /// negative, so that Y H is subtracted, and X H if y is negative; H² is 0.
    #[inline]
    fn times(&self, other: &Self) -> Self {
        debug_assert!(self.is_half() && other.is_half(), "{self:?} {other:?}");
        let mut product = [0u64; N];
        for i in 0..N / 2 {
            let mut carry = 0;
            for j in 0..N / 2 {
                let column = u128::from(self.0[i]) * u128::from(other.0[j])
                    + u128::from(product[i + j])
                    + u128::from(carry);
                product[i + j] = column as u64;
                carry = (column >> 64) as u64;
            }
            product[i + N / 2] = carry;
        }
        for (x, y) in [(self, other), (other, self)] {
            let mask = sign_word(x.0[N / 2 - 1]);
            let mut borrow = false;
            for k in 0..N / 2 {
                (product[k + N / 2], borrow) = subtract(product[k + N / 2], y.0[k] & mask, borrow);
            }
        }
        Wide(product)
    }
}

impl<const N: usize> Scalar for Wide<N> {
    fn sign(&self) -> Sign {
        match (self.is_negative(), *self == Wide::ZERO) {
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
            Wide::ZERO.minus(self)
        } else {
            *self
        };
        let words = size.0.iter().rev();
        let value = words.fold(0.0, |sum, &word| sum * 2f64.powi(64) + word as f64);
        if self.is_negative() { -value } else { value }
    }
}

impl RingElement for I128 {
    fn integer(&self, value: i64) -> Self {
        I128(i128::from(value))
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        I128(self.0 + other.0)
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        I128(self.0 - other.0)
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        let half = |x: i128| i128::from(x as i64);
        debug_assert!(half(self.0) == self.0 && half(other.0) == other.0);
        I128(half(self.0) * half(other.0))
    }
}

impl Scalar for I128 {
    #[inline]
    fn sign(&self) -> Sign {
        self.0.cmp(&0)
    }

    /// In 256 bits: |d y| must be less than 2^127.
    fn compare_squares(x: &Self, y: &Self, d: &Self) -> Ordering {
        let [x, y, d] = [x, y, d].map(|n| I256::from(n.0));
        x.times(&x).minus(&y.times(&d).times(&y)).sign()
    }

    fn approximate(&self) -> f64 {
        self.0 as f64
    }
}

/// Machine integers, for edges and other values that are known to fit.
impl RingElement for i128 {
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
}

impl Scalar for i128 {
    fn sign(&self) -> Sign {
        self.cmp(&0)
    }

    /// In integers without bound.
    fn compare_squares(x: &Self, y: &Self, d: &Self) -> Ordering {
        let [x, y, d] = [x, y, d].map(|n| Integer::from(*n));
        Integer::compare_squares(&x, &y, &d)
    }

    fn approximate(&self) -> f64 {
        *self as f64
    }
}
