//! Every operation against num-bigint, most of all where 64 and 128 bits end.

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
    (bytes, 0usize..304).prop_map(|(bytes, shift)| BigInt::from_signed_bytes_le(&bytes) >> shift)
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
