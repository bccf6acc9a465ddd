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

use super::{Limits, Refusal};
use num_bigint::{BigInt, Sign};
use num_traits::{One, Zero};
use std::cell::Cell;
use std::cmp::Ordering;

use super::number::Rational;

/// Coefficients of 1, a, a², …, at most n, the last one not zero; zero is empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Element(pub(super) Vec<BigInt>);

pub(super) struct Ring {
    /// p from the constant term up, with its leading 1; empty over Q.
    modulus: Vec<BigInt>,
    /// Shrinking enclosures of the root; empty over Q.
    enclosures: Vec<Enclosure>,
    budget: Budget,
}

impl Ring {
    /// Q, seen from its integers.
    pub(super) fn integers() -> Ring {
        Ring {
            modulus: Vec::new(),
            enclosures: Vec::new(),
            budget: Budget::default(),
        }
    }

    /// `Z[a]`, for a monic `modulus` of degree at least two.
    pub(super) fn extension(
        modulus: Vec<BigInt>,
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
        self.modulus.len().saturating_sub(1).max(1)
    }

    /// The bits of the largest coefficient of p.
    pub(super) fn bits(&self) -> u64 {
        self.modulus.iter().map(BigInt::bits).max().unwrap_or(0)
    }

    /// The sum of ± x y over the terms (is it minus?, x, y). Everything that is
    /// multiplied is multiplied here, with one reduction for each sum.
    pub(super) fn sum<'e>(
        &self,
        terms: impl IntoIterator<Item = (bool, &'e Element, &'e Element)>,
    ) -> Element {
        let mut sum: Vec<BigInt> = Vec::new();
        for (minus, Element(x), Element(y)) in terms {
            if x.is_empty() || y.is_empty() {
                continue;
            }
            sum.resize(sum.len().max(x.len() + y.len() - 1), BigInt::zero());
            for (i, x) in x.iter().enumerate() {
                for (j, y) in y.iter().enumerate() {
                    if minus {
                        sum[i + j] -= x * y
                    } else {
                        sum[i + j] += x * y
                    }
                }
            }
        }
        self.reduced(sum)
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
    fn reduced(&self, mut x: Vec<BigInt>) -> Element {
        let degree = self.degree();
        while x.len() > degree {
            let base = x.len() - 1 - degree;
            let Some(top) = x.pop() else { break };
            for (k, c) in self.modulus[..degree].iter().enumerate() {
                x[base + k] -= c * &top;
            }
        }
        Element::new(x)
    }

    /// The strict sign where an enclosure proves it, `Equal` where the vector is
    /// zero, `None` where neither rule applies.
    pub(super) fn sign(&self, x: &Element) -> Result<Option<Ordering>, Refusal> {
        match x.0.as_slice() {
            [] => return Ok(Some(Ordering::Equal)),
            [integer] => return Ok(Some(sign_of(integer))),
            _ => {}
        }
        for root in &self.enclosures {
            let sign = root.sign(&x.0, &self.budget)?;
            if sign.is_some() {
                return Ok(sign);
            }
        }
        Ok(None)
    }
}

impl Element {
    pub(super) fn new(mut coefficients: Vec<BigInt>) -> Element {
        while coefficients.last().is_some_and(BigInt::is_zero) {
            coefficients.pop();
        }
        Element(coefficients)
    }

    pub(super) fn integer(value: BigInt) -> Element {
        Element::new(vec![value])
    }

    /// self + other
    pub(super) fn plus(mut self, other: &Element) -> Element {
        self.0
            .resize(self.0.len().max(other.0.len()), BigInt::zero());
        for (x, y) in self.0.iter_mut().zip(&other.0) {
            *x += y;
        }
        Element::new(self.0)
    }

    /// self - other
    pub(super) fn minus(mut self, other: &Element) -> Element {
        self.0
            .resize(self.0.len().max(other.0.len()), BigInt::zero());
        for (x, y) in self.0.iter_mut().zip(&other.0) {
            *x -= y;
        }
        Element::new(self.0)
    }

