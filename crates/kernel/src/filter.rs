//! Real intervals with integers of 30 bits, for coordinates of which exact products are long.
//!
//! An interval either shows a sign or leaves it undecided; then exact integers decide. So the
//! intervals save work and decide nothing that is not true.

use crate::int::Int;
use crate::limits::Work;
use crate::refusal::{Checked, Stop};
use crate::ring::{Ring, Sign};
use crate::root::{BITS, Root, enclosure};
use num_bigint::BigInt;
use std::rc::Rc;

/// The numbers between (middle - radius) 2^exponent and (middle + radius) 2^exponent.
/// |middle| + radius < 2^30 + 4.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    middle: i64,
    radius: u64,
    exponent: i64,
}

const SIZE: u32 = 30;

impl Default for Interval {
    /// Zero. Its exponent is less than all others.
    fn default() -> Self {
        Interval { middle: 0, radius: 0, exponent: -(1 << 40) }
    }
}

impl Interval {
    /// Shifted down to 30 bits. Both parts are rounded down, each by less than one unit.
    #[inline(always)]
    fn rounded(middle: i64, radius: u64, exponent: i64) -> Interval {
        let size = middle.unsigned_abs() + radius;
        let shift = (u64::BITS - SIZE).saturating_sub(size.leading_zeros());
        let lost = if shift > 0 { 2 } else { 0 };
        let (middle, radius) = (middle >> shift, (radius >> shift) + lost);
        Interval { middle, radius, exponent: exponent + i64::from(shift) }
    }

    /// |x y - m m'| <= (|m| + r) (|m'| + r') - |m m'|. The factors have less than 30.1 bits.
    #[inline(always)]
    fn product(&self, other: &Interval) -> Interval {
        let middle = self.middle * other.middle;
        let most = |x: &Interval| x.middle.unsigned_abs() + x.radius;
        let radius = most(self) * most(other) - middle.unsigned_abs();
        Interval { middle, radius, exponent: self.exponent + other.exponent }
    }

    /// The sum of at most four intervals of 61 bits. Shifts lose less than one unit of each part.
    #[inline(always)]
    fn sum<const K: usize>(terms: [Interval; K]) -> Interval {
        let exponent = terms.iter().fold(i64::MIN, |most, term| most.max(term.exponent));
        let (mut middle, mut radius) = (0, 0u64);
        for term in terms {
            let shift = (exponent - term.exponent).min(63);
            middle += term.middle >> shift;
            radius += (term.radius >> shift) + if shift > 0 { 2 } else { 0 };
        }
        Interval::rounded(middle, radius, exponent)
    }
}

#[derive(Clone)]
pub struct Intervals {
    pub(crate) root: Rc<Root>,
    pub(crate) work: Rc<Work>,
}

impl Intervals {
    /// An interval that contains the number with these coefficients.
    pub(crate) fn of<T: Int>(&self, coefficients: &[T]) -> Checked<Interval> {
        if let Some((c, rest)) = coefficients.split_first()
            && rest.iter().all(|c| *c == T::default())
        {
            let shift = c.length().saturating_sub(u64::from(SIZE));
            let radius = u64::from(shift > 0);
            return Ok(Interval { middle: c.top(shift)?, radius, exponent: shift.cast_signed() });
        }
        let (middle, radius, dropped) = enclosure(coefficients, &self.root.rough)?;
        // To 60 bits. Both parts are rounded down, each by less than one unit.
        let shift = (i128::BITS - 60).saturating_sub((middle.abs() + radius).leading_zeros());
        let lost = if shift > 0 { 2 } else { 0 };
        let radius = (radius >> shift).top(0)?.unsigned_abs() + lost;
        let up = self.root.dropped + dropped + u64::from(shift);
        let exponent = i64::try_from(up).map_err(|_| Stop::LARGER)? - BITS.cast_signed();
        Ok(Interval::rounded((middle >> shift).top(0)?, radius, exponent))
    }
}

impl Ring for Intervals {
    type Element = Interval;

    fn element(&self, coefficients: &[BigInt]) -> Checked<Interval> {
        self.of(coefficients)
    }

    fn coefficients(&self, _: &Interval) -> Vec<BigInt> {
        Vec::new()
    }

    #[inline(always)]
    fn plus(&self, x: &Interval, y: &Interval) -> Checked<Interval> {
        Ok(Interval::sum([*x, *y]))
    }

    #[inline(always)]
    fn minus(&self, x: &Interval, y: &Interval) -> Checked<Interval> {
        Ok(Interval::sum([*x, self.negated(y)?]))
    }

    fn negated(&self, x: &Interval) -> Checked<Interval> {
        Ok(Interval { middle: -x.middle, ..*x })
    }

    #[inline(always)]
    fn dot<const K: usize>(&self, x: [&Interval; K], y: [&Interval; K]) -> Checked<Interval> {
        let mut products = [Interval::default(); K];
        for ((product, x), y) in products.iter_mut().zip(x).zip(y) {
            *product = x.product(y);
        }
        Ok(Interval::sum(products))
    }

    fn sign(&self, x: &Interval) -> Sign {
        let is_decided = x.middle.unsigned_abs() > x.radius || (x.middle, x.radius) == (0, 0);
        if is_decided { Sign::exactly(x.middle.cmp(&0)) } else { Sign::UNDECIDED }
    }

    fn work(&self) -> &Work {
        &self.work
    }

    fn price(&self) -> u64 {
        4
    }
}
