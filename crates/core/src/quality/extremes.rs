//! Exact least and greatest values, over all simplices of a tiling, of the largest dihedral angle, the
//! smallest one, and the radius-edge ratio.
//!
//! Doubles propose the simplices that have them. Then all simplices are compared with the exact
//! values, by predicates with filters. The simplices that are beyond a value are few; the best
//! of them has the true extreme.

use super::measure::{DihedralAngle, RadiusEdge};
use super::ranges::{Measures, Range, Ranges, measures};
use crate::parallel;
use crate::predicates::{AnglesAgainst, Model, Predicate, RadiusAgainst, Signs};
use crate::tiling::SimplexId;
use acutile_exact::geometry::{Simplex, linear};
use acutile_exact::number::Number;
use std::collections::HashSet;

/// The exact ranges of a tiling whose simplices are positively oriented; `None` if it has none.
pub fn exact_ranges<const D: usize>(model: &Model<D>) -> Option<Ranges> {
    if model.tiling.is_empty() {
        return None;
    }
    let candidates = candidates(model);
    let measured = parallel::map_slow(&candidates, |s| measures(model.tiling, *s));
    let measured = measured.into_iter().collect::<Option<Vec<Measures>>>()?;
    let mut ranges = super::ranges::ranges(&measured)?;
    confirm_angles(model, &mut ranges)?;
    confirm_ratios(model, &mut ranges.radius_edge)?;
    Some(ranges)
}

/// Replaces each value that a simplex is beyond.
fn confirm_angles<const D: usize>(model: &Model<D>, ranges: &mut Ranges) -> Option<()> {
    let against = |angle: &DihedralAngle| AnglesAgainst::new(&angle.signed_square);
    let largest = |m: Measures| m.angles.last().cloned();
    let smallest = |m: Measures| m.angles.first().cloned();
    // The signs are those of cos t - c for all angles t of a simplex, and the cosine falls.
    let range = &mut ranges.largest_dihedral;
    let beyond = beyond(model, against(&range.max), Signs::none_negative, largest)?;
    range.max = best(&range.max, beyond, Ord::max);
    let beyond = self::beyond(model, against(&range.min), is_not_all_positive, largest)?;
    range.min = best(&range.min, beyond, Ord::min);
    let range = &mut ranges.smallest_dihedral;
    let beyond = self::beyond(model, against(&range.max), is_not_all_negative, smallest)?;
    range.max = best(&range.max, beyond, Ord::max);
    let beyond = self::beyond(model, against(&range.min), Signs::none_positive, smallest)?;
    range.min = best(&range.min, beyond, Ord::min);
    Some(())
}

fn confirm_ratios<const D: usize>(model: &Model<D>, range: &mut Range<RadiusEdge>) -> Option<()> {
    let against = |ratio: &RadiusEdge| RadiusAgainst::new(&ratio.square);
    let ratio = |m: Measures| Some(m.radius_edge);
    // The signs are those of b |e|² - R² for all edges e.
    let beyond = beyond(model, against(&range.max), Signs::none_negative, ratio)?;
    range.max = best(&range.max, beyond, Ord::max);
    let beyond = self::beyond(model, against(&range.min), is_not_all_positive, ratio)?;
    range.min = best(&range.min, beyond, Ord::min);
    Some(())
}

fn is_not_all_positive(signs: &Signs) -> bool {
    !signs.all_positive()
}

fn is_not_all_negative(signs: &Signs) -> bool {
    !signs.all_negative()
}

/// The values of the simplices for which the signs of a predicate are not as they should be.
fn beyond<P: Predicate<D>, T: Send + Sync, const D: usize>(
    model: &Model<D>,
    predicate: P,
    is_right: fn(&Signs) -> bool,
    value: fn(Measures) -> Option<T>,
) -> Option<Vec<T>> {
    let failing = model.prepare(predicate).failing(is_right);
    let values = parallel::map(failing.len(), |k| {
        value(measures(model.tiling, failing[k])?)
    });
    values.into_iter().collect()
}

fn best<T: Clone>(first: &T, others: Vec<T>, better: impl Fn(T, T) -> T) -> T {
    others.into_iter().fold(first.clone(), better)
}

