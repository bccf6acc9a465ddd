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
use super::{Limits, Refusal};
use std::cell::Cell;
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
    /// Shrinking enclosures of the root, the first one rough; empty over Q.
    enclosures: Vec<Enclosure>,
    budget: Budget,
}

impl Ring {
    /// Q, seen from its integers.
    pub(super) fn integers() -> Ring {
        Ring {
            modulus: Element::default(),
            enclosures: Vec::new(),
            budget: Budget::default(),
        }
    }

    /// `Z[a]`, for a monic `modulus` of degree at least two.
    pub(super) fn extension(
        modulus: Element,
        root: (Rational, Rational),
        limits: &Limits,
    ) -> Result<Ring, Refusal> {
        let budget = Budget::new(limits);
        let given = Enclosure::new(root)?;
        check_root_signs(&modulus, &given, &budget)?;
        check_root_derivative(&modulus, &given, &budget)?;
        let enclosures = given.ladder(&modulus, limits.bisections, &budget)?;
        Ok(Ring {
            modulus,
            enclosures,
            budget,
        })
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
    /// zero, `None` where neither rule applies. All enclosures lie in the rough one, and so do
    /// the values on them: a sign that it shows is shown by each. It is looked at first, for
    /// it has few bits; what is counted is the finer one.
    pub(super) fn sign(&self, x: &Element) -> Result<Option<Ordering>, Refusal> {
        if x.rest.is_empty() {
            return Ok(Some(x.constant.sign()));
        }
        let Some((rough, finer)) = self.enclosures.split_first() else {
            return Ok(None);
        };
        for root in finer {
            self.budget.spend(root.cost(x))?;
            let sign = rough.roughly_shown(x).or_else(|| root.shown(x));
            if sign.is_some() {
                return Ok(sign);
            }
        }
        Ok(None)
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

    /// That of the k-th power.
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
    pub(super) fn plus(mut self, other: &Element) -> Element {
        self.constant += &other.constant;
        for (k, c) in other.rest.iter().enumerate() {
            *self.at(k + 1) += c;
        }
        self.trimmed()
    }

    /// self - other
    #[inline]
    pub(super) fn minus(mut self, other: &Element) -> Element {
        self.constant -= &other.constant;
        for (k, c) in other.rest.iter().enumerate() {
            *self.at(k + 1) -= c;
        }
        self.trimmed()
    }

    /// The bits of the largest coefficient.
    pub(super) fn bits(&self) -> u64 {
        self.coefficients().map(Integer::bits).max().unwrap_or(0)
    }
}

/// What all evaluations at enclosures together may cost. How fine an enclosure
/// a sign needs is not known beforehand, so each is counted just before it is made.
#[derive(Default)]
struct Budget {
    spent: Cell<u64>,
    limit: u64,
}

impl Budget {
    fn new(limits: &Limits) -> Budget {
        Budget {
            spent: Cell::new(0),
            limit: limits.work.saturating_mul(Limits::SIGNS),
        }
    }

    fn spend(&self, cost: u64) -> Result<(), Refusal> {
        let (found, limit) = (self.spent.get().saturating_add(cost), self.limit);
        self.spent.set(found);
        match found <= limit {
            true => Ok(()),
            false => Err(Refusal::Work {
                of: "for the signs",
                found,
                limit,
            }),
        }
    }
}

/// The root lies in [low, high] / denominator; the denominator is positive.
#[derive(Clone)]
struct Enclosure {
    low: Integer,
    high: Integer,
    denominator: Integer,
}

/// p(low) and p(high) have opposite strict signs: there is a root between.
fn check_root_signs(modulus: &Element, given: &Enclosure, budget: &Budget) -> Result<(), Refusal> {
    let at_low = given.at_low().sign(modulus, budget)?;
    let at_high = given.at_high().sign(modulus, budget)?;
    match (at_low, at_high) {
        (Some(Ordering::Less), Some(Ordering::Greater)) => Ok(()),
        (Some(Ordering::Greater), Some(Ordering::Less)) => Ok(()),
        _ => Err(Refusal::RootSigns {}),
    }
}

/// 0 is not in p'([low, high]), by an enclosure: p is strictly monotone there,
/// so the root is the only one.
fn check_root_derivative(
    modulus: &Element,
    given: &Enclosure,
    budget: &Budget,
) -> Result<(), Refusal> {
    let powers = modulus.coefficients().zip(0..).skip(1);
    let derivative = Element::new(powers.map(|(c, k)| c * &Integer::from(k)));
    match given.sign(&derivative, budget)? {
        Some(_) => Ok(()),
        None => Err(Refusal::RootDerivative {}),
    }
}

impl Enclosure {
    fn new((low, high): (Rational, Rational)) -> Result<Enclosure, Refusal> {
        if low >= high {
            return Err(Refusal::RootOrder {});
        }
        Ok(Enclosure {
            low: Integer::from(low.numer() * high.denom()),
            high: Integer::from(high.numer() * low.denom()),
            denominator: Integer::from(low.denom() * high.denom()),
        })
    }

    fn at_low(&self) -> Enclosure {
        Enclosure {
            high: self.low.clone(),
            ..self.clone()
        }
    }

    fn at_high(&self) -> Enclosure {
        Enclosure {
            low: self.high.clone(),
            ..self.clone()
        }
    }

    /// The sign that is [`shown`](Self::shown), counted.
    fn sign(&self, f: &Element, budget: &Budget) -> Result<Option<Ordering>, Refusal> {
        budget.spend(self.cost(f))?;
        Ok(self.shown(f))
    }

    /// The sign of f on the whole interval, if the interval Horner scheme shows
    /// that it is strict and constant.
    fn shown(&self, f: &Element) -> Option<Ordering> {
        self.horner(f.coefficients().rev().map(|c| (c.clone(), c.clone())))
    }

    /// The same from the first 64 bits of the coefficients: for c the interval from
    /// floor(c / 2^k) to that plus one, so that all are divided by 2^k.
    fn roughly_shown(&self, f: &Element) -> Option<Ordering> {
        let dropped = f.bits().saturating_sub(64);
        if dropped == 0 {
            return self.shown(f);
        }
        self.horner(f.coefficients().rev().map(|c| {
            let low = c.shifted_down(dropped);
            let mut high = low.clone();
            high += &Integer::ONE;
            (low, high)
        }))
    }

    /// With root = [l, h]/d and f of degree m with coefficients in the intervals c_k,
    /// from the top, d^m f is enclosed by F_m = c_m, F_k = F_(k+1) [l, h] + c_k d^(m-k).
    fn horner(&self, mut falling: impl Iterator<Item = (Integer, Integer)>) -> Option<Ordering> {
        let (mut least, mut most) = falling.next()?;
        let mut power = Integer::ONE;
        for (low, high) in falling {
            power = &power * &self.denominator;
            (least, most) = self.times(&least, &most);
            least.add_product(false, &low, &power);
            most.add_product(false, &high, &power);
        }
        match (least.sign(), most.sign()) {
            (Ordering::Greater, _) => Some(Ordering::Greater),
            (_, Ordering::Less) => Some(Ordering::Less),
            _ => None,
        }
    }

    /// Word products of the Horner scheme, up to a factor of five: with m
    /// coefficients of v words, and d words for l, h and d, the k-th step multiplies
    /// v + k d words by d words four times, k d by d words, and v by k d words.
    fn cost(&self, f: &Element) -> u64 {
        let m = f.rest.len() as u64 + 1;
        let v = words(f.coefficients());
        let d = words([&self.low, &self.high, &self.denominator]);
        [m, m, d, v + d].into_iter().fold(1, u64::saturating_mul)
    }

    /// The hull of [least, most] [low, high]: extremes are taken at ends.
    fn times(&self, least: &Integer, most: &Integer) -> (Integer, Integer) {
        let products = [
            least * &self.low,
            least * &self.high,
            most * &self.low,
            most * &self.high,
        ];
        let [first, rest @ ..] = products;
        rest.into_iter()
            .fold((first.clone(), first), |(low, high), product| {
                (low.min(product.clone()), high.max(product))
            })
    }

    /// Enclosures after 16, or all, and after 64, 128, 256, … and `bisections` halvings.
    fn ladder(
        mut self,
        modulus: &Element,
        bisections: usize,
        budget: &Budget,
    ) -> Result<Vec<Enclosure>, Refusal> {
        const ROUGH: usize = 16;
        const FIRST: usize = 64;
        let rising = self.at_high().sign(modulus, budget)?;
        let mut enclosures = vec![];
        for step in 1..=bisections {
            self = self.halved(modulus, rising, budget)?;
            if step == bisections.min(ROUGH) {
                enclosures.push(self.clone());
            }
            if step == bisections || (step >= FIRST && step.is_power_of_two()) {
                enclosures.push(self.clone());
            }
        }
        Ok(enclosures)
    }

    /// The half with the root, where p has the sign `rising` right of the root
    /// and the other one left of it. A root at the middle is the root.
    fn halved(
        self,
        modulus: &Element,
        rising: Option<Ordering>,
        budget: &Budget,
    ) -> Result<Enclosure, Refusal> {
        let twice = |x: &Integer| x * &Integer::from(2);
        let mut middle = self.low.clone();
        middle += &self.high;
        let half = Enclosure {
            low: middle.clone(),
            high: middle,
            denominator: twice(&self.denominator),
        };
        Ok(match half.sign(modulus, budget)? {
            None => half,
            right if right == rising => Enclosure {
                low: twice(&self.low),
                ..half
            },
            _ => Enclosure {
                high: twice(&self.high),
                ..half
            },
        })
    }
}

/// The words of the largest.
fn words<'b>(integers: impl IntoIterator<Item = &'b Integer>) -> u64 {
    let bits = integers.into_iter().map(Integer::bits);
    bits.max().unwrap_or(0) / 64 + 1
}
