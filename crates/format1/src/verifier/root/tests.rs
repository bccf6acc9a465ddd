//! Signs and products in Z[a] against exact rules that need no enclosure.

use super::super::ring::Ring;
use super::*;
use num_bigint::BigInt;
use num_traits::Zero;
use proptest::prelude::*;

fn rational(x: i64) -> Rational {
    Rational::from_integer(BigInt::from(x))
}

fn element(coefficients: &[BigInt]) -> Element {
    Element::new(coefficients.iter().cloned().map(Integer::from))
}

fn small(coefficients: &[i64]) -> Element {
    Element::new(coefficients.iter().copied().map(Integer::from))
}

/// sqrt 5, between 2 and 3.
fn sqrt_5() -> Root {
    let p = small(&[-5, 0, 1]);
    Root::new(&p, (rational(2), rational(3)), &Limits::DEFAULT).unwrap()
}

/// The sign of x + y sqrt 5: of the larger one of x² and 5 y² if the signs differ.
fn expected(x: &BigInt, y: &BigInt) -> Ordering {
    let (of_x, of_y) = (x.cmp(&BigInt::zero()), y.cmp(&BigInt::zero()));
    let squares = (x * x).cmp(&(y * y * 5));
    match (of_x, squares) {
        (Ordering::Equal, _) => of_y,
        (of_x, _) if of_x == of_y => of_x,
        (of_x, Ordering::Greater) => of_x,
        _ => of_y,
    }
}

/// Whatever the rough enclosure shows is right, and every finer one shows it too.
fn check_sign(root: &Root, x: &BigInt, y: &BigInt) {
    let value = element(&[x.clone(), y.clone()]);
    let true_sign = expected(x, y);
    for dropped in [0, 1, 7, value.bits().saturating_sub(64), value.bits()] {
        if let Some(sign) = root.rough.shown(&value, dropped) {
            assert_eq!(sign, true_sign, "{x} {y}, {dropped} bits dropped");
            for finer in &root.enclosures {
                assert_eq!(finer.shown(&value, 0), Some(sign));
            }
        }
    }
    if !value.bits().is_zero() {
        assert_eq!(root.sign(&value).unwrap(), Some(true_sign), "{x} {y}");
    }
}

#[test]
fn signs_of_differences_that_almost_vanish() {
    // The solutions of x² - 5 y² = ±4 (Lucas and Fibonacci numbers): x - y sqrt 5 is 4/(x + y sqrt 5)
    // up to its sign, so each next one is less by the golden ratio.
    let root = sqrt_5();
    let pair = |x: i64, y: i64| (BigInt::from(x), BigInt::from(y));
    let (mut lucas, mut fibonacci) = (pair(2, 1), pair(0, 1));
    for _ in 0..340 {
        let (x, y) = (&lucas.0, &fibonacci.0);
        for (x, y) in [(x.clone(), -y), (-x, y.clone()), (x + 1, -y), (x - 1, -y)] {
            check_sign(&root, &x, &y);
        }
        lucas = (lucas.1.clone(), lucas.0 + lucas.1);
        fibonacci = (fibonacci.1.clone(), fibonacci.0 + fibonacci.1);
    }
}

/// x y by the schoolbook, and then p subtracted from the top as often as it goes.
fn product(x: &[BigInt], y: &[BigInt], p: &[BigInt]) -> Vec<BigInt> {
    let mut product = vec![BigInt::zero(); x.len() + y.len()];
    for (i, x) in x.iter().enumerate() {
        for (j, y) in y.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    let degree = p.len() - 1;
    for top in (degree..product.len()).rev() {
        let factor = product[top].clone();
        for (k, c) in p.iter().enumerate() {
            product[top - degree + k] -= &factor * c;
        }
    }
    product.truncate(degree);
    product
}

fn integer() -> impl Strategy<Value = BigInt> {
    let bytes = prop::collection::vec(any::<u8>(), 34);
    (bytes, 0usize..272).prop_map(|(bytes, shift)| BigInt::from_signed_bytes_le(&bytes) >> shift)
}

proptest! {
    #[test]
    fn signs_of_any_numbers(x in integer(), y in integer()) {
        check_sign(&sqrt_5(), &x, &y);
    }

    /// x^n - x - 2 is negative at 1 and positive at 2, and its derivative positive between.
    #[test]
    fn products_and_differences(
        (x, y, z) in (1usize..6).prop_flat_map(|n| {
            let numbers = || prop::collection::vec(integer(), n);
            (numbers(), numbers(), numbers())
        })
    ) {
        let n = x.len().max(2);
        let mut p = vec![BigInt::zero(); n + 1];
        (p[0], p[1], p[n]) = (BigInt::from(-2), BigInt::from(-1), BigInt::from(1));
        let ring = Ring::extension(element(&p), (rational(1), rational(2)), &Limits::DEFAULT);
        // x² - x - 2 has the root 2: there the interval ends at 3.
        let ring = ring.or_else(|_| Ring::extension(element(&p), (rational(1), rational(3)), &Limits::DEFAULT)).unwrap();
        prop_assert_eq!(ring.times(&element(&x), &element(&y)), element(&product(&x, &y, &p)));
        let by_hand: Vec<BigInt> = product(&x, &y, &p).iter().zip(product(&z, &y, &p)).map(|(a, b)| a - b).collect();
        let found = ring.sum([(false, &element(&x), &element(&y)), (true, &element(&z), &element(&y))]);
        prop_assert_eq!(found, element(&by_hand));
        let (sum, difference) = (element(&x).plus(&element(&z)), element(&x).minus(&element(&z)));
        let pairs = x.iter().zip(&z);
        prop_assert_eq!(sum, element(&pairs.clone().map(|(a, b)| a + b).collect::<Vec<_>>()));
        prop_assert_eq!(difference, element(&pairs.map(|(a, b)| a - b).collect::<Vec<_>>()));
    }
}
