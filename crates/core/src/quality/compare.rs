//! A dihedral angle compared with a rational number of degrees, exactly.

use super::measure::DihedralAngle;
use acutile_exact::number::{Number, enclosure};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Ceiling, PowerOf2};
use std::cmp::Ordering;

/// Compares the angle t with `degrees`, 0 < `degrees` <= 180. Always decided.
///
/// Equality is decided algebraically, so that enclosures of different values separate.
pub fn compare_with_degrees(angle: &DihedralAngle, degrees: &Rational) -> Ordering {
    let order = compare_by_enclosures(angle, degrees, FIRST_BITS);
    if let Some(order) = order {
        return order;
    }
    if may_be_equal(angle, degrees) {
        return Ordering::Equal;
    }
    let mut bits = 2 * FIRST_BITS;
    loop {
        if let Some(order) = compare_by_enclosures(angle, degrees, bits) {
            return order;
        }
        bits *= 2;
    }
}

/// Bits of the first enclosures.
const FIRST_BITS: i64 = 64;

/// The order, if enclosures of both cosines with this many bits are disjoint.
fn compare_by_enclosures(angle: &DihedralAngle, degrees: &Rational, bits: i64) -> Option<Ordering> {
    let width = Rational::power_of_2(-bits);
    let (low, high) = angle.cosine(&width);
    let (cos_low, cos_high) = enclosure::cos_of_degrees(degrees, &width);
    // The cosine falls.
    if high < cos_low {
        Some(Ordering::Greater)
    } else if low > cos_high {
        Some(Ordering::Less)
    } else {
        None
    }
}

/// Whether t = 180 p/q degrees, for an angle that is closer to it than any other multiple of
/// 90/q degrees.
///
/// x = cos 2t = 2 cos² t - 1 is in the field. If t = 180 p/q, then x = cos(2π p/q) has degree
/// φ(q)/2 for q > 2 (Lehmer), at most the degree n of the field, and T_q(x) = 1 for the Chebyshev
/// polynomial T_q. Conversely T_q(x) = 1 says that 2t is a multiple of 360/q degrees.
/// As φ(q) >= √(q/2), only q up to 8 n² is possible, and for these 2^-64 separates the angles.
fn may_be_equal(angle: &DihedralAngle, degrees: &Rational) -> bool {
    let turns = degrees / Rational::from(180);
    let square = angle.signed_square.abs();
    let degree = square.field().map_or(1, |field| field.degree() as u64);
    let Ok(q) = u64::try_from(turns.denominator_ref()) else {
        return false;
    };
    if q > 8 * degree * degree || totient(q) > 2 * degree {
        return false;
    }
    let one = Number::from(Rational::from(1));
    let x = &square * Number::from(Rational::from(2)) - &one;
    chebyshev(q, &x) == one
}

/// Euler's φ.
fn totient(n: u64) -> u64 {
    let mut rest = n;
    let mut totient = n;
    let mut p = 2;
    while p * p <= rest {
        if rest.is_multiple_of(p) {
            totient -= totient / p;
            while rest.is_multiple_of(p) {
                rest /= p;
            }
        }
        p += 1;
    }
    if rest > 1 {
        totient -= totient / rest;
    }
    totient
}

/// T_n(x), by T_(2k) = 2 T_k² - 1 and T_(2k+1) = 2 T_k T_(k+1) - x.
fn chebyshev(n: u64, x: &Number) -> Number {
    let two = Number::from(Rational::from(2));
    let one = Number::from(Rational::from(1));
    // T_k and T_(k+1)
    let (mut low, mut high) = (one.clone(), x.clone());
    for bit in (0..64 - n.leading_zeros()).rev() {
        let middle = &low * &high * &two - x;
        if n >> bit & 1 == 1 {
            high = &high * &high * &two - &one;
            low = middle;
        } else {
            low = &low * &low * &two - &one;
            high = middle;
        }
    }
    low
}

/// A rational c with few decimals, cos b <= c < cos t for b = `degrees` > t: then t is less
/// than arccos c, and arccos c is at most b. `None` if t is not less than b.
pub fn cosine_above(angle: &DihedralAngle, degrees: &Rational) -> Option<Rational> {
    let is_less = compare_with_degrees(angle, degrees) == Ordering::Less;
    is_less.then(|| {
        between(|width| {
            let (_, low) = enclosure::cos_of_degrees(degrees, width);
            let (high, _) = angle.cosine(width);
            (low, high)
        })
    })
}

/// A rational c with few decimals, cos t < c <= cos b for b = `degrees` < t.
pub fn cosine_below(angle: &DihedralAngle, degrees: &Rational) -> Option<Rational> {
    let is_more = compare_with_degrees(angle, degrees) == Ordering::Greater;
    is_more.then(|| {
        -between(|width| {
            let (low, _) = enclosure::cos_of_degrees(degrees, width);
            let (_, high) = angle.cosine(width);
            (-low, -high)
        })
    })
}

/// The shortest decimal c with low <= c < high; the ends come closer to different values as the
/// width falls, low to the smaller one.
fn between(ends: impl Fn(&Rational) -> (Rational, Rational)) -> Rational {
    let ten = Rational::from(10);
    let mut width = Rational::power_of_2(-FIRST_BITS);
    loop {
        let (low, high) = ends(&width);
        if low < high {
            let mut scale = Rational::from(1);
            loop {
                let c = Rational::from((&low * &scale).ceiling()) / &scale;
                if c < high {
                    return c;
                }
                scale *= &ten;
            }
        }
        width = &width * &width;
    }
}

impl DihedralAngle {
    /// Bounds of the cosine at most `width` apart.
    pub fn cosine(&self, width: &Rational) -> (Rational, Rational) {
        let (low, high) = self.signed_square.abs().enclosure_of_root(width);
        if self.against_right() == Ordering::Greater {
            (-high, -low)
        } else {
            (low, high)
        }
    }

    /// The angle with a rational cosine.
    pub fn of_cosine(cosine: &Rational) -> Self {
        let square = cosine * cosine;
        DihedralAngle::of_rational(if *cosine < 0 { -square } else { square })
    }
}
