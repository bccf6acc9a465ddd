//! Every exact operation against a second implementation. Rationals are compared with num-rational, Q(√5)
//! and Q(√2, √3) with formulas for pairs, a reducible field with an irreducible one, and signs with long
//! enclosures.

use acutile_exact::geometry::{RingElement, Scalar};
use acutile_exact::number::{Field, Number, Reader};
use malachite::base::num::arithmetic::traits::Pow;
use malachite::{Integer, Rational};
use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{Signed, Zero};
use proptest::prelude::*;
use std::cmp::Ordering;

type BigRational = Ratio<BigInt>;

fn big(text: &str) -> BigRational {
    text.parse().unwrap()
}

fn rational(x: &BigRational) -> Rational {
    x.to_string().parse().unwrap()
}

/// Fractions of all sizes.
fn fraction() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        (-9i64..=9, 1i64..=4).prop_map(|(n, d)| (n as i128, d as i128)),
        (any::<i32>(), 1..=i32::MAX).prop_map(|(n, d)| (n as i128, d as i128)),
        (any::<i64>(), 1..=i64::MAX).prop_map(|(n, d)| (n as i128, d as i128)),
        (any::<i128>(), 1..=i128::MAX),
    ]
    .prop_map(|(n, d)| BigRational::new(n.into(), d.into()))
}

/// x + y √d as a pair over any ring of pairs or fractions.
#[derive(Clone, Debug, PartialEq)]
struct Pair(BigRational, BigRational);

fn pair() -> impl Strategy<Value = Pair> {
    (fraction(), fraction()).prop_map(|(x, y)| Pair(x, y))
}

impl Pair {
    fn times(&self, o: &Pair, d: i64) -> Pair {
        let d = BigRational::from_integer(d.into());
        Pair(
            &self.0 * &o.0 + d * &self.1 * &o.1,
            &self.0 * &o.1 + &self.1 * &o.0,
        )
    }
    fn plus(&self, o: &Pair) -> Pair {
        Pair(&self.0 + &o.0, &self.1 + &o.1)
    }
    fn minus(&self, o: &Pair) -> Pair {
        Pair(&self.0 - &o.0, &self.1 - &o.1)
    }
    /// (x - y √d)/(x² - d y²)
    fn inverse(&self, d: i64) -> Pair {
        let norm = &self.0 * &self.0 - BigRational::from_integer(d.into()) * &self.1 * &self.1;
        Pair(&self.0 / &norm, -&self.1 / norm)
    }
    /// The sign of the larger of x² and d y².
    fn sign(&self, d: i64) -> Ordering {
        let square = BigRational::from_integer(d.into()) * &self.1 * &self.1;
        let winner = if &self.0 * &self.0 > square {
            &self.0
        } else {
            &self.1
        };
        winner.cmp(&BigRational::zero())
    }
    fn number(&self, root: &Number) -> Number {
        Number::from(rational(&self.0)) + Number::from(rational(&self.1)) * root
    }
}

fn field(polynomial: &[i64], lo: (i64, i64), hi: (i64, i64)) -> Number {
    let p: Vec<Integer> = polynomial.iter().map(|c| Integer::from(*c)).collect();
    let end = |(n, d)| Rational::from_signeds(n, d);
    Field::adjoin_root(&p, end(lo), end(hi)).unwrap().1
}

