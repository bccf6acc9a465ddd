//! Exact real numbers in Q(√3, √11), which contains √33.

use super::arithmetic::{Arithmetic, Function};
use acutile_core::quality::decimal_range;
use acutile_exact::number::{Number, Reader};
use malachite::Rational;
use std::cmp::Ordering;

/// Decimals are shown this close to the number.
const WIDTH: u64 = 1_000_000_000;

/// The field Q(√3, √11).
pub struct Exact(Reader);

impl Exact {
    /// The field.
    ///
    /// # Errors
    /// That the field could not be made, in words.
    pub fn new() -> Result<Exact, String> {
        let mut reader = Reader::new();
        for root in ["sqrt(3)", "sqrt(11)"] {
            reader.learn(root).map_err(|error| error.to_string())?;
        }
        Ok(Exact(reader))
    }
}

impl Arithmetic for Exact {
    type Value = Number;

    fn rational(&self, value: &Rational) -> Number {
        Number::from(value.clone())
    }

    fn sum(&self, x: &Number, y: &Number) -> Number {
        x + y
    }

    fn difference(&self, x: &Number, y: &Number) -> Number {
        x - y
    }

    fn product(&self, x: &Number, y: &Number) -> Number {
        x * y
    }

    fn inverse(&self, x: &Number) -> Result<Number, String> {
        x.inverse().ok_or_else(|| "division by zero".to_owned())
    }

    /// Only of rational numbers.
    fn root(&self, x: &Number) -> Result<Number, String> {
        let square = x.to_rational();
        let square = square.ok_or_else(|| format!("sqrt({x}): the radicand is irrational"))?;
        let root = self.0.value(&format!("sqrt({square})"));
        root.map_err(|error| error.to_string())
    }

    fn apply(&self, function: Function, _: &Number) -> Result<Number, String> {
        Err(format!("{}: has no value in the field", function.name()))
    }

    fn compare(&self, x: &Number, y: &Number) -> Option<Ordering> {
        Some(x.cmp(y))
    }

    fn shown(&self, x: &Number) -> String {
        decimal_range(&x.enclosure(&Rational::from_unsigneds(1, WIDTH)))
    }
}
