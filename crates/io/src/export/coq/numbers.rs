//! Numbers of a certificate as terms of Coq: integers with one common denominator for the
//! checker, fractions for people.

use super::NotATheorem;
use acutile_format1::certificate::Number;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{One, Signed};

pub(super) type BigRational = Ratio<BigInt>;

/// Rows of numbers, each by its coefficients.
pub(super) type Table = Vec<Vec<Vec<BigRational>>>;

pub(super) fn table(rows: &[Vec<Number>]) -> Result<Table, NotATheorem> {
    let row = |row: &Vec<Number>| row.iter().map(coefficients).collect();
    rows.iter().map(row).collect()
}

/// The least positive integer that makes all entries integral.
pub(super) fn common_denominator<'a>(tables: impl IntoIterator<Item = &'a Table>) -> BigInt {
    let all = tables.into_iter().flatten().flatten().flatten();
    all.fold(BigInt::one(), |m, c| m.lcm(c.denom()))
}

/// m times the number as a term of type `Z`, or of type `list Z` over a field; m must
/// clear its denominators.
pub(super) fn scaled(coefficients: &[BigRational], m: &BigInt, algebraic: bool) -> String {
    let integers: Vec<String> = coefficients
        .iter()
        .map(|c| integer(&(c.numer() * (m / c.denom()))))
        .collect();
    match algebraic {
        true => format!("[{}]", integers.join(";")),
        false => integers.join(" "),
    }
}

pub(super) fn coefficients(number: &Number) -> Result<Vec<BigRational>, NotATheorem> {
    number.0.iter().map(|text| rational(text)).collect()
}

pub(super) fn rational(text: &str) -> Result<BigRational, NotATheorem> {
    let zero_denominator = text
        .split_once('/')
        .is_some_and(|(_, q)| q.trim_start_matches('0').is_empty());
    match text.parse() {
        Ok(value) if !zero_denominator => Ok(value),
        _ => Err(NotATheorem::Malformed(format!("the number {text:?}"))),
    }
}

pub(super) fn integer(value: &BigInt) -> String {
    match value.is_negative() {
        true => format!("({value})"),
        false => value.to_string(),
    }
}

/// c_0 + a (c_1 + a (…)) over the real numbers.
pub(super) fn real(coefficients: &[BigRational], a: &str) -> String {
    let fraction = |c: &BigRational| match c.is_integer() {
        true => integer(c.numer()),
        false => format!("({} / {})", integer(c.numer()), c.denom()),
    };
    match coefficients {
        [] => "0".to_owned(),
        [c] => fraction(c),
        [c, rest @ ..] => format!("({} + {a} * {})", fraction(c), real(rest, a)),
    }
}
