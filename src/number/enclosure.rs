//! Intervals with rational ends.

use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Rational};

/// All real numbers from `lo` to `hi`, lo <= hi.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// Lower end.
    pub lo: Rational,
    /// Upper end.
    pub hi: Rational,
}

impl From<(Rational, Rational)> for Interval {
    fn from((lo, hi): (Rational, Rational)) -> Interval {
        Interval { lo, hi }
    }
}

impl Interval {
    /// Whether 0 lies in it.
    pub fn contains_zero(&self) -> bool {
        self.lo <= 0 && self.hi >= 0
    }

    /// All products of a number of `self` with one of `other`.
    pub fn times(&self, other: &Interval) -> Interval {
        let products = [
            &self.lo * &other.lo,
            &self.lo * &other.hi,
            &self.hi * &other.lo,
            &self.hi * &other.hi,
        ];
        let [a, b, c, d] = &products;
        Interval {
            lo: a.min(b).min(c.min(d)).clone(),
            hi: a.max(b).max(c.max(d)).clone(),
        }
    }

    /// An interval with all values of Σ p_i x^i for x in `self`, by Horner's
    /// rule with interval operations.
    pub fn horner(&self, p: &[Integer]) -> Interval {
        let zero = Interval {
            lo: Rational::ZERO,
            hi: Rational::ZERO,
        };
        p.iter().rev().fold(zero, |value, c| {
            let product = value.times(self);
            let c = Rational::from(c);
            Interval {
                lo: product.lo + &c,
                hi: product.hi + c,
            }
        })
    }
}
