//! A tiling made ready for predicates, and its simplices run through them on all cores.

use super::filter::{Filter, Rounded};
use super::floats::{BATCH, Batch, Floats};
use super::ladder::Ladder;
use super::polynomials::{MOST_PARTS, Metric, Predicate, Shape};
use super::ring::{Ring, SquareRoot, cleared_integers, cleared_quadratics};
use super::shapes::Shapes;
use super::signs::Signs;
use super::vectors::Vectors;
use crate::parallel;
use crate::tiling::{Corner, SimplexId, Tiling};
use acutile_exact::geometry::{Quadratic, linear};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::PowerOf2;
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};
use std::ops::Range;
use std::sync::OnceLock;

/// Simplices that one task of a core takes.
const CHUNK: usize = 1 << 12;

/// Corners that are given later pass the filter if their shifts differ by no more steps.
const STEPS: i32 = 8;

/// A tiling with its coordinates as doubles and in a ring.
#[derive(Clone, Debug)]
pub struct Model<'a, const D: usize> {
    /// The tiling itself.
    pub tiling: &'a Tiling<D>,
    floats: Floats<'a, D>,
    pub(super) ring: Ring<'a, D>,
    shapes: OnceLock<Shapes>,
}

/// A predicate with its filter and its exact twin, for one model.
#[derive(Clone, Debug)]
pub struct Prepared<'m, P, const D: usize> {
    pub(super) model: &'m Model<'m, D>,
    predicate: P,
    filter: Filter<D>,
    pub(super) exact: Exact<D>,
}

/// How values are computed exactly.
#[derive(Clone, Debug)]
pub(super) struct Exact<const D: usize> {
    pub integers: Option<Ladder<i128, D>>,
    pub quadratics: Option<Ladder<Quadratic<i128>, D>>,
    /// Where the others do not reach.
    pub numbers: Metric<Number, D>,
}

impl<'a, const D: usize> Model<'a, D> {
    /// The model of a tiling whose corners name vertices that exist.
    pub fn new(tiling: &'a Tiling<D>) -> Self {
        Model::with_floats(tiling, Floats::new(tiling))
    }

    /// The model of vertices without simplices: corners are given later, see
    /// [`Prepared::signs_of`].
    pub fn of_vertices(tiling: &'a Tiling<D>) -> Self {
        Model::with_floats(tiling, Floats::within(tiling, STEPS))
    }

    fn with_floats(tiling: &'a Tiling<D>, floats: Floats<'a, D>) -> Self {
        Model {
            tiling,
            floats,
            ring: Ring::new(tiling),
            shapes: OnceLock::new(),
        }
    }

    /// A predicate made ready.
    pub fn prepare<P: Predicate<D>>(&self, predicate: P) -> Prepared<'_, P, D> {
        let constants = predicate.constants();
        let numbers = number_metric(&self.tiling.frame.gram, &constants);
        let rounded = rounded(&numbers);
        Prepared {
            model: self,
            filter: Filter::new(&predicate, &self.floats, &rounded),
            exact: Exact::new(self, &predicate, numbers, &constants),
            predicate,
        }
    }

    /// The results of `work` for the simplices, a chunk of them at a time, on all cores.
    pub fn by_chunks<T: Send + Sync>(&self, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
        parallel::by_chunks(self.tiling.len(), CHUNK, work)
    }

    /// The edges of a simplex in doubles.
    pub fn float_edges(&self, simplex: SimplexId) -> [[f64; D]; D] {
        self.floats.edges(self.tiling.simplex(simplex))
    }

    /// Folds the edges of the simplices of each chunk, in doubles, on all cores; for what is decided
    /// exactly afterwards.
    pub fn fold<T: Copy + Send + Sync>(
        &self,
        start: T,
        with: impl Fn(T, [[f64; D]; D]) -> T + Sync,
    ) -> Vec<T> {
        self.by_chunks(|simplices| {
            let simplices = simplices.map(SimplexId::at);
            simplices.fold(start, |value, simplex| {
                with(value, self.float_edges(simplex))
            })
        })
    }
}

