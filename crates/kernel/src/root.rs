//! The root a of the field's polynomial: one exists, and integers enclose its powers.

use crate::claim::Field;
use crate::int::Int;
use crate::refusal::{Checked, Larger, Place, Stop};
use num_bigint::BigInt;
use std::cmp::Ordering::{self, Greater, Less};

/// The bits of the fine enclosures after the point.
pub(crate) const BITS: u64 = 1024;
/// The bits of the largest rough enclosure.
const ROUGH_BITS: u64 = 60;

/// Enclosures of 1, a, …, a^(n-1).
pub(crate) struct Root {
    /// a^n = Σ tail_k a^k
    pub(crate) tail: Vec<BigInt>,
    /// 2^(BITS - dropped) a^k lies between these integers of at most 61 bits.
    pub(crate) rough: Vec<(i64, i64)>,
    pub(crate) dropped: u64,
    /// 2^BITS a^k lies between these.
    pub(crate) fine: Vec<(BigInt, BigInt)>,
}

impl Root {
    pub(crate) fn new(field: &Field) -> Checked<Root> {
        let (tail, fine) = match field {
            Field::Rational => {
                let one = BigInt::from(1) << BITS;
                (vec![BigInt::ZERO], vec![(one.clone(), one)])
            }
            Field::Algebraic {
                polynomial,
                low,
                high,
                denominator,
            } => {
                check_root(polynomial, low, high, denominator)?;
                let (low, high) = enclose(polynomial, low, high, denominator);
                let degree = polynomial.len().saturating_sub(1);
                let tail = polynomial.iter().take(degree).map(|c| -c).collect();
                (tail, powers(&low, &high, degree))
            }
        };
        let most = fine.iter().map(|(low, high)| low.bits().max(high.bits()));
        let dropped = most.max().unwrap_or(0).saturating_sub(ROUGH_BITS);
        let mut rough = Vec::new();
        for (low, high) in &fine {
            let ceiling: BigInt = -(-high >> dropped);
            // They fit, for all others are smaller than the one with the most bits.
            let ends = (low.top(dropped), i64::of(&ceiling));
            let (Ok(low), Ok(high)) = ends else {
                return Err(Stop::Larger.at_last(Place::Field));
            };
            rough.push((low, high));
        }
        Ok(Root {
            tail,
            rough,
            dropped,
            fine,
        })
    }
}

/// The polynomial p is monic. It has exactly one root between the ends of the interval.
fn check_root(p: &[BigInt], low: &BigInt, high: &BigInt, denominator: &BigInt) -> Checked {
    let is_interval = low < high && *denominator > BigInt::ZERO;
    ensure!(is_interval, RootOrder, Place::Field);
    // p has opposite strict signs at the ends: there is a root between them.
    let signs = (sign_at(p, low, denominator), sign_at(p, high, denominator));
    let are_opposite = matches!(signs, (Less, Greater) | (Greater, Less));
    ensure!(are_opposite, RootSigns, Place::Field);
    // The derivative is nowhere zero between the ends, so there is no other root. Horner's rule
    // with [low, high] / d encloses d^m p'.
    let derivative: Vec<BigInt> = p.iter().zip(0u32..).skip(1).map(|(c, k)| c * k).collect();
    let (mut least, mut most) = (BigInt::ZERO, BigInt::ZERO);
    let mut unit = BigInt::from(1);
    for c in derivative.iter().rev() {
        let ends = [&least * low, &least * high, &most * low, &most * high];
        let term = c * &unit;
        least = ends.iter().min().unwrap_or(&BigInt::ZERO) + &term;
        most = ends.iter().max().unwrap_or(&BigInt::ZERO) + &term;
        unit *= denominator;
    }
    let is_monotone = least > BigInt::ZERO || most < BigInt::ZERO;
    ensure!(is_monotone, RootDerivative, Place::Field);
    Ok(())
}

/// The sign of p(x / d), which is that of d^n p(x / d).
fn sign_at(p: &[BigInt], x: &BigInt, d: &BigInt) -> Ordering {
    let (mut sum, mut unit) = (BigInt::ZERO, BigInt::from(1));
    for c in p.iter().rev() {
        sum = sum * x + c * &unit;
        unit *= d;
    }
    sum.cmp(&BigInt::ZERO)
}

/// Neighbouring integers between which 2^BITS a lies. p rises or falls on the whole interval, so
/// halving it keeps the root. All points at which p is evaluated are inside of the interval.
fn enclose(p: &[BigInt], low: &BigInt, high: &BigInt, denominator: &BigInt) -> (BigInt, BigInt) {
    let unit = BigInt::from(1) << BITS;
    let rises = sign_at(p, high, denominator);
    let mut least = floor(&(low << BITS), denominator);
    let mut most = -floor(&-(high << BITS), denominator);
    while &most - &least > BigInt::from(1) {
        let middle: BigInt = (&least + &most) >> 1;
        if sign_at(p, &middle, &unit) == rises {
            most = middle;
        } else {
            least = middle;
        }
    }
    (least, most)
}

fn floor(x: &BigInt, positive: &BigInt) -> BigInt {
    let quotient = x / positive;
    if &quotient * positive > *x {
        quotient - 1
    } else {
        quotient
    }
}

/// The first powers of an enclosure, all in units of 2^-BITS.
fn powers(low: &BigInt, high: &BigInt, count: usize) -> Vec<(BigInt, BigInt)> {
    let one = BigInt::from(1) << BITS;
    let mut power = (one.clone(), one);
    let mut powers = Vec::new();
    for _ in 0..count {
        let (least, most) = &power;
        let ends = [least * low, least * high, most * low, most * high];
        // Shifts round down.
        let next_least: BigInt = ends.iter().min().unwrap_or(&BigInt::ZERO) >> BITS;
        let next_most: BigInt = (ends.iter().max().unwrap_or(&BigInt::ZERO) >> BITS) + 1;
        powers.push(std::mem::replace(&mut power, (next_least, next_most)));
    }
    powers
}

/// Σ c_k a^k lies in [low, high] 2^s in units of the rough enclosures, by the first 60 bits of the
/// coefficients. Returns low, high and s.
#[inline(always)]
pub(crate) fn enclosure<T: Int>(
    coefficients: &[T],
    rough: &[(i64, i64)],
) -> Result<(i128, i128, u64), Larger> {
    let bits = coefficients.iter().map(T::bits).max().unwrap_or(0);
    let dropped = bits.saturating_sub(ROUGH_BITS);
    // A coefficient lies between its floor and that plus the width.
    let width = i128::from(dropped > 0);
    let (mut low, mut high) = (0i128, 0i128);
    for (c, (least, most)) in coefficients.iter().zip(rough) {
        let floor = i128::from(c.top(dropped)?);
        let (least, most) = (i128::from(*least), i128::from(*most));
        let ends = (floor * least, floor * most);
        low += ends.0.min(ends.1) + width * least.min(0);
        high += ends.0.max(ends.1) + width * most.max(0);
    }
    Ok((low, high, dropped))
}

/// The sign of a number between two others, if they show it.
#[inline(always)]
pub(crate) fn sign_between(low: Ordering, high: Ordering) -> Result<Ordering, Larger> {
    match (low, high) {
        (Greater, _) => Ok(Greater),
        (_, Less) => Ok(Less),
        _ => Err(Larger),
    }
}
