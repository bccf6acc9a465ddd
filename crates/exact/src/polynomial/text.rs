//! Polynomials as people write them, `3*c2/4 - 1` or `2*x^2`, and back.
//!
//! The syntax is that of numbers. A name is a parameter or a generator of the field. Divisors and
//! radicands are constant.

use super::{Coefficient, MOST_PARAMETERS, Monomial, Polynomial};
use crate::geometry::RingElement;
use crate::number::limits::EXPONENT_LIMIT;
use crate::number::text::parse;
use crate::number::{Declared, Expression, Number, ReadError, ReadErrorKind, Reader};

/// Extends the field of `reader` until the constants of the text lie in it.
///
/// # Errors
/// If the text is no polynomial.
pub fn learn(reader: &mut Reader, text: &str, parameters: &[String]) -> Result<(), ReadError> {
    learn_constants(reader, &parse(text)?, parameters)
        .map_err(|error| with_declared(error, reader, parameters))
}

/// The polynomial, whose constants have been learnt. Numbers of smaller fields do not mix with
/// those of the final one, so learning comes first.
///
/// # Errors
/// As [`learn`], and if an exponent is larger than [`EXPONENT_LIMIT`].
pub fn read(reader: &Reader, text: &str, parameters: &[String]) -> Result<Polynomial, ReadError> {
    polynomial(reader, &parse(text)?, parameters)
        .map_err(|error| with_declared(error, reader, parameters))
}

/// An unknown name may be meant as a parameter, so the message lists those that are declared.
fn with_declared(error: ReadError, reader: &Reader, parameters: &[String]) -> ReadError {
    let kind = match error.kind {
        ReadErrorKind::UnknownName(unknown) | ReadErrorKind::NoNames(unknown) => {
            ReadErrorKind::NotDeclared(Declared {
                unknown,
                parameters: parameters.to_vec(),
                generators: reader.generator_names().map(str::to_owned).collect(),
            })
        }
        kind => kind,
    };
    ReadError { kind, ..error }
}

/// The first parameter that occurs.
fn parameter_in<'e>(expression: &'e Expression, parameters: &[String]) -> Option<&'e str> {
    let within = |x: &'e Expression| parameter_in(x, parameters);
    match expression {
        Expression::Rational(_) => None,
        Expression::Name(name, _) => parameters.contains(name).then_some(name),
        Expression::Sum(summands) => summands.iter().find_map(|(_, x)| within(x)),
        Expression::Product(first, factors) => {
            within(first).or_else(|| factors.iter().find_map(|(_, x, _)| within(x)))
        }
        Expression::Power(base, ..) => within(base),
        Expression::Root(radicand, _) => within(radicand),
    }
}

fn learn_constants(
    reader: &mut Reader,
    expression: &Expression,
    parameters: &[String],
) -> Result<(), ReadError> {
    let Some(name) = parameter_in(expression, parameters) else {
        return reader.learn_expression(expression);
    };
    match expression {
        Expression::Rational(_) | Expression::Name(..) => Ok(()),
        Expression::Sum(summands) => {
            let mut summands = summands.iter();
            summands.try_for_each(|(_, x)| learn_constants(reader, x, parameters))
        }
        Expression::Product(first, factors) => {
            learn_constants(reader, first, parameters)?;
            let mut factors = factors.iter();
            factors.try_for_each(|(_, x, _)| learn_constants(reader, x, parameters))
        }
        Expression::Power(base, ..) => learn_constants(reader, base, parameters),
        Expression::Root(_, column) => Err(not_a_polynomial(*column, name)),
    }
}

fn not_a_polynomial(column: usize, name: &str) -> ReadError {
    ReadError {
        column,
        kind: ReadErrorKind::NotAPolynomial(name.to_owned()),
    }
}

