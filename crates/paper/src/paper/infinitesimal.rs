//! Polynomials in one variable ε over the rationals as a ring for predicates: the predicate
//! of a figure that depends on ε comes out as a polynomial.
//!
//! The order is that of small positive ε: a polynomial has the sign of its lowest
//! coefficient that is not zero.

use acutile_exact::geometry::{RingElement, Scalar, Sign};
use malachite::Rational;
use malachite::base::num::basic::traits::Zero;

/// Σ c_k ε^k, constant coefficient first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial(Vec<Rational>);

impl Polynomial {
    /// From coefficients with a common denominator.
    pub fn new(numerators: &[i64], denominator: i64) -> Polynomial {
        let coefficients = numerators.iter();
        Polynomial(
            coefficients
                .map(|&n| Rational::from_signeds(n, denominator))
                .collect(),
        )
    }

    /// The coefficient of ε^k.
    pub fn coefficient(&self, k: usize) -> Rational {
        self.0.get(k).cloned().unwrap_or(Rational::ZERO)
    }

    /// The coefficients.
    pub fn coefficients(&self) -> &[Rational] {
        &self.0
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.0.iter().all(|c| *c == 0)
    }

    /// Whether all coefficients are <= 0 and one is not 0, so that its value is negative for
    /// all ε > 0.
    pub fn is_negative_for_all(&self) -> bool {
        self.0.iter().all(|c| *c <= 0) && !self.is_zero()
    }

    fn combine(&self, other: &Polynomial, by: impl Fn(Rational, Rational) -> Rational) -> Self {
        let length = self.0.len().max(other.0.len());
        let sum = (0..length).map(|k| by(self.coefficient(k), other.coefficient(k)));
        Polynomial(sum.collect())
    }
}

impl RingElement for Polynomial {
    fn integer(&self, value: i64) -> Self {
        Polynomial::new(&[value], 1)
    }

    fn plus(&self, other: &Self) -> Self {
        self.combine(other, |x, y| x + y)
    }

    fn minus(&self, other: &Self) -> Self {
        self.combine(other, |x, y| x - y)
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = vec![Rational::ZERO; (self.0.len() + other.0.len()).max(1) - 1];
        for (i, x) in self.0.iter().enumerate() {
            for (j, y) in other.0.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        Polynomial(product)
    }
}

impl Scalar for Polynomial {
    fn sign(&self) -> Sign {
        let lowest = self.0.iter().find(|c| **c != 0);
        lowest.map_or(Sign::Equal, |c| c.partial_cmp(&0).unwrap_or(Sign::Equal))
    }

    fn approximate(&self) -> f64 {
        acutile_exact::number::Number::from(self.coefficient(0)).approximate()
    }
}
