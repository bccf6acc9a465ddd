//! Comparisons with square roots of integers that paper and pencil can follow.

use super::rational::{DIGITS, decimal};
use acutile_core::quality::{rounded_down, rounded_up};
use acutile_exact::number::Number;
use acutile_exact::number::radical::tex_root;
use malachite::base::num::conversion::traits::FromSciString;
use malachite::{Integer, Rational};

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
            "{p}/{q}{relation}{}{relation}{}",
            decimal(&between),
            tex_root(&Rational::from(d)),
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
