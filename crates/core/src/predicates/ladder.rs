//! Exact evaluation in integers that are as wide as they must be.
//!
//! The edges are given in a base ring: integers of 128 bits, or x + y √d of such. A predicate evaluated
//! over [`Bound`]s, for edges whose coefficients are at most 2^b, bounds everything that is computed on the
//! way, and all factors of products. The rungs have 128, 256 and 512 bits, and half as many for factors. So
//! for each rung there is a largest b for which nothing is lost. The lowest rung that is safe for a simplex
//! is taken. If none is safe, big integers are. In the plane, where tilings are small and the polynomials
//! short, big integers follow 128 bits: each rung is code for every predicate.

use super::filter::map_metric;
use super::polynomials::{Metric, Predicate};
use super::signs::Signs;
use acutile_exact::geometry::{
    Bound, I128, I256, I512, Quadratic, RingElement, Scalar, Simplex, linear, wide::Wide,
};
use acutile_exact::number::Number;
use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;

/// A ring over 128 bits, and the ring that it is lifted to.
pub trait Base: Scalar {
    /// Over 128 bits, factors 64.
    type Narrow: Scalar + Lift<Self>;
    /// Over 256 bits, factors 128.
    type Wide: Scalar + Lift<Self>;
    /// Over 512 bits, factors 256.
    type Long: Scalar + Lift<Self>;
    /// Over integers.
    type Big: Scalar + Lift<Self>;
    /// Over bounds.
    type Size: Scalar;
    /// A number with as many bits as the largest coefficient.
    fn spread(&self) -> u128;
    /// The same value, if the coefficients have at most 126 bits.
    fn narrow(value: &Self::Big) -> Option<Self>;
    /// Bounds of the coefficients.
    fn size(value: &Self::Big) -> Self::Size;
    /// Coefficients of at most this size, in the ring of `like`.
    fn given(size: f64, like: &Self::Size) -> Self::Size;
    /// The sizes that must fit for a value and its sign.
    fn need(value: &Self::Size) -> Need;
    /// A value as x + y √d, y = 0 over the integers.
    fn narrow_coefficients(value: Self::Narrow) -> [I512; 2];
    /// The same.
    fn wide_coefficients(value: Self::Wide) -> [I512; 2];
    /// The same.
    fn long_coefficients(value: Self::Long) -> [I512; 2];
    /// The same.
    fn big_coefficients(value: Self::Big) -> [Integer; 2];
}

/// Bounds of all values and factors that a value is computed from, and, where squares are
/// compared for its sign, of those and their factors.
#[derive(Clone, Copy, Debug, Default)]
pub struct Need {
    values: f64,
    factors: f64,
    squares: f64,
    square_factors: f64,
}

impl Need {
    /// Whether `bits` bits are enough, and twice as many for squares.
    fn fits(&self, bits: i32) -> bool {
        let below = |x: f64, bits: i32| x < 2f64.powi(bits - 1);
        below(self.values, bits)
            && below(self.factors, bits / 2)
            && below(self.squares, 2 * bits)
            && below(self.square_factors, bits)
    }

    fn union(self, other: Self) -> Self {
        Need {
            values: self.values.max(other.values),
            factors: self.factors.max(other.factors),
            squares: self.squares.max(other.squares),
            square_factors: self.square_factors.max(other.square_factors),
        }
    }
}

impl Base for i128 {
    type Narrow = I128;
    type Wide = I256;
    type Long = I512;
    type Big = Integer;
    type Size = Bound;

    /// x, or -x - 1 if x is negative: b bits for -2^b <= x < 2^b.
    #[inline(always)]
    fn spread(&self) -> u128 {
        (self ^ (self >> 127)) as u128
    }

    fn narrow(value: &Integer) -> Option<i128> {
        let is_small = |x: &i128| x.unsigned_abs() >> 126 == 0;
        i128::try_from(value).ok().filter(is_small)
    }

    fn size(value: &Integer) -> Bound {
        let nearest = f64::rounding_from(&malachite::Rational::from(value), RoundingMode::Up).0;
        Bound::given(nearest.abs(), 0.0)
    }

    fn given(size: f64, _: &Bound) -> Bound {
        Bound::given(size, 0.0)
    }

    fn need(value: &Bound) -> Need {
        Need {
            values: value.top,
            factors: value.factor,
            ..Need::default()
        }
    }

    #[inline(always)]
    fn narrow_coefficients(value: I128) -> [I512; 2] {
        [I512::from(value.0), I512::ZERO]
    }

    fn wide_coefficients(value: I256) -> [I512; 2] {
        [I512::from(value), I512::ZERO]
    }

    fn long_coefficients(value: I512) -> [I512; 2] {
        [value, I512::ZERO]
    }

    fn big_coefficients(value: Integer) -> [Integer; 2] {
        [value, Integer::ZERO]
    }
}

impl Base for Quadratic<i128> {
    type Narrow = Quadratic<I128>;
    type Wide = Quadratic<I256>;
    type Long = Quadratic<I512>;
    type Big = Quadratic<Integer>;
    type Size = Quadratic<Bound>;

