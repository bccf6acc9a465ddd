//! Polynomials in one parameter: where their signs change, exactly.
//!
//! Squarefree factors without common roots are found by Euclid's algorithm, and their roots are
//! counted by Sturm's theorem. So a root is a root of one factor, and the sign of every polynomial
//! is known at each root and between neighbouring ones.

use super::dense::{self, Dense, Factor};
use super::{Polynomial, Side};
use crate::geometry::{RingElement, Sign};
use crate::number::Number;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::PowerOf2;
use malachite::rational::rational::arithmetic::traits::SimplestRationalInInterval;
use std::cmp::Ordering;

/// Polynomials in one parameter.
#[derive(Clone, Debug)]
pub struct Line {
    polynomials: Vec<Dense>,
    factors: Vec<Factor>,
    /// For each polynomial the factors that divide it.
    divisors: Vec<Vec<usize>>,
}

/// An end of a maximal interval.
#[derive(Clone, Debug)]
pub enum Extent {
    /// There is none.
    Unbounded,
    /// It is here, and may be left out.
    At {
        /// The number at the end.
        place: Place,
        /// Whether the interval leaves the end out.
        is_open: bool,
    },
}

/// A real number.
#[derive(Clone, Debug)]
pub enum Place {
    /// A number of the field.
    Number(Number),
    /// The only root of a squarefree polynomial, constant term first, between two numbers.
    Root {
        /// The coefficients, constant term first.
        polynomial: Vec<Number>,
        /// A number of the field below the root.
        low: Number,
        /// A number of the field above the root.
        high: Number,
    },
}

/// A root in an interval (low, high] that contains no other root of any factor.
struct Isolated {
    factor: usize,
    low: Number,
    high: Number,
}

impl Line {
    /// The first parameter is the only one that may occur.
    pub fn new<'p>(polynomials: impl IntoIterator<Item = &'p Polynomial<Number>>) -> Self {
        Line::of_dense(polynomials.into_iter().map(dense::of).collect())
    }

    fn of_dense(polynomials: Vec<Dense>) -> Self {
        let factors = dense::coprime(&polynomials);
        let divisors = polynomials.iter().map(|p| {
            let divides = |f: &usize| !p.is_empty() && dense::remainder(p, &factors[*f]).is_empty();
            (0..factors.len()).filter(divides).collect()
        });
        Line {
            divisors: divisors.collect(),
            factors: factors.iter().map(|f| Factor::new(f.clone())).collect(),
            polynomials,
        }
    }

    /// The largest interval around a point in which a condition on the signs of all polynomials holds.
    /// `None` if it does not hold at the point.
    pub fn maximal(
        &self,
        point: &Number,
        holds: impl Fn(&[Sign]) -> bool,
    ) -> Option<(Extent, Extent)> {
        let at_point: Vec<Sign> = self
            .polynomials
            .iter()
            .map(|p| dense::value(p, point).sign())
            .collect();
        if !holds(&at_point) {
            return None;
        }
        let mirrored = self.polynomials.iter().map(|p| dense::mirrored(p));
        let mirrored = Line::of_dense(mirrored.collect());
        let low = mirrored.upwards(&-point, &holds);
        Some((low.mirrored(), self.upwards(point, &holds)))
    }

    /// The roots of all factors in an interval, in order; at most this many.
    pub fn roots(&self, side: &Side, most: usize) -> Vec<Place> {
        let (low, high) = (&side.low.value, &side.high.value);
        let is_root = |x: &Number| self.factors.iter().any(|f| f.sign_at(x) == Ordering::Equal);
        let mut places = Vec::new();
        if !side.low.is_open && is_root(low) {
            places.push(Place::Number(low.clone()));
        }
        let mut from = low.clone();
        while places.len() < most
            && let Some(root) = self.next_root(&from)
        {
            let factor = &self.factors[root.factor];
            let is_end =
                factor.sign_at(high) == Ordering::Equal && factor.count(&root.low, high) == 1;
            if root.low >= *high
                || factor.count(&root.low, high) == 0
                || is_end && side.high.is_open
            {
                break;
            }
            places.push(self.place(&root));
            from = root.high;
        }
        places
    }

    /// From a point at which the condition holds to where it ends.
    fn upwards(&self, point: &Number, holds: &impl Fn(&[Sign]) -> bool) -> Extent {
        let after = self.free_end(point);
        if !holds(&self.signs(&after)) {
            return Extent::At {
                place: Place::Number(point.clone()),
                is_open: false,
            };
        }
        let mut from = point.clone();
        while let Some(root) = self.next_root(&from) {
            let end = |is_open| Extent::At {
                place: self.place(&root),
                is_open,
            };
            let is_at_end = self.factors[root.factor].sign_at(&root.high) == Ordering::Equal;
            let after = if is_at_end {
                self.free_end(&root.high)
            } else {
                root.high.clone()
            };
            let mut signs = self.signs(&after);
            let beyond = holds(&signs);
            // Only the polynomials with this factor vanish; the others keep their signs.
            for (sign, divisors) in signs.iter_mut().zip(&self.divisors) {
                if divisors.contains(&root.factor) {
                    *sign = Sign::Equal;
                }
            }
            if !holds(&signs) {
                return end(true);
            }
            if !beyond {
                return end(false);
            }
            from = root.high;
        }
        Extent::Unbounded
    }

    fn signs(&self, point: &Number) -> Vec<Sign> {
        self.polynomials
            .iter()
            .map(|p| dense::value(p, point).sign())
            .collect()
    }

    /// The number of roots of all factors in (low, high].
    fn count(&self, low: &Number, high: &Number) -> usize {
        self.factors.iter().map(|f| f.count(low, high)).sum()
    }

    /// A point above such that there is no root after `point` up to it.
    fn free_end(&self, point: &Number) -> Number {
        let mut step = Rational::from(1);
        loop {
            let end = point + Number::from(step.clone());
            if self.count(point, &end) == 0 {
                return end;
            }
            step >>= 1u32;
        }
    }

    /// The least root that is larger than a point.
    fn next_root(&self, point: &Number) -> Option<Isolated> {
        let bounds = self.factors.iter().map(Factor::bound);
        let mut high = bounds.max().filter(|bound| bound > point)?;
        let mut low = point.clone();
        if self.count(&low, &high) == 0 {
            return None;
        }
        while self.count(&low, &high) > 1 {
            let middle = middle(&low, &high);
            match self.count(&low, &middle) {
                0 => low = middle,
                _ => high = middle,
            }
        }
        let factor = self
            .factors
            .iter()
            .position(|f| f.count(&low, &high) == 1)?;
        Some(Isolated { factor, low, high })
    }

    fn place(&self, root: &Isolated) -> Place {
        let factor = &self.factors[root.factor];
        if let [c, b] = factor.polynomial() {
            let root = (-c).divide(b);
            return Place::Number(root.unwrap_or_else(Number::zero));
        }
        let (mut low, mut high) = (root.low.clone(), root.high.clone());
        let enough = Number::from(Rational::power_of_2(-PRECISION));
        while &high - &low > enough || factor.sign_at(&low) == Ordering::Equal {
            let middle = middle(&low, &high);
            match factor.count(&low, &middle) {
                0 => low = middle,
                _ => high = middle,
            }
        }
        if let Some(exact) = simplest(&low, &high).filter(|x| factor.sign_at(x).is_eq()) {
            return Place::Number(exact);
        }
        Place::Root {
            polynomial: factor.polynomial().to_vec(),
            low,
            high,
        }
    }
}

