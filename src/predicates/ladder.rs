//! Exact evaluation in integers that are as wide as they must be.
//!
//! The edges are given in a base ring: integers of 128 bits, or x + y √d of such. A
//! predicate evaluated over [`Bound`]s, for edges whose coefficients are at most
//! 2^b, bounds everything that is computed on the way. So for each width there is
//! a largest b for which nothing can overflow; the narrowest width that is safe
//! for a simplex is taken, and big integers where none is.

use super::floats::map_metric;
use super::polynomials::{Metric, Predicate};
use super::signs::Signs;
use crate::geometry::{Bound, I256, Quadratic, Scalar, Simplex, linear};
use malachite::Integer;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// A ring over 128 bits, the same over 256 bits, and without bound.
pub trait Base: Scalar {
    /// Over 256 bits.
    type Wide: Scalar + Lift<Self>;
    /// Over integers.
    type Big: Scalar + Lift<Self>;
    /// Over bounds.
    type Size: Scalar;
    /// The number of bits of the largest coefficient.
    fn bits(&self) -> u32;
    /// The same value, if the coefficients have at most 126 bits.
    fn narrow(value: &Self::Big) -> Option<Self>;
    /// Bounds of the coefficients.
    fn size(value: &Self::Big) -> Self::Size;
    /// Coefficients of at most this size, in the ring of `like`.
    fn given(size: f64, like: &Self::Size) -> Self::Size;
    /// Bounds of all that led to a value, and of what its sign is computed from.
    fn top(value: &Self::Size) -> (f64, f64);
}

impl Base for i128 {
    type Wide = I256;
    type Big = Integer;
    type Size = Bound;

    fn bits(&self) -> u32 {
        128 - self.unsigned_abs().leading_zeros()
    }

    fn narrow(value: &Integer) -> Option<i128> {
        i128::try_from(value).ok().filter(|x| x.bits() <= 126)
    }

    fn size(value: &Integer) -> Bound {
        let nearest = f64::rounding_from(&malachite::Rational::from(value), RoundingMode::Up).0;
        Bound::given(nearest.abs(), 0.0)
    }

    fn given(size: f64, _: &Bound) -> Bound {
        Bound::given(size, 0.0)
    }

    fn top(value: &Bound) -> (f64, f64) {
        (value.top, 0.0)
    }
}

impl Base for Quadratic<i128> {
    type Wide = Quadratic<I256>;
    type Big = Quadratic<Integer>;
    type Size = Quadratic<Bound>;

    fn bits(&self) -> u32 {
        self.x.bits().max(self.y.bits())
    }

    fn narrow(value: &Self::Big) -> Option<Self> {
        value.map(i128::narrow)
    }

    fn size(value: &Self::Big) -> Self::Size {
        let Quadratic { x, y, d } = value;
        let [x, y, d] = [x, y, d].map(i128::size);
        Quadratic { x, y, d }
    }

    fn given(size: f64, like: &Self::Size) -> Self::Size {
        let coefficient = Bound::given(size, 0.0);
        Quadratic {
            x: coefficient,
            y: coefficient,
            d: like.d,
        }
    }

    fn top(value: &Self::Size) -> (f64, f64) {
        // x² and d y²
        let squares = value.times(value);
        (value.x.top.max(value.y.top), squares.x.top)
    }
}

/// A predicate over each width, with the bits of edges for which it is safe.
#[derive(Clone, Debug)]
pub struct Ladder<B: Base, const D: usize> {
    narrow: Option<(u32, Metric<B, D>)>,
    wide: Option<(u32, Metric<B::Wide, D>)>,
    big: Metric<B::Big, D>,
}

impl<B: Base, const D: usize> Ladder<B, D> {
    /// The ladder for this Gram matrix and these constants of the predicate.
    pub fn new<P: Predicate<D>>(
        predicate: &P,
        gram: [[B::Big; D]; D],
        constants: Vec<B::Big>,
    ) -> Self {
        let big = Metric {
            cogram: linear::cofactors(&gram),
            gram,
            constants,
        };
        let sizes = map_metric(&big, B::size);
        let tops: Vec<(f64, f64)> = (0..=126)
            .map(|b| tops::<B, P, D>(predicate, &sizes, b))
            .collect();
        // Squares are compared in 256 bits by the narrow ring, without bound by the wide one.
        let safe_bits = |bits: i32, squares: f64| {
            let fits = |top: &&(f64, f64)| top.0 < 2f64.powi(bits) && top.1 < squares;
            tops.iter()
                .take_while(fits)
                .count()
                .checked_sub(1)
                .map(|b| b as u32)
        };
        let narrow = narrowed::<B, D>(&big);
        let wide = narrow
            .as_ref()
            .map(|metric| map_metric(metric, |x| B::Wide::lift(x)));
        Ladder {
            narrow: safe_bits(127, 2f64.powi(255)).zip(narrow),
            wide: safe_bits(255, f64::INFINITY).zip(wide),
            big,
        }
    }

