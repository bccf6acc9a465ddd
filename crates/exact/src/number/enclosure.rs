//! Rigorous bounds of real numbers by rational ones: interval operations, square
//! roots, π, the cosine and its inverse in degrees.
//!
//! The transcendental functions are computed with integers in units of 2^-bits; every rounding has a
//! direction. No error is estimated beforehand. The result is a lower and an upper bound for any number of
//! bits. Bits are added until the bounds are as close as asked. Signs use the intervals; the angles of
//! reports, and proofs of bounds for angles, use the rest.

use malachite::base::num::arithmetic::traits::{
    Abs, Ceiling, CeilingSqrt, DivRound, Floor, FloorSqrt, ShrRound,
};
use malachite::base::num::basic::traits::{NegativeOne, One, Zero};
use malachite::base::rounding_modes::RoundingMode;
use malachite::{Integer, Rational};

/// All real numbers from `lo` to `hi`, lo <= hi.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// Lower end.
    pub lo: Rational,
    /// Upper end.
    pub hi: Rational,
}

impl Interval {
    /// Whether 0 lies in it.
    pub fn contains_zero(&self) -> bool {
        self.lo <= 0 && self.hi >= 0
    }

    /// All products of a number of `self` with one of `other`.
    pub fn times(&self, other: &Interval) -> Interval {
        let (a, b) = (&self.lo * &other.lo, &self.lo * &other.hi);
        let (c, d) = (&self.hi * &other.lo, &self.hi * &other.hi);
        let lo = (&a).min(&b).min((&c).min(&d)).clone();
        Interval {
            lo,
            hi: a.max(b).max(c.max(d)),
        }
    }

    /// An interval with all values of Σ p_i x^i for x in `self`, by Horner's
    /// rule with interval operations.
    pub fn horner(&self, p: &[Integer]) -> Interval {
        let zero = Interval {
            lo: Rational::ZERO,
            hi: Rational::ZERO,
        };
        p.iter().rev().fold(zero, |value, c| {
            let product = value.times(self);
            let c = Rational::from(c);
            Interval {
                lo: product.lo + &c,
                hi: product.hi + c,
            }
        })
    }
}

/// The largest multiple of 2^-bits that is at most √x, for x >= 0.
pub fn sqrt_below(x: &Rational, bits: u64) -> Rational {
    Rational::from((x << (2 * bits)).floor().floor_sqrt()) >> bits
}

/// The smallest multiple of 2^-bits that is at least √x, for x >= 0.
pub fn sqrt_above(x: &Rational, bits: u64) -> Rational {
    Rational::from((x << (2 * bits)).ceiling().ceiling_sqrt()) >> bits
}

/// Bounds of π at most `width` > 0 apart.
pub fn pi(width: &Rational) -> (Rational, Rational) {
    refine(width, pi_bounds)
}

/// Bounds of the cosine of `degrees` degrees at most `width` > 0 apart. For multiples of 60 and of 90
/// degrees both are the value itself. These are the only ones with a rational cosine (Niven).
pub fn cos_of_degrees(degrees: &Rational, width: &Rational) -> (Rational, Rational) {
    // cos is even and has period 360: 0 <= q <= 180.
    let turn = Rational::from(360);
    let q = degrees - Rational::from((degrees / &turn).floor()) * &turn;
    let q = if q > 180 { turn - q } else { q };
    // cos(180 - q) = -cos q: 0 <= q <= 90.
    if q > 90 {
        let (lo, hi) = cos_of_degrees(&(Rational::from(180) - q), width);
        return (-hi, -lo);
    }
    if let Some((_, cosine)) = niven().into_iter().find(|(angle, _)| *angle == q) {
        return (cosine.clone(), cosine);
    }
    // x = q π/180 lies in [0, π/2], and the cosine falls from 0 to π.
    let radian = &q / Rational::from(180);
    refine(width, |bits| {
        let (lo, hi) = pi_bounds(bits);
        let (lo, hi) = (
            (Rational::from(lo) * &radian).floor(),
            (Rational::from(hi) * &radian).ceiling(),
        );
        (cosine(&hi, bits).0, cosine(&lo, bits).1)
    })
}

