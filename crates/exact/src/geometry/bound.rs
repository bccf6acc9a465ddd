//! Bounds of the values of a predicate, and of the errors of doubles. They come from evaluating the
//! predicate's own code over bounds.
//!
//! A [`Bound`] stands for all pairs of an exact value x and a double x' with
//! |x| <= size and |x - x'| <= error; `top` bounds every value that its computation
//! has gone through, exact or in doubles, and `factor` those that were multiplied. With u = 2^-53 and rounding to nearest,
//! a double sum x' ∘ y' is off by at most u times its exact value, hence
//!
//! - for x ± y: size s + t, error e + f + u (s + e + t + f);
//! - for x y: size s t, error s f + t e + e f + u (s + e)(t + f);
//!
//! and where nothing is rounded, because all are integers of at most 53 bits, the
//! doubles are exact. The bounds are themselves computed in doubles, so each is
//! raised by 2^-50 of itself, more than the few roundings in one line take away.
//! Underflow is not covered here; see `checker`'s filter, which stays away from it.

use super::{RingElement, Scalar, Sign};
use std::cmp::Ordering;

/// Bounds of a value, of its error in doubles, and of the whole computation.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// Of the exact value.
    pub size: f64,
    /// Of the distance of the double from it.
    pub error: f64,
    /// Of all values that led to it.
    pub top: f64,
    /// Of all factors of products that led to it.
    pub factor: f64,
}

/// The unit roundoff of doubles.
pub const ROUNDOFF: f64 = 1.0 / (1u64 << 53) as f64;

impl Bound {
    /// A value that is given, known up to `error`.
    pub fn given(size: f64, error: f64) -> Self {
        Bound {
            size,
            error,
            top: size + error,
            factor: 0.0,
        }
    }

    fn after(&self, other: &Self, size: f64, error: f64) -> Self {
        let (size, error) = (raised(size), raised(error));
        Bound {
            size,
            error,
            top: raised(size + error).max(self.top).max(other.top),
            factor: self.factor.max(other.factor),
        }
    }

    fn sum(&self, other: &Self) -> Self {
        let size = self.size + other.size;
        let error = self.error + other.error;
        self.after(other, size, error + ROUNDOFF * (size + error))
    }
}

fn raised(x: f64) -> f64 {
    x * (1.0 + 8.0 * ROUNDOFF)
}

impl RingElement for Bound {
    fn integer(&self, value: i64) -> Self {
        let size = raised(value.unsigned_abs() as f64);
        Bound::given(
            size,
            if size < 2f64.powi(53) {
                0.0
            } else {
                size * ROUNDOFF
            },
        )
    }

    fn plus(&self, other: &Self) -> Self {
        self.sum(other)
    }

    fn minus(&self, other: &Self) -> Self {
        self.sum(other)
    }

    fn times(&self, other: &Self) -> Self {
        let error = self.size * other.error + other.size * self.error + self.error * other.error;
        let rounding = ROUNDOFF * (self.size + self.error) * (other.size + other.error);
        let product = self.after(other, self.size * other.size, error + rounding);
        let factor = raised((self.size + self.error).max(other.size + other.error));
        Bound {
            factor: factor.max(product.factor),
            ..product
        }
    }
}

impl Scalar for Bound {
    fn sign(&self) -> Sign {
        Ordering::Greater
    }

    fn approximate(&self) -> f64 {
        self.size
    }
}
