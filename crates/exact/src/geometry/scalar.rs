//! The operations that predicates need of a number: those of a ring, and a sign.

use std::cmp::Ordering;

/// The sign of a real number: `Less` for negative, `Equal` for zero, `Greater`
/// for positive.
pub type Sign = Ordering;

/// An element of a commutative ring. Nothing is ever divided. The operations take
/// references because big numbers are not `Copy`.
pub trait RingElement: Clone + std::fmt::Debug + Send + Sync {
    /// The ring's image of an integer, in the ring of `self`.
    fn integer(&self, value: i64) -> Self;
    /// `self + other`
    fn plus(&self, other: &Self) -> Self;
    /// `self - other`
    fn minus(&self, other: &Self) -> Self;
    /// `self * other`
    fn times(&self, other: &Self) -> Self;
}

/// An element of an ordered ring, in which every sign is known.
pub trait Scalar: RingElement {
    /// The exact sign.
    fn sign(&self) -> Sign;
    /// |x|
    #[inline]
    fn magnitude(&self) -> Self {
        match self.sign() {
            Ordering::Less => self.integer(0).minus(self),
            _ => self.clone(),
        }
    }
    /// x² compared with d y²
    fn compare_squares(x: &Self, y: &Self, d: &Self) -> Ordering {
        x.times(x).minus(&y.times(d).times(y)).sign()
    }
    /// The nearest double or one close to it; infinite beyond its range. Only
    /// for filters that are confirmed exactly afterwards, and for display.
    fn approximate(&self) -> f64;
}

/// Doubles, for candidates and pictures only: no sign of a double decides a proof.
impl RingElement for f64 {
    #[inline]
    fn integer(&self, value: i64) -> Self {
        value as f64
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        self * other
    }
}

impl Scalar for f64 {
    #[inline]
    fn sign(&self) -> Sign {
        self.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }

    fn approximate(&self) -> f64 {
        *self
    }
}