proptest! {
    #[test]
    fn rationals(x in fraction(), y in fraction()) {
        let (a, b) = (Number::from(rational(&x)), Number::from(rational(&y)));
        prop_assert_eq!((&a + &b).to_string(), (&x + &y).to_string());
        prop_assert_eq!((&a - &b).to_string(), (&x - &y).to_string());
        prop_assert_eq!((&a * &b).to_string(), (&x * &y).to_string());
        prop_assert_eq!(a.cmp(&b), x.cmp(&y));
        prop_assert_eq!(a.sign(), x.cmp(&BigRational::zero()));
        prop_assert_eq!(a.abs().to_string(), x.abs().to_string());
        let quotient = (!y.is_zero()).then(|| (&x / &y).to_string());
        prop_assert_eq!(a.divide(&b).map(|q| q.to_string()), quotient);
    }

    #[test]
    fn square_root_of_five(x in pair(), y in pair()) {
        let root = field(&[-5, 0, 1], (0, 1), (3, 1));
        let (a, b) = (x.number(&root), y.number(&root));
        let same = |n: Number, p: Pair| n.coefficients() == p.number(&root).coefficients();
        prop_assert!(same(&a + &b, x.plus(&y)));
        prop_assert!(same(&a - &b, x.minus(&y)));
        prop_assert!(same(&a * &b, x.times(&y, 5)));
        prop_assert!(same(-&a, Pair(-&x.0, -&x.1)));
        prop_assert_eq!(a.sign(), x.sign(5));
        prop_assert_eq!(a.cmp(&b), x.minus(&y).sign(5));
        prop_assert!(a.is_zero() || same(a.inverse().unwrap(), x.inverse(5)));
    }

    /// Pairs x + y √3 of numbers x, y in Q(√2).
    #[test]
    fn two_square_roots(x in pair(), y in pair(), z in pair(), w in pair()) {
        let mut reader = Reader::new();
        reader.learn("sqrt(2)+sqrt(3)").unwrap();
        let (r, s) = (reader.value("sqrt(2)").unwrap(), reader.value("sqrt(3)").unwrap());
        let number = |x: &Pair, y: &Pair| x.number(&r) + y.number(&r) * &s;
        let (a, b) = (number(&x, &y), number(&z, &w));
        let yw = y.times(&w, 2);
        let three_yw = yw.plus(&yw).plus(&yw);
        let product = number(&x.times(&z, 2).plus(&three_yw), &x.times(&w, 2).plus(&y.times(&z, 2)));
        let found = &a * &b;
        prop_assert_eq!(found.coefficients(), product.coefficients());
        prop_assert_eq!((&a - &b).sign(), number(&x.minus(&z), &y.minus(&w)).sign());
        prop_assert!(a.is_zero() || a.inverse().unwrap() * &a == Number::from(Rational::from(1)));
    }

    /// (x² - 2)(x² - 3) at √3 and x² - 3: the same real numbers, written with four
    /// coefficients and with two.
    #[test]
    fn reducible_twin(c in prop::collection::vec(-3i64..=3, 4), e in prop::collection::vec(-3i64..=3, 4)) {
        let long = field(&[6, 0, -5, 0, 1], (3, 2), (2, 1));
        let short = field(&[-3, 0, 1], (0, 1), (2, 1));
        let at = |c: &[i64], a: &Number| {
            let term = |c: i64| Number::from(Rational::from(c));
            c.iter().rev().fold(Number::zero(), |value, c| value * a + term(*c))
        };
        let (x, y) = (at(&c, &long), at(&e, &long));
        let (u, v) = (at(&c, &short), at(&e, &short));
        prop_assert_eq!(x.sign(), u.sign());
        prop_assert_eq!(x.cmp(&y), u.cmp(&v));
        prop_assert_eq!(x == y, u == v);
        prop_assert_eq!(x.inverse().is_none(), u.is_zero());
        let difference = u.approximate() - x.approximate();
        prop_assert!(difference.abs() <= 1e-15 * u.approximate().abs());
        if let (Some(x), Some(u)) = (x.inverse(), u.inverse()) {
            prop_assert_eq!((x * &y).sign(), (u * &v).sign());
        }
    }

    #[test]
    fn signs_against_long_enclosures(c in prop::collection::vec(fraction(), 1..6)) {
        // The real root of x³ - x - 1, the greatest one of x⁴ - 10 x² + 1.
        for a in [field(&[-1, -1, 0, 1], (1, 1), (2, 1)), field(&[1, 0, -10, 0, 1], (3, 1), (4, 1))] {
            let x = a.field().unwrap().element(c.iter().map(rational).collect());
            let width = Rational::from(10).pow(-120i64);
            let (lo, hi) = x.enclosure(&width);
            prop_assert!(lo <= hi && &hi - &lo <= width);
            if lo > 0 || hi < 0 {
                prop_assert_eq!(x.sign(), lo.cmp(&Rational::from(0)));
            }
            let double = x.approximate();
            let near = |d: f64| Rational::try_from(d).unwrap();
            prop_assert!(near(double.next_down()) < hi && lo < near(double.next_up()));
            // The enclosure does not depend on what was asked before.
            let fresh = field(&a.field().unwrap().polynomial().iter().map(|c| i64::try_from(c).unwrap())
                .collect::<Vec<_>>(), (1, 1), (4, 1));
            let again = fresh.field().unwrap().element(x.coefficients().to_vec());
            prop_assert_eq!(again.enclosure(&width), (lo, hi));
        }
    }

    #[test]
    fn integers_as_scalars(x in any::<i64>(), y in any::<i64>()) {
        let (a, b) = (Integer::from(x), Integer::from(y));
        let (x, y) = (i128::from(x), i128::from(y));
        prop_assert_eq!(a.plus(&b).to_string(), (x + y).to_string());
        prop_assert_eq!(a.minus(&b).to_string(), (x - y).to_string());
        prop_assert_eq!(a.times(&b).to_string(), (x * y).to_string());
        prop_assert_eq!(Scalar::sign(&a), x.cmp(&0));
        prop_assert_eq!(a.times(&b).approximate(), (x * y) as f64);
    }
}

