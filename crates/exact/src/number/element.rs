//! Elements of a field: arithmetic, comparison and text.
//!
//! An element is a rational number, which belongs to every field, or a combination of the powers of a
//! generator. In a combination some coefficient after the first is not zero. Signs and enclosures are in
//! [`super::sign`].

use super::field::{Field, SYMBOL};
use super::polynomial as poly;
use crate::geometry::{RingElement, Scalar, Sign};
use malachite::base::num::arithmetic::traits::Reciprocal;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Rational};
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// A real number in a [`Field`].
///
/// Equality and order are those of the real numbers. Operations on two irrational numbers of different
/// fields panic. The elements of one computation belong to one field, so mixing fields is an error of the
/// program.
#[derive(Clone)]
pub struct Number(pub(super) Value);

#[derive(Clone)]
pub(super) enum Value {
    Rational(Rational),
    /// At least two coefficients, the last not zero, at most the degree.
    Algebraic(Field, Vec<Rational>),
}

use Value::{Algebraic, Rational as Simple};

impl From<Rational> for Number {
    fn from(value: Rational) -> Number {
        Number(Simple(value))
    }
}

impl Number {
    /// The number 0.
    pub fn zero() -> Number {
        Number(Simple(Rational::ZERO))
    }

    /// Σ c_i a^i for coefficients fewer than the degree.
    fn from_coefficients(field: &Field, mut coefficients: Vec<Rational>) -> Number {
        poly::trim(&mut coefficients);
        if coefficients.len() > 1 {
            return Number(Algebraic(field.clone(), coefficients));
        }
        Number(Simple(coefficients.pop().unwrap_or(Rational::ZERO)))
    }

    /// Σ c_i a^i, any number of coefficients: a^n is replaced by its value
    /// from the highest power down.
    pub(super) fn reduced(field: &Field, mut coefficients: Vec<Rational>) -> Number {
        let n = field.degree();
        while coefficients.len() > n {
            let shift = coefficients.len() - 1 - n;
            let Some(top) = coefficients.pop().filter(|top| *top != 0) else {
                continue;
            };
            for (i, c) in field.reduction() {
                coefficients[shift + i] += &top * c;
            }
        }
        Number::from_coefficients(field, coefficients)
    }

    /// The coefficients c_i of Σ c_i a^i: at least one, and the last is not
    /// zero unless it is the only one.
    pub fn coefficients(&self) -> &[Rational] {
        match &self.0 {
            Simple(value) => std::slice::from_ref(value),
            Algebraic(_, coefficients) => coefficients,
        }
    }

    /// The field of a number that is not written as a rational.
    pub fn field(&self) -> Option<&Field> {
        match &self.0 {
            Simple(_) => None,
            Algebraic(field, _) => Some(field),
        }
    }

    /// Whether only the constant coefficient is not zero. With a reducible
    /// polynomial a rational number may also have other coefficients.
    pub fn is_rational(&self) -> bool {
        matches!(self.0, Simple(_))
    }

    /// The value of a number for which [`Number::is_rational`].
    pub fn to_rational(&self) -> Option<&Rational> {
        match &self.0 {
            Simple(value) => Some(value),
            Algebraic(..) => None,
        }
    }

    /// 1/x, or `None` for 0.
    ///
    /// Let p be the polynomial of the field, f that of x, and g = gcd(f, p). If g vanishes at the root, x
    /// is 0. Else p/g does; it has no common factor with f, because p is squarefree. So f is inverted
    /// modulo p/g.
    pub fn inverse(&self) -> Option<Number> {
        match &self.0 {
            Simple(value) => (*value != 0).then(|| Number(Simple(value.reciprocal()))),
            Algebraic(field, f) => {
                let p = poly::from_integers(field.polynomial());
                let g = poly::gcd(f, &p);
                if g.len() > 1 && field.root_of(&g) {
                    return None;
                }
                let modulus = if g.len() > 1 {
                    poly::divide(&p, &g).0
                } else {
                    p
                };
                let inverse = poly::inverse_modulo(f, &modulus)?;
                Some(Number::from_coefficients(field, inverse))
            }
        }
    }

    /// `self / other`, or `None` if `other` is 0.
    pub fn divide(&self, other: &Number) -> Option<Number> {
        other.inverse().map(|inverse| self * &inverse)
    }
}

/// The one field of two irrational numbers.
fn common<'a>(x: &'a Field, y: &Field) -> &'a Field {
    assert!(
        x == y,
        "arithmetic with numbers of different fields: {x:?} and {y:?}"
    );
    x
}

fn add(x: &Number, y: &Number) -> Number {
    match (&x.0, &y.0) {
        (Simple(x), Simple(y)) => Number(Simple(x + y)),
        (Simple(r), Algebraic(field, c)) | (Algebraic(field, c), Simple(r)) => {
            let mut c = c.clone();
            c[0] += r;
            Number(Algebraic(field.clone(), c))
        }
        (Algebraic(k, x), Algebraic(l, y)) => {
            let (long, short) = if x.len() < y.len() { (y, x) } else { (x, y) };
            let mut sum = long.clone();
            sum.iter_mut().zip(short).for_each(|(s, c)| *s += c);
            Number::from_coefficients(common(k, l), sum)
        }
    }
}