/// Doubles closer than this, relatively, are compared exactly.
const SLACK: f64 = 1e-9;
/// The most candidates that are compared exactly. Others are found afterwards if they are better.
const CANDIDATES: usize = 1 << 10;

/// Simplices that seem to have an extreme value; those with equal edges once.
fn candidates<const D: usize>(model: &Model<D>) -> Vec<SimplexId> {
    let metric = FloatMetric::of(model);
    let extremes = model.fold(Extremes::NONE, |extremes, edges| {
        extremes.with(metric.values(edges))
    });
    let extremes = extremes.into_iter().fold(Extremes::NONE, Extremes::union);
    let found = model.by_chunks(|simplices| {
        let mut seen = HashSet::new();
        let mut found = Vec::new();
        for simplex in simplices.map(SimplexId::at) {
            let edges = model.float_edges(simplex);
            if extremes.has(&metric.values(edges)) {
                let bits: Vec<u64> = edges.as_flattened().iter().map(|x| x.to_bits()).collect();
                if found.len() < CANDIDATES && seen.insert(bits.clone()) {
                    found.push((simplex, bits));
                }
            }
        }
        found
    });
    let mut seen = HashSet::new();
    let mut candidates: Vec<SimplexId> = found
        .into_iter()
        .flatten()
        .filter_map(|(simplex, bits)| seen.insert(bits).then_some(simplex))
        .take(CANDIDATES)
        .collect();
    if candidates.is_empty() {
        candidates.push(SimplexId::new(0));
    }
    candidates
}

/// The metric in doubles.
struct FloatMetric<const D: usize> {
    gram: [[f64; D]; D],
    cogram: [[f64; D]; D],
}

/// The signed squares of the cosines of the largest and of the smallest angle, and the squared
/// radius-edge ratio.
type Values = [f64; 3];

impl<const D: usize> FloatMetric<D> {
    fn of(model: &Model<D>) -> Self {
        let numbers = &model.tiling.frame.gram;
        let gram = numbers
            .each_ref()
            .map(|row| row.each_ref().map(Number::approximate));
        FloatMetric {
            cogram: linear::cofactors(&gram),
            gram,
        }
    }

    /// As the arc cosine of the root falls, it is enough to keep the squares.
    #[inline]
    fn values(&self, edges: [[f64; D]; D]) -> Values {
        let simplex = Simplex::from_edges(edges);
        let products = simplex.normal_products(&self.cogram);
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        products.for_pairs(|i, j, product| {
            let square = product * product.abs();
            let cosine = -square / (products.get(i, i) * products.get(j, j));
            least = least.min(cosine);
            greatest = greatest.max(cosine);
        });
        let (numerator, denominator) = simplex.squared_circumradius(&self.gram, &products);
        let mut shortest = f64::INFINITY;
        simplex.for_squared_edges(&self.gram, |edge| shortest = shortest.min(*edge));
        [least, greatest, numerator / denominator / shortest]
    }
}

/// The least and the greatest of each value.
#[derive(Clone, Copy)]
struct Extremes {
    least: Values,
    greatest: Values,
}

impl Extremes {
    const NONE: Extremes = Extremes {
        least: [f64::INFINITY; 3],
        greatest: [f64::NEG_INFINITY; 3],
    };

    fn with(mut self, values: Values) -> Self {
        for (k, value) in values.into_iter().enumerate() {
            self.least[k] = self.least[k].min(value);
            self.greatest[k] = self.greatest[k].max(value);
        }
        self
    }

    fn union(self, other: Extremes) -> Self {
        Extremes {
            least: std::array::from_fn(|k| self.least[k].min(other.least[k])),
            greatest: std::array::from_fn(|k| self.greatest[k].max(other.greatest[k])),
        }
    }

    /// Whether one of the values may be extreme.
    fn has(&self, values: &Values) -> bool {
        (0..3).any(|k| {
            let slack = SLACK * (values[k].abs() + 1e-3);
            values[k] <= self.least[k] + slack || values[k] >= self.greatest[k] - slack
        })
    }
}
