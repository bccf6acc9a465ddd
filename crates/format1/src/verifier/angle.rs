//! `all dihedral angles below Q` and `above Q`: a rational enclosure of cos Q° and a
//! comparison of squares.

use super::Refusal;
use super::geometry::facet_pairs;
use super::integer::Integer;
use super::number::Rational;
use super::ring::Element;
use super::simplex::{Judge, Simplex};
use super::tiling::Tiling;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// Every dihedral angle is less than Q degrees: cos θ_ij > cos Q°, where
/// cos θ_ij = -g_i · g_j / (|g_i| |g_j|). With low <= cos Q° <= high it is proved by
/// cos θ_ij > high and disproved by cos θ_ij <= low.
pub(super) fn judge_below<'t>(tiling: &'t Tiling) -> Option<Judge<'t>> {
    let angle = tiling.bounds.below.as_ref()?;
    let c = Cosine::of_degrees(angle);
    let bounds = c.bounds(tiling, |c| &c.high, |c| &c.low);
    let refuse = move |simplex, facets| Refusal::AngleNotBelow {
        simplex,
        facets,
        degrees: angle.to_string(),
    };
    Some(Box::new(compare_cosines(
        tiling,
        angle,
        Ordering::Greater,
        bounds,
        refuse,
    )))
}

/// Every dihedral angle is more than Q degrees: cos θ_ij < cos Q°. It is proved by
/// cos θ_ij < low and disproved by cos θ_ij >= high.
pub(super) fn judge_above<'t>(tiling: &'t Tiling) -> Option<Judge<'t>> {
    let angle = tiling.bounds.above.as_ref()?;
    let c = Cosine::of_degrees(angle);
    let bounds = c.bounds(tiling, |c| &c.low, |c| &c.high);
    let refuse = move |simplex, facets| Refusal::AngleNotAbove {
        simplex,
        facets,
        degrees: angle.to_string(),
    };
    Some(Box::new(compare_cosines(
        tiling,
        angle,
        Ordering::Less,
        bounds,
        refuse,
    )))
}

/// Every cos θ_ij is on the `wanted` side of one of the bounds that prove it. Where one is
/// not even on that side of the bound that is needed, the statement is false.
fn compare_cosines<'t>(
    tiling: &'t Tiling,
    angle: &'t Rational,
    wanted: Ordering,
    (proving, needed): (Vec<Bound>, Bound),
    refuse: impl Fn(usize, (usize, usize)) -> Refusal + 't,
) -> impl Fn(&Simplex) -> Result<(), Refusal> + 't {
    move |simplex| {
        let products = &simplex.gradients;
        'angles: for facets @ (i, j) in facet_pairs(tiling.dimension()) {
            let square = tiling.ring.times(&products[i][i], &products[j][j]);
            let negated = Element::default().minus(&products[i][j]);
            let of = || {
                let simplex = simplex.index;
                format!("cosine of facets {i} and {j} of simplex {simplex}, compared")
            };
            let is_within = |bound| Ok(compare(tiling, &negated, &square, bound, of)? == wanted);
            for bound in &proving {
                if is_within(bound)? {
                    continue 'angles;
                }
            }
            return Err(match is_within(&needed)? {
                false => refuse(simplex.index, facets),
                true => Refusal::AngleUndecided {
                    simplex: simplex.index,
                    facets,
                    degrees: angle.to_string(),
                },
            });
        }
        Ok(())
    }
}

/// c = p/q with q > 0, as it is compared with.
struct Bound {
    sign: Ordering,
    /// p²
    numerator: Element,
    /// q²
    denominator: Element,
}

impl Bound {
    fn new(p: &BigInt, q: &BigInt) -> Bound {
        let square = |n: &BigInt| Element::integer(Integer::from(n * n));
        Bound {
            sign: p.cmp(&BigInt::zero()),
            numerator: square(p),
            denominator: square(q),
        }
    }
}

