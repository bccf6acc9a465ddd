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
use std::cmp::Ordering;
use std::rc::Rc;

/// The numbers between (middle - radius) 2^exponent and (middle + radius) 2^exponent.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    pub(crate) middle: i64,
    /// |middle| + radius; less than 2^30 + 4.
    most: u64,
    exponent: i64,
}

const SIZE: u32 = 30;

impl Default for Interval {
    /// Zero. Its exponent is less than all others.
    fn default() -> Self {
        Interval { middle: 0, most: 0, exponent: -(1 << 40) }
    }
}

impl Interval {
    /// An interval that contains the number with these coefficients.
    #[inline(always)]
    pub(crate) fn of<T: Int>(coefficients: &[T], root: &Root) -> Checked<Interval> {
        if let Some((c, rest)) = coefficients.split_first()
            && rest.iter().all(|c| *c == T::default())
        {
            let shift = c.length().saturating_sub(u64::from(SIZE));
            let middle = c.top(shift)?;
            let most = middle.unsigned_abs() + u64::from(shift > 0);
            return Ok(Interval { middle, most, exponent: shift.cast_signed() });
        }
        let (middle, radius, dropped) = enclosure(coefficients, &root.rough)?;
        // To 30 bits. Both parts are rounded down, each by less than one unit.
        let shift = (i128::BITS - SIZE).saturating_sub((middle.unsigned_abs() + radius).leading_zeros());
        let lost = if shift > 0 { 2 } else { 0 };
        let middle = (middle >> shift).top(0)?;
        let most = middle.unsigned_abs() + u64::try_from(radius >> shift).map_err(|_| Stop::LARGER)? + lost;
        let up = root.dropped + dropped + u64::from(shift);
        Ok(Interval { middle, most, exponent: up.cast_signed() - BITS.cast_signed() })
    }

    /// The sum of at most four middles, radii and exponents, of which one is the greatest. Shifts lose less than one
    /// unit of each part, and so does the last one, to 30 bits.
    #[inline(always)]
    fn sum<const K: usize>(terms: [(i64, u64, i64); K], exponent: i64) -> Interval {
        let (mut middle, mut radius) = (0i64, 0u64);
        for (term, error, smaller) in terms {
            let shift = exponent.abs_diff(smaller).min(63);
            middle += term >> shift;
            radius += (error >> shift) + if shift > 0 { 2 } else { 0 };
        }
        let size = middle.unsigned_abs() + radius;
        let shift = (u64::BITS - SIZE).saturating_sub(size.leading_zeros());
        let lost = if shift > 0 { 2 } else { 0 };
        let middle = middle >> shift;
        let most = middle.unsigned_abs() + (radius >> shift) + lost;
        Interval { middle, most, exponent: exponent + i64::from(shift) }
    }
}

/// A positive number between (middle - error) 2^exponent and (middle + error) 2^exponent, where
/// 2^31 <= middle < 2^32, error < 2^20 + 2 and |exponent| < 2^27.
#[derive(Clone, Copy)]
pub struct Rough {
    middle: u64,
    error: u64,
    exponent: i64,
}

impl Rough {
    /// Of numbers up to `radius` from `middle`, in units of 2^exponent.
    #[inline(always)]
    pub(crate) fn new(middle: u128, radius: u128, exponent: i64) -> Option<Rough> {
        let up = middle.leading_zeros();
        let exponent = exponent + 96 - i64::from(up);
        if radius.leading_zeros() < up + 12 || exponent.unsigned_abs() >> 27 > 0 {
            return None;
        }
        // The first 32 bits. Both parts are rounded down, each by less than one unit.
        let first = |x: u128| u64::try_from((x << up) >> 96).ok();
        Some(Rough { middle: first(middle)?, error: first(radius)? + 2, exponent })
    }
}

/// A number lies between these places, inclusive, on a scale that rises with the numbers. Zero has the place 0, and
/// (1 + t) 2^(k+31) with 0 <= t < 1 has 2^62 + (k + t) 2^31: its logarithm, but linear between powers of 2. The
/// places of negative numbers are negative.
#[derive(Clone, Copy)]
pub struct Range {
    pub(crate) low: i64,
    pub(crate) high: i64,
}

