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
        let term = if powers.is_empty() {
            signed(&text, &numerals.inline(coefficient))
        } else {
            product(&text, &numerals.slashed_factor(coefficient), &powers)
        };
        text.push_str(&term);
    }
    if text.is_empty() {
        "0".to_owned()
    } else {
        text
    }
}

fn signed(before: &str, number: &str) -> String {
    if before.is_empty() || number.starts_with('-') {
        number.to_owned()
    } else {
        format!("+{number}")
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
