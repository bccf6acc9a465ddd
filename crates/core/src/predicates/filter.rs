//! The filter: predicates in doubles with a proved bound of the error.
//!
//! **Edges** are known up to delta, see [`super::floats`].
//!
//! **Values.** Let m be the largest entry of the computed edges, and delta = r m. The exact edges are at
//! most (1 + r) m. One part of a predicate is homogeneous of degree k, and doubles scale by powers of two
//! without rounding. Hence the error of a value is at most m^k E(r). E(r) is the value of the predicate
//! over [`Bound`]s for edges of size 1 + r with error r. E is a polynomial in r with coefficients that are
//! not negative, hence convex, and for r <= R = 2^-20 E(r) <= E(0) + r (E(R) - E(0)) / R. Both constants
//! are raised by 2^-20 of themselves for the roundings in the threshold itself, and for the few of E.
//!
//! **Underflow** adds at most 2^-1075 to a product, and that is multiplied further by
//! at most the largest intermediate bound T for edges of size 1 (and m^k if m > 1).
//! With less than 2^10 operations, T < 2^200, E(0) > 2^-300 and 2^-480 < m^k < 2^480 that is less
//! than 2^-20 of the threshold, and nothing overflows. Beyond these limits the filter is silent.
//!
//! **Integers.** Where everything is an integer and all intermediate values are
//! bounded by 2^53, doubles are exact and so is the sign zero.

use super::floats::{BATCH, Batch, Floats};
use super::polynomials::{MOST_PARTS, Metric, Predicate};
use super::signs::Signs;
use acutile_exact::geometry::bound::ROUNDOFF;
use acutile_exact::geometry::{Bound, Simplex};
use acutile_exact::number::Number;
use std::hint::black_box;

/// A number of the metric as a double, with a bound of its error.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    /// An approximation.
    pub value: f64,
    /// A bound of the absolute error.
    pub error: f64,
}

impl Rounded {
    /// The number times 2^scale, for |scale| <= 400 and rationals that are integers.
    pub fn of(number: &Number, scale: i32) -> Self {
        let value = number.approximate();
        let is_exact = number
            .to_rational()
            .is_some_and(|exact| malachite::Rational::try_from(value).is_ok_and(|x| x == *exact));
        let scaled = value * 2f64.powi(scale);
        Rounded {
            value: scaled,
            error: if is_exact {
                0.0
            } else {
                scaled.abs() * 4.0 * ROUNDOFF + 2f64.powi(-900)
            },
        }
    }

    fn bound(&self) -> Bound {
        Bound::given(self.value.abs() + self.error, self.error)
    }

    fn is_integer(&self) -> bool {
        self.error == 0.0 && self.value.fract() == 0.0
    }
}

/// The data of a predicate's filter.
#[derive(Clone, Debug)]
pub struct Filter<const D: usize> {
    metric: Metric<f64, D>,
    parts: [Part; MOST_PARTS],
    /// Values are exact up to this entry of the edges.
    exact: f64,
    low: f64,
    high: f64,
}

/// E(0) and (E(R) - E(0)) / R of the values of one part, raised; the latter times delta.
#[derive(Clone, Copy, Debug, Default)]
struct Part {
    constant: f64,
    slope: f64,
}

/// R
const LARGEST_RATIO: f64 = 1.0 / (1 << 20) as f64;

