//! The coefficients of polynomials.

use super::cuboid::Side;
use crate::geometry::Scalar;
use crate::number::Number;
use malachite::base::num::arithmetic::traits::{DivExact, Gcd, Lcm};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};

/// A coefficient: an integer, or a number of a field.
pub trait Coefficient: Scalar + Ord {
    /// The cost of a product, against one of integers.
    const COST: u64;
    /// An integer.
    fn from_integer(value: i64) -> Self;
    /// These numbers times one positive number.
    fn reduced(coefficients: Vec<&Self>) -> Vec<Self>;
    /// Positive d with d x = l and d y = h for the ends x and y of a side: [l, h, d]. `None` if they
    /// are no quotients of such coefficients.
    fn ends(side: &Side) -> Option<[Self; 3]>;
    /// The number.
    fn to_number(&self) -> Number;
}

impl Coefficient for Integer {
    const COST: u64 = 1;

    fn from_integer(value: i64) -> Self {
        Integer::from(value)
    }

    fn reduced(coefficients: Vec<&Self>) -> Vec<Self> {
        let sizes = coefficients.iter().map(|c| c.unsigned_abs_ref());
        let divisor = sizes.fold(Natural::ZERO, |gcd, size| gcd.gcd(size));
        let divisor = Integer::from(divisor.max(Natural::ONE));
        coefficients
            .into_iter()
            .map(|c| c.div_exact(&divisor))
            .collect()
    }

    fn ends(side: &Side) -> Option<[Self; 3]> {
        let [low, high] = [
            side.low.value.to_rational()?,
            side.high.value.to_rational()?,
        ];
        let unit = low.denominator_ref().lcm(high.denominator_ref());
        let scaled = |x: &Rational| Integer::try_from(x * Rational::from(&unit)).ok();
        Some([scaled(low)?, scaled(high)?, Integer::from(&unit)])
    }

    fn to_number(&self) -> Number {
        Number::from(Rational::from(self))
    }
}

impl Coefficient for Number {
    const COST: u64 = 8;

    fn from_integer(value: i64) -> Self {
        Number::from(Rational::from(value))
    }

    fn reduced(coefficients: Vec<&Self>) -> Vec<Self> {
        let all = || coefficients.iter().flat_map(|c| c.coefficients());
        let sizes = all().map(|c| c.numerator_ref());
        let divisor = sizes.fold(Natural::ZERO, |gcd, size| gcd.gcd(size));
        let multiple = all().fold(Natural::ONE, |lcm, c| lcm.lcm(c.denominator_ref()));
        let factor = Rational::from_naturals(multiple, divisor.max(Natural::ONE));
        let factor = Number::from(factor);
        coefficients.into_iter().map(|c| c * &factor).collect()
    }

    fn ends(side: &Side) -> Option<[Self; 3]> {
        Some([
            side.low.value.clone(),
            side.high.value.clone(),
            Self::from_integer(1),
        ])
    }

    fn to_number(&self) -> Number {
        self.clone()
    }
}
