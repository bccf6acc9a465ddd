//! Dihedral angles as cosines in the ring, compared and sorted into bins exactly.

use super::extreme::Compare;
use crate::quality::{DihedralAngle, Exact};
use acutile_exact::geometry::{NormalProducts, Scalar, Sign};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;

/// The cosine -p / √(q_i q_j) of a dihedral angle, with p = <g_i, g_j> and q_i = <g_i, g_i>.
#[derive(Clone)]
pub struct Cosine<S> {
    /// The sign of the cosine.
    sign: Sign,
    /// p
    product: S,
    /// q_i and q_j
    squares: [S; 2],
}

impl<S: Scalar> Cosine<S> {
    pub fn between<const D: usize>(
        products: &NormalProducts<S, D>,
        (i, j): (usize, usize),
    ) -> Self {
        let product = products.get(i, j).clone();
        Cosine {
            sign: product.sign().reverse(),
            product,
            squares: [products.get(i, i).clone(), products.get(j, j).clone()],
        }
    }

    /// The angle in degrees, at most 1e-5 off; NaN beyond the range of doubles.
    pub fn degrees(&self) -> f64 {
        let [a, b] = self.squares.each_ref().map(|q| q.approximate().sqrt());
        let cosine = -self.product.approximate() / a / b;
        cosine.clamp(-1.0, 1.0).acos().to_degrees()
    }

    /// cos² t compared with n/d.
    fn square_against(&self, n: i64, d: i64) -> Sign {
        let p = &self.product;
        let left = p.times(p).times(&p.integer(d));
        let right = self.squares[0].times(&self.squares[1]).times(&p.integer(n));
        left.minus(&right).sign()
    }

    /// The angle t compared with one whose cosine has this sign and the square n/d.
    fn against(&self, sign: Sign, n: i64, d: i64) -> Sign {
        let cosines = match (self.sign, sign) {
            (a, b) if a != b => a.cmp(&b),
            (Sign::Less, _) => self.square_against(n, d).reverse(),
            _ => self.square_against(n, d),
        };
        cosines.reverse()
    }
}

/// By the size of the angle.
impl<S: Scalar> Compare for Cosine<S> {
    fn compare(&self, other: &Self) -> Sign {
        if self.sign != other.sign {
            return other.sign.cmp(&self.sign);
        }
        let part = |a: &Self, b: &Self| {
            let square = a.product.times(&a.product);
            square.times(&b.squares[0]).times(&b.squares[1])
        };
        let squares = part(self, other).minus(&part(other, self)).sign();
        match self.sign {
            Sign::Greater => squares.reverse(),
            Sign::Equal => Sign::Equal,
            Sign::Less => squares,
        }
    }
}

/// Bins of a whole number of degrees each.
pub struct Bins {
    width: u32,
}

/// An angle closer to the end of a bin than this is compared exactly.
const NEAR: f64 = 1e-4;

impl Bins {
    pub fn new(width: u32) -> Self {
        Bins { width }
    }

    /// The index k of the bin [k w, (k + 1) w) of an angle that is about `degrees`; `exact` gives
    /// it where a boundary is not among those that squares of cosines decide.
    pub fn of<S: Scalar>(
        &self,
        cosine: &Cosine<S>,
        degrees: f64,
        exact: impl Fn() -> DihedralAngle,
    ) -> usize {
        let width = f64::from(self.width);
        let end = (degrees / width).round();
        if (degrees - end * width).abs() > NEAR {
            return (degrees / width).floor() as usize;
        }
        let is_below = |bin: u32| compared(cosine, bin * self.width, &exact).is_lt();
        // NaN casts to zero and counts up from there; 180 degrees are no angle.
        let mut bin = (end as u32).min(180 / self.width - 1);
        while bin > 0 && is_below(bin) {
            bin -= 1;
        }
        while (bin + 1) * self.width < 180 && !is_below(bin + 1) {
            bin += 1;
        }
        bin as usize
    }
}

/// The angle compared with so many whole degrees.
fn compared<S: Scalar>(
    cosine: &Cosine<S>,
    degrees: u32,
    exact: &impl Fn() -> DihedralAngle,
) -> Sign {
    match degrees {
        30 => cosine.against(Sign::Greater, 3, 4),
        45 => cosine.against(Sign::Greater, 1, 2),
        60 => cosine.against(Sign::Greater, 1, 4),
        90 => cosine.against(Sign::Equal, 0, 1),
        120 => cosine.against(Sign::Less, 1, 4),
        135 => cosine.against(Sign::Less, 1, 2),
        150 => cosine.against(Sign::Less, 3, 4),
        _ => compared_by_bounds(&exact(), &Rational::from(degrees)),
    }
}

/// An angle that is not equal to a multiple of 15, 18 or 22.5 degrees, which are recognised, is
/// apart from all of them; whole degrees beyond those are no angle of a quadratic field, and one that
/// is not told apart from its bound with 30 digits counts as equal to it.
fn compared_by_bounds(angle: &DihedralAngle, degrees: &Rational) -> Sign {
    if let Some(value) = angle.rational() {
        return value.cmp(degrees);
    }
    for digits in [9i64, 18, 30] {
        let width = Rational::from(10).pow(-digits);
        let (low, high) = angle.enclosure(&width);
        if low > *degrees || high < *degrees {
            return low.cmp(degrees);
        }
    }
    Sign::Equal
}
