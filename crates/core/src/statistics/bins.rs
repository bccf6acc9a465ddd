//! Bins of dihedral angles, a whole number of degrees wide.
//!
//! Let p = <g_i, g_j>, q = <g_i, g_i>, r = <g_j, g_j> be known up to e, with e <= q/16 and e <= r/16 for the
//! doubles q and r. With a = e/q and b = e/r, the factor that 1/√q is off by is within 1 ± 0.55 a. So
//! the cosine -p/√(qr) is off by at most 2 (a + b), since e/√(qr) <= (a + b)/2; doubles
//! are rounded by less than 2^-50 in addition.

use crate::predicates::{AnglesAgainst, Model, Prepared};
use crate::quality::{DihedralAngle, Exact, compare_with_degrees};
use crate::tiling::SimplexId;
use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::{Number, enclosure};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Floor, PowerOf2};
use std::ops::RangeInclusive;

/// Bins of a model's angles.
pub(super) struct Bins<'m, 't, const D: usize> {
    model: &'m Model<'t, D>,
    /// Degrees of a bin.
    width: u32,
    /// The ends of all bins but the last.
    ends: Vec<End<'m, D>>,
    /// Their cosines, which fall, up to [`ROUNDED`].
    cosines: Vec<f64>,
}

/// An end of a bin.
struct End<'m, const D: usize> {
    degrees: Rational,
    /// Compares angles with it, if the square of its cosine is rational.
    against: Option<Prepared<'m, AnglesAgainst, D>>,
}

/// No cosine of an end, and no cosine of an angle for exact products, is off by more.
const ROUNDED: f64 = 1.0 / (1u64 << 50) as f64;

impl<'m, 't, const D: usize> Bins<'m, 't, D> {
    pub fn new(model: &'m Model<'t, D>, width: u32) -> Self {
        let degrees: Vec<u32> = (1..180u32.div_ceil(width)).map(|k| k * width).collect();
        let precision = Rational::power_of_2(-60i64);
        let cosine = |degrees: &u32| {
            let (low, _) = enclosure::cos_of_degrees(&Rational::from(*degrees), &precision);
            Number::from(low).approximate()
        };
        let end = |degrees: &u32| End {
            degrees: Rational::from(*degrees),
            against: signed_square(*degrees).map(|(n, d)| {
                let square = Number::from(Rational::from_signeds(n, d));
                model.prepare(AnglesAgainst::new(&square))
            }),
        };
        Bins {
            model,
            width,
            cosines: degrees.iter().map(cosine).collect(),
            ends: degrees.iter().map(end).collect(),
        }
    }

    /// The number of bins.
    pub fn len(&self) -> usize {
        self.ends.len() + 1
    }

    /// The bins that an angle may be in, for products that are known up to `error`.
    #[inline(always)]
    pub fn of_products(
        &self,
        product: f64,
        squares: [f64; 2],
        error: f64,
    ) -> RangeInclusive<usize> {
        let [a, b] = squares.map(|square| error / square);
        // Written so that it is false for values that are no numbers.
        let is_known = squares[0] > 0.0 && squares[1] > 0.0 && a <= 0.0625 && b <= 0.0625;
        if !is_known {
            return 0..=self.len() - 1;
        }
        let cosine = -product / (squares[0].sqrt() * squares[1].sqrt());
        let error = 2.0 * (a + b) + 4.0 * ROUNDED;
        let bin = |cosine: f64| self.cosines.partition_point(|end| *end >= cosine);
        let first = bin(cosine + error);
        let is_inside = self
            .cosines
            .get(first)
            .is_none_or(|end| cosine - error > *end);
        let last = if is_inside {
            first
        } else {
            bin(cosine - error)
        };
        first..=last
    }

    /// The bin of an angle, one of some: angles at the end of a bin are in the next one.
    #[cold]
    pub fn decide(
        &self,
        simplex: SimplexId,
        pair: (usize, (usize, usize)),
        bins: RangeInclusive<usize>,
    ) -> usize {
        let (mut bin, mut last) = bins.into_inner();
        let exact = || exact_angle(self.model, simplex, pair.1);
        if last - bin > 1 {
            let (low, high) = exact().enclosure(&Rational::from_signeds(1, 1_000_000_000));
            let of = |degrees: Rational| {
                let bin = (degrees / Rational::from(self.width)).floor();
                usize::try_from(&bin).map_or(0, |bin| bin.min(self.len() - 1))
            };
            (bin, last) = (of(low), of(high));
        }
        while bin < last && !self.is_below(&self.ends[bin], simplex, pair.0, exact) {
            bin += 1;
        }
        bin
    }

    fn is_below(
        &self,
        end: &End<D>,
        simplex: SimplexId,
        index: usize,
        exact: impl Fn() -> DihedralAngle,
    ) -> bool {
        match &end.against {
            // The sign is that of the difference of the cosines, which fall.
            Some(against) => against.signs(simplex).get(index) == Sign::Greater,
            None => compare_with_degrees(&exact(), &end.degrees).is_lt(),
        }
    }
}

/// cos t |cos t| as a fraction for the whole degrees between 0 and 180 for which it is rational.
fn signed_square(degrees: u32) -> Option<(i64, i64)> {
    Some(match degrees {
        30 => (3, 4),
        45 => (1, 2),
        60 => (1, 4),
        90 => (0, 1),
        120 => (-1, 4),
        135 => (-1, 2),
        150 => (-3, 4),
        _ => return None,
    })
}

/// The angle in the tiling's own numbers.
fn exact_angle<const D: usize>(
    model: &Model<D>,
    simplex: SimplexId,
    (i, j): (usize, usize),
) -> DihedralAngle {
    let cogram = linear::cofactors(&model.tiling.frame.gram);
    let products = model.tiling.shape(simplex).normal_products(&cogram);
    DihedralAngle::between(&products, i, j).expect("flat simplices are left out")
}
