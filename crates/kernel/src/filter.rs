//! Real intervals with integers of 30 bits, for coordinates of which exact products are long.
//!
//! An interval either shows a sign or leaves it undecided; then exact integers decide. So the
//! intervals save work and decide nothing that is not true.

use crate::int::Int;
use crate::refusal::Larger;
use crate::ring::Ring;
use crate::root::{BITS, Root, enclosure};
use num_bigint::BigInt;
use std::cmp::Ordering;
use std::rc::Rc;

/// The numbers between (middle - radius) 2^exponent and (middle + radius) 2^exponent.
/// |middle| + radius < 2^30 + 4, and radius >= 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct Interval {
    middle: i64,
    radius: i64,
    exponent: i64,
}

const SIZE: u32 = 30;

impl Interval {
    /// Shifted down to 30 bits. The middle is rounded down, by less than one unit; the radius too.
    #[inline(always)]
    fn rounded(middle: i64, radius: i64, exponent: i64) -> Interval {
        let size = middle.unsigned_abs() + radius.unsigned_abs();
        let shift = (u64::BITS - SIZE).saturating_sub(size.leading_zeros());
        if shift == 0 {
            return Interval {
                middle,
                radius,
                exponent,
            };
        }
        Interval {
            middle: middle >> shift,
            radius: (radius >> shift) + 2,
            exponent: exponent + i64::from(shift),
        }
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self.middle == 0 && self.radius == 0
    }

    /// |x y - m m'| <= |m| r' + |m'| r + r r'. The factors have less than 30.1 bits.
    #[inline(always)]
    fn product(self, other: Interval) -> Interval {
        Interval {
            middle: self.middle * other.middle,
            radius: self.middle.abs() * other.radius
                + self.radius * (other.middle.abs() + other.radius),
            exponent: self.exponent + other.exponent,
        }
    }

    /// The sum of at most three intervals of 61 bits.
    #[inline(always)]
    fn sum<const K: usize>(terms: [Interval; K]) -> Interval {
        let largest = terms.iter().filter(|term| !term.is_zero());
        let exponent = largest.map(|term| term.exponent).max().unwrap_or(0);
        let (mut middle, mut radius) = (0, 0);
        for term in terms.iter().filter(|term| !term.is_zero()) {
            let shift = (exponent - term.exponent).min(63);
            middle += term.middle >> shift;
            radius += (term.radius >> shift) + if shift > 0 { 2 } else { 0 };
        }
        Interval::rounded(middle, radius, exponent)
    }

    #[inline(always)]
    fn negated(self) -> Interval {
        Interval {
            middle: -self.middle,
            ..self
        }
    }
}

pub struct Intervals {
    pub(crate) root: Rc<Root>,
}

impl Intervals {
    pub(crate) fn new(root: &Rc<Root>) -> Intervals {
        Intervals { root: root.clone() }
    }

    /// An interval that contains the number with these coefficients.
    #[inline(always)]
    pub(crate) fn of<T: Int>(&self, coefficients: &[T]) -> Result<Interval, Larger> {
        let (low, high, dropped) = enclosure(coefficients, &self.root.rough)?;
        let size = low.unsigned_abs().max(high.unsigned_abs());
        // To 60 bits; the ends are rounded outwards.
        let shift = (i128::BITS - 60).saturating_sub(size.leading_zeros());
        let (low, high) = (low >> shift, -(-high >> shift));
        let middle: i128 = (low + high) >> 1;
        let radius = (high - middle).max(middle - low);
        let fixed = i64::try_from(self.root.dropped).map_err(|_| Larger)?;
        let dropped = i64::try_from(dropped).map_err(|_| Larger)?;
        let unit = fixed - i64::try_from(BITS).map_err(|_| Larger)?;
        Ok(Interval::rounded(
            i64::try_from(middle).map_err(|_| Larger)?,
            i64::try_from(radius).map_err(|_| Larger)?,
            unit + dropped + i64::from(shift),
        ))
    }
}

impl Ring for Intervals {
    type Element = Interval;
    type Next = Intervals;

    fn element(&self, coefficients: &[BigInt]) -> Result<Interval, Larger> {
        self.of(coefficients)
    }

    fn coefficients(&self, _: &Interval) -> Vec<BigInt> {
        Vec::new()
    }

    fn next(x: &Interval) -> Interval {
        *x
    }

    #[inline(always)]
    fn plus(&self, x: &Interval, y: &Interval) -> Result<Interval, Larger> {
        Ok(Interval::sum([*x, *y]))
    }

    #[inline(always)]
    fn minus(&self, x: &Interval, y: &Interval) -> Result<Interval, Larger> {
        Ok(Interval::sum([*x, y.negated()]))
    }

    #[inline(always)]
    fn dot<const K: usize>(
        &self,
        x: [&Interval; K],
        y: [&Interval; K],
    ) -> Result<Interval, Larger> {
        let mut products = [Interval::default(); K];
        for ((product, x), y) in products.iter_mut().zip(x).zip(y) {
            *product = x.product(*y);
        }
        Ok(Interval::sum(products))
    }

    #[inline(always)]
    fn sign(&self, x: &Interval) -> Result<Ordering, Larger> {
        if x.middle.abs() > x.radius || x.is_zero() {
            Ok(x.middle.cmp(&0))
        } else {
            Err(Larger)
        }
    }

    /// x + min(0, y - x). Where the sign is undecided, the minimum is between -m and 0 for the
    /// largest absolute value m of the difference.
    #[inline(always)]
    fn lesser(&self, x: &Interval, y: &Interval) -> Result<Interval, Larger> {
        let difference = self.minus(y, x)?;
        match self.sign(&difference) {
            Ok(Ordering::Less) => Ok(*y),
            Ok(_) => Ok(*x),
            Err(Larger) => {
                let half = (difference.middle.abs() + difference.radius + 1) >> 1;
                let least = Interval {
                    middle: -half,
                    radius: half,
                    exponent: difference.exponent,
                };
                self.plus(x, &least)
            }
        }
    }

    fn price(&self) -> u64 {
        4
    }
}
