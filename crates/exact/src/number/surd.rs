//! Square roots of integers in simplest form, and the generator of a quadratic field by one.

use super::{Field, Number};
use malachite::base::num::arithmetic::traits::{CheckedSqrt, Parity};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Rational};

/// Prime factors are taken out of roots up to this one.
const LARGEST_FACTOR: u32 = 10_000;

/// The generator of a field of degree 2 as offset + factor √radicand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadratic {
    /// The rational part.
    pub offset: Rational,
    /// The factor of the root, not 0.
    pub factor: Rational,
    /// Greater than 1, without the square of a small prime as a factor.
    pub radicand: Integer,
}

impl Quadratic {
    /// `None` for another degree, and where the roots of the polynomial are rational.
    pub fn of(field: &Field) -> Option<Quadratic> {
        let [c, b, _] = field.polynomial() else {
            return None;
        };
        // a = (-b ± √(b² - 4c))/2
        let (square, radicand) = square_part(&(b * b - Integer::from(4) * c));
        if radicand == 1u32 {
            return None;
        }
        let two = Rational::from(2);
        let offset = -Rational::from(b) / &two;
        let factor = Rational::from(square) / two;
        let is_larger = field.generator() > Number::from(offset.clone());
        Some(Quadratic {
            offset,
            factor: if is_larger { factor } else { -factor },
            radicand,
        })
    }
}

/// m and r with n = m² r, where r has no square of a small prime as a factor; (0, 1) for 0.
pub fn square_part(n: &Integer) -> (Integer, Integer) {
    let (mut square, mut rest) = (Integer::ONE, n.clone());
    if *n == 0 {
        return (Integer::ZERO, Integer::ONE);
    }
    for p in (2..=LARGEST_FACTOR).filter(|p| *p == 2 || p.odd()) {
        let factor = Integer::from(p) * Integer::from(p);
        if *rest.unsigned_abs_ref() < *factor.unsigned_abs_ref() {
            break;
        }
        while &rest % &factor == 0 {
            rest /= &factor;
            square *= Integer::from(p);
        }
    }
    if let (true, Some(root)) = (rest > 1, rest.unsigned_abs_ref().checked_sqrt()) {
        return (square * Integer::from(root), Integer::ONE);
    }
    (square, rest)
}
