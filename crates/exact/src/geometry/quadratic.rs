//! The ring Z[√d] over a ring of integers of some width, for a positive integer d
//! that is no square: exact signs by squares, without enclosures.

use super::{RingElement, Scalar, Sign};
use std::cmp::Ordering;

/// x + y √d, where all elements of a computation have the same d.
#[derive(Clone, Debug)]
pub struct Quadratic<T> {
    /// The coefficient of 1.
    pub x: T,
    /// The coefficient of √d.
    pub y: T,
    /// d itself.
    pub d: T,
}

impl<T> Quadratic<T> {
    /// Maps all three numbers; `None` if one of them has no image.
    pub fn map<S>(&self, map: impl Fn(&T) -> Option<S>) -> Option<Quadratic<S>> {
        Some(Quadratic {
            x: map(&self.x)?,
            y: map(&self.y)?,
            d: map(&self.d)?,
        })
    }
}

impl<T: Scalar> Quadratic<T> {
    fn with(&self, x: T, y: T) -> Self {
        Quadratic {
            x,
            y,
            d: self.d.clone(),
        }
    }
}

impl<T: Scalar> RingElement for Quadratic<T> {
    fn integer(&self, value: i64) -> Self {
        self.with(self.x.integer(value), self.x.integer(0))
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        self.with(self.x.plus(&other.x), self.y.plus(&other.y))
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        self.with(self.x.minus(&other.x), self.y.minus(&other.y))
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        // In this order no factor is a product of two coefficients.
        let yy = self.y.times(&self.d).times(&other.y);
        self.with(
            self.x.times(&other.x).plus(&yy),
            self.x.times(&other.y).plus(&self.y.times(&other.x)),
        )
    }
}

impl<T: Scalar> Scalar for Quadratic<T> {
    /// If x and y have no opposite signs, theirs is the sign. Otherwise x + y √d has the
    /// sign of x if x² > d y², and of y if less; they are equal only for x = y = 0.
    fn sign(&self) -> Sign {
        let (x, y) = (self.x.sign(), self.y.sign());
        match (x, y) {
            (_, Ordering::Equal) => x,
            (Ordering::Equal, _) => y,
            _ if x == y => x,
            _ if T::compare_squares(&self.x, &self.y, &self.d) == Ordering::Greater => x,
            _ => y,
        }
    }

    fn approximate(&self) -> f64 {
        self.x.approximate() + self.y.approximate() * self.d.approximate().sqrt()
    }
}
