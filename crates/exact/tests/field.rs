//! Fields and their elements: known values, reducible polynomials, twins.

use acutile_exact::number::{Field, FieldError, Interval, Number};
use malachite::base::num::arithmetic::traits::{Pow, Square};
use malachite::{Integer, Rational};
use std::cmp::Ordering;

fn q(n: i64, d: i64) -> Rational {
    Rational::from_signeds(n, d)
}

fn root(polynomial: &[i64], lo: i64, hi: i64) -> Result<(Field, Number), FieldError> {
    let p: Vec<Integer> = polynomial.iter().map(|c| Integer::from(*c)).collect();
    Field::adjoin_root(&p, q(lo, 1), q(hi, 1))
}

fn one() -> Number {
    Number::from(q(1, 1))
}

#[test]
fn golden_ratio() {
    let (field, s) = root(&[-5, 0, 1], 0, 3).unwrap();
    let phi = field.element(vec![q(1, 2), q(1, 2)]);
    assert_eq!(&phi * &phi, &phi + &one());
    assert_eq!(phi.inverse().unwrap(), &phi - &one());
    assert_eq!(phi.to_string(), "1/2 + 1/2 a");
    assert_eq!((&s - &phi).to_string(), "-1/2 + 1/2 a");
    assert_eq!(phi.approximate(), 1.618033988749895);
    assert!(phi > Number::from(q(1618033988, 1000000000)));
    assert!(phi < Number::from(q(1618033989, 1000000000)));
}

/// (x^2 - 2)(x^2 - 3) at sqrt(3), (x - 1)(x^2 - 2) at sqrt(2), x^4 - 4 at
/// sqrt(2): every zero is recognised, and what is not zero has an inverse.
#[test]
fn reducible_polynomials() {
    for (p, lo, hi, square) in [
        (&[6, 0, -5, 0, 1][..], 1, 1, 2),
        (&[2, -2, -1, 1], 1, 2, 2),
        (&[-4, 0, 0, 0, 1], 0, 2, 2),
    ] {
        let (lo, hi) = if lo == hi {
            (q(3, 2), q(2, 1))
        } else {
            (q(lo, 1), q(hi, 1))
        };
        let lo = if p.len() == 4 { q(5, 4) } else { lo };
        let p: Vec<Integer> = p.iter().map(|c| Integer::from(*c)).collect();
        let (field, a) = Field::adjoin_root(&p, lo, hi).unwrap();
        let square = if p.len() == 5 && p[0] == 6 { 3 } else { square };
        let zero = &a * &a - Number::from(q(square, 1));
        assert!(
            zero.coefficients().len() > 1,
            "the vector of {field:?} is not zero"
        );
        assert_eq!(zero.sign(), Ordering::Equal);
        assert!(zero.inverse().is_none());
        assert_eq!(&a * &a, Number::from(q(square, 1)));
        for other in [1, 2, 3, 4, 5].into_iter().filter(|n| *n != square) {
            let x = &a * &a - Number::from(q(other, 1));
            assert_eq!(x.sign(), square.cmp(&other));
            assert_eq!(x.inverse().unwrap() * &x, one());
        }
        assert_eq!(a.inverse().unwrap() * &a, one());
    }
}

#[test]
fn refused_fields() {
    let error = |p: &[i64], lo, hi| root(p, lo, hi).unwrap_err();
    assert_eq!(error(&[0, 0], 0, 1), FieldError::ZeroPolynomial);
    assert_eq!(error(&[3], 0, 1), FieldError::ConstantPolynomial);
    assert_eq!(
        error(&[-2, 0, 1], 2, 3),
        FieldError::NoRoot(q(2, 1), q(3, 1))
    );
    assert_eq!(
        error(&[-2, 0, 1], -2, 3),
        FieldError::SeveralRoots(q(-2, 1), q(3, 1), 2)
    );
    assert_eq!(
        error(&[-2, 0, 1], 3, 1),
        FieldError::EmptyInterval(q(3, 1), q(1, 1))
    );
    assert_eq!(
        error(&[-2, 0, 1], -2, 3).to_string(),
        "the polynomial has 2 roots from -2 to 3, and must have one"
    );
    let huge = [-(Integer::from(1) << 4096u64), Integer::from(1)];
    assert_eq!(
        Field::adjoin_root(&huge, q(0, 1), q(1, 1)).unwrap_err(),
        FieldError::SizeBeyondLimit(4097)
    );
    let mut long = vec![0; 34];
    long[33] = 1;
    assert_eq!(error(&long, 0, 1), FieldError::DegreeBeyondLimit(33));
}

#[test]
fn rational_roots_stay_in_q() {
    // (2x - 1)(x^2 - 2), a root at the end, a double root.
    for (p, lo, hi, value) in [
        (&[2, -4, -1, 2][..], 0, 1, q(1, 2)),
        (&[-3, 1], 3, 5, q(3, 1)),
        (&[1, -2, 1], 0, 5, q(1, 1)),
    ] {
        let (field, a) = root(p, lo, hi).unwrap();
        assert!(field.is_rationals());
        assert_eq!(a, Number::from(value));
    }
}

