//! The numbers of a field, and fields from roots of polynomials.

use super::element::Number;
use super::error::FieldError;
use super::field::{Field, SYMBOL};
use super::isolation::{self, Isolated};
use super::polynomial as poly;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Rational};

impl Field {
    /// Q(a) for the only root a of `polynomial` in the closed interval
    /// [`lo`, `hi`], and a itself.
    ///
    /// `polynomial`: integers, constant term first, of degree at least one; any
    /// leading coefficient, not necessarily irreducible or squarefree. A
    /// multiple root counts once. If a is rational the field is Q.
    pub fn adjoin_root(
        polynomial: &[Integer],
        lo: Rational,
        hi: Rational,
    ) -> Result<(Field, Number), FieldError> {
        Field::adjoin_named_root(SYMBOL, polynomial, lo, hi)
    }

    /// The same, with a name for the root. The generator of the field is printed by this name
    /// if it is the root, that is if the polynomial is monic.
    pub(super) fn adjoin_named_root(
        name: &str,
        polynomial: &[Integer],
        lo: Rational,
        hi: Rational,
    ) -> Result<(Field, Number), FieldError> {
        isolation::check_limits(polynomial, &lo, &hi)?;
        let p = poly::squarefree(&poly::from_integers(polynomial));
        match poly::count_roots(&p, &lo, &hi) {
            0 => return Err(FieldError::NoRoot(lo, hi)),
            1 => {}
            count => return Err(FieldError::SeveralRoots(lo, hi, count)),
        }
        let (monic, scale) = isolation::make_monic(poly::primitive(&p));
        let root = isolation::isolate(&monic, &(lo * &scale), &(hi * &scale));
        Ok(match root.ok_or(FieldError::RootsTooClose)? {
            Isolated::Integer(m) => (Field::rationals(), Number::from(Rational::from(m) / scale)),
            Isolated::Irrational(interval) => {
                let symbol = if scale == 1 { name } else { SYMBOL };
                let field = Field::new(symbol, monic, interval);
                let a = field.element(vec![Rational::ZERO, Rational::ONE / scale]);
                (field, a)
            }
        })
    }

    /// The integer `value`.
    pub fn integer(&self, value: i64) -> Number {
        Number::from(Rational::from(value))
    }

    /// The rational number `value`.
    pub fn rational(&self, value: Rational) -> Number {
        Number::from(value)
    }

    /// Σ c_i a^i for the generator a and any number of coefficients c_i.
    pub fn element(&self, coefficients: Vec<Rational>) -> Number {
        Number::reduced(self, coefficients)
    }

    /// The generator a.
    pub fn generator(&self) -> Number {
        self.element(vec![Rational::ZERO, Rational::ONE])
    }
}
