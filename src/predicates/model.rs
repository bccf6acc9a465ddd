//! A tiling made ready for predicates, and its simplices run through them on all cores.

use super::floats::{BATCH, Filter, Floats, Rounded};
use super::ladder::{Ladder, Lift};
use super::polynomials::{Metric, Orientation, Predicate};
use super::ring::{Ring, Vectors, cleared_integers, cleared_quadratics};
use super::signs::Signs;
use crate::geometry::{Quadratic, Scalar, Simplex, linear};
use crate::number::Number;
use crate::tiling::{Corner, Tiling};
use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Rational};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::ops::Range;

/// Simplices that one task of a core takes.
const CHUNK: usize = 1 << 12;

/// A tiling with its coordinates as doubles and in a ring.
#[derive(Clone, Debug)]
pub struct Model<'a, const D: usize> {
    /// The tiling itself.
    pub tiling: &'a Tiling<D>,
    floats: Floats<'a, D>,
    ring: Ring<'a, D>,
}

/// A predicate with its filter and its exact twin, for one model.
#[derive(Clone, Debug)]
pub struct Prepared<'m, P, const D: usize> {
    model: &'m Model<'m, D>,
    predicate: P,
    filter: Filter<D>,
    exact: Exact<D>,
}

/// How values are computed exactly.
#[derive(Clone, Debug)]
struct Exact<const D: usize> {
    integers: Option<Ladder<i128, D>>,
    quadratics: Option<Ladder<Quadratic<i128>, D>>,
    /// Where the others do not reach.
    numbers: Metric<Number, D>,
}

impl<'a, const D: usize> Model<'a, D> {
    /// The model of a tiling whose corners name vertices that exist.
    pub fn new(tiling: &'a Tiling<D>) -> Self {
        Model {
            tiling,
            floats: Floats::new(tiling),
            ring: Ring::new(tiling),
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
            exact: Exact::new(self, &predicate, numbers, constants),
            predicate,
        }
    }

    /// The simplices, in order, that are wanted.
    pub fn select(&self, is_wanted: impl Fn(usize) -> bool + Sync) -> Vec<usize> {
        let simplices = (0..self.tiling.len()).into_par_iter();
        simplices
            .with_min_len(CHUNK)
            .filter(|simplex| is_wanted(*simplex))
            .collect()
    }

    /// What `work` makes of the simplices, a chunk of them at a time, on all cores.
    pub fn by_chunks<T: Send>(&self, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
        let n = self.tiling.len();
        let chunks = (0..n.div_ceil(CHUNK)).into_par_iter();
        chunks
            .map(|chunk| work(chunk * CHUNK..n.min((chunk + 1) * CHUNK)))
            .collect()
    }

    /// Folds the edges of all simplices, in doubles, on all cores; for what is decided
    /// exactly afterwards.
    pub fn fold<T: Copy + Send + Sync>(
        &self,
        start: T,
        with: impl Fn(T, [[f64; D]; D]) -> T + Sync + Send,
    ) -> impl ParallelIterator<Item = T> {
        let simplices = (0..self.tiling.len()).into_par_iter().with_min_len(CHUNK);
        simplices.fold(
            move || start,
            move |value, simplex| with(value, self.floats.edges(self.tiling.simplex(simplex))),
        )
    }

    /// The sum of det (e_1, …, e_D) over all simplices, in basis coordinates.
    pub fn sum_of_determinants(&self) -> Number {
        let orientation = self.prepare(Orientation);
        let simplices = 0..self.tiling.len();
        let chunks = simplices.into_par_iter().with_min_len(CHUNK);
        let total = chunks.fold(Total::default, |mut total, simplex| {
            orientation.add_determinant(simplex, &mut total);
            total
        });
        let total = total.reduce(Total::default, Total::plus);
        total.value(&self.ring, D)
    }
}