/// Bounds of the angles, in degrees, whose cosines lie between `cos_lo` and
/// `cos_hi`; cosines beyond -1 and 1 are taken for -1 and 1. The lower bound is
/// less than `width` > 0 below the smallest angle, and the upper bound less than
/// `width` above the largest.
pub fn acos_degrees(
    cos_lo: &Rational,
    cos_hi: &Rational,
    width: &Rational,
) -> (Rational, Rational) {
    (acos_of(cos_hi, width).0, acos_of(cos_lo, width).1)
}

/// Bounds of the angle with cosine `c`. With c >= 0 and u² = (1-c)/(1+c), it is
/// 2 atan u, and 0 <= u <= 1.
fn acos_of(c: &Rational, width: &Rational) -> (Rational, Rational) {
    let c = c.clamp(&Rational::NEGATIVE_ONE, &Rational::ONE).clone();
    if c < 0 {
        let (lo, hi) = acos_of(&c.abs(), width);
        return (Rational::from(180) - hi, Rational::from(180) - lo);
    }
    if let Some((angle, _)) = niven().into_iter().find(|(_, cosine)| *cosine == c) {
        return (angle.clone(), angle);
    }
    let square = (Rational::ONE - &c) / (Rational::ONE + c);
    refine(width, |bits| {
        let u = (
            sqrt_below(&square, bits) << bits,
            sqrt_above(&square, bits) << bits,
        );
        let (lo, hi) = (
            atan_below(u.0.floor(), bits),
            atan_above(u.1.ceiling(), bits),
        );
        let (pi_lo, pi_hi) = pi_bounds(bits);
        let lo = ((Integer::from(360) * lo) << bits)
            .div_round(pi_hi, RoundingMode::Floor)
            .0;
        let hi = ((Integer::from(360) * hi) << bits)
            .div_round(pi_lo, RoundingMode::Ceiling)
            .0;
        (lo, hi)
    })
}

/// The angles from 0 to 90 degrees with a rational cosine, and the cosines.
fn niven() -> [(Rational, Rational); 3] {
    [
        (Rational::ZERO, Rational::ONE),
        (Rational::from(60), Rational::from_signeds(1, 2)),
        (Rational::from(90), Rational::ZERO),
    ]
}

/// The bounds that `bounds` gives in units of 2^-bits, for the first number of
/// bits for which they are at most `width` apart.
fn refine(width: &Rational, bounds: impl Fn(u64) -> (Integer, Integer)) -> (Rational, Rational) {
    assert!(*width > 0, "bounds have a positive distance");
    let mut bits = 64;
    loop {
        let (lo, hi) = bounds(bits);
        if Rational::from(&hi - &lo) >> bits <= *width {
            return (Rational::from(lo) >> bits, Rational::from(hi) >> bits);
        }
        bits += bits / 2;
    }
}

/// Bounds of 2^bits π: Machin, π = 16 atan(1/5) - 4 atan(1/239).
fn pi_bounds(bits: u64) -> (Integer, Integer) {
    let (a, b) = (atan_of_inverse(5, bits), atan_of_inverse(239, bits));
    ((a.0 << 4u64) - (b.1 << 2u64), (a.1 << 4u64) - (b.0 << 2u64))
}

/// Bounds of 2^bits atan(1/n) = Σ ± t_i, t_i = 2^bits / ((2i+1) n^(2i+1)), n >= 2.
///
/// The terms fall and alternate, so the rest after the last one used is smaller
/// than the next, which is below 1. Each floor used is below its term by less
/// than 1 (nested floors of quotients are the floor of the quotient).
fn atan_of_inverse(n: u64, bits: u64) -> (Integer, Integer) {
    let square = Integer::from(n * n);
    let mut power = (Integer::ONE << bits) / Integer::from(n);
    let (mut lo, mut hi) = (Integer::ZERO, Integer::ZERO);
    for i in 0u64.. {
        let term = &power / Integer::from(2 * i + 1);
        if term == 0 {
            break;
        }
        if i % 2 == 0 {
            lo += &term;
            hi += term + Integer::ONE;
        } else {
            lo -= &term + Integer::ONE;
            hi -= term;
        }
        power /= &square;
    }
    (lo - Integer::ONE, hi + Integer::ONE)
}

