//! Common denominators.

use super::Number;
use malachite::base::num::arithmetic::traits::{DivExact, Lcm};
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Natural, Rational};

/// The least common multiple of the denominators.
pub fn common_denominator<'r>(numbers: impl Iterator<Item = &'r Rational>) -> Natural {
    numbers.fold(Natural::ONE, |lcm, x| {
        if *x.denominator_ref() == 1 {
            lcm
        } else {
            lcm.lcm(x.denominator_ref())
        }
    })
}

/// Integers n_i and the common denominator d > 0 with p_i = n_i / d.
pub fn over_common_denominator(p: &[Rational]) -> (Vec<Integer>, Natural) {
    let d = common_denominator(p.iter());
    let numerator = |c: &Rational| {
        let n = c.numerator_ref() * (&d).div_exact(c.denominator_ref());
        Integer::from_sign_and_abs(*c >= 0, n)
    };
    (p.iter().map(numerator).collect(), d)
}

impl Number {
    /// The least positive integer that clears the coefficients of some numbers.
    pub fn common_denominator<'n>(numbers: impl Iterator<Item = &'n Number>) -> Integer {
        Integer::from(common_denominator(numbers.flat_map(Number::coefficients)))
    }
}
