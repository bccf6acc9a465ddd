//! Dihedral angles in degrees, as rational intervals.

use super::measure::{DihedralAngle, Exact};
use crate::geometry::{NormalProducts, Simplex, linear};
use crate::number::Number;
use crate::tiling::Tiling;
use malachite::Rational;

/// The width of angle enclosures in messages: 1e-6 degrees.
pub fn display_width() -> Rational {
    Rational::from_signeds(1, 1_000_000)
}

/// The dihedral angle between two facets, enclosed in an interval of at most the
/// given width, in degrees.
pub fn dihedral_degrees(
    products: &NormalProducts<Number>,
    (i, j): (usize, usize),
    width: &Rational,
) -> (Rational, Rational) {
    DihedralAngle::between(products, i, j).enclosure(width)
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