impl<P: Predicate<D>, const D: usize> Prepared<'_, P, D> {
    /// The exact signs for a simplex.
    #[inline]
    pub fn signs(&self, simplex: SimplexId) -> Signs {
        let corners = self.model.tiling.simplex(simplex);
        let edges = self.model.floats.edges(corners);
        let filtered = self.filter.signs(&self.predicate, edges, &[0.0; D]);
        filtered.unwrap_or_else(|| self.exact_signs(corners, &corners[0]))
    }

    /// Calls `visit` with the values for a simplex in doubles, up to a positive factor; gives the
    /// largest error of each part. `None`, without a call, where no error is proved.
    #[inline(always)]
    pub fn bounded(&self, simplex: SimplexId, visit: impl FnMut(f64)) -> Option<[f64; MOST_PARTS]> {
        let edges = self.model.float_edges(simplex);
        self.filter.bounded(&self.predicate, edges, visit)
    }

    /// The Gram matrix in doubles, with the factor that belongs to those of [`Prepared::bounded`].
    pub fn float_gram(&self) -> &[[f64; D]; D] {
        &self.filter.metric().gram
    }

    /// The exact signs for a simplex and a further corner.
    #[inline]
    pub fn signs_with(&self, simplex: SimplexId, apex: &Corner<D>) -> Signs {
        let corners = self.model.tiling.simplex(simplex);
        let floats = &self.model.floats;
        let point = floats.difference(&corners[0], apex);
        let filtered = self
            .filter
            .signs(&self.predicate, floats.edges(corners), &point);
        filtered.unwrap_or_else(|| self.exact_signs(corners, apex))
    }

    /// The exact signs for the simplex with these corners, which need not be one of the
    /// tiling, and a further corner.
    #[inline]
    pub fn signs_of(&self, corners: &[Corner<D>], apex: &Corner<D>) -> Signs {
        let floats = &self.model.floats;
        if !floats.cover(corners, apex) {
            return self.exact_signs(corners, apex);
        }
        let point = floats.difference(&corners[0], apex);
        let filtered = self
            .filter
            .signs(&self.predicate, floats.edges(corners), &point);
        filtered.unwrap_or_else(|| self.exact_signs(corners, apex))
    }

    /// The exact signs without the filter.
    #[cold]
    pub fn exact_signs(&self, corners: &[Corner<D>], apex: &Corner<D>) -> Signs {
        let Prepared {
            model,
            predicate,
            exact,
            ..
        } = self;
        if let Some(ladder) = &exact.integers
            && let Some(vectors) = model.ring.integers(corners, apex)
        {
            let vectors = match model.ring {
                Ring::Doubles { .. } => vectors.reduced(),
                _ => vectors,
            };
            return ladder.signs(predicate, &vectors.edges, &vectors.point);
        }
        if let Some(ladder) = &exact.quadratics
            && let Some(vectors) = model.ring.quadratics(corners, apex)
        {
            return ladder.signs(predicate, &vectors.edges, &vectors.point);
        }
        let Vectors { edges, point, .. } = model.ring.numbers(model.tiling, corners, apex);
        Signs::of(predicate, edges, &point, &exact.numbers)
    }

    /// The simplices, in order, whose signs are not as wanted.
    pub fn failing(&self, is_right: impl Fn(&Signs) -> bool + Sync) -> Vec<SimplexId> {
        let failing = self.model.by_chunks(|simplices| {
            let mut failing = Vec::new();
            self.for_each(simplices, |simplex, signs| {
                if !is_right(signs) {
                    failing.push(simplex);
                }
            });
            failing
        });
        failing.concat()
    }

    /// Calls `visit` with each of these simplices, in order, and its exact signs.
    #[inline]
    pub fn for_each(&self, simplices: Range<usize>, mut visit: impl FnMut(SimplexId, &Signs)) {
        let mut batch = Batch::default();
        for first in simplices.clone().step_by(BATCH) {
            let size = BATCH.min(simplices.end - first);
            let corners = &self.model.tiling.corners[first * (D + 1)..(first + size) * (D + 1)];
            for (place, corners) in (0..BATCH).zip(corners.chunks_exact(D + 1)) {
                batch.put(place, &self.model.floats, corners, None);
            }
            let items = (first..first + size).map(|simplex| (SimplexId::at(simplex), None));
            self.decide(&batch, items, &mut visit);
        }
    }

    /// The same for pairs of simplices, of each the first, with a further corner.
    #[inline]
    pub fn for_each_with(
        &self,
        mut pairs: impl Iterator<Item = ((SimplexId, SimplexId), Corner<D>)>,
        mut visit: impl FnMut((SimplexId, SimplexId), &Signs),
    ) {
        let mut batch = Batch::default();
        let mut filled = Vec::with_capacity(BATCH);
        loop {
            filled.clear();
            for (pair, apex) in pairs.by_ref().take(BATCH) {
                let corners = self.model.tiling.simplex(pair.0);
                batch.put(filled.len(), &self.model.floats, corners, Some(&apex));
                filled.push((pair, apex));
            }
            if filled.is_empty() {
                return;
            }
            let items = filled.iter().map(|(pair, apex)| (pair.0, Some(*apex)));
            let mut pairs = filled.iter().map(|(pair, _)| *pair);
            self.decide(&batch, items, &mut |_, signs| {
                if let Some(pair) = pairs.next() {
                    visit(pair, signs);
                }
            });
        }
    }

    /// Calls `visit` with the items that fill the first places of a batch.
    #[inline(always)]
    fn decide(
        &self,
        batch: &Batch<D>,
        items: impl Iterator<Item = (SimplexId, Option<Corner<D>>)>,
        visit: &mut impl FnMut(SimplexId, &Signs),
    ) {
        let signs = self.filter.signs_of_all(&self.predicate, batch);
        for ((simplex, apex), signs) in items.zip(signs) {
            let exact = || {
                let corners = self.model.tiling.simplex(simplex);
                self.exact_signs(corners, apex.as_ref().unwrap_or(&corners[0]))
            };
            visit(simplex, &signs.unwrap_or_else(exact));
        }
    }
}

