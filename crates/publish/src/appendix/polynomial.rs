//! Polynomials in named parameters as TeX.

use super::numeral::Numerals;
use acutile_exact::polynomial::Polynomial;

/// A parameter's name in a formula.
pub fn name(name: &str) -> String {
    match name.len() {
        1 => name.to_owned(),
        _ => format!("\\mathit{{{}}}", name.replace('_', "\\_")),
    }
}

/// The polynomial for math mode.
pub fn polynomial(numerals: &Numerals, names: &[String], p: &Polynomial) -> String {
    let mut text = String::new();
    for (monomial, coefficient) in p.terms().iter().rev() {
        let powers: String = names
            .iter()
            .enumerate()
            .map(|(k, parameter)| match monomial.exponent(k) {
                0 => String::new(),
                1 => name(parameter),
                e => format!("{}^{{{e}}}", name(parameter)),
            })
            .collect();
        let term = match powers.is_empty() {
            true => signed(&text, &numerals.inline(coefficient)),
            false => product(&text, &numerals.slashed_factor(coefficient), &powers),
        };
        text.push_str(&term);
    }
    match text.is_empty() {
        true => "0".to_owned(),
        false => text,
    }
}

fn signed(before: &str, number: &str) -> String {
    match before.is_empty() || number.starts_with('-') {
        true => number.to_owned(),
        false => format!("+{number}"),
    }
}

/// A coefficient in front of a variable; `(-1)` and `1` are signs.
pub fn product(before: &str, coefficient: &str, variable: &str) -> String {
    let negative = coefficient
        .strip_prefix("(-")
        .and_then(|rest| rest.strip_suffix(')'))
        .filter(|size| !size[1..].contains(['+', '-', '/']));
    let plus = if before.is_empty() { "" } else { "+" };
    match (coefficient, negative) {
        ("1", _) => format!("{plus}{variable}"),
        (_, Some("1")) => format!("-{variable}"),
        (_, Some(size)) => format!("-{size}{}{variable}", gap(size)),
        _ => format!("{plus}{coefficient}{}{variable}", gap(coefficient)),
    }
}

/// The blank that ends the name of a command, as in `\alpha t`.
fn gap(before: &str) -> &'static str {
    if before.ends_with(|c: char| c.is_ascii_alphabetic()) {
        " "
    } else {
        ""
    }
}
