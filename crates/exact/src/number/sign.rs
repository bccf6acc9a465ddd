//! Signs, enclosures and nearest doubles of elements of a field.
//!
//! A strict sign is proved by an enclosure at the root. A zero is recognised by its coefficients. If the
//! polynomial of the field is reducible, gcd(f, p) decides: f vanishes at the root exactly when that
//! divisor does.

use super::element::{Number, Value};
use super::enclosure as fixed;
use super::field::Field;
use super::over_common_denominator;
use super::polynomial as poly;
use super::root::Level;
use crate::geometry::Sign;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, Sign as _};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode::Nearest;
use malachite::{Integer, Natural, Rational};
use std::cmp::Ordering;

/// The level from which on an undecided sign is suspected to be zero.
const SUSPECT: usize = 2;
/// Bits of an approximation beyond those of a double.
const GUARD_BITS: u64 = 12;

impl Number {
    /// The exact sign.
    pub fn sign(&self) -> Sign {
        match &self.0 {
            Value::Rational(value) => value.sign(),
            Value::Algebraic(field, f) => field
                .small()
                .and_then(|small| small.sign(f))
                .or_else(|| separate(field, f, |_, _| true).map(|bounds| bounds.low.sign()))
                .unwrap_or(Ordering::Equal),
        }
    }

    /// Whether the number is 0.
    pub fn is_zero(&self) -> bool {
        self.sign() == Ordering::Equal
    }

    /// |x|
    pub fn abs(&self) -> Number {
        if self.sign() == Ordering::Less {
            -self
        } else {
            self.clone()
        }
    }

    /// Rational bounds (lo, hi) with lo <= x <= hi and hi - lo <= `width`, which
    /// is positive; the value itself twice if it is written as a rational.
    /// Dyadic numbers of about as many bits as the width needs.
    pub fn enclosure(&self, width: &Rational) -> (Rational, Rational) {
        let (field, f) = match &self.0 {
            Value::Rational(value) => return (value.clone(), value.clone()),
            Value::Algebraic(field, f) => (field, f),
        };
        assert!(*width > 0, "an enclosure has a positive width");
        // Rounding out to multiples of 2^-grid <= width/4 adds width/2.
        let grid = (2 - width.floor_log_base_2_abs()).max(0).unsigned_abs();
        let (numerators, denominator) = over_common_denominator(f);
        let mut level = 0;
        loop {
            let (low, high) = field.level(level).bounds(&numerators);
            let scale = Rational::from(&denominator) << Level::bits(level);
            if Rational::from(&high - &low) / &scale <= width / Rational::from(2) {
                let low = ((Rational::from(low) / &scale) << grid).floor();
                let high = ((Rational::from(high) / &scale) << grid).ceiling();
                return (Rational::from(low) >> grid, Rational::from(high) >> grid);
            }
            level += 1;
        }
    }

    /// The largest integer that is not more than the number.
    pub fn floor(&self) -> Integer {
        if let Some(rational) = self.to_rational() {
            return rational.floor();
        }
        // The width is below 1, so there are two candidates at most.
        let (low, _) = self.enclosure(&Rational::from_unsigneds(1u8, 4u8));
        let candidate = low.floor();
        let next = &candidate + Integer::ONE;
        match (self - &Number::from(Rational::from(&next))).sign() {
            Sign::Less => candidate,
            _ => next,
        }
    }

    /// Rational bounds of √x at most `width` apart, for x >= 0.
    ///
    /// √hi - √lo <= √(hi - lo) <= width/2, and the rounding adds width/2.
    pub fn enclosure_of_root(&self, width: &Rational) -> (Rational, Rational) {
        let (lo, hi) = self.enclosure(&(width * width / Rational::from(4)));
        let bits = (2 - width.floor_log_base_2_abs()).max(0).unsigned_abs();
        (
            fixed::sqrt_below(&lo.max(Rational::ZERO), bits),
            fixed::sqrt_above(&hi, bits),
        )
    }

    /// The nearest double or a neighbour of it; infinite beyond the range.
    pub fn approximate(&self) -> f64 {
        let middle = match &self.0 {
            Value::Rational(value) => return f64::rounding_from(value, Nearest).0,
            Value::Algebraic(field, f) => {
                let precise = |low: &Integer, high: &Integer| {
                    (high - low).significant_bits() + 53 + GUARD_BITS <= low.significant_bits()
                };
                separate(field, f, precise).map(|bounds| bounds.middle())
            }
        };
        middle.map_or(0.0, |middle| f64::rounding_from(middle, Nearest).0)
    }
}

/// A number between low/(2^bits d) and high/(2^bits d), both of its sign.
struct Bounds {
    low: Integer,
    high: Integer,
    bits: u64,
    denominator: Natural,
}

impl Bounds {
    fn middle(&self) -> Rational {
        (Rational::from(&self.low + &self.high) >> (self.bits + 1))
            / Rational::from(&self.denominator)
    }
}

/// Bounds of the element with coefficients `f` that exclude 0 and are `enough`,
/// at the first level that has them; `None` if the element is 0.
///
/// The loop ends: an element that is not 0 is away from 0 by a positive number,
/// and the width of the bounds goes to 0.
fn separate(
    field: &Field,
    f: &[Rational],
    enough: impl Fn(&Integer, &Integer) -> bool,
) -> Option<Bounds> {
    let (numerators, denominator) = over_common_denominator(f);
    let mut level = 0;
    loop {
        let (low, high) = field.level(level).bounds(&numerators);
        if low.sign() == high.sign() && low != Integer::ZERO && enough(&low, &high) {
            return Some(Bounds {
                low,
                high,
                bits: Level::bits(level),
                denominator,
            });
        }
        if level == SUSPECT && low <= 0 && high >= 0 && vanishes(field, f) {
            return None;
        }
        level += 1;
    }
}

/// Whether f is 0 at the root of the field.
fn vanishes(field: &Field, f: &[Rational]) -> bool {
    let common = poly::gcd(f, &poly::from_integers(field.polynomial()));
    common.len() > 1 && field.root_of(&common)
}
