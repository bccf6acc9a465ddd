//! Dihedral angles in degrees, as rational intervals.

use crate::geometry::{NormalProducts, Scalar, Sign, Simplex, linear};
use crate::number::{Number, enclosure};
use crate::tiling::Tiling;
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, FloorSqrt, UnsignedAbs};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Rational};

/// The width of angle enclosures in messages: 1e-6 degrees.
pub fn display_width() -> Rational {
    Rational::from_signeds(1, 1_000_000)
}

/// The dihedral angle between two facets, enclosed in an interval of at most the
/// given width, in degrees.
///
/// cos t = -p / sqrt(q) with p = <g_i, g_j> and q = <g_i, g_i> <g_j, g_j>, so
/// |cos t| is the root of the field element p² / q in [0, 1].
pub fn dihedral_degrees(
    products: &NormalProducts<Number>,
    (i, j): (usize, usize),
    width: &Rational,
) -> (Rational, Rational) {
    let p = products.get(i, j);
    let q = products.get(i, i) * products.get(j, j);
    let ratio = (p * p).divide(&q).unwrap_or_else(|| p.integer(0));
    let acute = p.sign() != Sign::Greater;
    let mut precision = width / Rational::from(1000);
    loop {
        let (low, high) = square_root(&ratio, &precision);
        let cosine = if acute { (low, high) } else { (-high, -low) };
        let degrees = enclosure::acos_degrees(&cosine.0, &cosine.1, width);
        // Near 0 and 180 degrees the arc cosine magnifies without bound.
        if &degrees.1 - &degrees.0 <= *width || precision < FINEST_COSINE {
            return degrees;
        }
        precision /= Rational::from(1000);
    }
}

/// No cosine is enclosed more tightly; only an angle within about 1e-30 degrees of
/// 0 or 180 comes here.
const FINEST_COSINE: f64 = 1e-60;

/// The square root of a number in [0, 1], enclosed in at most about the width.
fn square_root(square: &Number, width: &Rational) -> (Rational, Rational) {
    // sqrt(b) - sqrt(a) <= sqrt(b - a)
    let (low, high) = square.enclosure(&(width * width / Rational::from(4)));
    let scale = (Rational::from(4) / width).ceiling().unsigned_abs();
    let scale_squared = Rational::from(&scale * &scale);
    let root = |integer: Integer| Integer::from(integer.unsigned_abs().floor_sqrt());
    let low = root((low.max(Rational::ZERO) * &scale_squared).floor());
    let high = root((high * scale_squared).ceiling()) + Integer::ONE;
    let scale = Rational::from(scale);
    (
        Rational::from(low) / &scale,
        (Rational::from(high) / scale).min(Rational::ONE),
    )
}

/// A dihedral angle by its place, and its cosine in floating point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The simplex.
    pub simplex: usize,
    /// The two facets.
    pub facets: (usize, usize),
    /// About the cosine of the angle.
    pub cosine: f64,
}

/// The angle that is largest in floating point: a candidate, nothing proved.
pub fn largest_angles<const D: usize>(tiling: &Tiling<D>) -> Option<Candidate> {
    let gram = tiling
        .frame
        .gram
        .each_ref()
        .map(|row| row.each_ref().map(Number::approximate));
    let cogram = linear::cofactors(&gram);
    let vertices: Vec<[f64; D]> = tiling
        .vertices
        .iter()
        .map(|v| v.each_ref().map(Number::approximate))
        .collect();
    let mut largest: Option<Candidate> = None;
    for (simplex, corners) in tiling.simplices().enumerate() {
        let points: Vec<[f64; D]> = corners
            .iter()
            .map(|c| {
                std::array::from_fn(|k| vertices[c.vertex as usize][k] + f64::from(c.shift[k]))
            })
            .collect();
        let products = Simplex::new(&points).normal_products(&cogram);
        for (i, j, product) in products.pairs() {
            let cosine = -product / (products.get(i, i) * products.get(j, j)).sqrt();
            if largest.is_none_or(|angle| cosine < angle.cosine) {
                largest = Some(Candidate {
                    simplex,
                    facets: (i, j),
                    cosine,
                });
            }
        }
    }
    largest
}

/// Bounds in whole hundredths of a degree, in increasing order, of which the first
/// that can be proved is the least that holds: the largest angle's enclosure starts
/// below the first one and rounding can have hidden a larger angle only just above.
pub fn least_bounds<const D: usize>(tiling: &Tiling<D>) -> impl Iterator<Item = Rational> + use<D> {
    let hundredths = largest_angles(tiling).map_or(18_000, |largest| {
        let degrees = largest.cosine.clamp(-1.0, 1.0).acos().to_degrees();
        ((degrees - 1e-6) * 100.0).floor() as i64 + 1
    });
    (hundredths..=(hundredths + 2).min(18_000)).map(|n| Rational::from_signeds(n, 100))
}
