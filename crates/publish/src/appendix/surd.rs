//! Square roots of integers: their simplest form, and comparisons with them that paper and
//! pencil can follow.

use super::rational::{DIGITS, decimal, rational};
use acutile_core::quality::{rounded_down, rounded_up};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::{CheckedSqrt, Parity};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::FromSciString;
use malachite::{Integer, Rational};

/// Prime factors are taken out of roots up to this one.
const LARGEST_FACTOR: u32 = 10_000;

/// √(p/q) = m √r / q with p q = m² r.
pub fn rational_root(x: &Rational) -> String {
    let (numerator, denominator) = (x.numerator_ref(), x.denominator_ref());
    let (square, radicand) = square_part(&Integer::from(numerator * denominator));
    let factor = Rational::from(square) / Rational::from(denominator);
    if radicand == 1u32 || *x == 0 {
        return rational(&factor);
    }
    let (m, n) = (factor.numerator_ref(), factor.denominator_ref());
    let root = match *m == 1u32 {
        true => format!("\\sqrt{{{radicand}}}"),
        false => format!("{m}\\sqrt{{{radicand}}}"),
    };
    match *n == 1u32 {
        true => root,
        false => format!("{root}/{n}"),
    }
}

/// m and r with n = m² r, where r has no square of a small prime as a factor; (0, 1) for 0.
pub fn square_part(n: &Integer) -> (Integer, Integer) {
    let (mut square, mut rest) = (Integer::ONE, n.clone());
    if *n == 0 {
        return (Integer::ZERO, Integer::ONE);
    }
    for p in (2..=LARGEST_FACTOR).filter(|p| *p == 2 || p.odd()) {
        let factor = Integer::from(p) * Integer::from(p);
        if *rest.unsigned_abs_ref() < *factor.unsigned_abs_ref() {
            break;
        }
        while &rest % &factor == 0 {
            rest /= &factor;
            square *= Integer::from(p);
        }
    }
    if let (true, Some(root)) = (rest > 1, rest.unsigned_abs_ref().checked_sqrt()) {
        return (square * Integer::from(root), Integer::ONE);
    }
    (square, rest)
}

/// Squares with more digits are not written out.
const SQUARE_DIGITS: usize = 9;

/// The comparison of |p| and |q| √d: of their squares, or where these are long of |p/q| and √d
/// with a short decimal between them.
pub fn compared(p: &Integer, q: &Integer, d: &Integer) -> String {
    let (left, right) = (p * p, q * q * d);
    let relation = if left < right { '<' } else { '>' };
    let [p, q] = [p, q].map(Integer::unsigned_abs_ref);
    if left.to_string().len().max(right.to_string().len()) > SQUARE_DIGITS
        && let Some(between) = between(&Rational::from_naturals_ref(p, q), d)
    {
        return format!(
            "{p}/{q}{relation}{}{relation}\\sqrt{{{d}}}",
            decimal(&between)
        );
    }
    format!("{p}^2={left}{relation}{right}={d}\\cdot{q}^2")
}

/// A decimal with few digits strictly between a ratio and √d.
fn between(ratio: &Rational, d: &Integer) -> Option<String> {
    let root = Number::from(Rational::from(d));
    (0..=DIGITS).find_map(|digits| {
        let bounds = root.enclosure_of_root(&Rational::from_signeds(1, 100_000_000));
        let candidates = [
            rounded_up(&bounds.1, digits),
            rounded_down(&bounds.0, digits),
        ];
        candidates.into_iter().find(|text| {
            let Some(value) = Rational::from_sci_string(text) else {
                return false;
            };
            let is_above_root = &value * &value > *d;
            let is_below_root = &value * &value < *d;
            (value < *ratio && is_above_root) || (value > *ratio && is_below_root)
        })
    })
}
