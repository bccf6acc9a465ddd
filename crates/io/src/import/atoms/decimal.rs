//! The numbers of a CIF: decimals taken exactly as written, with their last written digit.
//!
//! `0.1234(5)` is 1234/10000 with the standard uncertainty 5/10000. `1/3` is no number of CIF, but it is read, exactly.

use malachite::base::num::arithmetic::traits::{Abs, Floor, Pow};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode::Nearest;
use malachite::{Natural, Rational};

/// The most digits of a number, and the largest size of its exponent.
const DIGITS_LIMIT: usize = 100;

/// A number as it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Decimal {
    /// Exactly.
    pub value: Rational,
    /// One unit of the last written digit; zero for a fraction like 1/3 or an integer.
    pub unit: Rational,
    /// The standard uncertainty, if one follows.
    pub uncertainty: Option<Rational>,
}

/// The result of snapping a number.
#[derive(Debug, PartialEq)]
pub enum Snapped {
    /// It is a multiple of 1/denominator, or no such multiple agrees with it.
    Kept,
    /// The only multiple that agrees with all of its digits.
    To(Rational),
    /// Several agree, or one does and the number has too few digits to say so.
    Short,
}

impl Decimal {
    /// Reads a number.
    ///
    /// # Errors
    /// The expected text.
    pub fn parse(text: &str) -> Result<Decimal, String> {
        let mut rest = text;
        let negative = rest.starts_with('-');
        rest = rest.strip_prefix(['-', '+']).unwrap_or(rest);
        let whole = digits(&mut rest);
        let mut number = match rest.strip_prefix('/') {
            Some(denominator) => fraction(whole, denominator),
            None => decimal(whole, rest),
        }
        .ok_or_else(|| problem(text))?;
        if negative {
            number.value = -number.value;
        }
        Ok(number)
    }

    /// The multiple k/n that the number is written for.
    ///
    /// It is rounded to two digits or more, and differs by at most half a unit of the last one.
    /// Or it is cut off after three digits or more, and differs by less than a unit. A multiple
    /// within a unit of a shorter number is a coincidence: 0.6 is not 2/3.
    pub fn snap(&self, denominator: u32) -> Snapped {
        let n = Rational::from(denominator);
        let low = Rational::from((&self.value * &n).floor()) / &n;
        if low == self.value {
            return Snapped::Kept;
        }
        let high = &low + Rational::from(1) / &n;
        let near = |x: &Rational| (x - &self.value).abs() < self.unit;
        let agrees = |x: &Rational| {
            let twice = (x - &self.value).abs() * Rational::from(2);
            let is_rounded = twice <= self.unit && self.unit <= Rational::from_signeds(1, 100);
            is_rounded || self.is_long() && near(x)
        };
        match (near(&low), near(&high)) {
            (true, false) if agrees(&low) => Snapped::To(low),
            (false, true) if agrees(&high) => Snapped::To(high),
            (false, false) => Snapped::Kept,
            _ => Snapped::Short,
        }
    }

    /// Whether it has three decimals or more.
    pub fn is_long(&self) -> bool {
        self.unit <= Rational::from_signeds(1, 1000)
    }
}

/// A value rounded to at most `decimals` decimals, for a message.
pub fn about(value: &Rational, decimals: usize) -> String {
    let digits = format!("{:.decimals$}", f64::rounding_from(value, Nearest).0);
    digits
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

fn problem(text: &str) -> String {
    let found = crate::import::words::short(text);
    format!(
        "found {found}, expected a number like 0.25, 0.3333(2) or 1/3, of at most {DIGITS_LIMIT} digits"
    )
}

/// The digits at the beginning of `rest`, which is what follows then.
fn digits<'t>(rest: &mut &'t str) -> &'t str {
    let end = rest
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(rest.len());
    let (head, tail) = rest.split_at(end);
    *rest = tail;
    head
}

fn natural(digits: &str) -> Option<Natural> {
    match digits.len() {
        1..=DIGITS_LIMIT => digits.parse().ok(),
        _ => None,
    }
}

fn fraction(numerator: &str, denominator: &str) -> Option<Decimal> {
    let is_digits = denominator.bytes().all(|byte| byte.is_ascii_digit());
    let denominator = natural(denominator).filter(|n| is_digits && *n != 0u32)?;
    Some(Decimal {
        value: Rational::from_naturals(natural(numerator)?, denominator),
        unit: Rational::from(0),
        uncertainty: None,
    })
}