/// Bounds of 2^bits cos x for x = k/2^bits >= 0.
///
/// The rest of Taylor's series from the term ±x^(2i)/(2i)! on is at most that term. (Lagrange: every
/// derivative of the cosine is at most 1.) An upper bound of the term is at most 1 where the sum stops.
fn cosine(k: &Integer, bits: u64) -> (Integer, Integer) {
    let one = Integer::ONE << bits;
    let square = k * k;
    let (mut term, mut sum) = ((one.clone(), one.clone()), (one.clone(), one));
    for i in 1u64.. {
        let divisor = Integer::from((2 * i - 1) * (2 * i)) << (2 * bits);
        term.0 = (term.0 * &square)
            .div_round(&divisor, RoundingMode::Floor)
            .0;
        term.1 = (term.1 * &square)
            .div_round(&divisor, RoundingMode::Ceiling)
            .0;
        if term.1 <= 1 {
            break;
        }
        if i % 2 == 1 {
            sum.0 -= &term.1;
            sum.1 -= &term.0;
        } else {
            sum.0 += &term.0;
            sum.1 += &term.1;
        }
    }
    (sum.0 - &term.1, sum.1 + term.1)
}

/// A lower bound of 2^bits atan u for u = k/2^bits in [0, 1].
///
/// atan u = 2 atan h(u) with h(u) = u/(1 + √(1+u²)), which grows with u; so does
/// the arctangent, so that lower bounds may be put in.
fn atan_below(k: Integer, bits: u64) -> Integer {
    let half = |k: Integer| {
        let root = ((Integer::ONE << (2 * bits)) + &k * &k).ceiling_sqrt();
        (k << bits)
            .div_round((Integer::ONE << bits) + root, RoundingMode::Floor)
            .0
    };
    atan_series(&half(half(k)), bits, false) << 2u64
}

/// An upper bound of 2^bits atan u for u = k/2^bits in [0, 1].
fn atan_above(k: Integer, bits: u64) -> Integer {
    let half = |k: Integer| {
        let root = ((Integer::ONE << (2 * bits)) + &k * &k).floor_sqrt();
        (k << bits)
            .div_round((Integer::ONE << bits) + root, RoundingMode::Ceiling)
            .0
    };
    atan_series(&half(half(k)), bits, true) << 2u64
}

/// A lower or an upper bound of 2^bits atan v = Σ ± 2^bits v^(2i+1)/(2i+1) for v = k/2^bits in [0, 1/2]. It
/// sums bounds of the terms and of the rest. The rest is at most the next term, because the terms fall and
/// alternate.
fn atan_series(k: &Integer, bits: u64, above: bool) -> Integer {
    let square = k * k;
    let mut power = (k.clone(), k.clone());
    let mut sum = Integer::ZERO;
    for i in 0u64.. {
        let odd = Integer::from(2 * i + 1);
        let low = (&power.0).div_round(&odd, RoundingMode::Floor).0;
        let high = (&power.1).div_round(&odd, RoundingMode::Ceiling).0;
        if high <= 1 {
            sum += if above { high } else { -high };
            break;
        }
        match (i % 2 == 0, above) {
            (true, true) => sum += high,
            (true, false) => sum += low,
            (false, true) => sum -= low,
            (false, false) => sum -= high,
        }
        power.0 = (power.0 * &square)
            .shr_round(2 * bits, RoundingMode::Floor)
            .0;
        power.1 = (power.1 * &square)
            .shr_round(2 * bits, RoundingMode::Ceiling)
            .0;
    }
    sum
}