impl<const D: usize> Filter<D> {
    /// The filter of a predicate for edges of a tiling with this metric.
    pub fn new<P: Predicate<D>>(
        predicate: &P,
        floats: &Floats<D>,
        metric: &Metric<Rounded, D>,
    ) -> Self {
        const { assert!(P::PARTS <= MOST_PARTS) };
        let bounds = map_metric(metric, Rounded::bound);
        let at = |size: f64, error: f64| bounds_of(predicate, &bounds, size, error);
        let (none, some) = (at(1.0, 0.0), at(1.0 + LARGEST_RATIO, LARGEST_RATIO));
        let raise = 1.0 + LARGEST_RATIO;
        let part = |k: usize| Part {
            constant: none[k].error * raise,
            slope: (some[k].error - none[k].error) / LARGEST_RATIO * raise * floats.error,
        };
        let in_range = |k: usize| none[k].top < 2f64.powi(200) && none[k].error > 2f64.powi(-300);
        let degrees = (0..P::PARTS).map(|k| predicate.degree(k));
        let degree = degrees.max().unwrap_or(1);
        let reach = 2f64.powf(480.0 / f64::from(degree)).floor();
        let is_on = (0..P::PARTS).all(in_range) && degree <= LARGEST_DEGREE && is_strict();
        let top = |size: f64| {
            at(size, 0.0)
                .iter()
                .fold(0.0, |top, part| part.top.max(top))
        };
        Filter {
            parts: std::array::from_fn(part),
            exact: if floats.is_integral && is_strict() && all_integers(metric) {
                largest_exact(top)
            } else {
                -1.0
            },
            // The least m for which r <= R is delta / R.
            low: if is_on {
                (1.0 / reach).max(floats.error / LARGEST_RATIO)
            } else {
                f64::INFINITY
            },
            high: if is_on { reach } else { 0.0 },
            metric: map_metric(metric, |x| x.value),
        }
    }

    /// The signs that doubles prove; `None` if one of them stays open.
    #[inline(always)]
    pub fn signs<P: Predicate<D>>(
        &self,
        predicate: &P,
        edges: [[f64; D]; D],
        point: &[f64; D],
    ) -> Option<Signs> {
        proved(self.judged(predicate, edges, point))
    }

    /// The same for many simplices, one after the other.
    #[inline(always)]
    pub fn signs_of_all<P: Predicate<D>>(
        &self,
        predicate: &P,
        batch: &Batch<D>,
    ) -> impl Iterator<Item = Option<Signs>> + use<P, D> {
        let mut judged = [Judged::default(); BATCH];
        for (k, judged) in judged.iter_mut().enumerate() {
            *judged = self.judged(predicate, batch.edges(k), &batch.point(k));
        }
        judged.into_iter().map(proved)
    }

    /// The signs beyond the thresholds. Without a branch and with one width of all words,
    /// so that a loop over this is compiled to vectors.
    #[inline(always)]
    fn judged<P: Predicate<D>>(
        &self,
        predicate: &P,
        edges: [[f64; D]; D],
        point: &[f64; D],
    ) -> Judged {
        let m = largest(&edges, point);
        let is_exact = m <= self.exact;
        let thresholds = self.thresholds(predicate, m);
        let mut signs = Signs::default();
        let simplex = Simplex::from_edges(edges);
        predicate.values(&simplex, point, &self.metric, |part, value| {
            signs.push(*value < -thresholds[part], *value > thresholds[part]);
        });
        Judged {
            signs,
            is_exact: u64::from(is_exact),
            is_in_range: u64::from((m >= self.low) & (m <= self.high)),
        }
    }
}

impl<const D: usize> Filter<D> {
    /// The largest error of the values of each part, for edges up to m.
    #[inline(always)]
    fn thresholds<P: Predicate<D>>(&self, predicate: &P, m: f64) -> [f64; MOST_PARTS] {
        let mut thresholds = [0.0; MOST_PARTS];
        for part in 0..P::PARTS {
            let Part { constant, slope } = self.parts[part];
            let threshold = power(m, predicate.degree(part) - 1) * (constant * m + slope);
            thresholds[part] = if m <= self.exact { 0.0 } else { threshold };
        }
        thresholds
    }

    /// Calls `visit` with the values in doubles, in order; gives the largest error of each part.
    /// `None`, without a call, out of the filter's range.
    #[inline(always)]
    pub fn bounded<P: Predicate<D>>(
        &self,
        predicate: &P,
        edges: [[f64; D]; D],
        mut visit: impl FnMut(f64),
    ) -> Option<[f64; MOST_PARTS]> {
        let point = [0.0; D];
        let m = largest(&edges, &point);
        if !(m <= self.exact || (self.low..=self.high).contains(&m)) {
            return None;
        }
        let simplex = Simplex::from_edges(edges);
        predicate.values(&simplex, &point, &self.metric, |_, value| visit(*value));
        Some(self.thresholds(predicate, m))
    }

