//! Bounds in short decimals for the angles and ratios of a tiling.
//!
//! Doubles propose them; whoever claims one proves it. Each list has the tightest
//! bound that can hold first, and then a few looser ones, for rounding may have
//! hidden a value just beyond the first.

use crate::geometry::{Simplex, linear};
use crate::number::Number;
use crate::tiling::Tiling;
use malachite::Rational;

/// Candidates, tightest first.
#[derive(Clone, Debug)]
pub struct Bounds {
    /// Whole hundredths of a degree, more than every dihedral angle.
    pub above_angles: Vec<Rational>,
    /// Whole hundredths of a degree, less than every dihedral angle.
    pub below_angles: Vec<Rational>,
    /// Whole thousandths, more than every radius-edge ratio.
    pub above_ratios: Vec<Rational>,
}

/// How far a double may be off before the tightest bound is missed.
const SLACK: f64 = 1e-6;
/// How many bounds are proposed.
const CHOICES: i64 = 3;

/// Candidates for the bounds of `tiling`.
pub fn bounds<const D: usize>(tiling: &Tiling<D>) -> Bounds {
    let extremes = Extremes::of(tiling);
    let largest = ((extremes.largest - SLACK) * 100.0).floor() as i64 + 1;
    let smallest = ((extremes.smallest + SLACK) * 100.0).ceil() as i64 - 1;
    let ratio = ((extremes.ratio - SLACK) * 1000.0).floor() as i64 + 1;
    let fraction = |n: i64, d: i64| Rational::from_signeds(n, d);
    let degrees = |n: i64| (n > 0 && n <= 18_000).then(|| fraction(n, 100));
    Bounds {
        above_angles: (0..CHOICES).filter_map(|k| degrees(largest + k)).collect(),
        below_angles: (0..CHOICES).filter_map(|k| degrees(smallest - k)).collect(),
        above_ratios: (0..CHOICES)
            .map(|k| fraction((ratio + k).max(1), 1000))
            .collect(),
    }
}

/// Extreme values in floating point.
struct Extremes {
    smallest: f64,
    largest: f64,
    ratio: f64,
}

impl Extremes {
    fn of<const D: usize>(tiling: &Tiling<D>) -> Self {
        let gram = tiling
            .frame
            .gram
            .each_ref()
            .map(|row| row.each_ref().map(Number::approximate));
        let cogram = linear::cofactors(&gram);
        let mut extremes = Extremes {
            smallest: 180.0,
            largest: 0.0,
            ratio: 0.0,
        };
        for corners in tiling.simplices() {
            // Differences are exact before they are rounded: coordinates may be large.
            let origin = tiling.position(&corners[0]);
            let points: Vec<[f64; D]> = corners
                .iter()
                .map(|c| linear::subtract(&tiling.position(c), &origin).map(|x| x.approximate()))
                .collect();
            extremes.include(&Simplex::new(&points), &gram, &cogram);
        }
        extremes
    }

    fn include<const D: usize>(
        &mut self,
        simplex: &Simplex<f64, D>,
        gram: &[[f64; D]; D],
        cogram: &[[f64; D]; D],
    ) {
        let products = simplex.normal_products(cogram);
        for (i, j, product) in products.pairs() {
            let cosine = -product / (products.get(i, i) * products.get(j, j)).sqrt();
            let degrees = cosine.clamp(-1.0, 1.0).acos().to_degrees();
            self.smallest = self.smallest.min(degrees);
            self.largest = self.largest.max(degrees);
        }
        let (numerator, denominator) = simplex.squared_circumradius(gram, &products);
        let shortest = simplex
            .squared_edges(gram)
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        self.ratio = self.ratio.max((numerator / denominator / shortest).sqrt());
    }
}
