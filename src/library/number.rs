//! Exact real numbers.

use super::Error;
use acutile_exact::number::{self, numbers};
use std::fmt;
use std::str::FromStr;

/// An exact real number: an integer, a fraction, a decimal, or an expression with square roots.
///
/// ```
/// use acutile::Number;
///
/// let golden: Number = "(1 + sqrt(5)) / 2".parse()?;
/// assert!((golden.approximate() - 1.618).abs() < 0.001);
/// assert_eq!(golden.to_string(), "(1 + sqrt(5)) / 2");
/// assert!("1 / 0".parse::<Number>().is_err());
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Number {
    text: String,
    value: number::Number,
}

impl Number {
    /// The nearest double, for display.
    pub fn approximate(&self) -> f64 {
        self.value.approximate()
    }
}

impl FromStr for Number {
    type Err = Error;

    fn from_str(text: &str) -> Result<Number, Error> {
        let mut values = numbers(&[text]).map_err(Error::new)?;
        let value = values.pop().ok_or_else(|| Error::new("no number"))?;
        let text = text.trim().to_owned();
        Ok(Number { text, value })
    }
}

/// The expression that was read.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.text)
    }
}
