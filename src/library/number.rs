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
/// assert_eq!(golden.to_string(), "1/2 + 1/2*sqrt(5)");
/// assert!("1 / 0".parse::<Number>().is_err());
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Number(number::Number);

impl Number {
    /// The nearest double, for display.
    pub fn approximate(&self) -> f64 {
        self.0.approximate()
    }
}

impl FromStr for Number {
    type Err = Error;

    fn from_str(text: &str) -> Result<Number, Error> {
        let mut values = numbers(&[text]).map_err(Error::new)?;
        values
            .pop()
            .map(Number)
            .ok_or_else(|| Error::new("no number"))
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.fmt(f)
    }
}