impl<P: Predicate<D>, const D: usize> Prepared<'_, P, D> {
    /// The exact signs for a simplex.
    #[inline]
    pub fn signs(&self, simplex: usize) -> Signs {
        let corners = self.model.tiling.simplex(simplex);
        let edges = self.model.floats.edges(corners);
        let filtered = self.filter.signs(&self.predicate, edges, &[0.0; D]);
        filtered.unwrap_or_else(|| self.exact_signs(corners, &corners[0]))
    }

    /// The exact signs for a simplex and a further corner.
    #[inline]
    pub fn signs_with(&self, simplex: usize, apex: &Corner<D>) -> Signs {
        let corners = self.model.tiling.simplex(simplex);
        let floats = &self.model.floats;
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
    pub fn failing(&self, is_right: impl Fn(&Signs) -> bool + Sync) -> Vec<usize> {
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
    pub fn for_each(&self, simplices: Range<usize>, mut visit: impl FnMut(usize, &Signs)) {
        let Prepared { model, filter, predicate, .. } = self;
        let mut simplex = simplices.start;
        while simplex + BATCH <= simplices.end {
            let batch = model.floats.batch(&model.tiling.corners[simplex * (D + 1)..]);
            for signs in filter.signs_of_all(predicate, &batch) {
                let corners = model.tiling.simplex(simplex);
                let signs = signs.unwrap_or_else(|| self.exact_signs(corners, &corners[0]));
                visit(simplex, &signs);
                simplex += 1;
            }
        }
        for simplex in simplex..simplices.end {
            visit(simplex, &self.signs(simplex));
        }
    }
}

impl<const D: usize> Exact<D> {
    fn new<P: Predicate<D>>(
        model: &Model<D>,
        predicate: &P,
        numbers: Metric<Number, D>,
        constants: Vec<Integer>,
    ) -> Self {
        let gram = &model.tiling.frame.gram;
        let mut exact = Exact {
            integers: None,
            quadratics: None,
            numbers,
        };
        match &model.ring {
            Ring::Quadratic { root, .. } => {
                let element = |n: Integer| Quadratic {
                    x: n,
                    y: Integer::ZERO,
                    d: Integer::from(root.d),
                };
                exact.quadratics = cleared_quadratics(gram, root).map(|gram| {
                    Ladder::new(
                        predicate,
                        gram,
                        constants.into_iter().map(element).collect(),
                    )
                });
            }
            Ring::Numbers { .. } => {}
            _ => {
                let gram = cleared_integers(gram);
                exact.integers = gram.map(|gram| Ladder::new(predicate, gram, constants));
            }
        }
        exact
    }
}

fn number_metric<const D: usize>(
    gram: &[[Number; D]; D],
    constants: &[Integer],
) -> Metric<Number, D> {
    // Cleared, so that the numbers are short and a rational matrix is one of integers.
    let unit = super::ring::common_denominator(gram.iter().flatten());
    let unit = Number::from(Rational::from(unit));
    let gram = gram.each_ref().map(|row| row.each_ref().map(|x| x * &unit));
    Metric {
        cogram: linear::cofactors(&gram),
        gram,
        constants: constants
            .iter()
            .map(|n| Number::from(Rational::from(n)))
            .collect(),
    }
}

/// The metric in doubles: if the largest entry is beyond 2^20 or so, the Gram matrix
/// is multiplied by a power of two, and its adjugate by the power that belongs to it.
fn rounded<const D: usize>(metric: &Metric<Number, D>) -> Metric<Rounded, D> {
    let entries = metric.gram.iter().flatten().map(|x| x.approximate().abs());
    let largest = entries.fold(0.0, f64::max);
    // Beyond 2^200 there is no filter.
    let scale = match (2f64.powi(20)..2f64.powi(200)).contains(&largest) {
        true => -(largest.log2().floor() as i32),
        false => 0,
    };
    let matrix = |rows: &[[Number; D]; D], scale: i32| {
        rows.each_ref()
            .map(|row| row.each_ref().map(|x| Rounded::of(x, scale)))
    };
    Metric {
        gram: matrix(&metric.gram, scale),
        cogram: matrix(&metric.cogram, scale * (D as i32 - 1)),
        constants: metric.constants.iter().map(|x| Rounded::of(x, 0)).collect(),
    }
}

impl<P: Predicate<D>, const D: usize> Prepared<'_, P, D> {
    fn add_determinant(&self, simplex: usize, total: &mut Total) {
        let Prepared { model, exact, .. } = self;
        let corners = model.tiling.simplex(simplex);
        let apex = &corners[0];
        if let Some(Vectors {
            edges, exponent, ..
        }) = model.ring.integers(corners, apex)
        {
            match exact
                .integers
                .as_ref()
                .is_some_and(|ladder| ladder.is_narrow(&edges))
            {
                true => total.add(exponent, [Simplex::from_edges(edges).determinant, 0]),
                false => {
                    let edges = edges.map(|edge| edge.map(Integer::from));
                    let determinant = Simplex::from_edges(edges).determinant;
                    total.add_big(exponent, [determinant, Integer::ZERO]);
                }
            }
        } else if let Some(Vectors { edges, .. }) = model.ring.quadratics(corners, apex) {
            match exact
                .quadratics
                .as_ref()
                .is_some_and(|ladder| ladder.is_narrow(&edges))
            {
                true => {
                    let Quadratic { x, y, .. } = Simplex::from_edges(edges).determinant;
                    total.add(0, [x, y]);
                }
                false => {
                    let edges = edges.map(|edge| edge.map(|x| Quadratic::<Integer>::lift(&x)));
                    let Quadratic { x, y, .. } = Simplex::from_edges(edges).determinant;
                    total.add_big(0, [x, y]);
                }
            }
        } else {
            let Vectors { edges, .. } = model.ring.numbers(model.tiling, corners, apex);
            let determinant = Simplex::from_edges(edges).determinant;
            total.numbers = total.numbers.plus(&determinant);
        }
    }
}