    /// The bits of the largest coefficient.
    pub(super) fn bits(&self) -> u64 {
        self.0.iter().map(BigInt::bits).max().unwrap_or(0)
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
    low: BigInt,
    high: BigInt,
    denominator: BigInt,
}

/// p(low) and p(high) have opposite strict signs: there is a root between.
fn check_root_signs(modulus: &[BigInt], given: &Enclosure, budget: &Budget) -> Result<(), Refusal> {
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
    modulus: &[BigInt],
    given: &Enclosure,
    budget: &Budget,
) -> Result<(), Refusal> {
    let derivative: Vec<BigInt> = modulus
        .iter()
        .enumerate()
        .skip(1)
        .map(|(k, c)| c * BigInt::from(k))
        .collect();
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
            low: low.numer() * high.denom(),
            high: high.numer() * low.denom(),
            denominator: low.denom() * high.denom(),
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

    /// The sign of f on the whole interval, if the interval Horner scheme shows
    /// that it is strict and constant. With root = [l, h]/d and f of degree m,
    /// d^m f is enclosed by F_m = [c_m, c_m], F_k = F_(k+1) [l, h] + c_k d^(m-k).
    fn sign(&self, f: &[BigInt], budget: &Budget) -> Result<Option<Ordering>, Refusal> {
        budget.spend(self.cost(f))?;
        let Some((top, rest)) = f.split_last() else {
            return Ok(None);
        };
        let (mut least, mut most) = (top.clone(), top.clone());
        let mut power = BigInt::one();
        for c in rest.iter().rev() {
            power *= &self.denominator;
            (least, most) = self.times(&least, &most);
            let c = c * &power;
            least += &c;
            most += &c;
        }
        Ok(match (sign_of(&least), sign_of(&most)) {
            (Ordering::Greater, _) => Some(Ordering::Greater),
            (_, Ordering::Less) => Some(Ordering::Less),
            _ => None,
        })
    }

    /// Word products of the Horner scheme, up to a factor of five: with m
    /// coefficients of v words, and d words for l, h and d, the k-th step multiplies
    /// v + k d words by d words four times, k d by d words, and v by k d words.
    fn cost(&self, f: &[BigInt]) -> u64 {
        let m = f.len() as u64;
        let v = words(f.iter());
        let d = words([&self.low, &self.high, &self.denominator]);
        [m, m, d, v + d].into_iter().fold(1, u64::saturating_mul)
    }

    /// The hull of [least, most] [low, high]: extremes are taken at ends.
    fn times(&self, least: &BigInt, most: &BigInt) -> (BigInt, BigInt) {
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

    /// Enclosures after 64, 128, 256, … and `bisections` halvings.
    fn ladder(
        mut self,
        modulus: &[BigInt],
        bisections: usize,
        budget: &Budget,
    ) -> Result<Vec<Enclosure>, Refusal> {
        const FIRST: usize = 64;
        let rising = self.at_high().sign(modulus, budget)?;
        let mut enclosures = vec![];
        for step in 1..=bisections {
            self = self.halved(modulus, rising, budget)?;
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
        modulus: &[BigInt],
        rising: Option<Ordering>,
        budget: &Budget,
    ) -> Result<Enclosure, Refusal> {
        let middle = &self.low + &self.high;
        let half = Enclosure {
            low: middle.clone(),
            high: middle,
            denominator: self.denominator * 2,
        };
        Ok(match half.sign(modulus, budget)? {
            None => half,
            right if right == rising => Enclosure {
                low: self.low * 2,
                ..half
            },
            _ => Enclosure {
                high: self.high * 2,
                ..half
            },
        })
    }
}

/// The words of the largest.
fn words<'b>(integers: impl IntoIterator<Item = &'b BigInt>) -> u64 {
    integers.into_iter().map(BigInt::bits).max().unwrap_or(0) / 64 + 1
}

fn sign_of(integer: &BigInt) -> Ordering {
    match integer.sign() {
        Sign::Minus => Ordering::Less,
        Sign::NoSign => Ordering::Equal,
        Sign::Plus => Ordering::Greater,
    }
}