/// `whole`, then in `rest` a point and digits, an exponent, an uncertainty.
fn decimal(whole: &str, mut rest: &str) -> Option<Decimal> {
    let mut decimals = "";
    if let Some(tail) = rest.strip_prefix('.') {
        rest = tail;
        decimals = digits(&mut rest);
    }
    let mantissa = natural(&format!("{whole}{decimals}"))?;
    let mut power = -i64::try_from(decimals.len()).ok()?;
    if let Some(tail) = rest.strip_prefix(['e', 'E']) {
        rest = tail;
        power += exponent(&mut rest)?;
    }
    let place = Rational::from(10).pow(power);
    let mut uncertainty = None;
    if !rest.is_empty() {
        let inner = rest.strip_prefix('(')?.strip_suffix(')')?;
        let is_digits = inner.bytes().all(|byte| byte.is_ascii_digit());
        let units = natural(inner).filter(|_| is_digits)?;
        uncertainty = Some(Rational::from(units) * &place);
    }
    let unit = if power < 0 {
        place.clone()
    } else {
        Rational::from(0)
    };
    Some(Decimal {
        value: Rational::from(mantissa) * place,
        unit,
        uncertainty,
    })
}

fn exponent(rest: &mut &str) -> Option<i64> {
    let negative = rest.starts_with('-');
    *rest = rest.strip_prefix(['-', '+']).unwrap_or(rest);
    let size: i64 = digits(rest).parse().ok()?;
    let size = Some(size).filter(|&size| size <= DIGITS_LIMIT as i64)?;
    Some(if negative { -size } else { size })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn q(n: i64, d: i64) -> Rational {
        Rational::from_signeds(n, d)
    }

    #[test]
    fn numbers_as_written() {
        for (text, value, unit, uncertainty) in [
            ("0.1234(5)", q(617, 5000), q(1, 10000), Some(q(5, 10000))),
            ("-.25", q(-1, 4), q(1, 100), None),
            ("+5.", q(5, 1), q(0, 1), None),
            ("90", q(90, 1), q(0, 1), None),
            ("90(1)", q(90, 1), q(0, 1), Some(q(1, 1))),
            ("12.50(12)", q(25, 2), q(1, 100), Some(q(12, 100))),
            ("1.5e-2(3)", q(3, 200), q(1, 1000), Some(q(3, 1000))),
            ("2E+1", q(20, 1), q(0, 1), None),
            ("2/6", q(1, 3), q(0, 1), None),
        ] {
            let expected = Decimal {
                value,
                unit,
                uncertainty,
            };
            assert_eq!(Decimal::parse(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn texts_that_are_no_numbers() {
        let long = "1".repeat(DIGITS_LIMIT + 1);
        for text in [
            "",
            "-",
            ".",
            "x",
            "1x",
            "1/0",
            "1/-3",
            "1/",
            "/3",
            "0.1(",
            "0.1()",
            "0.1(x)",
            "0.1(5)6",
            "1e",
            "1e101",
            "--1",
            "0x1",
            "\u{663}",
            "1/\u{663}",
            "inf",
            "0,5",
            &long,
        ] {
            assert!(Decimal::parse(text).is_err(), "{text}");
        }
    }

    /// By hand: 0.3333 lies 0.33 units below 1/3 and 0.6666 lies 0.67 units below 2/3.
    #[test]
    fn snapping() {
        let snap = |text: &str, n| Decimal::parse(text).expect("a number").snap(n);
        assert_eq!(snap("0.3333", 3), Snapped::To(q(1, 3)));
        assert_eq!(snap("0.6666", 12), Snapped::To(q(2, 3)));
        assert_eq!(snap("-0.667(2)", 3), Snapped::To(q(-2, 3)));
        assert_eq!(snap("0.3330", 3), Snapped::Kept);
        assert_eq!(snap("0.25", 12), Snapped::Kept);
        assert_eq!(snap("1/7", 3), Snapped::Kept);
        assert_eq!(snap("0.33", 3), Snapped::To(q(1, 3)));
        assert_eq!(snap("0.66", 3), Snapped::Short);
        assert_eq!(snap("0.666", 3), Snapped::To(q(2, 3)));
        assert_eq!(snap("0.3", 3), Snapped::Short);
        assert_eq!(snap("0.6", 3), Snapped::Short);
        assert_eq!(snap("0.6", 12), Snapped::Short);
        assert_eq!(snap("0.063", 3), Snapped::Kept);
        assert_eq!(snap("0.3", 24), Snapped::Short);
    }
}