impl<const D: usize> Model<'_, D> {
    /// The shapes of all simplices, found in one pass when they are asked for first.
    pub fn shapes(&self) -> &Shapes {
        self.shapes.get_or_init(|| self.find_shapes())
    }

    fn find_shapes(&self) -> Shapes {
        let shape = self.prepare(Shape);
        let parts = self.by_chunks(|simplices: Range<usize>| {
            let mut part = Shapes::default();
            shape.for_each(simplices, |simplex, signs| {
                let (orientation, angles) = signs.split_first();
                if !(orientation.all_positive() && angles.all_negative()) {
                    part.add(simplex, orientation.all_positive(), angles);
                }
            });
            part
        });
        let list =
            |of: fn(&Shapes) -> &Vec<SimplexId>| parts.iter().flat_map(of).copied().collect();
        Shapes {
            not_positive: list(|part| &part.not_positive),
            not_acute: list(|part| &part.not_acute),
            obtuse: list(|part| &part.obtuse),
        }
    }
}

impl<const D: usize> Exact<D> {
    fn new<P: Predicate<D>>(
        model: &Model<D>,
        predicate: &P,
        numbers: Metric<Number, D>,
        constants: &[Number],
    ) -> Self {
        let gram = &model.tiling.frame.gram;
        let mut exact = Exact {
            integers: None,
            quadratics: None,
            numbers,
        };
        match &model.ring {
            Ring::Quadratic { root, .. } => {
                let constants = quadratic_constants(constants, root);
                exact.quadratics = cleared_quadratics(gram, root)
                    .zip(constants)
                    .map(|(gram, constants)| Ladder::new(predicate, gram, constants));
            }
            Ring::Numbers { .. } => {}
            _ => {
                let constants = integer_constants(constants);
                exact.integers = cleared_integers(gram)
                    .zip(constants)
                    .map(|(gram, constants)| Ladder::new(predicate, gram, constants));
            }
        }
        exact
    }
}

/// `None` if one is not rational.
fn integer_constants(constants: &[Number]) -> Option<Vec<Integer>> {
    let integer = |x: &Number| Integer::try_from(x.to_rational()?.clone()).ok();
    constants.iter().map(integer).collect()
}

fn quadratic_constants(constants: &[Number], root: &SquareRoot) -> Option<Vec<Quadratic<Integer>>> {
    let element = |x: &Number| root.element(x, &Integer::ONE);
    constants.iter().map(element).collect()
}

fn number_metric<const D: usize>(
    gram: &[[Number; D]; D],
    constants: &[Number],
) -> Metric<Number, D> {
    // Cleared, so that the numbers are short and a rational matrix is one of integers.
    let unit = Number::common_denominator(gram.iter().flatten());
    let unit = Number::from(Rational::from(unit));
    let gram = gram.each_ref().map(|row| row.each_ref().map(|x| x * &unit));
    Metric {
        cogram: linear::cofactors(&gram),
        gram,
        constants: constants.to_vec(),
    }
}

/// The metric in doubles. If the largest entry is beyond 2^20 or so, the Gram matrix is multiplied by a
/// power of two, and its adjugate by the corresponding power.
fn rounded<const D: usize>(metric: &Metric<Number, D>) -> Metric<Rounded, D> {
    let entries = metric.gram.iter().flatten().map(|x| x.approximate().abs());
    let largest = entries.fold(0.0, f64::max);
    // Beyond 2^200 there is no filter.
    let scale = if (2f64.powi(20)..2f64.powi(200)).contains(&largest) {
        -(largest.log2().floor() as i32)
    } else {
        0
    };
    let matrix = |rows: &[[Number; D]; D], scale: i32| {
        rows.each_ref()
            .map(|row| row.each_ref().map(|x| Rounded::of(x, scale)))
    };
    Metric {
        gram: matrix(&metric.gram, scale),
        cogram: matrix(&metric.cogram, scale * (D as i32 - 1)),
        constants: scaled_down(&metric.constants)
            .iter()
            .map(|x| Rounded::of(x, 0))
            .collect(),
    }
}

/// Constants with more bits than this are scaled.
const SMALL_CONSTANTS: i64 = 20;

/// The constants, times one power of two if they are large. No sign changes by that.
fn scaled_down(constants: &[Number]) -> Vec<Number> {
    let bits = |c: &Rational| {
        c.numerator_ref().significant_bits() as i64 - c.denominator_ref().significant_bits() as i64
    };
    let coefficients = constants.iter().flat_map(|x| x.coefficients());
    let largest = coefficients.filter(|c| **c != 0).map(bits).max();
    match largest {
        Some(largest) if largest > SMALL_CONSTANTS => {
            let scale = Number::from(Rational::power_of_2(-largest));
            constants.iter().map(|x| x * &scale).collect()
        }
        _ => constants.to_vec(),
    }
}
