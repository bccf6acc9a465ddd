//! The root of an algebraic field, isolated by bisection: enclosures for the checker.

use super::error::{NotATheorem, require};
use super::numbers::{fraction, integer, polynomial, sign};
use acutile_core::format::AlgebraicField;
use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};

/// The field's polynomial, and the interval of its root.
pub(super) struct RootOf<'f> {
    field: &'f AlgebraicField,
}

/// The root lies in [low, high] / scale.
#[derive(Clone)]
struct Enclosure {
    low: Integer,
    high: Integer,
    scale: Integer,
}

impl Enclosure {
    fn term(&self) -> String {
        let (low, high) = (integer(&self.low), integer(&self.high));
        format!("Encl {low} {high} {}", self.scale)
    }
}

impl<'f> RootOf<'f> {
    pub(super) fn new(field: &'f AlgebraicField) -> Result<RootOf<'f>, NotATheorem> {
        require(field.polynomial.len() >= 3, "the degree of the polynomial")?;
        require(field.denominator > 0, "a denominator is positive")?;
        Ok(RootOf { field })
    }

    /// The polynomial at `x`, for people.
    pub(super) fn polynomial(&self, x: &str) -> String {
        polynomial(&self.field.polynomial, &Integer::ONE, x)
    }

    /// "low <= x <= high".
    pub(super) fn between(&self, x: &str) -> String {
        let end = |e| fraction(e, &self.field.denominator);
        format!(
            "{} <= {x} <= {}",
            end(&self.field.low),
            end(&self.field.high)
        )
    }

    /// The lower coefficients of the polynomial, the interval, and finer enclosures.
    pub(super) fn definitions(&self) -> Result<String, NotATheorem> {
        let ladder = self.ladder();
        let terms: Vec<String> = ladder.iter().map(Enclosure::term).collect();
        let broken = NotATheorem::Malformed("the root");
        let (finest, coarse) = terms.split_last().ok_or(broken.clone())?;
        let (_, lower) = self.field.polynomial.split_last().ok_or(broken)?;
        let lower: Vec<String> = lower.iter().map(integer).collect();
        Ok(format!(
            "(* The lower coefficients of the polynomial, the interval of the claim, and enclosures. *)\n\
             Definition fl : list Z := [{}].\nDefinition interval := {}.\n\
             Definition es : list encl := [{}].\nDefinition e0 := {finest}.\n\n",
            lower.join(";"),
            self.enclosure().term(),
            coarse.join("; "),
        ))
    }

    fn enclosure(&self) -> Enclosure {
        Enclosure {
            low: self.field.low.clone(),
            high: self.field.high.clone(),
            scale: self.field.denominator.clone(),
        }
    }

    /// Enclosures after 32, 64, …, 512 halvings: coarse ones are cheap and mostly do.
    fn ladder(&self) -> Vec<Enclosure> {
        let mut at = self.enclosure();
        let right = self.sign(&at.high, &at.scale);
        let mut ladder = Vec::new();
        for step in 1..=512u32 {
            let middle = &at.low + &at.high;
            at = Enclosure {
                low: at.low * Integer::from(2),
                high: at.high * Integer::from(2),
                scale: at.scale * Integer::from(2),
            };
            let sign = self.sign(&middle, &at.scale);
            if sign == 0 || sign != right {
                at.low = middle.clone();
            }
            if sign == 0 || sign == right {
                at.high = middle;
            }
            if step >= 32 && step.is_power_of_two() {
                ladder.push(at.clone());
            }
        }
        ladder
    }

    /// The sign of the polynomial at x / scale, for scale > 0.
    fn sign(&self, x: &Integer, scale: &Integer) -> i8 {
        let mut power = Integer::ONE;
        let mut value = Integer::ZERO;
        for c in self.field.polynomial.iter().rev() {
            value = value * x + c * &power;
            power *= scale;
        }
        sign(&value)
    }
}