    /// The exact signs for these edges and this point.
    pub fn signs<P: Predicate<D>>(
        &self,
        predicate: &P,
        edges: &[[B; D]; D],
        point: &[B; D],
    ) -> Signs {
        let bits = largest_bits(edges.iter().flatten().chain(point));
        match (&self.narrow, &self.wide) {
            (Some((safe, metric)), _) if bits <= *safe => {
                Signs::of(predicate, edges.clone(), point, metric)
            }
            (_, Some((safe, metric))) if bits <= *safe => lifted(predicate, edges, point, metric),
            _ => lifted(predicate, edges, point, &self.big),
        }
    }

    /// Whether everything fits in 128 bits for these edges.
    pub fn is_narrow(&self, edges: &[[B; D]; D]) -> bool {
        let safe = self.narrow.as_ref().map(|(safe, _)| *safe);
        safe.is_some_and(|safe| largest_bits(edges.iter().flatten()) <= safe)
    }
}

fn largest_bits<'b, B: Base + 'b>(values: impl Iterator<Item = &'b B>) -> u32 {
    values.map(B::bits).max().unwrap_or(0)
}

fn lifted<B: Base, S, P: Predicate<D>, const D: usize>(
    predicate: &P,
    edges: &[[B; D]; D],
    point: &[B; D],
    metric: &Metric<S, D>,
) -> Signs
where
    S: Scalar + Lift<B>,
{
    let lift = |vector: &[B; D]| vector.each_ref().map(|x| S::lift(x));
    Signs::of(predicate, edges.each_ref().map(lift), &lift(point), metric)
}

fn narrowed<B: Base, const D: usize>(big: &Metric<B::Big, D>) -> Option<Metric<B, D>> {
    let options = map_metric(big, |x| B::narrow(x));
    let entries = [&options.gram, &options.cogram]
        .into_iter()
        .flatten()
        .flatten();
    let zero = entries
        .chain(&options.constants)
        .cloned()
        .collect::<Option<Vec<B>>>()?[0]
        .integer(0);
    Some(map_metric(&options, |x| x.clone().unwrap_or(zero.clone())))
}

/// Bounds of all that is computed for edges and a point with coefficients of at
/// most 2^bits.
fn tops<B: Base, P: Predicate<D>, const D: usize>(
    predicate: &P,
    metric: &Metric<B::Size, D>,
    bits: i32,
) -> (f64, f64) {
    let entry = B::given(2f64.powi(bits), &metric.gram[0][0]);
    let vector: [B::Size; D] = std::array::from_fn(|_| entry.clone());
    let simplex = Simplex::from_edges(std::array::from_fn(|_| vector.clone()));
    let mut tops = (0.0f64, 0.0f64);
    predicate.values(&simplex, &vector, metric, |_, value| {
        let (top, squares) = B::top(value);
        tops = (tops.0.max(top), tops.1.max(squares));
    });
    tops
}

/// The same value in a wider ring.
pub trait Lift<B> {
    /// The value of B.
    fn lift(value: &B) -> Self;
}

impl Lift<i128> for I256 {
    fn lift(value: &i128) -> Self {
        I256::from(*value)
    }
}

impl Lift<i128> for Integer {
    fn lift(value: &i128) -> Self {
        Integer::from(*value)
    }
}

impl<T, S: Lift<T>> Lift<Quadratic<T>> for Quadratic<S> {
    fn lift(value: &Quadratic<T>) -> Self {
        Quadratic {
            x: S::lift(&value.x),
            y: S::lift(&value.y),
            d: S::lift(&value.d),
        }
    }
}

impl<T> Quadratic<T> {
    fn map<S>(&self, map: impl Fn(&T) -> Option<S>) -> Option<Quadratic<S>> {
        Some(Quadratic {
            x: map(&self.x)?,
            y: map(&self.y)?,
            d: map(&self.d)?,
        })
    }
}
