//! Exact numbers as short decimals, for people.

use crate::number::Number;
use malachite::Integer;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor};

/// The least integer that is not less, kept within the range of i64.
pub fn ceiling_to_i64(value: &Rational) -> i64 {
    i64::try_from(&value.clone().ceiling()).unwrap_or(if *value < 0 { i64::MIN } else { i64::MAX })
}

/// About six significant digits.
pub fn short_decimal(number: &Number) -> String {
    format!("{:.6e}", number.approximate())
}

/// An interval rounded outward to six decimals: `89.999998 to 90.000001`, or one
/// number where both ends print alike.
pub fn decimal_range((lower, upper): &(Rational, Rational)) -> String {
    let million = Rational::from(1_000_000);
    let low = millionths(&(lower * &million).floor());
    let high = millionths(&(upper * &million).ceiling());
    if low == high {
        low
    } else {
        format!("{low} to {high}")
    }
}

fn millionths(value: &Integer) -> String {
    let digits = format!("{:07}", value.unsigned_abs_ref());
    let (whole, fraction) = digits.split_at(digits.len() - 6);
    let sign = if *value < 0 { "-" } else { "" };
    format!("{sign}{whole}.{fraction}")
}