    #[inline(always)]
    fn spread(&self) -> u128 {
        self.x.spread() | self.y.spread()
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

    fn need(value: &Self::Size) -> Need {
        let Quadratic { x, y, .. } = value;
        // Its first coefficient is x x + (y d) y.
        let squares = value.times(value).x;
        Need {
            values: x.top.max(y.top),
            factors: x.factor.max(y.factor),
            squares: squares.top,
            square_factors: squares.factor,
        }
    }

    fn narrow_coefficients(value: Self::Narrow) -> [I512; 2] {
        [value.x, value.y].map(|x| I512::from(x.0))
    }

    fn wide_coefficients(value: Self::Wide) -> [I512; 2] {
        [value.x, value.y].map(I512::from)
    }

    fn long_coefficients(value: Self::Long) -> [I512; 2] {
        [value.x, value.y]
    }

    fn big_coefficients(value: Self::Big) -> [Integer; 2] {
        [value.x, value.y]
    }
}

/// A predicate over each width.
#[derive(Clone, Debug)]
pub struct Ladder<B: Base, const D: usize> {
    narrow: Option<Rung<B::Narrow, D>>,
    wide: Option<Rung<B::Wide, D>>,
    long: Option<Rung<B::Long, D>>,
    big: Metric<B::Big, D>,
}

/// The metric in one width, and the bits of edges for which it is safe.
#[derive(Clone, Debug)]
struct Rung<S, const D: usize> {
    bits: u32,
    metric: Metric<S, D>,
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
        let needs = (0..=126).map(|bits| need::<B, P, D>(predicate, &sizes, bits));
        let needs: Vec<Need> = needs.collect();
        let metric = narrowed::<B, D>(&big);
        Ladder {
            narrow: rung(&needs, 128, metric.as_ref()),
            wide: rung(&needs, 256, metric.as_ref()),
            long: rung(&needs, 512, metric.as_ref()),
            big,
        }
    }

    /// The exact signs for these edges and this point.
    #[inline]
    pub fn signs<P: Predicate<D>>(
        &self,
        predicate: &P,
        edges: &[[B; D]; D],
        point: &[B; D],
    ) -> Signs {
        let bits = largest_bits(edges.iter().flatten().chain(point));
        if let Some(rung) = reached(&self.narrow, bits) {
            lifted(predicate, edges, point, &rung.metric)
        } else if D == 3
            && let Some(rung) = reached(&self.wide, bits)
        {
            lifted(predicate, edges, point, &rung.metric)
        } else if D == 3
            && let Some(rung) = reached(&self.long, bits)
        {
            lifted(predicate, edges, point, &rung.metric)
        } else {
            lifted(predicate, edges, point, &self.big)
        }
    }

    /// det (e_1, …, e_D) as x + y √d, if it is computed in 512 bits or less; for the ladder
    /// of a predicate that computes it.
    #[inline]
    pub fn determinant(&self, edges: &[[B; D]; D]) -> Option<[I512; 2]> {
        let bits = largest_bits(edges.iter().flatten());
        if reached(&self.narrow, bits).is_some() {
            Some(B::narrow_coefficients(determinant(edges)))
        } else if D == 3 && reached(&self.wide, bits).is_some() {
            Some(B::wide_coefficients(determinant(edges)))
        } else if D == 3 && reached(&self.long, bits).is_some() {
            Some(B::long_coefficients(determinant(edges)))
        } else {
            None
        }
    }
}

/// det (e_1, …, e_D) in a wider ring.
#[inline]
pub fn determinant<B, S: Scalar + Lift<B>, const D: usize>(edges: &[[B; D]; D]) -> S {
    let lift = |edge: &[B; D]| edge.each_ref().map(|x| S::lift(x));
    Simplex::from_edges(edges.each_ref().map(lift)).determinant
}

fn rung<B, S: Lift<B>, const D: usize>(
    needs: &[Need],
    width: i32,
    metric: Option<&Metric<B, D>>,
) -> Option<Rung<S, D>> {
    let safe = needs.iter().take_while(|need| need.fits(width)).count();
    Some(Rung {
        bits: safe.checked_sub(1)? as u32,
        metric: map_metric(metric?, |x| S::lift(x)),
    })
}

#[inline]
fn reached<S, const D: usize>(rung: &Option<Rung<S, D>>, bits: u32) -> Option<&Rung<S, D>> {
    rung.as_ref().filter(|rung| bits <= rung.bits)
}

#[inline]
fn largest_bits<'b, B: Base + 'b>(values: impl Iterator<Item = &'b B>) -> u32 {
    128 - values.fold(0, |all, x| all | x.spread()).leading_zeros()
}

#[inline]
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

/// The sizes that must fit for edges and a point with coefficients of at most 2^bits.
fn need<B: Base, P: Predicate<D>, const D: usize>(
    predicate: &P,
    metric: &Metric<B::Size, D>,
    bits: i32,
) -> Need {
    let entry = B::given(2f64.powi(bits), &metric.gram[0][0]);
    let vector: [B::Size; D] = std::array::from_fn(|_| entry.clone());
    let simplex = Simplex::from_edges(std::array::from_fn(|_| vector.clone()));
    let mut need = Need::default();
    predicate.values(&simplex, &vector, metric, |_, value| {
        need = need.union(B::need(value));
    });
    need
}

/// The same value in a wider ring.
pub trait Lift<B> {
    /// The value of B.
    fn lift(value: &B) -> Self;
}

impl Lift<i128> for I128 {
    #[inline(always)]
    fn lift(value: &i128) -> Self {
        I128(*value)
    }
}

impl<const N: usize> Lift<i128> for Wide<N> {
    #[inline(always)]
    fn lift(value: &i128) -> Self {
        Wide::from(*value)
    }
}

impl Lift<i128> for Integer {
    fn lift(value: &i128) -> Self {
        Integer::from(*value)
    }
}

impl Lift<Number> for Number {
    fn lift(value: &Number) -> Self {
        value.clone()
    }
}

impl<T, S: Lift<T>> Lift<Quadratic<T>> for Quadratic<S> {
    #[inline]
    fn lift(value: &Quadratic<T>) -> Self {
        Quadratic {
            x: S::lift(&value.x),
            y: S::lift(&value.y),
            d: S::lift(&value.d),
        }
    }
}
