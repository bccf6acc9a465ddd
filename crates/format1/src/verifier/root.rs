//! The root a of the field's polynomial: that there is one, and the signs that enclosures of
//! it show.
//!
//! Called by [`super::ring`]. Over which interval a polynomial keeps its sign is found by
//! interval arithmetic with integers; nothing here is a guess.

use super::integer::Integer;
use super::number::Rational;
use super::ring::Element;
use super::{Limits, Refusal};
use std::cell::Cell;
use std::cmp::Ordering;

pub(super) struct Root {
    /// It contains all others.
    rough: Enclosure,
    /// After 64, 128, 256, … halvings and after all.
    enclosures: Vec<Enclosure>,
    budget: Budget,
}

impl Root {
    /// The root of p in the given interval; p is monic.
    ///
    /// # Errors
    /// The interval is empty, or p is not seen to have exactly one root in it.
    pub(super) fn new(
        p: &Element,
        interval: (Rational, Rational),
        limits: &Limits,
    ) -> Result<Root, Refusal> {
        let budget = Budget::new(limits);
        let given = Enclosure::new(interval)?;
        check_root_signs(p, &given, &budget)?;
        check_root_derivative(p, &given, &budget)?;
        given.root(p, limits.bisections, budget)
    }

    /// The strict sign of x if an enclosure shows it. What the rough one shows, of the first 64 bits, each of the
    /// others shows too, for they lie in it. So it is looked at first; what is counted is the finer one.
    pub(super) fn sign(&self, x: &Element) -> Result<Option<Ordering>, Refusal> {
        let dropped = x.bits().saturating_sub(64);
        for root in &self.enclosures {
            self.budget.spend(root.cost(x))?;
            let sign = self.rough.shown(x, dropped).or_else(|| root.shown(x, 0));
            if sign.is_some() {
                return Ok(sign);
            }
        }
        Ok(None)
    }
}

/// What all evaluations at enclosures together may cost. How fine an enclosure
/// a sign needs is not known beforehand, so each is counted just before it is made.
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
        Ok(self.shown(f, 0))
    }

    /// The sign of f on the whole interval, if the interval Horner scheme shows that it is
    /// strict and constant. With root = [l, h]/d and f of degree m, d^m f is enclosed by
    /// F_m = c_m, F_k = F_(k+1) [l, h] + c_k d^(m-k). Here c_k is the coefficient; or where bits
    /// are dropped the interval from floor(c_k / 2^dropped) to that plus one, and f is divided by 2^dropped.
    fn shown(&self, f: &Element, dropped: u64) -> Option<Ordering> {
        let mut falling = f.coefficients().rev().map(|c| c.shifted_down(dropped));
        let width = Integer::from(i64::from(dropped > 0));
        let mut least = falling.next()?;
        let mut most = least.clone();
        most.add(false, &width);
        let mut power = Integer::ONE;
        for c in falling {
            power = &power * &self.denominator;
            (least, most) = self.times(&least, &most);
            least.add_product(false, &c, &power);
            most.add_product(false, &c, &power);
            most.add_product(false, &width, &power);
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
        let m = f.coefficients().count() as u64;
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

    /// The root in this interval, its enclosures found by halving. The rough one is that
    /// after 16 halvings.
    fn root(mut self, p: &Element, bisections: usize, budget: Budget) -> Result<Root, Refusal> {
        const ROUGH: usize = 16;
        const FIRST: usize = 64;
        let rising = self.at_high().sign(p, &budget)?;
        let (mut rough, mut enclosures) = (self.clone(), Vec::new());
        for step in 1..=bisections {
            self = self.halved(p, rising, &budget)?;
            if step <= ROUGH {
                rough = self.clone();
            }
            if step == bisections || (step >= FIRST && step.is_power_of_two()) {
                enclosures.push(self.clone());
            }
        }
        Ok(Root {
            rough,
            enclosures,
            budget,
        })
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
        middle.add(false, &self.high);
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

#[cfg(test)]
mod tests;
