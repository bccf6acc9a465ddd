//! Ordered fields inside the real numbers: Q, and Q(a) for a root a of an
//! integer polynomial.
//!
//! The polynomial need not be irreducible. It is made monic and squarefree, so
//! that a is an algebraic integer and a simple root, and everything that is
//! decided about an element is decided at the root itself. The elements are in
//! [`super::element`]; this file makes fields and encloses their roots.

use super::element::Number;
use super::enclosure::Interval;
use super::polynomial as poly;
use super::root::{Dyadic, Level};
use crate::certificate;
use crate::geometry::Sign;
use malachite::base::num::arithmetic::traits::{Ceiling, DivExact, DivisibleBy, Floor, Pow};
use malachite::base::num::basic::traits::{NegativeOne, One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};
use std::cmp::Ordering;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// No field has a larger degree.
pub const DEGREE_LIMIT: usize = 32;
/// No coefficient of a defining polynomial, and no numerator or denominator of
/// an interval's end, has more bits (about 1,200 decimal digits).
pub const POLYNOMIAL_BITS_LIMIT: u64 = 4096;
/// A root that is not alone in a dyadic interval of width 2^-this is declined.
pub const ISOLATION_LIMIT: u64 = 4096;

/// Q, or Q(a) for one real root a of an integer polynomial. Cheap to clone;
/// equal when the polynomials and the roots are the same.
#[derive(Clone)]
pub struct Field(Arc<Inner>);

struct Inner {
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
}

/// Why there is no such field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FieldError {
    /// The polynomial is zero.
    ZeroPolynomial,
    /// The polynomial is a constant, which has no root.
    ConstantPolynomial,
    /// The degree is above [`DEGREE_LIMIT`].
    DegreeBeyondLimit(usize),
    /// A coefficient or an end of the interval has more than
    /// [`POLYNOMIAL_BITS_LIMIT`] bits: the number of bits.
    SizeBeyondLimit(u64),
    /// The lower end is above the upper end.
    EmptyInterval(Rational, Rational),
    /// The polynomial has no root in the interval.
    NoRoot(Rational, Rational),
    /// The polynomial has this many different roots in the interval.
    SeveralRoots(Rational, Rational, usize),
    /// Other roots are closer than 2^-[`ISOLATION_LIMIT`].
    RootsTooClose,
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::ZeroPolynomial => write!(f, "the polynomial is zero"),
            Self::ConstantPolynomial => write!(f, "the polynomial is a constant"),
            Self::DegreeBeyondLimit(degree) => {
                write!(f, "degree {degree} is beyond the limit of {DEGREE_LIMIT}")
            }
            Self::SizeBeyondLimit(bits) => write!(
                f,
                "a number of {bits} bits in the polynomial or its interval is beyond the limit of {POLYNOMIAL_BITS_LIMIT}"
            ),
            Self::EmptyInterval(lo, hi) => {
                write!(
                    f,
                    "the interval from {lo} to {hi} is empty: its ends are in the wrong order"
                )
            }
            Self::NoRoot(lo, hi) => write!(f, "the polynomial has no root from {lo} to {hi}"),
            Self::SeveralRoots(lo, hi, count) => {
                write!(
                    f,
                    "the polynomial has {count} roots from {lo} to {hi}, and must have one"
                )
            }
            Self::RootsTooClose => {
                write!(
                    f,
                    "other roots are closer than 2^-{ISOLATION_LIMIT} to the root"
                )
            }
        }
    }
}