/// How x compares with c sqrt(y), for y > 0 and c = p/q, q > 0. Where the signs
/// of x and c differ they decide. Where both are positive, x² q² - p² y has the
/// sign of x - c sqrt(y); where both are negative, the opposite sign.
fn compare(
    tiling: &Tiling,
    x: &Element,
    y: &Element,
    c: &Bound,
    of: impl Fn() -> String,
) -> Result<Ordering, Refusal> {
    let sign = tiling.sign(x, &Integer::ONE, &of)?;
    if sign != c.sign || sign == Ordering::Equal {
        return Ok(sign.cmp(&c.sign));
    }
    let ring = &tiling.ring;
    let square = ring.times(x, x);
    let difference = ring.sum([(false, &square, &c.denominator), (true, y, &c.numerator)]);
    let difference = tiling.sign(&difference, &Integer::ONE, of)?;
    Ok(if sign == Ordering::Less {
        difference.reverse()
    } else {
        difference
    })
}

/// cos Q° lies in [low, high] / denominator.
struct Cosine {
    low: BigInt,
    high: BigInt,
    denominator: BigInt,
}

impl Cosine {
    /// For 0 <= Q <= 180. The rational cosines of rational degrees (Niven's
    /// theorem) are exact, so that 60° is known not to be below 60°.
    fn of_degrees(degrees: &Rational) -> Cosine {
        for (angle, doubled) in [(0, 2), (60, 1), (90, 0), (120, -1), (180, -2)] {
            if *degrees == Rational::from_integer(BigInt::from(angle)) {
                let exact = BigInt::from(doubled);
                return Cosine {
                    low: exact.clone(),
                    high: exact,
                    denominator: BigInt::from(2),
                };
            }
        }
        enclose_cosine(degrees)
    }

    /// The ends that prove, of which each suffices, and the end that is needed. The first is rounded to
    /// few bits; over a field it is not tried, for there each sign asked is counted.
    fn bounds(&self, tiling: &Tiling, proving: End, needed: End) -> (Vec<Bound>, Bound) {
        let bound = |cosine: &Cosine, end: End| Bound::new(end(cosine), &cosine.denominator);
        let mut bounds = vec![bound(self, proving)];
        if tiling.ring.degree() == 1 {
            bounds.insert(0, bound(&self.rough(), proving));
        }
        (bounds, bound(self, needed))
    }

    /// An enclosure of the enclosure, in units of 2^-24.
    fn rough(&self) -> Cosine {
        let unit = BigInt::one() << 24u8;
        let [low, high] = [&self.low, &self.high].map(|end| end * &unit);
        Cosine {
            low: low.div_floor(&self.denominator),
            high: high.div_ceil(&self.denominator),
            denominator: unit,
        }
    }
}

/// `low` or `high`.
type End = fn(&Cosine) -> &BigInt;

/// Fixed point: a real number x is enclosed by integers l, h with l <= 2^BITS x <= h.
const BITS: usize = 128;

/// With θ = Q π/180 in [l, h], both in units of 2^-BITS: cos l is enclosed, and
/// |cos θ - cos l| <= h - l widens it.
fn enclose_cosine(degrees: &Rational) -> Cosine {
    let (pi_low, pi_high) = enclose_pi();
    let denominator = degrees.denom() * BigInt::from(180);
    let theta_low = (degrees.numer() * pi_low).div_floor(&denominator);
    let theta_high = (degrees.numer() * pi_high).div_ceil(&denominator);
    let (low, high) = taylor_cosine(&theta_low);
    let width = theta_high - theta_low;
    Cosine {
        low: low - &width,
        high: high + width,
        denominator: BigInt::one() << BITS,
    }
}

/// cos t = 1 - t²/2! + t⁴/4! - … for 0 <= t < 4. Each term is enclosed; after
/// TERMS of them the remainder is at most the next one (Lagrange).
fn taylor_cosine(t: &BigInt) -> (BigInt, BigInt) {
    const TERMS: usize = 48;
    let square = t * t;
    let unit = BigInt::one() << BITS;
    let (mut least, mut most) = (unit.clone(), unit.clone());
    let (mut low, mut high) = (unit.clone(), unit);
    for k in 1..=TERMS {
        let divisor = BigInt::from((2 * k - 1) * (2 * k)) << (2 * BITS);
        least = (least * &square).div_floor(&divisor);
        most = (most * &square).div_ceil(&divisor);
        let minus = k % 2 == 1;
        low += if minus { -&most } else { least.clone() };
        high += if minus { -&least } else { most.clone() };
    }
    // Here t² < (2 TERMS + 1)(2 TERMS + 2), so the next term is below the last.
    (low - &most, high + most)
}