/// x^32 - 2 (c x - 1)² for c = 10^600 has two roots within about c^-17 of 1/c (Mignotte). They are too
/// close to be separated within the limit.
#[test]
fn roots_too_close() {
    let c = Integer::from(10).pow(600u64);
    let mut p = vec![Integer::from(0); 33];
    p[0] = Integer::from(-2);
    p[1] = Integer::from(4) * &c;
    p[2] = Integer::from(-2) * (&c).square();
    p[32] = Integer::from(1);
    let end = Rational::from_integers(Integer::from(1), c);
    assert_eq!(
        Field::adjoin_root(&p, q(0, 1), end).unwrap_err(),
        FieldError::RootsTooClose
    );
}

/// 4x² - 5 at √5/2: the generator is an algebraic integer, and as small as easy.
#[test]
fn generators_are_algebraic_integers() {
    let (field, x) = root(&[-5, 0, 4], 0, 2).unwrap();
    assert_eq!(field.polynomial(), [-5, 0, 1].map(Integer::from));
    assert_eq!(x.to_string(), "1/2 a");
    assert_eq!(&x * &x, Number::from(q(5, 4)));
    // -x³ + 2x + 4/9 has the roots of 9x³ - 18x - 4.
    let (field, x) = root(&[4, 18, 0, -9], 1, 2).unwrap();
    assert_eq!(field.polynomial().last(), Some(&Integer::from(1)));
    let nine = Number::from(q(9, 1));
    assert_eq!(
        nine * &x * &x * &x,
        Number::from(q(18, 1)) * &x + Number::from(q(4, 1))
    );
}

/// The conditions of a certificate on the interval, with rational Horner: opposite signs at the ends, and a
/// derivative whose interval value excludes 0.
#[test]
fn intervals_are_as_certificates_want_them() {
    for (p, lo, hi) in [
        (&[-5, 0, 1][..], 0, 3),
        (&[-5, 0, 1], -3, 0),
        (&[6, 0, -5, 0, 1], -3, -1),
        (&[1, 0, -10, 0, 1], 0, 1),
        (&[-1, -1, 0, 1], 0, 2),
        (&[-2, 0, 1], 0, 2),
    ] {
        let Ok((field, a)) = root(p, lo, hi) else {
            assert_eq!(p[0], 6, "-√2 and -√3 are two roots");
            continue;
        };
        let (lo, hi) = field.root();
        let at = |x: &Rational| {
            let term = |c: &Integer| Rational::from(c);
            field
                .polynomial()
                .iter()
                .rev()
                .fold(q(0, 1), |v, c| v * x + term(c))
        };
        assert!(at(&lo) * at(&hi) < 0);
        let mut slope = Interval {
            lo: q(0, 1),
            hi: q(0, 1),
        };
        for (i, c) in field.polynomial().iter().enumerate().skip(1).rev() {
            let c = Rational::from(c) * Rational::from(i as u64);
            slope = slope.times(&Interval {
                lo: lo.clone(),
                hi: hi.clone(),
            });
            slope = Interval {
                lo: slope.lo + &c,
                hi: slope.hi + c,
            };
        }
        assert!(!slope.contains_zero());
        assert!(a > Number::from(lo) && a < Number::from(hi));
    }
}

#[test]
fn display() {
    let (field, a) = root(&[-1, -1, 0, 1], 0, 2).unwrap();
    let x = field.element(vec![q(0, 1), q(-1, 2), q(1, 1)]);
    assert_eq!(x.to_string(), "-1/2 a + a^2");
    assert_eq!((-&x).to_string(), "1/2 a - a^2");
    assert_eq!((&a * &a * &a).to_string(), "1 + a");
    let zero = &a - &a;
    assert_eq!(zero.to_string(), "0");
    assert!(zero.is_rational() && zero.inverse().is_none() && a.divide(&zero).is_none());
    assert_eq!(Field::rationals().degree(), 1);
}

#[test]
fn floors() {
    let (_, s) = root(&[-5, 0, 1], 0, 3).unwrap();
    let far = Integer::from(2).pow(70u64);
    let number = |n: &Integer| Number::from(Rational::from(n));
    // 2 < √5 < 3, and √5 √5 = 5 as an element of the field.
    let cases = [
        (s.clone(), Integer::from(2)),
        (-&s, Integer::from(-3)),
        (&s + &number(&far), &far + Integer::from(2)),
        (&number(&-&far) - &s, -&far - Integer::from(3)),
        (&s * &s, Integer::from(5)),
        (Number::from(q(7, 2)), Integer::from(3)),
        (Number::from(q(-7, 2)), Integer::from(-4)),
    ];
    for (x, floor) in cases {
        assert_eq!(x.floor(), floor, "{x}");
    }
}
