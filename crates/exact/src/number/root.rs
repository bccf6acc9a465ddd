//! Enclosures of a root of a polynomial, and of its powers, by dyadic numbers.
//!
//! What is found for a number of bits is determined by the root alone (k is the
//! floor of 2^bits times the root), whatever was found before.
//! A field keeps the enclosures.

use crate::geometry::Sign;
use malachite::base::num::arithmetic::traits::{DivRound, ShrRound, Sign as _};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::rounding_modes::RoundingMode::{Ceiling, Floor};
use malachite::{Integer, Rational};

/// The interval from low/2^bits to high/2^bits, low < high.
#[derive(Clone, Debug)]
pub(super) struct Dyadic {
    pub low: Integer,
    pub high: Integer,
    pub bits: u64,
}

impl Dyadic {
    /// The ends.
    pub fn ends(&self) -> (Rational, Rational) {
        (
            Rational::from(&self.low) >> self.bits,
            Rational::from(&self.high) >> self.bits,
        )
    }

    /// k/2^bits to (k+1)/2^bits around the only root of `p` in `self`, which is
    /// simple and irrational, where `below` is the sign of p at the lower end.
    ///
    /// Newton's step from the middle, when it doubles the right bits, misses k
    /// by little: the probes go out from it by 2^(2^i), and then bisection ends.
    pub fn refine(&self, p: &[Integer], below: Sign, bits: u64) -> Dyadic {
        if bits <= self.bits {
            let low = &self.low >> (self.bits - bits);
            return Dyadic {
                high: &low + Integer::ONE,
                low,
                bits,
            };
        }
        let mut low = &self.low << (bits - self.bits);
        let mut high = &self.high << (bits - self.bits);
        let mut narrow = |probe: Integer| {
            if low < probe && probe < high {
                if numerator_at(p, &probe, bits).sign() == below {
                    low = probe;
                } else {
                    high = probe;
                }
            }
            &high - &low
        };
        let guess = self.newton(p, bits);
        let mut reach = 1u64;
        while reach < bits && narrow(&guess - (Integer::ONE << (reach - 1))) > Integer::ONE << reach
        {
            if narrow(&guess + (Integer::ONE << (reach - 1))) <= Integer::ONE << reach {
                break;
            }
            reach *= 2;
        }
        while &high - &low > 1 {
            let middle = (&low + &high) >> 1u64;
            if numerator_at(p, &middle, bits).sign() == below {
                low = middle;
            } else {
                high = middle;
            }
        }
        Dyadic { low, high, bits }
    }

    /// 2^bits (x - p(x)/p'(x)) for the middle x, rounded; x if p'(x) is zero.
    /// Only a guess: nothing depends on it but time.
    fn newton(&self, p: &[Integer], bits: u64) -> Integer {
        let slope: Vec<Integer> = (1u64..)
            .zip(&p[1..])
            .map(|(i, c)| c * Integer::from(i))
            .collect();
        let middle = (&self.low + &self.high) << (bits - self.bits - 1);
        let rise = numerator_at(&slope, &middle, bits);
        if rise == 0 {
            return middle;
        }
        let step = numerator_at(p, &middle, bits).div_round(rise, Floor).0;
        middle - step
    }
}

/// 2^(bits·n) p(k/2^bits) for p of degree n: Σ p_i k^i 2^(bits (n-i)).
fn numerator_at(p: &[Integer], k: &Integer, bits: u64) -> Integer {
    let mut shift = 0;
    p.iter().rev().fold(Integer::ZERO, |value, c| {
        let value = value * k + (c << shift);
        shift += bits;
        value
    })
}

/// Lower and upper bounds of 2^bits a^i for the powers of a root a.
pub(super) struct Level {
    root: Dyadic,
    powers: Vec<(Integer, Integer)>,
}

impl Level {
    /// 64·2^j
    pub fn bits(j: usize) -> u64 {
        64 << j
    }

    /// The powers 0 to `degree` - 1 of the root in `root`.
    pub fn new(root: Dyadic, degree: usize) -> Level {
        let mut powers = vec![(Integer::ONE << root.bits, Integer::ONE << root.bits)];
        while powers.len() < degree {
            let (lo, hi) = &powers[powers.len() - 1];
            let corners = [
                lo * &root.low,
                lo * &root.high,
                hi * &root.low,
                hi * &root.high,
            ];
            let (min, max) = min_max(corners);
            powers.push((
                min.shr_round(root.bits, Floor).0,
                max.shr_round(root.bits, Ceiling).0,
            ));
        }
        Level { root, powers }
    }

    /// The enclosure of the root itself.
    pub fn root(&self) -> &Dyadic {
        &self.root
    }

    /// Bounds of 2^bits a^i, i = 0, 1, …
    pub fn powers(&self) -> &[(Integer, Integer)] {
        &self.powers
    }

    /// Bounds of 2^bits Σ n_i a^i.
    pub fn bounds(&self, numerators: &[Integer]) -> (Integer, Integer) {
        let mut bounds = (Integer::ZERO, Integer::ZERO);
        for (n, (lo, hi)) in numerators.iter().zip(&self.powers) {
            let (lo, hi) = if *n >= 0 { (lo, hi) } else { (hi, lo) };
            bounds.0 += n * lo;
            bounds.1 += n * hi;
        }
        bounds
    }
}

fn min_max(values: [Integer; 4]) -> (Integer, Integer) {
    let [a, b, c, d] = values;
    let (ab, cd) = (
        if a < b { (a, b) } else { (b, a) },
        if c < d { (c, d) } else { (d, c) },
    );
    (ab.0.min(cd.0), ab.1.max(cd.1))
}
