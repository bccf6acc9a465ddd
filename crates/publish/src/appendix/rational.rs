//! Rational numbers and decimals as TeX.

use acutile_core::quality::{rounded_down, rounded_up};
use malachite::Rational;

/// Decimals of enclosures have this many digits after the point.
pub const DIGITS: u64 = 6;

/// A rational in a line of text.
pub fn rational(x: &Rational) -> String {
    x.to_string()
}

/// Bounds as decimals rounded outward: `[53.130102, 53.130103]`, or one number where that
/// is exact.
pub fn interval((low, high): &(Rational, Rational)) -> String {
    let (below, above) = (rounded_down(low, DIGITS), rounded_up(high, DIGITS));
    if below == above {
        let exact = below.trim_end_matches('0').trim_end_matches('.');
        return decimal(exact);
    }
    format!("[{},\\allowbreak\\,{}]", decimal(&below), decimal(&above))
}

/// A decimal as the document writes them.
pub fn decimal(text: &str) -> String {
    format!("\\acutiledecimal{{{text}}}")
}
