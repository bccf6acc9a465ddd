//! The ring `Z[a]` in which every predicate is evaluated, and signs in it.
//!
//! Let p be the monic integer polynomial of the field, n its degree and a its
//! root in the given interval. Evaluation at a is a ring homomorphism
//! ev: `Z[x]/(p)` -> R, whether or not p is irreducible. An [`Element`] is the
//! reduced coefficient vector of a class in `Z[x]/(p)`. Hence two one-sided rules:
//!
//! - u = v as vectors implies ev(u) = ev(v);
//! - an enclosure of ev(u) that excludes zero proves the sign of ev(u).
//!
//! Where p is reducible a vector that is not zero can have the value zero: then
//! neither rule applies and [`Ring::sign`] answers `None`, never a guess.
//! Over Q, n = 1, there is no p, and an element is an integer.

use super::integer::Integer;
use super::number::Rational;
use super::root::Root;
use super::{Limits, Refusal};
use std::cmp::Ordering;
use std::iter;

/// Coefficients of 1, a, a², …, at most n: the first, and the others up to the last one
/// that is not zero. So an integer takes no memory but its own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Element {
    constant: Integer,
    rest: Vec<Integer>,
}

pub(super) struct Ring {
    /// p, with its leading 1; zero over Q.
    modulus: Element,
    /// a; none over Q.
    root: Option<Root>,
}

impl Ring {
    /// Q, seen from its integers.
    pub(super) fn integers() -> Ring {
        Ring {
            modulus: Element::default(),
            root: None,
        }
    }

    /// `Z[a]`, for a monic `modulus` of degree at least two.
    pub(super) fn extension(
        modulus: Element,
        root: (Rational, Rational),
        limits: &Limits,
    ) -> Result<Ring, Refusal> {
        let root = Some(Root::new(&modulus, root, limits)?);
        Ok(Ring { modulus, root })
    }

    /// n.
    pub(super) fn degree(&self) -> usize {
        self.modulus.rest.len().max(1)
    }

    /// The bits of the largest coefficient of p.
    pub(super) fn bits(&self) -> u64 {
        self.modulus.bits()
    }

    /// The sum of ± x y over the terms (is it minus?, x, y). Everything that is
    /// multiplied is multiplied here, with one reduction for each sum.
    pub(super) fn sum<'e>(
        &self,
        terms: impl IntoIterator<Item = (bool, &'e Element, &'e Element)>,
    ) -> Element {
        let mut sum = Element {
            constant: Integer::ZERO,
            rest: Vec::with_capacity(2 * self.degree() - 2),
        };
        for (minus, x, y) in terms {
            if x.is_zero() || y.is_zero() {
                continue;
            }
            sum.constant.add_product(minus, &x.constant, &y.constant);
            for (j, y) in y.rest.iter().enumerate() {
                sum.at(j + 1).add_product(minus, &x.constant, y);
            }
            for (i, x) in x.rest.iter().enumerate() {
                sum.at(i + 1).add_product(minus, x, &y.constant);
                for (j, y) in y.rest.iter().enumerate() {
                    sum.at(i + j + 2).add_product(minus, x, y);
                }
            }
        }
        match sum.rest.is_empty() {
            true => sum,
            false => self.reduced(sum),
        }
    }

    /// x y
    pub(super) fn times(&self, x: &Element, y: &Element) -> Element {
        self.sum([(false, x, y)])
    }

    /// x_1 y_1 + x_2 y_2 + …
    pub(super) fn dot(&self, x: &[Element], y: &[Element]) -> Element {
        self.sum(x.iter().zip(y).map(|(x, y)| (false, x, y)))
    }

    /// c x^m = -(c_0 x^(m-n) + … + c_(n-1) x^(m-1)) c modulo p, from the top.
    fn reduced(&self, mut x: Element) -> Element {
        let degree = self.degree();
        while x.rest.len() >= degree {
            let base = x.rest.len() - degree;
            let Some(top) = x.rest.pop() else { break };
            for (k, c) in self.modulus.coefficients().take(degree).enumerate() {
                if !c.is_zero() {
                    x.at(base + k).add_product(true, c, &top);
                }
            }
        }
        x.trimmed()
    }

    /// The strict sign where an enclosure proves it, `Equal` where the vector is
    /// zero, `None` where neither rule applies.
    pub(super) fn sign(&self, x: &Element) -> Result<Option<Ordering>, Refusal> {
        match &self.root {
            _ if x.rest.is_empty() => Ok(Some(x.constant.sign())),
            Some(root) => root.sign(x),
            None => Ok(None),
        }
    }
}

impl Element {
    /// The element with these coefficients.
    pub(super) fn new(coefficients: impl IntoIterator<Item = Integer>) -> Element {
        let mut coefficients = coefficients.into_iter();
        let constant = coefficients.next().unwrap_or_default();
        let rest = coefficients.collect();
        Element { constant, rest }.trimmed()
    }

    pub(super) fn integer(value: Integer) -> Element {
        Element {
            constant: value,
            rest: Vec::new(),
        }
    }

    /// Those of 1, a, …, the last one not zero unless it is alone.
    pub(super) fn coefficients(&self) -> impl DoubleEndedIterator<Item = &Integer> {
        iter::once(&self.constant).chain(&self.rest)
    }

    fn is_zero(&self) -> bool {
        self.rest.is_empty() && self.constant.is_zero()
    }

    /// The coefficient of the k-th power.
    fn at(&mut self, k: usize) -> &mut Integer {
        if k == 0 {
            return &mut self.constant;
        }
        while self.rest.len() < k {
            self.rest.push(Integer::ZERO);
        }
        &mut self.rest[k - 1]
    }

    #[inline]
    fn trimmed(mut self) -> Element {
        while self.rest.last().is_some_and(Integer::is_zero) {
            self.rest.pop();
        }
        self
    }

    /// self + other
    #[inline]
    pub(super) fn plus(self, other: &Element) -> Element {
        self.combined(false, other)
    }

    /// self - other
    #[inline]
    pub(super) fn minus(self, other: &Element) -> Element {
        self.combined(true, other)
    }

    #[inline]
    fn combined(mut self, minus: bool, other: &Element) -> Element {
        self.constant.add(minus, &other.constant);
        for (k, c) in other.rest.iter().enumerate() {
            self.at(k + 1).add(minus, c);
        }
        self.trimmed()
    }

    /// The bits of the largest coefficient.
    pub(super) fn bits(&self) -> u64 {
        self.coefficients().map(Integer::bits).max().unwrap_or(0)
    }
}