impl Range {
    /// Of ± x y / (z w), with this sign. Relative errors add up, to E/2^31 for the sum E of the errors, and 1 % of it
    /// for products of them. The integers below lose three units more, of 2^-30. A relative error is doubled at most.
    #[inline(always)]
    pub(crate) fn quotient(sign: Sign, roughs: Option<[Rough; 4]>) -> Range {
        let (mut low, mut high) = (1, i64::MAX);
        if let Some([x, y, z, w]) = roughs {
            let quotient = x.middle * y.middle / ((z.middle * w.middle) >> 32);
            let up = quotient.leading_zeros();
            let t = ((quotient << up) >> 32).cast_signed() - (1 << 31);
            let exponent = x.exponent + y.exponent - z.exponent - w.exponent - i64::from(up);
            let error = (3 * (x.error + y.error + z.error + w.error) + 16).cast_signed();
            let middle = (1 << 62) + exponent * (1 << 31) + t;
            (low, high) = (middle - error, middle + error);
        }
        match sign.decided() {
            Ok(Ordering::Greater) => Range { low, high },
            Ok(Ordering::Less) => Range { low: -high, high: -low },
            Ok(Ordering::Equal) => Range { low: 0, high: 0 },
            Err(_) => Range { low: -high, high },
        }
    }

    /// The order of the numbers, if it is known.
    #[inline(always)]
    pub(crate) fn compare(&self, other: &Range) -> Option<Ordering> {
        let order = if self.low > other.high { Ordering::Greater } else { Ordering::Less };
        (order == Ordering::Greater || self.high < other.low).then_some(order)
    }
}

#[derive(Clone)]
pub struct Intervals {
    pub(crate) root: Rc<Root>,
    pub(crate) work: Rc<Work>,
}

impl Ring for Intervals {
    type Element = Interval;

    fn element(&self, coefficients: &[BigInt]) -> Checked<Interval> {
        Interval::of(coefficients, &self.root)
    }

    fn coefficients(&self, _: &Interval) -> Vec<BigInt> {
        Vec::new()
    }

    #[inline(always)]
    fn plus(&self, x: &Interval, y: &Interval) -> Checked<Interval> {
        let term = |x: &Interval| (x.middle, x.most - x.middle.unsigned_abs(), x.exponent);
        Ok(Interval::sum([term(x), term(y)], x.exponent.max(y.exponent)))
    }

    #[inline(always)]
    fn minus(&self, x: &Interval, y: &Interval) -> Checked<Interval> {
        self.plus(x, &self.negated(y)?)
    }

    #[inline(always)]
    fn negated(&self, x: &Interval) -> Checked<Interval> {
        Ok(Interval { middle: -x.middle, ..*x })
    }

    /// Of a product, |x y - m m'| <= (|m| + r) (|m'| + r') - |m m'| < 2^61.
    #[inline(always)]
    fn dot<const K: usize>(&self, x: [&Interval; K], y: [&Interval; K]) -> Checked<Interval> {
        let mut terms = [(0, 0, i64::MIN); K];
        let mut exponent = i64::MIN;
        for ((term, x), y) in terms.iter_mut().zip(x).zip(y) {
            let middle = x.middle * y.middle;
            *term = (middle, x.most * y.most - middle.unsigned_abs(), x.exponent + y.exponent);
            exponent = exponent.max(term.2);
        }
        Ok(Interval::sum(terms, exponent))
    }

    #[inline(always)]
    fn sign(&self, x: &Interval) -> Sign {
        // The middle is greater than the radius, or both are zero.
        let is_decided = 2 * x.middle.unsigned_abs() > x.most || x.most == 0;
        if is_decided { Sign::exactly(x.middle.cmp(&0)) } else { Sign::UNDECIDED }
    }

    #[inline(always)]
    fn rough(&self, x: &Interval) -> (Sign, Option<Rough>) {
        let middle = x.middle.unsigned_abs();
        (self.sign(x), Rough::new(middle.into(), (x.most - middle).into(), x.exponent))
    }

    fn work(&self) -> &Work {
        &self.work
    }

    fn price(&self) -> u64 {
        4
    }
}