/// A sum of determinants: x + y √d in units of 2^(D e) for exponents e, and numbers.
struct Total {
    current: (i32, [i128; 2]),
    sums: BTreeMap<i32, [Integer; 2]>,
    numbers: Number,
}

impl Default for Total {
    fn default() -> Self {
        Total {
            current: (0, [0, 0]),
            sums: BTreeMap::new(),
            numbers: Number::zero(),
        }
    }
}

impl Total {
    fn add(&mut self, exponent: i32, [x, y]: [i128; 2]) {
        let (current, sum) = self.current;
        let sums = [sum[0].checked_add(x), sum[1].checked_add(y)];
        match sums {
            [Some(x), Some(y)] if current == exponent => self.current.1 = [x, y],
            _ => {
                self.flush();
                self.current = (exponent, [x, y]);
            }
        }
    }

    fn add_big(&mut self, exponent: i32, [x, y]: [Integer; 2]) {
        let sum = self.sums.entry(exponent).or_default();
        sum[0] += x;
        sum[1] += y;
    }

    fn flush(&mut self) {
        let (exponent, sum) = std::mem::take(&mut self.current);
        self.add_big(exponent, sum.map(Integer::from));
    }

    fn plus(mut self, mut other: Total) -> Total {
        self.flush();
        other.flush();
        for (exponent, sum) in other.sums {
            self.add_big(exponent, sum);
        }
        self.numbers = self.numbers.plus(&other.numbers);
        self
    }

    /// The sum in basis coordinates.
    fn value<const D: usize>(mut self, ring: &Ring<D>, dimension: usize) -> Number {
        self.flush();
        let root = match ring {
            Ring::Quadratic { root, .. } => root.number.clone(),
            _ => Number::zero(),
        };
        let mut value = self.numbers;
        for (exponent, sum) in self.sums {
            let scale = exponent * dimension as i32;
            let [x, y] = sum.map(|n| Number::from(Rational::from(n) << scale));
            value = value + x + y * &root;
        }
        let unit = ring.unit();
        let cell = (1..dimension).fold(unit.clone(), |cell, _| cell * &unit);
        value.divide(&cell).unwrap_or_else(Number::zero)
    }
}
