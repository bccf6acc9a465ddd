//! Fields and their elements: known values, reducible polynomials, twins.
#![cfg(feature = "prover")]

use acutile::number::{Field, FieldError, Number};
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