/// π = 16 arctan(1/5) - 4 arctan(1/239) (Machin).
fn enclose_pi() -> (BigInt, BigInt) {
    let (a, b) = (enclose_arctan_inverse(5), enclose_arctan_inverse(239));
    (a.0 * 16 - b.1 * 4, a.1 * 16 - b.0 * 4)
}

/// arctan(1/n) = 1/n - 1/(3n³) + 1/(5n⁵) - … for n > 1: the terms alternate and
/// decrease, so the remainder is at most the next one, hence the last.
fn enclose_arctan_inverse(n: u32) -> (BigInt, BigInt) {
    const TERMS: u32 = 64;
    let unit = BigInt::one() << BITS;
    let (mut low, mut high) = (BigInt::zero(), BigInt::zero());
    let mut last = unit.clone();
    for k in 0..TERMS {
        let divisor = BigInt::from(n).pow(2 * k + 1) * (2 * k + 1);
        let (least, most) = (unit.div_floor(&divisor), unit.div_ceil(&divisor));
        low += if k % 2 == 0 { least.clone() } else { -&most };
        high += if k % 2 == 0 { most.clone() } else { -&least };
        last = most;
    }
    (low - &last, high + last)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::Signed;

    /// The first 50 digits of π, from the literature (OEIS A000796).
    const PI: &str = "314159265358979323846264338327950288419716939937510";

    #[test]
    fn pi_is_enclosed_to_within_a_few_units() {
        let (low, high) = enclose_pi();
        let ten = BigInt::from(10u8).pow(50);
        let pi: BigInt = PI.parse().unwrap();
        assert!(&low * &ten <= (&pi + 1) << BITS && pi << BITS <= &high * ten);
        assert!(high - low < BigInt::from(10_000));
    }

    #[test]
    fn cosines_of_known_angles_are_enclosed() {
        // cos 36° = (1 + sqrt 5)/4, so (4 cos 36° - 1)² = 5; cos 45°² = 1/2;
        // cos 135° = -cos 45°; cos 72° = (sqrt 5 - 1)/4.
        let five = |c: &BigInt, sign: i32| {
            let unit = BigInt::one() << BITS;
            let root: BigInt = c * 4 - &unit * sign;
            (&root * &root).cmp(&(&unit * &unit * 5))
        };
        let of = |n: u32| enclose_cosine(&Rational::from_integer(BigInt::from(n)));
        let (c36, c72) = (of(36), of(72));
        assert_eq!(
            (five(&c36.low, 1), five(&c36.high, 1)),
            (Ordering::Less, Ordering::Greater)
        );
        assert_eq!(
            (five(&c72.low, -1), five(&c72.high, -1)),
            (Ordering::Less, Ordering::Greater)
        );
        let (c45, c135) = (of(45), of(135));
        let half = BigInt::one() << (2 * BITS - 1);
        assert!(&c45.low * &c45.low < half && half < &c45.high * &c45.high);
        assert!(&c135.high * &c135.high < half && half < &c135.low * &c135.low);
        assert!(c135.high.is_negative() && c45.low.is_positive());
    }

    #[test]
    fn general_enclosures_contain_the_exact_cosines_and_are_narrow() {
        for angle in [0u8, 60, 90, 120, 180] {
            let degrees = Rational::from_integer(BigInt::from(angle));
            let (exact, wide) = (Cosine::of_degrees(&degrees), enclose_cosine(&degrees));
            assert!(wide.low.clone() * 2 <= exact.low.clone() << BITS);
            assert!(exact.high << BITS <= wide.high.clone() * 2);
            assert!(wide.high - wide.low < BigInt::from(100_000), "{angle}");
        }
    }
}
