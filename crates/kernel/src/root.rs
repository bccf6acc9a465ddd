//! The root a of the field's polynomial: one exists, and integers enclose its powers.

use crate::claim::Field;
use crate::int::Int;
use crate::limits::Work;
use crate::refusal::{Checked, Place, Stop};
use num_bigint::BigInt;
use std::cmp::Ordering;

/// The bits of the fine enclosures after the point.
pub(crate) const BITS: u64 = 1024;
/// The bits of the largest rough enclosure.
pub(crate) const ROUGH_BITS: u64 = 60;

/// Enclosures of 1, a, …, a^(n-1).
pub(crate) struct Root {
    /// a^n = Σ tail_k a^k
    pub(crate) tail: Vec<BigInt>,
    /// 2^(BITS - dropped) a^k lies between low and low + width. |low| is at most 2^60.
    pub(crate) rough: Vec<(i64, u64)>,
    pub(crate) dropped: u64,
    /// 2^BITS a^k lies between these.
    pub(crate) fine: Vec<(BigInt, BigInt)>,
}

impl Root {
    pub(crate) fn new(field: &Field, work: &Work) -> Checked<Root> {
        let one = BigInt::from(1) << BITS;
        let p = &field.polynomial;
        let tail = p.iter().take(field.degree()).map(|c| -c).collect();
        let mut fine = vec![(one.clone(), one)];
        if let Some([low, high, denominator]) = &field.root {
            check_root(p, low, high, denominator, work)?;
            let (low, high) = enclose(p, [low, high, denominator], work)?;
            while fine.len() < field.degree() {
                let (least, most) = fine.last().ok_or(Stop::LARGER)?;
                let (least, most) = product((least, most), (&low, &high));
                // The shift rounds down.
                fine.push((least >> BITS, (most >> BITS) + 1));
            }
        }
        let most = fine.iter().map(|(low, high)| low.bits().max(high.bits())).max();
        let dropped = most.unwrap_or(0).saturating_sub(ROUGH_BITS);
        let mut rough = Vec::new();
        for (low, high) in &fine {
            let (low, high) = (low.top(dropped)?, -(-high).top(dropped)?);
            rough.push((low, high.abs_diff(low)));
        }
        Ok(Root { tail, rough, dropped, fine })
    }
}

/// Σ c_k a^k lies within `radius` of `middle`, both times 2^s in units of the rough enclosures, by the
/// first 60 bits of the coefficients. Returns middle, radius and s.
#[inline(always)]
pub(crate) fn enclosure<T: Int>(coefficients: &[T], rough: &[(i64, u64)]) -> Checked<(i128, u128, u64)> {
    let length = coefficients.iter().fold(0, |most, c| c.length().max(most));
    let s = length.saturating_sub(ROUGH_BITS);
    let (mut middle, mut radius) = (0i128, 0u128);
    for (c, (low, width)) in coefficients.iter().zip(rough) {
        let floor = c.top(s)?;
        middle += i128::from(floor) * i128::from(*low);
        radius += u128::from(floor.unsigned_abs()) * u128::from(*width);
        if s > 0 {
            // A coefficient lies between its floor and that plus one.
            radius += u128::from(low.unsigned_abs()) + u128::from(*width);
        }
    }
    Ok((middle, radius, s))
}

/// The polynomial p is monic. It has exactly one root between the ends of the interval.
fn check_root(p: &[BigInt], low: &BigInt, high: &BigInt, d: &BigInt, work: &Work) -> Checked {
    let is_interval = low < high && *d > BigInt::ZERO;
    ensure!(is_interval, RootOrder, Place::Field);
    // p has opposite strict signs at the ends: there is a root between them.
    let signs = (sign_at(p, low, d, work), sign_at(p, high, d, work));
    let are_opposite = signs.0 == signs.1.reverse() && signs.0 != Ordering::Equal;
    ensure!(are_opposite, RootSigns, Place::Field);
    // The derivative is nowhere zero between the ends, so there is no other root. Horner's rule
    // with [low, high] / d encloses d^m p'.
    let (mut least, mut most, mut unit) = (BigInt::ZERO, BigInt::ZERO, BigInt::from(1));
    for (c, k) in p.iter().zip(0u32..).skip(1).collect::<Vec<_>>().into_iter().rev() {
        (least, most) = product((&least, &most), (low, high));
        let term = c * k * &unit;
        least += &term;
        most += term;
        unit *= d;
    }
    let is_monotone = least > BigInt::ZERO || most < BigInt::ZERO;
    ensure!(is_monotone, RootDerivative, Place::Field);
    Ok(())
}

/// The sign of p(x / d), which is that of d^n p(x / d).
fn sign_at(p: &[BigInt], x: &BigInt, d: &BigInt, work: &Work) -> Ordering {
    // The numbers grow to this many words.
    let words = p.iter().map(|_| 1 + (x.bits() + d.bits()) / 64).sum::<u64>();
    work.add(words.saturating_mul(words));
    let (mut sum, mut unit) = (BigInt::ZERO, BigInt::from(1));
    for c in p.iter().rev() {
        sum = sum * x + c * &unit;
        unit *= d;
    }
    Int::sign(&sum)
}

/// Integers between which 2^BITS a lies. p rises or falls on the whole interval, so halving it keeps the root.
fn enclose(p: &[BigInt], ends: [&BigInt; 3], work: &Work) -> Checked<(BigInt, BigInt)> {
    let [mut low, mut high, mut unit] = ends.map(BigInt::clone);
    let rises = sign_at(p, &high, &unit, work);
    while (&high - &low) << BITS > unit {
        work.check(Place::Field)?;
        let middle = &low + &high;
        (low, high, unit) = (low << 1, high << 1, unit << 1);
        let is_above = sign_at(p, &middle, &unit, work) == rises;
        *(if is_above { &mut high } else { &mut low }) = middle;
    }
    // Division rounds towards zero: one more unit encloses the end.
    Ok(((low << BITS) / &unit - 1, (high << BITS) / unit + 1))
}

/// An interval that contains all products of two intervals; it is the smallest one.
fn product(x: (&BigInt, &BigInt), y: (&BigInt, &BigInt)) -> (BigInt, BigInt) {
    let [a, b, c, d] = [x.0 * y.0, x.0 * y.1, x.1 * y.0, x.1 * y.1];
    let least = (&a).min(&b).min(&c).min(&d).clone();
    (least, a.max(b).max(c).max(d))
}