/// √5 minus its convergents: signs that need many bits.
#[test]
fn close_to_zero() {
    let root = field(&[-5, 0, 1], (0, 1), (3, 1));
    // x² - 5 y² = ±1: (x, y) ↦ (2x + 5y, x + 2y), from (2, 1) with -1.
    let (mut x, mut y) = (big("2"), big("1"));
    let (two, five) = (big("2"), big("5"));
    for i in 0..600 {
        let difference = &root * &Number::from(rational(&y)) - Number::from(rational(&x));
        let expected = if i % 2 == 0 {
            Ordering::Greater
        } else {
            Ordering::Less
        };
        assert_eq!(difference.sign(), expected, "step {i}");
        (x, y) = (&two * &x + &five * &y, &x + &two * &y);
    }
}

#[test]
fn doubles_beyond_the_range() {
    let huge = Number::from(Rational::from(10).pow(400i64));
    assert_eq!(huge.approximate(), f64::INFINITY);
    assert_eq!(
        (-&huge * field(&[-2, 0, 1], (0, 1), (2, 1))).approximate(),
        f64::NEG_INFINITY
    );
    assert_eq!(Integer::from(10).pow(400u64).approximate(), f64::INFINITY);
    let tiny = Number::from(Rational::from(10).pow(-400i64));
    assert_eq!(
        (tiny * field(&[-2, 0, 1], (0, 1), (2, 1))).approximate(),
        0.0
    );
}

#[test]
fn fields_are_equal_by_polynomial_and_root() {
    let positive = field(&[-5, 0, 1], (0, 1), (3, 1));
    let again = field(&[-5, 0, 1], (223, 100), (224, 100));
    let negative = field(&[-5, 0, 1], (-3, 1), (0, 1));
    assert_eq!(positive.field(), again.field());
    assert_ne!(positive.field(), negative.field());
    assert_eq!(&positive - &again, Number::zero());
}

#[test]
#[should_panic(expected = "different fields")]
fn different_fields_do_not_mix() {
    let _ = field(&[-5, 0, 1], (0, 1), (3, 1)) + field(&[-5, 0, 1], (-3, 1), (0, 1));
}
