//! Bounds in short decimals for the angles and ratios of a tiling.
//!
//! Doubles propose them; whoever claims one proves it. Each list has the tightest
//! bound that can hold first, and then a few looser ones, for rounding may have
//! hidden a value just beyond the first.

use crate::predicates::Model;
use acutile_exact::geometry::{Simplex, linear};
use acutile_exact::number::Number;
use malachite::Rational;
use rayon::iter::ParallelIterator;

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

/// Candidates for the bounds of a tiling.
pub fn bounds<const D: usize>(model: &Model<D>) -> Bounds {
    let extremes = Extremes::of(model);
    let largest = ((degrees(extremes.least_cosine) - SLACK) * 100.0).floor() as i64 + 1;
    let smallest = ((degrees(extremes.greatest_cosine) + SLACK) * 100.0).ceil() as i64 - 1;
    // Beyond all integers where a circumradius is 10^16 times an edge.
    let ratio = (((extremes.ratio.sqrt() - SLACK) * 1000.0).floor() as i64).saturating_add(1);
    let fraction = |n: i64, d: i64| Rational::from_signeds(n, d);
    let hundredths = |n: i64| (n > 0 && n <= 18_000).then(|| fraction(n, 100));
    Bounds {
        above_angles: (0..CHOICES)
            .filter_map(|k| hundredths(largest + k))
            .collect(),
        below_angles: (0..CHOICES)
            .filter_map(|k| hundredths(smallest - k))
            .collect(),
        above_ratios: (0..CHOICES)
            .map(|k| fraction(ratio.saturating_add(k).max(1), 1000))
            .collect(),
    }
}

/// Extreme values in floating point: signed squares of cosines, and squared ratios.
#[derive(Clone, Copy)]
struct Extremes {
    /// Of the largest angle.
    least_cosine: f64,
    /// Of the smallest angle.
    greatest_cosine: f64,
    ratio: f64,
}

impl Extremes {
    const NONE: Extremes = Extremes {
        least_cosine: 1.0,
        greatest_cosine: -1.0,
        ratio: 0.0,
    };

    fn of<const D: usize>(model: &Model<D>) -> Self {
        let numbers = &model.tiling.frame.gram;
        let gram = numbers
            .each_ref()
            .map(|row| row.each_ref().map(Number::approximate));
        let cogram = linear::cofactors(&gram);
        let extremes = model.fold(Extremes::NONE, |extremes, edges| {
            extremes.with(&Simplex::from_edges(edges), &gram, &cogram)
        });
        extremes.reduce(|| Extremes::NONE, Extremes::union)
    }

    /// As the arc cosine of the root falls, it is enough to keep the squares.
    fn with<const D: usize>(
        mut self,
        simplex: &Simplex<f64, D>,
        gram: &[[f64; D]; D],
        cogram: &[[f64; D]; D],
    ) -> Self {
        let products = simplex.normal_products(cogram);
        for (i, j, product) in products.pairs() {
            let square = product * product.abs();
            let cosine = -square / (products.get(i, i) * products.get(j, j));
            self.least_cosine = self.least_cosine.min(cosine);
            self.greatest_cosine = self.greatest_cosine.max(cosine);
        }
        let (numerator, denominator) = simplex.squared_circumradius(gram, &products);
        let mut shortest = f64::INFINITY;
        simplex.for_squared_edges(gram, |edge| shortest = shortest.min(*edge));
        self.ratio = self.ratio.max(numerator / denominator / shortest);
        self
    }

    fn union(self, other: Extremes) -> Self {
        Extremes {
            least_cosine: self.least_cosine.min(other.least_cosine),
            greatest_cosine: self.greatest_cosine.max(other.greatest_cosine),
            ratio: self.ratio.max(other.ratio),
        }
    }
}

/// The angle in degrees whose cosine has this signed square.
fn degrees(square: f64) -> f64 {
    let cosine = square.abs().sqrt().copysign(square);
    cosine.clamp(-1.0, 1.0).acos().to_degrees()
}
