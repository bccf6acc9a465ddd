//! Ordered fields inside the real numbers: Q, and Q(a) for a root a of an
//! integer polynomial.
//!
//! The polynomial need not be irreducible. It is made monic and squarefree, so that a is an algebraic
//! integer and a simple root. Everything about an element is decided at the root itself. The elements are
//! in `element`; this file makes fields and encloses their roots.

use super::error::FieldError;
use super::isolation;
use super::limits::ISOLATION_LIMIT;
use super::polynomial as poly;
use super::root::{Dyadic, Level};
use super::small::Small;
use crate::geometry::Sign;
use malachite::base::num::arithmetic::traits::{Floor, PowerOf2};
use malachite::base::num::basic::traits::{NegativeOne, One, Zero};
use malachite::{Integer, Rational};
use std::fmt;
use std::sync::{Arc, OnceLock};

/// Q, or Q(a) for one real root a of an integer polynomial. Cheap to clone;
/// equal when the polynomials and the roots are the same, whatever their symbols are.
#[derive(Clone)]
pub struct Field(Arc<Inner>);

/// The symbol of a generator that has no name.
pub(super) const SYMBOL: &str = "a";

struct Inner {
    /// How the generator is printed.
    symbol: Box<str>,
    /// Monic, squarefree.
    polynomial: Vec<Integer>,
    /// The indices and negatives of the coefficients below the leading one that
    /// are not zero: a^n = Σ c a^i.
    reduction: Vec<(usize, Rational)>,
    /// Contains the root; see [`Field::root`].
    isolation: Dyadic,
    /// The sign of the polynomial at the lower end.
    sign_below: Sign,
    /// Enclosures of the powers of the root; level j has 64·2^j bits.
    levels: [OnceLock<Level>; 32],
    /// For elements with short coefficients, if the polynomial has such, too.
    small: OnceLock<Option<Small>>,
}

impl Field {
    /// The field of rational numbers. Its generator is 0, a root of x.
    pub fn rationals() -> Field {
        static RATIONALS: OnceLock<Field> = OnceLock::new();
        RATIONALS
            .get_or_init(|| {
                let around_zero = Dyadic {
                    low: Integer::NEGATIVE_ONE,
                    high: Integer::ONE,
                    bits: 0,
                };
                Field::new(SYMBOL, vec![Integer::ZERO, Integer::ONE], around_zero)
            })
            .clone()
    }

    pub(super) fn new(symbol: &str, polynomial: Vec<Integer>, isolation: Dyadic) -> Field {
        let reduction = polynomial[..polynomial.len() - 1]
            .iter()
            .enumerate()
            .filter(|(_, c)| **c != 0)
            .map(|(i, c)| (i, Rational::from(-c)))
            .collect();
        let sign_below = poly::sign_at(&polynomial, &isolation.ends().0);
        Field(Arc::new(Inner {
            symbol: symbol.into(),
            polynomial,
            reduction,
            isolation,
            sign_below,
            levels: Default::default(),
            small: OnceLock::new(),
        }))
    }

    /// How the generator is printed: the name that a file gives it, or `a`.
    pub fn symbol(&self) -> &str {
        &self.0.symbol
    }

    /// Q(a) for the root a of the monic squarefree `polynomial` that `enclose`
    /// encloses in rational bounds at most as far apart as asked.
    pub(super) fn from_enclosure(
        polynomial: Vec<Integer>,
        enclose: impl Fn(&Rational) -> (Rational, Rational),
    ) -> Result<Field, FieldError> {
        for bits in 0..ISOLATION_LIMIT {
            let (lo, hi) = enclose(&Rational::power_of_2(-(bits as i64) - 8));
            let (low, high) = ((lo << bits).floor(), (hi << bits).floor() + Integer::ONE);
            let root = Dyadic { low, high, bits };
            if isolation::isolates(&polynomial, &root) {
                return Ok(Field::new(SYMBOL, polynomial, root));
            }
        }
        Err(FieldError::RootsTooClose)
    }

    /// The degree of the polynomial, 1 for Q. The degree of the field over Q
    /// where the polynomial is irreducible, and an upper bound of it always.
    pub fn degree(&self) -> usize {
        self.0.polynomial.len() - 1
    }

    /// Whether this is Q.
    pub fn is_rationals(&self) -> bool {
        self.degree() == 1
    }

    /// The monic squarefree integer polynomial of the generator, constant term
    /// first.
    pub fn polynomial(&self) -> &[Integer] {
        &self.0.polynomial
    }

    /// An interval with dyadic ends that contains the generator and no other root. The lower end is less
    /// than the upper one, and the polynomial has opposite strict signs at them. The interval value of the
    /// derivative (Horner) excludes 0.
    pub fn root(&self) -> (Rational, Rational) {
        self.0.isolation.ends()
    }

    /// a^n = Σ c a^i with n the degree: the pairs (i, c).
    pub(super) fn reduction(&self) -> &[(usize, Rational)] {
        &self.0.reduction
    }

    /// Whether `factor`, a divisor of the polynomial, vanishes at the root:
    /// only then it has a root in the isolating interval, a simple one.
    pub(super) fn root_of(&self, factor: &[Rational]) -> bool {
        let factor = poly::primitive(factor);
        let (lo, hi) = self.root();
        poly::sign_at(&factor, &lo) != poly::sign_at(&factor, &hi)
    }

    /// Fast arithmetic for elements with short coefficients.
    pub(super) fn small(&self) -> Option<&Small> {
        let small = || Small::new(self.polynomial(), self.level(0));
        self.0.small.get_or_init(small).as_ref()
    }

    /// Enclosures of the powers of the root with 64·2^j bits. They are
    /// determined by the field and j, not by what was asked for before.
    pub(super) fn level(&self, j: usize) -> &Level {
        // Level 31 would have 2^37 bits a number: memory ends long before.
        self.0.levels[j].get_or_init(|| {
            let coarser = match j {
                0 => &self.0.isolation,
                _ => self.level(j - 1).root(),
            };
            let root = coarser.refine(self.polynomial(), self.0.sign_below, Level::bits(j));
            Level::new(root, self.degree())
        })
    }
}

impl PartialEq for Field {
    /// The same polynomial, and the intersection of the isolating intervals
    /// still holds a root. Its ends are ends of the intervals, so they are no
    /// roots, and a sign change is a root of both.
    fn eq(&self, other: &Field) -> bool {
        if Arc::ptr_eq(&self.0, &other.0) {
            return true;
        }
        if self.0.polynomial != other.0.polynomial {
            return false;
        }
        let ((lo, hi), (lo_2, hi_2)) = (self.root(), other.root());
        let (lo, hi) = (lo.max(lo_2), hi.min(hi_2));
        lo < hi && poly::sign_at(self.polynomial(), &lo) != poly::sign_at(self.polynomial(), &hi)
    }
}

impl Eq for Field {}

impl fmt::Debug for Field {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (lo, hi) = self.root();
        write!(f, "Q(a), {:?} at a in ({lo}, {hi})", self.0.polynomial)
    }
}
