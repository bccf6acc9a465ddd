//! Square roots as people read them: in texts as `√5`, `√(5/12)`, in TeX as `\sqrt{5/12}`.
//!
//! Messages, tables, pages, figures and the appendix write roots by these functions.
//!
//! ```
//! use acutile_exact::number::radical::{root, tex_root, with_radicals};
//! use malachite::Rational;
//! assert_eq!(root(&Rational::from_signeds(5, 12)), "√(5/12)");
//! assert_eq!(root(&Rational::from_signeds(9, 4)), "3/2");
//! assert_eq!(tex_root(&Rational::from_signeds(5, 12)), "\\sqrt{5/12}");
//! assert_eq!(with_radicals("arccos(√(1/6))", str::to_owned, str::to_owned), "arccos(\\sqrt{1/6})");
//! ```

use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedSqrt;

/// Characters under a root sign of TeX, where no line breaks. A longer text has the exponent 1/2.
const LONGEST: usize = 20;

/// The root of a number that is not negative, as a text.
pub fn root(square: &Rational) -> String {
    match square.checked_sqrt() {
        Some(root) => root.to_string(),
        None => sign_over(&square.to_string()),
    }
}

/// The same in TeX.
pub fn tex_root(square: &Rational) -> String {
    match square.checked_sqrt() {
        Some(root) => root.to_string(),
        None => tex_sign_over(&square.to_string()),
    }
}

/// A root sign over a formula: `√5`, `√(1/2 + a)`.
pub fn sign_over(formula: &str) -> String {
    if formula.bytes().all(|byte| byte.is_ascii_digit()) {
        format!("√{formula}")
    } else {
        format!("√({formula})")
    }
}

/// The same in TeX: `\sqrt{5}`.
pub fn tex_sign_over(formula: &str) -> String {
    if formula.len() > LONGEST {
        format!("({formula})^{{1/2}}")
    } else {
        format!("\\sqrt{{{formula}}}")
    }
}

/// A text with `plain` for what is no root, and `tex` for each root as written in TeX.
pub fn with_radicals(
    text: &str,
    plain: impl Fn(&str) -> String,
    tex: impl Fn(&str) -> String,
) -> String {
    let mut parts = text.split('√');
    let mut out = plain(parts.next().unwrap_or_default());
    for part in parts {
        let (formula, rest) = operand(part);
        out.push_str(&tex(&tex_sign_over(formula)));
        out.push_str(&plain(rest));
    }
    out
}

/// The text under a root sign, and the text after it. The former is digits, a letter, or a formula in
/// parentheses.
fn operand(text: &str) -> (&str, &str) {
    if let Some(inner) = text.strip_prefix('(') {
        let mut depth = 1;
        for (place, letter) in inner.char_indices() {
            depth += i32::from(letter == '(') - i32::from(letter == ')');
            if depth == 0 {
                return (&inner[..place], &inner[place + 1..]);
            }
        }
    }
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let letter = text.chars().next().filter(|c| c.is_alphabetic());
    text.split_at(digits.max(letter.map_or(0, char::len_utf8)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_read_with_their_parentheses() {
        let cases = [
            ("√5/2", "\\sqrt{5}/2"),
            (
                "2 + √3 and √(1/2 + (1/4) a)x",
                "2 + \\sqrt{3} and \\sqrt{1/2 + (1/4) a}x",
            ),
            ("√d", "\\sqrt{d}"),
            ("√", "\\sqrt{}"),
            ("no root", "no root"),
        ];
        for (text, expected) in cases {
            assert_eq!(with_radicals(text, str::to_owned, str::to_owned), expected);
        }
    }

    #[test]
    fn long_formulas_have_an_exponent() {
        let long = "1".repeat(21);
        assert_eq!(tex_sign_over(&long), format!("({long})^{{1/2}}"));
    }
}