/// Bits of an enclosure of a root. A rational root whose denominator has half as many is found.
const PRECISION: i64 = 64;

fn middle(low: &Number, high: &Number) -> Number {
    (low + high) * Number::from(Rational::from_signeds(1, 2))
}

/// The rational number with the least denominator from `low` to `high`.
fn simplest(low: &Number, high: &Number) -> Option<Number> {
    let (low, high) = (low.to_rational()?, high.to_rational()?);
    Some(Number::from(
        Rational::simplest_rational_in_closed_interval(low, high),
    ))
}

impl Extent {
    /// The extent of the interval that is mirrored at 0.
    fn mirrored(self) -> Self {
        match self {
            Extent::Unbounded => Extent::Unbounded,
            Extent::At { place, is_open } => Extent::At {
                place: match place {
                    Place::Number(x) => Place::Number(-x),
                    Place::Root {
                        polynomial,
                        low,
                        high,
                    } => Place::Root {
                        polynomial: dense::mirrored(&polynomial),
                        low: -high,
                        high: -low,
                    },
                },
                is_open,
            },
        }
    }
}

impl Place {
    /// Numbers that enclose it; equal if it is a number of the field.
    pub fn enclosure(&self) -> (&Number, &Number) {
        match self {
            Place::Number(x) => (x, x),
            Place::Root { low, high, .. } => (low, high),
        }
    }

    /// The polynomial of a root in the first parameter, with a positive leading coefficient.
    pub fn polynomial(&self) -> Option<Polynomial<Number>> {
        let Place::Root { polynomial, .. } = self else {
            return None;
        };
        let x = Polynomial::parameter(0);
        let sum = polynomial.iter().rev().fold(Polynomial::zero(), |sum, c| {
            sum.times(&x).plus(&Polynomial::constant(c.clone()))
        });
        let is_negative = polynomial.last().is_some_and(|c| c.sign().is_lt());
        let sum = if is_negative { sum.negated() } else { sum };
        Some(sum.reduced())
    }
}