fn subtract(x: &Number, y: &Number) -> Number {
    match (&x.0, &y.0) {
        (Simple(x), Simple(y)) => Number(Simple(x - y)),
        (Algebraic(field, c), Simple(r)) => {
            let mut c = c.clone();
            c[0] -= r;
            Number(Algebraic(field.clone(), c))
        }
        (Simple(_), Algebraic(..)) => add(&negate(y), x),
        (Algebraic(k, x), Algebraic(l, y)) => {
            Number::from_coefficients(common(k, l), poly::subtract(x, y))
        }
    }
}

fn multiply(x: &Number, y: &Number) -> Number {
    match (&x.0, &y.0) {
        (Simple(x), Simple(y)) => Number(Simple(x * y)),
        (Simple(r), Algebraic(field, c)) | (Algebraic(field, c), Simple(r)) => {
            let product = c.iter().map(|c| c * r).collect();
            Number::from_coefficients(field, product)
        }
        (Algebraic(k, x), Algebraic(l, y)) => {
            let field = common(k, l);
            match field.small().and_then(|small| small.product(x, y)) {
                Some(product) => Number::from_coefficients(field, product),
                None => Number::reduced(field, poly::multiply(x, y)),
            }
        }
    }
}

fn negate(x: &Number) -> Number {
    match &x.0 {
        Simple(x) => Number(Simple(-x)),
        Algebraic(field, c) => Number(Algebraic(field.clone(), c.iter().map(|c| -c).collect())),
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $function:ident) => {
        impl $trait<&Number> for &Number {
            type Output = Number;
            fn $method(self, other: &Number) -> Number {
                $function(self, other)
            }
        }
        impl $trait<Number> for &Number {
            type Output = Number;
            fn $method(self, other: Number) -> Number {
                $function(self, &other)
            }
        }
        impl $trait<&Number> for Number {
            type Output = Number;
            fn $method(self, other: &Number) -> Number {
                $function(&self, other)
            }
        }
        impl $trait<Number> for Number {
            type Output = Number;
            fn $method(self, other: Number) -> Number {
                $function(&self, &other)
            }
        }
    };
}

operator!(Add, add, add);
operator!(Sub, sub, subtract);
operator!(Mul, mul, multiply);

impl Neg for &Number {
    type Output = Number;
    fn neg(self) -> Number {
        negate(self)
    }
}

impl Neg for Number {
    type Output = Number;
    fn neg(self) -> Number {
        negate(&self)
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Number) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Number {}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Number) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Number) -> Ordering {
        match (&self.0, &other.0) {
            (Simple(x), Simple(y)) => x.cmp(y),
            (Algebraic(k, x), Algebraic(l, y)) if x == y && k == l => Ordering::Equal,
            _ => (self - other).sign(),
        }
    }
}

impl RingElement for Number {
    fn integer(&self, value: i64) -> Number {
        Number(Simple(Rational::from(value)))
    }
    fn plus(&self, other: &Number) -> Number {
        add(self, other)
    }
    fn minus(&self, other: &Number) -> Number {
        subtract(self, other)
    }
    fn times(&self, other: &Number) -> Number {
        multiply(self, other)
    }
}

impl Scalar for Number {
    fn sign(&self) -> Sign {
        Number::sign(self)
    }
    fn approximate(&self) -> f64 {
        Number::approximate(self)
    }
}

impl RingElement for Rational {
    fn integer(&self, value: i64) -> Rational {
        Rational::from(value)
    }
    fn plus(&self, other: &Rational) -> Rational {
        self + other
    }
    fn minus(&self, other: &Rational) -> Rational {
        self - other
    }
    fn times(&self, other: &Rational) -> Rational {
        self * other
    }
}

impl Scalar for Rational {
    fn sign(&self) -> Sign {
        malachite::base::num::arithmetic::traits::Sign::sign(self)
    }
    fn approximate(&self) -> f64 {
        f64::rounding_from(self, RoundingMode::Nearest).0
    }
}

impl RingElement for Integer {
    fn integer(&self, value: i64) -> Integer {
        Integer::from(value)
    }
    fn plus(&self, other: &Integer) -> Integer {
        self + other
    }
    fn minus(&self, other: &Integer) -> Integer {
        self - other
    }
    fn times(&self, other: &Integer) -> Integer {
        self * other
    }
}

impl Scalar for Integer {
    fn sign(&self) -> Sign {
        malachite::base::num::arithmetic::traits::Sign::sign(self)
    }
    fn approximate(&self) -> f64 {
        // As a rational, because that conversion is infinite beyond the range.
        f64::rounding_from(&Rational::from(self), RoundingMode::Nearest).0
    }
}

/// `1/2 + 3/2 a - a^2`, with the symbol of the field's generator.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let terms = self.coefficients().iter().enumerate();
        let symbol = self.field().map_or(SYMBOL, Field::symbol);
        let mut first = true;
        for (i, c) in terms.filter(|(i, c)| **c != 0 || *i == 0 && self.is_rational()) {
            let size = if *c < 0 { -c } else { c.clone() };
            match (first, *c < 0) {
                (true, true) => write!(f, "-")?,
                (true, false) => {}
                (false, true) => write!(f, " - ")?,
                (false, false) => write!(f, " + ")?,
            }
            first = false;
            match i {
                0 => write!(f, "{size}")?,
                _ if size == Rational::ONE => write_power(f, symbol, i)?,
                _ => {
                    write!(f, "{size} ")?;
                    write_power(f, symbol, i)?;
                }
            }
        }
        Ok(())
    }
}

fn write_power(f: &mut fmt::Formatter, symbol: &str, i: usize) -> fmt::Result {
    if i == 1 {
        write!(f, "{symbol}")
    } else {
        write!(f, "{symbol}^{i}")
    }
}

impl fmt::Debug for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