fn polynomial(
    reader: &Reader,
    expression: &Expression,
    parameters: &[String],
) -> Result<Polynomial, ReadError> {
    let Some(first_name) = parameter_in(expression, parameters) else {
        return reader.value_of(expression).map(Polynomial::constant);
    };
    match expression {
        Expression::Rational(_) => reader.value_of(expression).map(Polynomial::constant),
        Expression::Name(name, _) => {
            let index = parameters.iter().position(|parameter| parameter == name);
            Ok(Polynomial::parameter(index.unwrap_or(0)))
        }
        Expression::Sum(summands) => {
            summands
                .iter()
                .try_fold(Polynomial::zero(), |sum, (is_minus, x)| {
                    let x = polynomial(reader, x, parameters)?;
                    Ok(if *is_minus {
                        sum.minus(&x)
                    } else {
                        sum.plus(&x)
                    })
                })
        }
        Expression::Product(first, factors) => {
            let first = polynomial(reader, first, parameters)?;
            factors
                .iter()
                .try_fold(first, |product, (divides, x, column)| {
                    let factor = polynomial(reader, x, parameters)?;
                    if *divides {
                        let divisor = factor.to_constant();
                        let divisor = divisor.ok_or_else(|| {
                            let name = parameter_in(x, parameters).unwrap_or_default();
                            not_a_polynomial(*column, name)
                        })?;
                        let inverse = divisor.inverse().ok_or(ReadError {
                            column: *column,
                            kind: ReadErrorKind::DivisionByZero,
                        })?;
                        Ok(product.map(|c| c * &inverse))
                    } else {
                        times(&product, &factor, *column)
                    }
                })
        }
        Expression::Power(base, exponent, column) => {
            let exponent = u32::try_from(*exponent);
            let exponent = exponent.map_err(|_| not_a_polynomial(*column, first_name))?;
            let base = polynomial(reader, base, parameters)?;
            let one = Polynomial::constant(Number::from_integer(1));
            (0..exponent).try_fold(one, |power, _| times(&power, &base, *column))
        }
        Expression::Root(_, column) => Err(not_a_polynomial(*column, first_name)),
    }
}

fn times(x: &Polynomial, y: &Polynomial, column: usize) -> Result<Polynomial, ReadError> {
    let degrees = (0..MOST_PARAMETERS).map(|k| x.degree(k) + y.degree(k));
    match degrees.max().filter(|degree| *degree > EXPONENT_LIMIT) {
        Some(degree) => Err(ReadError {
            column,
            kind: ReadErrorKind::DegreeTooHigh(degree),
        }),
        None => Ok(x.times(y)),
    }
}

/// `3/4*c2^2 - x + 1`, the highest powers first.
pub(super) fn shown(p: &Polynomial<Number>, names: &[String]) -> String {
    let mut text = String::new();
    for (monomial, c) in p.terms().iter().rev() {
        let powers = powers(*monomial, names);
        let is_negative = c.is_rational() && c.sign().is_lt();
        let size = if is_negative { -c } else { c.clone() };
        text += match (text.is_empty(), is_negative) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let is_one = size == size.integer(1);
        text += &match (powers.as_str(), size.is_rational()) {
            ("", true) => size.to_string(),
            ("", false) => format!("({})", in_products(&size)),
            (powers, _) if is_one => powers.to_owned(),
            (powers, true) => format!("{size}*{powers}"),
            (powers, false) => format!("({})*{powers}", in_products(&size)),
        };
    }
    if text.is_empty() {
        "0".to_owned()
    } else {
        text
    }
}

fn powers(monomial: Monomial, names: &[String]) -> String {
    let power = |(k, name): (usize, &String)| match monomial.exponent(k) {
        0 => None,
        1 => Some(name.clone()),
        e => Some(format!("{name}^{e}")),
    };
    let powers: Vec<String> = names.iter().enumerate().filter_map(power).collect();
    powers.join("*")
}

/// `1/2+3/4*a^2` in the syntax of files.
pub fn in_products(number: &Number) -> String {
    let symbol = number.field().map_or("", |field| field.symbol());
    let mut text = String::new();
    for (power, c) in number
        .coefficients()
        .iter()
        .enumerate()
        .filter(|(_, c)| **c != 0)
    {
        if !text.is_empty() && *c > 0 {
            text.push('+');
        }
        text += &match power {
            0 => c.to_string(),
            1 => format!("{c}*{symbol}"),
            _ => format!("{c}*{symbol}^{power}"),
        };
    }
    if text.is_empty() {
        "0".to_owned()
    } else {
        text
    }
}
