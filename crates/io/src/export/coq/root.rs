//! The root of an algebraic field, isolated by bisection: enclosures for the checker.

use super::NotATheorem;
use super::numbers::{BigRational, integer, rational};
use acutile_format1::certificate::{AlgebraicField, Field};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

/// The field's polynomial, constant term first, and the interval of its root.
pub(super) struct RootOf {
    pub(super) polynomial: Vec<BigInt>,
    pub(super) low: BigRational,
    pub(super) high: BigRational,
}

/// The root lies in [low, high] / scale.
#[derive(Clone)]
pub(super) struct Enclosure {
    low: BigInt,
    high: BigInt,
    scale: BigInt,
}

impl Enclosure {
    pub(super) fn term(&self) -> String {
        format!(
            "Encl {} {} {}",
            integer(&self.low),
            integer(&self.high),
            self.scale
        )
    }
}

impl RootOf {
    pub(super) fn new(field: &Field) -> Result<Option<RootOf>, NotATheorem> {
        let Field::Algebraic(AlgebraicField { polynomial, root }) = field else {
            return Ok(None);
        };
        let coefficients = polynomial
            .iter()
            .map(|c| rational(c))
            .collect::<Result<Vec<_>, _>>()?;
        if coefficients.len() < 3 || coefficients.iter().any(|c| !c.is_integer()) {
            return Err(NotATheorem::Malformed("the polynomial".to_owned()));
        }
        let polynomial = coefficients.iter().map(BigRational::to_integer).collect();
        let (low, high) = (rational(&root.0)?, rational(&root.1)?);
        Ok(Some(RootOf {
            polynomial,
            low,
            high,
        }))
    }

    pub(super) fn rational_polynomial(&self) -> Vec<BigRational> {
        let coefficients = self.polynomial.iter().cloned();
        coefficients.map(BigRational::from_integer).collect()
    }

    pub(super) fn enclosure(&self) -> Enclosure {
        Enclosure {
            low: self.low.numer() * self.high.denom(),
            high: self.high.numer() * self.low.denom(),
            scale: self.low.denom() * self.high.denom(),
        }
    }

    /// Enclosures after 32, 64, …, 512 halvings: coarse ones are cheap and mostly do.
    pub(super) fn ladder(&self) -> Vec<Enclosure> {
        let mut at = self.enclosure();
        let right = self.sign(&at.high, &at.scale);
        let mut ladder = Vec::new();
        for step in 1..=512u32 {
            let middle = &at.low + &at.high;
            at = Enclosure {
                low: at.low * 2,
                high: at.high * 2,
                scale: at.scale * 2,
            };
            let sign = self.sign(&middle, &at.scale);
            if sign.is_zero() || sign != right {
                at.low = middle.clone();
            }
            if sign.is_zero() || sign == right {
                at.high = middle;
            }
            if step >= 32 && step.is_power_of_two() {
                ladder.push(at.clone());
            }
        }
        ladder
    }

    /// The sign of the polynomial at x / scale, for scale > 0.
    fn sign(&self, x: &BigInt, scale: &BigInt) -> BigInt {
        let mut power = BigInt::one();
        let mut value = BigInt::zero();
        for c in self.polynomial.iter().rev() {
            value = value * x + c * &power;
            power *= scale;
        }
        value.signum()
    }
}
