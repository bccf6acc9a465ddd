//! Rational numbers from text, in the only notation that each has.

use super::document::excerpt;
use super::{Limits, Refusal};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed};

pub(super) type Rational = num_rational::Ratio<BigInt>;

/// `p` or `p/q` in lowest terms, q > 1; digits are ASCII, no leading zero, no
/// plus sign, no minus zero. `place` names the text in a refusal.
pub(super) fn rational(
    text: &str,
    place: &dyn Fn() -> String,
    limits: &Limits,
) -> Result<Rational, Refusal> {
    let refuse = |reason| Refusal::Number {
        place: place(),
        text: excerpt(text),
        reason,
    };
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    check_digits(text, place, limits)?;
    let p = integer(numerator).ok_or_else(|| refuse("not an integer in decimal notation"))?;
    let q = integer(denominator).ok_or_else(|| refuse("not an integer in decimal notation"))?;
    if !q.is_positive() {
        return Err(refuse("the denominator is not positive"));
    }
    if q.is_one() == text.contains('/') {
        return Err(refuse("a denominator of 1 is not written"));
    }
    if !p.gcd(&q).is_one() {
        return Err(refuse("not in lowest terms"));
    }
    Ok(Rational::new_raw(p, q))
}

/// The number of digits is bounded before any arithmetic is done with them.
fn check_digits(text: &str, place: &dyn Fn() -> String, limits: &Limits) -> Result<(), Refusal> {
    let found = text.bytes().filter(u8::is_ascii_digit).count();
    match found <= limits.digits {
        true => Ok(()),
        false => Err(Refusal::TooManyDigits {
            place: place(),
            found,
            limit: limits.digits,
        }),
    }
}

/// `0`, or an optional minus sign and digits of which the first is not zero.
pub(super) fn integer(text: &str) -> Option<BigInt> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let canonical = text == "0"
        || (!digits.starts_with('0')
            && !digits.is_empty()
            && digits.bytes().all(|byte| byte.is_ascii_digit()));
    if canonical {
        BigInt::parse_bytes(text.as_bytes(), 10)
    } else {
        None
    }
}
