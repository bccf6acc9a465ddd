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
mod tests {
    use super::*;
    use num_integer::Integer as _;
    use proptest::prelude::*;

    /// Everything near a power of two, with both signs, up to 2^260: 0, the borders of i64
    /// and i128, their squares, and what is one or two off.
    fn borders() -> Vec<BigInt> {
        let powers = (0..=260).flat_map(|k| (-2..=2).map(move |by| (BigInt::from(1) << k) + by));
        let mut all: Vec<BigInt> = powers.flat_map(|x| [-&x, x]).collect();
        all.sort();
        all.dedup();
        all
    }

    /// All that is asked of two integers, against num-bigint.
    fn check(x: &BigInt, y: &BigInt) {
        let (a, b) = (Integer::from(x.clone()), Integer::from(y.clone()));
        check_one(&(&a * &b), &(x * y));
        check_one(
            &a.shifted_down(y.bits()),
            &x.div_floor(&(BigInt::from(1) << y.bits())),
        );
        let by = |change: &dyn Fn(&mut Integer)| {
            let mut changed = a.clone();
            change(&mut changed);
            changed
        };
        check_one(&by(&|x| x.add(false, &b)), &(x + y));
        check_one(&by(&|x| x.add(true, &b)), &(x - y));
        check_one(&by(&|x| x.add_product(false, &b, &a)), &(x + y * x));
        check_one(&by(&|x| x.add_product(true, &b, &a)), &(x - y * x));
        assert_eq!(a.cmp(&b), x.cmp(y));
        assert_eq!(a == b, x == y);
    }

    /// The value, the only form, sign and length.
    fn check_one(found: &Integer, expected: &BigInt) {
        assert_eq!(found.big().as_ref(), expected);
        assert_eq!(found, &Integer::from(expected.clone()));
        let fits = (BigInt::from(i128::MIN)..=BigInt::from(i128::MAX)).contains(expected);
        assert_eq!(matches!(found.0, Small(_)), fits, "{expected}");
        assert_eq!(found.sign(), expected.cmp(&BigInt::ZERO));
        assert_eq!(found.is_zero(), *expected == BigInt::ZERO);
        assert_eq!(found.bits(), expected.bits());
    }

    #[test]
    fn agrees_with_num_bigint_at_all_borders() {
        let borders = borders();
        // Of the powers up to 2^130 all, of the larger ones some.
        let near: Vec<&BigInt> = borders.iter().filter(|x| x.bits() <= 131).collect();
        for x in near.iter().copied().chain(borders.iter().step_by(41)) {
            for y in near
                .iter()
                .copied()
                .step_by(3)
                .chain(borders.iter().step_by(37))
            {
                check(x, y);
            }
        }
        for &power in &[63, 64, 127, 128] {
            let edge: BigInt = BigInt::from(1) << power;
            for by in -2..=2 {
                for x in [edge.clone() + by, -edge.clone() - by] {
                    borders.iter().for_each(|y| check(&x, y));
                }
            }
        }
    }

    #[test]
    fn the_least_of_128_bits_has_a_negative_and_a_square() {
        let (least, one) = (BigInt::from(i128::MIN), BigInt::from(1));
        for other in [
            &-&one,
            &one,
            &least,
            &BigInt::from(i128::MAX),
            &BigInt::ZERO,
        ] {
            check(&least, other);
            check(other, &least);
        }
        // 2^127, by hand.
        let mut negative = Integer::ZERO;
        negative.add(true, &Integer::from(least));
        assert_eq!(
            negative.big().to_string(),
            "170141183460469231731687303715884105728"
        );
        assert_eq!(negative.bits(), 128);
        // What has become large becomes small again.
        negative.add(true, &Integer::ONE);
        assert_eq!(negative.0, Small(i128::MAX));
    }

    #[test]
    fn powers() {
        for base in [-3i64, 0, 1, 10, i64::MIN, i64::MAX] {
            for exponent in 0..9 {
                let found = Integer::from(base).pow(exponent);
                check_one(&found, &BigInt::from(base).pow(exponent as u32));
            }
        }
    }

    /// Integers of up to 300 bits, of each length equally often.
    fn any_integer() -> impl Strategy<Value = BigInt> {
        let bytes = prop::collection::vec(any::<u8>(), 38);
        (bytes, 0usize..304)
            .prop_map(|(bytes, shift)| BigInt::from_signed_bytes_le(&bytes) >> shift)
    }

    proptest! {
        #[test]
        fn agrees_with_num_bigint(x in any_integer(), y in any_integer()) {
            check(&x, &y);
        }

        #[test]
        fn sums_of_products_agree(terms in prop::collection::vec((any::<bool>(), any_integer(), any_integer()), 0..12)) {
            let (mut found, mut expected) = (Integer::ZERO, BigInt::ZERO);
            for (minus, x, y) in terms {
                found.add_product(minus, &Integer::from(x.clone()), &Integer::from(y.clone()));
                expected += if minus { -(x * y) } else { x * y };
                check_one(&found, &expected);
            }
        }
    }
}