impl std::error::Error for FieldError {}

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
                Field::new(vec![Integer::ZERO, Integer::ONE], around_zero)
            })
            .clone()
    }

    fn new(polynomial: Vec<Integer>, isolation: Dyadic) -> Field {
        let reduction = polynomial[..polynomial.len() - 1]
            .iter()
            .enumerate()
            .filter(|(_, c)| **c != 0)
            .map(|(i, c)| (i, Rational::from(-c)))
            .collect();
        let sign_below = poly::sign_at(&polynomial, &isolation.ends().0);
        Field(Arc::new(Inner {
            polynomial,
            reduction,
            isolation,
            sign_below,
            levels: Default::default(),
        }))
    }

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
        check_limits(polynomial, &lo, &hi)?;
        let p = poly::squarefree(&poly::from_integers(polynomial));
        match poly::count_roots(&p, &lo, &hi) {
            0 => return Err(FieldError::NoRoot(lo, hi)),
            1 => {}
            count => return Err(FieldError::SeveralRoots(lo, hi, count)),
        }
        let (monic, scale) = make_monic(poly::primitive(&p));
        let root = isolate(&monic, &(lo * &scale), &(hi * &scale));
        Ok(match root.ok_or(FieldError::RootsTooClose)? {
            Isolated::Integer(m) => (Field::rationals(), Number::from(Rational::from(m) / scale)),
            Isolated::Irrational(interval) => {
                let field = Field::new(monic, interval);
                let a = field.element(vec![Rational::ZERO, Rational::ONE / scale]);
                (field, a)
            }
        })
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

    /// An interval with dyadic ends that holds the generator and no other root:
    /// lower end < upper end, the polynomial has opposite strict signs at them,
    /// and the interval value of the derivative (Horner) excludes 0.
    pub fn root(&self) -> (Rational, Rational) {
        self.0.isolation.ends()
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

    /// The field as a certificate writes it.
    pub fn to_certificate(&self) -> certificate::Field {
        if self.is_rationals() {
            return certificate::Field::Rationals;
        }
        let (lo, hi) = self.root();
        certificate::Field::Algebraic(certificate::AlgebraicField {
            polynomial: self.polynomial().iter().map(Integer::to_string).collect(),
            root: (lo.to_string(), hi.to_string()),
        })
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

fn check_limits(polynomial: &[Integer], lo: &Rational, hi: &Rational) -> Result<(), FieldError> {
    let degree = polynomial
        .iter()
        .rposition(|c| *c != 0)
        .ok_or(FieldError::ZeroPolynomial)?;
    if degree == 0 {
        return Err(FieldError::ConstantPolynomial);
    }
    if degree > DEGREE_LIMIT {
        return Err(FieldError::DegreeBeyondLimit(degree));
    }
    let ends = [lo, hi].map(|x| {
        x.numerator_ref()
            .significant_bits()
            .max(x.denominator_ref().significant_bits())
    });
    let bits = polynomial
        .iter()
        .map(SignificantBits::significant_bits)
        .chain(ends)
        .max();
    if let Some(bits) = bits.filter(|bits| *bits > POLYNOMIAL_BITS_LIMIT) {
        return Err(FieldError::SizeBeyondLimit(bits));
    }
    if lo > hi {
        return Err(FieldError::EmptyInterval(lo.clone(), hi.clone()));
    }
    Ok(())
}

/// A monic polynomial whose roots are s times the roots of `p`, and s > 0.
///
/// With l the leading coefficient, s = l works: y = l x is a root of
/// l^(n-1) p(y/l) = Σ p_i l^(n-1-i) y^i. Then s is made smaller by the small
/// primes q for which q^(n-i) divides every coefficient.
fn make_monic(mut p: Vec<Integer>) -> (Vec<Integer>, Rational) {
    let n = p.len() - 1;
    if p[n] < 0 {
        p.iter_mut().for_each(|c| *c = -&*c);
    }
    let lead = p[n].clone();
    let mut scale = Rational::from(&lead);
    if lead == 1 {
        return (p, scale);
    }
    p[n] = Integer::ONE;
    let mut power = Integer::ONE;
    for c in p[..n].iter_mut().rev() {
        *c *= &power;
        power *= &lead;
    }
    for q in (2u64..100).map(Integer::from) {
        let powers: Vec<Integer> = (0..=n as u64).map(|i| (&q).pow(n as u64 - i)).collect();
        while p.iter().zip(&powers).all(|(c, q)| c.divisible_by(q)) {
            p.iter_mut()
                .zip(&powers)
                .for_each(|(c, q)| *c = (&*c).div_exact(q));
            scale /= Rational::from(&q);
        }
    }
    (p, scale)
}

enum Isolated {
    Integer(Integer),
    Irrational(Dyadic),
}

/// The only root of the monic `p` in [lo, hi]: an integer (a rational root of a
/// monic polynomial is one), or an interval as in [`Field::root`]. `None` beyond
/// [`ISOLATION_LIMIT`].
///
/// The interval is the first of k/2^e to (k+1)/2^e, e = 0, 1, …, with the root
/// inside and a derivative that is seen not to vanish; p is monotone there and
/// has no other root.
fn isolate(p: &[Integer], lo: &Rational, hi: &Rational) -> Option<Isolated> {
    let (at_lo, at_hi) = (poly::sign_at(p, lo), poly::sign_at(p, hi));
    for (x, sign) in [(lo, at_lo), (hi, at_hi)] {
        if sign == Ordering::Equal {
            return Integer::try_from(x).ok().map(Isolated::Integer);
        }
    }
    // The sign that p would have without its other roots.
    let sign = |x: &Rational| match x {
        x if x <= lo => at_lo,
        x if x >= hi => at_hi,
        x => poly::sign_at(p, x),
    };
    let (mut low, mut high) = (lo.floor(), hi.ceiling());
    while &high - &low > 1 {
        let middle = (&low + &high) >> 1u64;
        match sign(&Rational::from(&middle)) {
            Ordering::Equal => return Some(Isolated::Integer(middle)),
            s if s == at_lo => low = middle,
            _ => high = middle,
        }
    }
    let slope: Vec<Integer> = (1u64..)
        .zip(&p[1..])
        .map(|(i, c)| c * Integer::from(i))
        .collect();
    for bits in 0..ISOLATION_LIMIT {
        let candidate = Dyadic {
            low: low.clone(),
            high: &low + Integer::ONE,
            bits,
        };
        if !Interval::from(candidate.ends())
            .horner(&slope)
            .contains_zero()
        {
            return Some(Isolated::Irrational(candidate));
        }
        low <<= 1u64;
        let middle = &low + Integer::ONE;
        if sign(&(Rational::from(&middle) >> (bits + 1))) == at_lo {
            low = middle;
        }
    }
    None
}
