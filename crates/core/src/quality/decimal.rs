//! Exact numbers as short decimals, for people.

use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, Pow};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Rational};

/// About six significant digits.
pub fn short_decimal(number: &Number) -> String {
    format!("{:.6e}", number.approximate())
}

/// Nine decimals where that shows enough, else as [`short_decimal`].
pub fn plain_decimal(value: f64) -> String {
    if (1e-3..1e9).contains(&value.abs()) {
        format!("{value:.9}")
    } else {
        format!("{value:.6e}")
    }
}

/// `1/2`, or `about 3.141592654`: exact where that is short or wanted.
pub fn short_number(number: &Number, is_exact: bool) -> String {
    let exact = number.to_string();
    match exact.len() {
        0..=24 => exact,
        _ if is_exact => exact,
        _ => format!("about {}", plain_decimal(number.approximate())),
    }
}

/// A point as `(1/2, 0, about 3.141592654)`.
pub fn short_point(point: &[Number], is_exact: bool) -> String {
    let number = |x: &Number| short_number(x, is_exact);
    let coordinates: Vec<String> = point.iter().map(number).collect();
    format!("({})", coordinates.join(", "))
}

/// An interval rounded outward to six decimals: `89.999998 to 90.000001`, or one
/// number where both ends print alike.
pub fn decimal_range((lower, upper): &(Rational, Rational)) -> String {
    let (low, high) = (rounded_down(lower, 6), rounded_up(upper, 6));
    if low == high {
        low
    } else {
        format!("{low} to {high}")
    }
}

/// The largest decimal with `digits` digits after the point that is at most `value`.
pub fn rounded_down(value: &Rational, digits: u64) -> String {
    decimal(&(value * power_of_ten(digits)).floor(), digits)
}

/// The smallest decimal with `digits` digits after the point that is at least `value`.
pub fn rounded_up(value: &Rational, digits: u64) -> String {
    decimal(&(value * power_of_ten(digits)).ceiling(), digits)
}

/// The nearest decimal with `digits` digits after the point; of two the larger one
/// in absolute value.
pub fn rounded_nearest(value: &Rational, digits: u64) -> String {
    let doubled = value * power_of_ten(digits) * Rational::from(2);
    let (half, _) = Integer::rounding_from(
        (doubled + Rational::from(if *value < 0 { -1 } else { 1 })) / Rational::from(2),
        RoundingMode::Down,
    );
    decimal(&half, digits)
}

fn power_of_ten(digits: u64) -> Rational {
    Rational::from(10).pow(digits)
}

/// value / 10^digits
fn decimal(value: &Integer, digits: u64) -> String {
    let width = digits as usize + 1;
    let text = format!("{:0width$}", value.unsigned_abs_ref());
    let (whole, fraction) = text.split_at(text.len() - digits as usize);
    let sign = if *value < 0 { "-" } else { "" };
    match digits {
        0 => format!("{sign}{whole}"),
        _ => format!("{sign}{whole}.{fraction}"),
    }
}
