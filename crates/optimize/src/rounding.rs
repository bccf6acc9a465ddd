//! Parameters on a grid: rounded, then improved by moves of one step, alone and in pairs.
//!
//! Candidates are compared by their six worst values in lexicographic order. The best candidate of the
//! doubles is only proposed here; exact arithmetic decides about it.

use crate::descent::Watch;
use crate::model::{Model, Patch};
use acutile_exact::number::Number;
use malachite::Integer;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// Parameters as integers over denominators.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// One denominator for each parameter.
    pub denominators: Vec<u64>,
}

/// Values that are compared, worst first.
type Key = [f64; 6];

/// Values closer than this count as equal: doubles do not distinguish them.
const SAME: f64 = 1e-13;
/// The number of parameters that take part in moves of pairs.
const PAIRED: usize = 16;
/// About the greatest number of simplices that are evaluated for moves.
const WORK: usize = 1 << 20;

impl Grid {
    /// The nearest points of the grid.
    pub fn nearest(&self, parameters: &[f64]) -> Vec<Integer> {
        let integer = |(x, d): (&f64, &u64)| {
            let scaled = x * *d as f64;
            if scaled.is_finite() {
                Integer::rounding_from(scaled, RoundingMode::Nearest).0
            } else {
                Integer::from(0)
            }
        };
        parameters
            .iter()
            .zip(&self.denominators)
            .map(integer)
            .collect()
    }

    /// The numbers of a point of the grid.
    pub fn numbers(&self, integers: &[Integer]) -> Vec<Number> {
        let number = |(n, d): (&Integer, &u64)| {
            Number::from(Rational::from_integers(n.clone(), Integer::from(*d)))
        };
        integers
            .iter()
            .zip(&self.denominators)
            .map(number)
            .collect()
    }

    /// The denominator of the Gram matrix, and that of coordinates.
    pub fn stated(&self, model: &Model) -> (Option<u64>, Option<u64>) {
        let (gram, points) = self.denominators.split_at(model.gram_parameters);
        (gram.first().copied(), points.first().copied())
    }

    fn doubles(&self, integers: &[Integer]) -> Vec<f64> {
        self.numbers(integers)
            .iter()
            .map(Number::approximate)
            .collect()
    }

    /// A point of the grid near `parameters`, improved by moves of one step.
    pub fn improved(&self, model: &Model, parameters: &[f64], watch: Watch) -> Vec<Integer> {
        let everything = model.everything();
        let mut point = self.nearest(parameters);
        let mut best = key(model, &everything, &self.doubles(&point));
        let enough = model.goal.enough();
        let mut budget = WORK / model.len().max(1);
        // Each move makes the key less, so no point comes again.
        while best.is_none_or(|key| key[0] > enough)
            && watch(best.map_or(f64::INFINITY, |key| key[0]))
        {
            let found = self.better_neighbour(model, &point, best, &mut budget);
            let Some((better, key)) = found else {
                break;
            };
            (point, best) = (better, Some(key));
        }
        point
    }

    /// The first better point: a move of one parameter, or of two.
    fn better_neighbour(
        &self,
        model: &Model,
        point: &[Integer],
        best: Option<Key>,
        budget: &mut usize,
    ) -> Option<(Vec<Integer>, Key)> {
        let everything = &model.everything();
        let start = self.doubles(point);
        let chosen = worst_parameters(model, everything, &start);
        let mut attempt = |changes: &[(usize, i64)]| {
            *budget = budget.checked_sub(1)?;
            let mut doubles = start.clone();
            for (k, step) in changes {
                doubles[*k] += *step as f64 / self.denominators[*k] as f64;
            }
            let key = key(model, everything, &doubles)?;
            best.is_none_or(|best| is_less(&key, &best)).then(|| {
                let mut moved = point.to_vec();
                for (k, step) in changes {
                    moved[*k] += Integer::from(*step);
                }
                (moved, key)
            })
        };
        let steps = [1, -1];
        let singles = chosen.iter().flat_map(|k| steps.map(|s| (*k, s)));
        let found = singles.clone().find_map(|change| attempt(&[change]));
        found.or_else(|| {
            let few: Vec<(usize, i64)> = singles.take(2 * PAIRED).collect();
            let pairs = few.iter().flat_map(|a| few.iter().map(move |b| (*a, *b)));
            pairs
                .filter(|(a, b)| a.0 < b.0)
                .find_map(|(a, b)| attempt(&[a, b]))
        })
    }
}

/// The parameters of the simplices with the worst values, in that order.
fn worst_parameters(model: &Model, everything: &Patch, parameters: &[f64]) -> Vec<usize> {
    let Some(mut values) = model.values(everything, parameters) else {
        return everything.free.clone();
    };
    let worst = |values: &[f64; 6]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    values.sort_by(|a, b| worst(&b.1).total_cmp(&worst(&a.1)));
    let mut chosen = Vec::new();
    for (simplex, _) in values.into_iter().take(6) {
        for parameter in model.parameters_of_simplex(simplex) {
            if !chosen.contains(&parameter) {
                chosen.push(parameter);
            }
        }
    }
    chosen
}

/// The six worst values; `None` if a simplex is not positively oriented.
fn key(model: &Model, everything: &Patch, parameters: &[f64]) -> Option<Key> {
    let mut key = [f64::NEG_INFINITY; 6];
    for (_, values) in model.values(everything, parameters)? {
        for value in values {
            if value > key[5] {
                let place = key.partition_point(|x| *x >= value);
                key[place..].rotate_right(1);
                key[place] = value;
            }
        }
    }
    Some(key)
}

fn is_less(a: &Key, b: &Key) -> bool {
    let different = a.iter().zip(b).find(|(x, y)| (*x - *y).abs() > SAME);
    different.is_some_and(|(x, y)| x < y)
}
