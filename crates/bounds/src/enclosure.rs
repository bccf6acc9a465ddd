//! Closed intervals with rational ends as enclosures of real numbers.
//!
//! Every result is rounded outward to multiples of 2^-64, so that the ends stay short.

use super::arithmetic::{Arithmetic, Function};
use acutile_core::quality::decimal_range;
use acutile_exact::number::Interval;
use acutile_exact::number::enclosure::{acos_degrees, cos_of_degrees, pi, sqrt_above, sqrt_below};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, PowerOf2};
use std::cmp::Ordering;

/// Ends are multiples of 2^-BITS.
const BITS: u64 = 64;
/// Cosines, arccosines and π are enclosed to 2^-FUNCTION_BITS.
const FUNCTION_BITS: i64 = 50;

/// Intervals.
pub struct Enclosures;

/// The width of an enclosed cosine, arccosine or π.
fn width() -> Rational {
    Rational::power_of_2(-FUNCTION_BITS)
}

/// The interval, with its ends rounded outward.
fn rounded(lo: Rational, hi: Rational) -> Interval {
    Interval {
        lo: Rational::from((lo << BITS).floor()) >> BITS,
        hi: Rational::from((hi << BITS).ceiling()) >> BITS,
    }
}

/// The interval of one number.
pub fn point(value: &Rational) -> Interval {
    Interval {
        lo: value.clone(),
        hi: value.clone(),
    }
}

/// An enclosure of π.
pub fn enclosed_pi() -> Interval {
    let (lo, hi) = pi(&width());
    Interval { lo, hi }
}

/// Whether every number of `x` lies between `lo` and `hi`.
fn lies_within(x: &Interval, lo: i32, hi: i32) -> bool {
    x.lo >= lo && x.hi <= hi
}

/// The cosine falls from 0 to 180 degrees.
fn cos(x: &Interval) -> Interval {
    let lo = cos_of_degrees(&x.hi, &width()).0;
    let hi = cos_of_degrees(&x.lo, &width()).1;
    rounded(lo, hi)
}

impl Arithmetic for Enclosures {
    type Value = Interval;

    fn rational(&self, value: &Rational) -> Interval {
        point(value)
    }

    fn sum(&self, x: &Interval, y: &Interval) -> Interval {
        rounded(&x.lo + &y.lo, &x.hi + &y.hi)
    }

    fn difference(&self, x: &Interval, y: &Interval) -> Interval {
        rounded(&x.lo - &y.hi, &x.hi - &y.lo)
    }

    fn product(&self, x: &Interval, y: &Interval) -> Interval {
        let product = x.times(y);
        rounded(product.lo, product.hi)
    }

    fn inverse(&self, x: &Interval) -> Result<Interval, String> {
        if x.contains_zero() {
            return Err("division by a number that may be zero".to_owned());
        }
        let one = Rational::from(1);
        Ok(rounded(&one / &x.hi, one / &x.lo))
    }

    fn root(&self, x: &Interval) -> Result<Interval, String> {
        if x.lo < 0 {
            return Err("root of a number that may be negative".to_owned());
        }
        Ok(Interval {
            lo: sqrt_below(&x.lo, BITS),
            hi: sqrt_above(&x.hi, BITS),
        })
    }

    fn apply(&self, function: Function, x: &Interval) -> Result<Interval, String> {
        let (lo, hi) = match function {
            Function::Cos => (0, 180),
            Function::Sin => (0, 90),
            Function::Arccos => (-1, 1),
        };
        if !lies_within(x, lo, hi) {
            let name = function.name();
            return Err(format!("{name}: an argument beyond {lo} to {hi}"));
        }
        Ok(match function {
            Function::Cos => cos(x),
            // sin x = cos(90 - x)
            Function::Sin => cos(&self.difference(&point(&Rational::from(90)), x)),
            Function::Arccos => {
                let (lo, hi) = acos_degrees(&x.lo, &x.hi, &width());
                rounded(lo, hi)
            }
        })
    }

    fn compare(&self, x: &Interval, y: &Interval) -> Option<Ordering> {
        if x.lo > y.hi {
            Some(Ordering::Greater)
        } else if x.hi < y.lo {
            Some(Ordering::Less)
        } else if x.lo == y.hi && x.hi == y.lo {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    fn shown(&self, x: &Interval) -> String {
        decimal_range(&(x.lo.clone(), x.hi.clone()))
    }
}