    /// The metric in doubles; each matrix has its own positive factor, see `rounded` of the model.
    pub fn metric(&self) -> &Metric<f64, D> {
        &self.metric
    }
}

/// The signs beyond the thresholds, and the evidence that they are proved.
#[derive(Clone, Copy, Default)]
struct Judged {
    signs: Signs,
    is_exact: u64,
    is_in_range: u64,
}

fn proved(judged: Judged) -> Option<Signs> {
    let Judged {
        signs,
        is_exact,
        is_in_range,
    } = judged;
    (is_exact != 0 || is_in_range != 0 && signs.none_zero()).then_some(signs)
}

/// [`power`] goes no further.
const LARGEST_DEGREE: i32 = 16;

/// m^n for n < 16
#[inline(always)]
fn power(m: f64, n: i32) -> f64 {
    let (mut power, mut square) = (1.0, m);
    for bit in 0..4 {
        if n >> bit & 1 == 1 {
            power *= square;
        }
        square *= square;
    }
    power
}

/// m
#[inline(always)]
fn largest<const D: usize>(edges: &[[f64; D]; D], point: &[f64; D]) -> f64 {
    let mut m = 0.0;
    for k in 0..D {
        for i in 0..D {
            m = greater(m, edges[i][k].abs());
        }
        m = greater(m, point[k].abs());
    }
    m
}

#[inline(always)]
fn greater(x: f64, y: f64) -> f64 {
    if y > x { y } else { x }
}

/// For each part the largest error and the largest intermediate value for edges of this size.
fn bounds_of<P: Predicate<D>, const D: usize>(
    predicate: &P,
    metric: &Metric<Bound, D>,
    size: f64,
    error: f64,
) -> [Bound; MOST_PARTS] {
    let edge = Bound::given(size, error);
    let mut parts = [Bound::given(0.0, 0.0); MOST_PARTS];
    let simplex = Simplex::from_edges([[edge; D]; D]);
    predicate.values(&simplex, &[edge; D], metric, |part, value| {
        parts[part].error = parts[part].error.max(value.error);
        parts[part].top = parts[part].top.max(value.top);
    });
    parts
}

/// The largest power of two for which no intermediate value exceeds 2^53.
fn largest_exact(top: impl Fn(f64) -> f64) -> f64 {
    let sizes = (0..53).map(|k| 2f64.powi(k));
    sizes
        .take_while(|size| top(*size) < 2f64.powi(53))
        .last()
        .unwrap_or(-1.0)
}

fn all_integers<const D: usize>(metric: &Metric<Rounded, D>) -> bool {
    let Metric {
        gram,
        cogram,
        constants,
    } = metric;
    let entries = gram.iter().chain(cogram).flatten().chain(constants);
    entries.into_iter().all(Rounded::is_integer)
}

/// The same metric in other numbers.
pub fn map_metric<S, T, const D: usize>(
    metric: &Metric<S, D>,
    map: impl Fn(&S) -> T,
) -> Metric<T, D> {
    let matrix = |rows: &[[S; D]; D]| rows.each_ref().map(|row| row.each_ref().map(&map));
    Metric {
        gram: matrix(&metric.gram),
        cogram: matrix(&metric.cogram),
        constants: metric.constants.iter().map(&map).collect(),
    }
}

/// Whether doubles round each operation to nearest, ties to even, in double
/// precision, and have subnormals: where not, nothing is filtered.
fn is_strict() -> bool {
    let one = black_box(1.0f64);
    let ulp = black_box(f64::EPSILON);
    let half_up = one + ulp / 2.0 == one && (one + ulp) + ulp / 2.0 == one + 2.0 * ulp;
    // Wrong where sums are rounded to 64 bits first.
    let big = black_box(9_007_199_254_740_994.0f64);
    let once = big + black_box(0.999_984_741_210_937_5) == big;
    // (1 + e)² = 1 + 2 e + e², and the last term is lost in the product.
    let square = (one + ulp) * (one + ulp) - (one + 2.0 * ulp);
    let subnormal = black_box(f64::MIN_POSITIVE) / 2.0;
    half_up && once && square == 0.0 && subnormal > 0.0 && subnormal * 2.0 == f64::MIN_POSITIVE
}
