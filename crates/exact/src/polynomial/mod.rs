//! Polynomials in several real parameters, and their signs on boxes.
//!
//! | file | contains |
//! |---|---|
//! | this one | [`Polynomial`]: ring operations, values |
//! | `coefficient` | [`Coefficient`]: integers, or numbers of a field |
//! | [`cuboid`] | [`Cuboid`]: a product of intervals with open or closed ends |
//! | [`bernstein`] | signs that hold on a whole box |
//! | [`mod@line`] | polynomials in one parameter: critical points, signs at them and between them |
//! | [`text`] | polynomials as people write them |
//!
//! A polynomial is a [`RingElement`], so the predicates of [`crate::geometry`] work on it. It is no
//! `Scalar`, because its sign may change from point to point.
//!
//! ```
//! use acutile_exact::geometry::RingElement;
//! use acutile_exact::number::Number;
//! use acutile_exact::polynomial::{Cuboid, Polynomial, bernstein};
//! use malachite::Rational;
//!
//! // x² - x + 1 is positive for all x in [0, 1].
//! let x: Polynomial<Number> = Polynomial::parameter(0);
//! let p = x.times(&x).minus(&x).plus(&x.integer(1));
//! let unit = Cuboid::closed(&[(Rational::from(0), Rational::from(1))]);
//! assert_eq!(bernstein::is_positive(&p, &unit), Some(true));
//! ```

pub mod bernstein;
mod coefficient;

pub mod cuboid;
mod dense;
pub mod line;
pub mod text;

pub use coefficient::Coefficient;
pub use cuboid::{Cuboid, End, Side};

use crate::geometry::{RingElement, Sign};
use crate::number::Number;
use std::collections::BTreeMap;
use std::fmt;

/// There are at most this many parameters.
pub const MOST_PARAMETERS: usize = 16;
/// No exponent is larger: products of more factors than any predicate has fit.
const MOST_EXPONENT: u32 = 255;

/// The exponents of the parameters, a byte for each, the first one in the highest byte. So the
/// order of the integers is the lexicographic order of the exponents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(u128);

impl Monomial {
    const ONE: Monomial = Monomial(0);

    fn power(parameter: usize, exponent: u8) -> Self {
        Monomial(u128::from(exponent) << (8 * (MOST_PARAMETERS - 1 - parameter)))
    }

    /// The exponent of a parameter.
    pub fn exponent(self, parameter: usize) -> usize {
        usize::from(self.0.to_be_bytes()[parameter])
    }
}

/// A polynomial: its terms that are not zero, in the order of their monomials.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Polynomial<C = Number> {
    terms: Vec<(Monomial, C)>,
}

impl<C: Coefficient> Polynomial<C> {
    /// The polynomial 0.
    pub fn zero() -> Self {
        Polynomial { terms: Vec::new() }
    }

    /// A constant.
    pub fn constant(value: C) -> Self {
        Polynomial::sum(std::iter::once((Monomial::ONE, value)))
    }

    /// The parameter with this index, which is less than [`MOST_PARAMETERS`].
    pub fn parameter(index: usize) -> Self {
        Polynomial {
            terms: vec![(Monomial::power(index, 1), C::from_integer(1))],
        }
    }

    /// The sum of these terms: exponents, as many as there are parameters, and coefficients.
    pub fn from_terms(terms: impl IntoIterator<Item = (Vec<u8>, C)>) -> Self {
        let monomial = |exponents: Vec<u8>| {
            let powers = exponents.into_iter().enumerate();
            Monomial(powers.map(|(k, e)| Monomial::power(k, e).0).sum())
        };
        Polynomial::sum(terms.into_iter().map(|(e, c)| (monomial(e), c)))
    }

    fn sum(terms: impl Iterator<Item = (Monomial, C)>) -> Self {
        let mut sum: BTreeMap<Monomial, C> = BTreeMap::new();
        for (monomial, c) in terms {
            match sum.get_mut(&monomial) {
                Some(present) => *present = present.plus(&c),
                None => drop(sum.insert(monomial, c)),
            }
        }
        let is_there = |(_, c): &(Monomial, C)| c.sign().is_ne();
        Polynomial {
            terms: sum.into_iter().filter(is_there).collect(),
        }
    }

    /// The terms that are not zero, in lexicographic order of the exponents.
    pub fn terms(&self) -> &[(Monomial, C)] {
        &self.terms
    }

