//! Numbers of a certificate as terms of Coq: integers for the checker, fractions for people.

use super::error::{NotATheorem, require};
use acutile_core::format::{Field, Number};
use malachite::base::num::arithmetic::traits::{DivExact, DivisibleBy, Gcd};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural};

/// An integer, in parentheses if it is negative.
pub(super) fn integer(value: &Integer) -> String {
    if *value < 0 {
        format!("({value})")
    } else {
        value.to_string()
    }
}

/// The ring of the field's integers.
pub(super) fn ring(field: &Field) -> &'static str {
    match field {
        Field::Rationals => "Z",
        Field::Algebraic(_) => "list Z",
    }
}

/// The number as a term of the ring: of type `Z`, or of type `list Z`.
pub(super) fn element(number: &Number, field: &Field) -> Result<String, NotATheorem> {
    let coefficients = coefficients(number, field)?;
    let terms: Vec<String> = coefficients.iter().map(integer).collect();
    Ok(match field {
        Field::Rationals => terms.concat(),
        Field::Algebraic(_) => format!("[{}]", terms.join(";")),
    })
}

/// The coefficients without zeros at the end, and at least one.
fn coefficients<'n>(number: &'n Number, field: &Field) -> Result<&'n [Integer], NotATheorem> {
    require(
        number.0.len() == field.degree(),
        "the number of coefficients",
    )?;
    let last = number.0.iter().rposition(|c| *c != 0).unwrap_or(0);
    Ok(&number.0[..=last])
}

/// The number over a denominator as a real number, a polynomial in `a`.
pub(super) fn real(
    number: &Number,
    denominator: &Integer,
    field: &Field,
    a: &str,
) -> Result<String, NotATheorem> {
    require(*denominator > 0, "a denominator is positive")?;
    Ok(polynomial(coefficients(number, field)?, denominator, a))
}

/// c_0 / m + a (c_1 / m + a (…)), each fraction in lowest terms.
pub(super) fn polynomial(coefficients: &[Integer], denominator: &Integer, a: &str) -> String {
    match coefficients {
        [] => "0".to_owned(),
        [c] => fraction(c, denominator),
        [c, rest @ ..] => {
            let rest = polynomial(rest, denominator, a);
            format!("({} + {a} * {rest})", fraction(c, denominator))
        }
    }
}

/// p / q for q > 0, in lowest terms.
pub(super) fn fraction(p: &Integer, q: &Integer) -> String {
    let common = Integer::from(p.unsigned_abs_ref().gcd(q.unsigned_abs_ref()));
    let (p, q) = (p.div_exact(&common), q.div_exact(&common));
    if q == Integer::ONE {
        integer(&p)
    } else {
        format!("({} / {q})", integer(&p))
    }
}

/// The factor by which numbers over `part` become numbers over `whole`.
pub(super) fn factor(whole: &Integer, part: &Integer) -> Result<Integer, NotATheorem> {
    let is_divisor = *part > 0 && whole.divisible_by(part);
    require(
        is_divisor,
        "the denominator of the domain divides the other",
    )?;
    Ok(whole.div_exact(part))
}

/// The number times an integer.
pub(super) fn times(number: &Number, factor: &Integer) -> Number {
    Number(number.0.iter().map(|c| c * factor).collect())
}

/// Zero in the field.
pub(super) fn zero(field: &Field) -> Number {
    Number(vec![Integer::ZERO; field.degree()])
}

/// The sign of an integer: -1, 0 or 1.
pub(super) fn sign(value: &Integer) -> i8 {
    if *value.unsigned_abs_ref() == Natural::ZERO {
        0
    } else if *value < 0 {
        -1
    } else {
        1
    }
}