    /// Whether this is the polynomial 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value, if the polynomial is constant.
    pub fn to_constant(&self) -> Option<C> {
        match self.terms.as_slice() {
            [] => Some(C::from_integer(0)),
            [(Monomial::ONE, value)] => Some(value.clone()),
            _ => None,
        }
    }

    /// The degree in a parameter; 0 for the polynomial 0.
    pub fn degree(&self, parameter: usize) -> usize {
        let exponents = self.terms.iter().map(|(m, _)| m.exponent(parameter));
        exponents.max().unwrap_or(0)
    }

    /// The polynomial with other coefficients; those that become 0 are left out.
    pub fn map<T: Coefficient>(&self, map: impl Fn(&C) -> T) -> Polynomial<T> {
        Polynomial::sum(self.terms.iter().map(|(m, c)| (*m, map(c))))
    }

    /// The multiple by a positive number whose coefficients are short; equal for all positive
    /// multiples, if coefficients are integers.
    pub fn reduced(&self) -> Self {
        let coefficients = self.terms.iter().map(|(_, c)| c);
        let reduced = C::reduced(coefficients.collect());
        let monomials = self.terms.iter().map(|(m, _)| *m);
        Polynomial {
            terms: monomials.zip(reduced).collect(),
        }
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        Polynomial::zero().minus(self)
    }

    fn merged(&self, other: &Self, of_other: impl Fn(&C) -> C) -> Self {
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        let (mut left, mut right) = (self.terms.iter().peekable(), other.terms.iter().peekable());
        loop {
            let term = match (left.peek(), right.peek()) {
                (Some((m, _)), Some((n, _))) if m == n => left
                    .next()
                    .zip(right.next())
                    .map(|(a, b)| (a.0, a.1.plus(&of_other(&b.1)))),
                (Some((m, _)), Some((n, _))) if m > n => {
                    right.next().map(|b| (b.0, of_other(&b.1)))
                }
                (None, Some(_)) => right.next().map(|b| (b.0, of_other(&b.1))),
                (Some(_), _) => left.next().cloned(),
                (None, None) => return Polynomial { terms },
            };
            terms.extend(term.filter(|(_, c)| c.sign().is_ne()));
        }
    }
}

impl Polynomial<Number> {
    /// The value at a point, as many numbers as there are parameters.
    pub fn value(&self, point: &[Number]) -> Number {
        let power = |x: &Number, e: usize| (0..e).fold(x.integer(1), |product, _| &product * x);
        let term = |(monomial, c): &(Monomial, Number)| {
            let factors = point.iter().enumerate();
            factors.fold(c.clone(), |product, (k, x)| match monomial.exponent(k) {
                0 => product,
                e => &product * &power(x, e),
            })
        };
        self.terms
            .iter()
            .fold(Number::zero(), |sum, t| sum + term(t))
    }

    /// The sign at a point.
    pub fn sign_at(&self, point: &[Number]) -> Sign {
        self.value(point).sign()
    }

    /// The text with these names of the parameters: `3/4*c2 - 1`.
    pub fn shown(&self, names: &[String]) -> String {
        text::shown(self, names)
    }
}

impl<C: Coefficient> RingElement for Polynomial<C> {
    fn integer(&self, value: i64) -> Self {
        Polynomial::constant(C::from_integer(value))
    }

    fn plus(&self, other: &Self) -> Self {
        self.merged(other, C::clone)
    }

    fn minus(&self, other: &Self) -> Self {
        self.merged(other, |c| c.integer(0).minus(c))
    }

    /// # Panics
    /// If an exponent becomes larger than 255.
    fn times(&self, other: &Self) -> Self {
        if let [(Monomial::ONE, c)] = other.terms.as_slice() {
            return self.map(|x| x.times(c));
        }
        for k in 0..MOST_PARAMETERS {
            let degree = self.degree(k) + other.degree(k);
            assert!(
                degree <= MOST_EXPONENT as usize,
                "the degree {degree} is too high"
            );
        }
        let products = self.terms.iter().flat_map(|(m, c)| {
            let factors = other.terms.iter();
            factors.map(move |(n, d)| (Monomial(m.0 + n.0), c.times(d)))
        });
        Polynomial::sum(products)
    }
}

impl<C: fmt::Debug> fmt::Debug for Polynomial<C> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let terms = self.terms.iter().map(|(m, c)| (m.0.to_be_bytes(), c));
        f.debug_list().entries(terms).finish()
    }
}
