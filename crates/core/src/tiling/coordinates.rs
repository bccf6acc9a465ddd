//! The coordinates of the vertices of a tiling, stored as narrowly as they allow.
//!
//! A million vertices as numbers of a field are three million objects on the heap. Coordinates from meshes
//! and supercells are machine integers over one common denominator, or doubles, each of which is a rational
//! number. Only coordinates that are neither are kept as numbers of the field. All forms are exact, and
//! equal ones are made equal: the narrowest form that holds the values is taken.

use super::VertexId;
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::Lcm;
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Natural, Rational};

/// The coordinates of points of D-space in a basis; see [`Coordinates::form`].
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinates<const D: usize>(Form<D>);

/// How coordinates are stored.
#[derive(Clone, Debug, PartialEq)]
pub enum Form<const D: usize> {
    /// Numerators over one positive denominator, less than 2^62 in absolute value.
    Integers {
        /// D numerators for each point.
        numerators: Vec<[i64; D]>,
        /// The positive denominator of all coordinates.
        denominator: i64,
    },
    /// Finite doubles, each the rational number that it is.
    Doubles(Vec<[f64; D]>),
    /// Elements of the tiling's field.
    Numbers(Vec<[Number; D]>),
}

/// Numerators and denominators have fewer bits than this.
const BITS: u32 = 62;

impl<const D: usize> Coordinates<D> {
    /// `numerators` over `denominator`, which must be positive; all below 2^62 in
    /// absolute value. `None` if that is not so.
    pub fn from_integers(numerators: Vec<[i64; D]>, denominator: i64) -> Option<Self> {
        let fits = |n: &i64| n.unsigned_abs() >> BITS == 0;
        let all_fit =
            denominator > 0 && fits(&denominator) && numerators.iter().flatten().all(fits);
        all_fit.then_some(Coordinates(Form::Integers {
            numerators,
            denominator,
        }))
    }

    /// Doubles, each the rational number that it is; `None` if one is not finite.
    /// Multiples of one power of two that fit are stored as integers.
    pub fn from_doubles(points: Vec<[f64; D]>) -> Option<Self> {
        if !points.iter().flatten().all(|x| x.is_finite()) {
            return None;
        }
        let scaled = scale_of(&points).and_then(|shift| scaled_doubles(&points, shift));
        Some(scaled.unwrap_or(Coordinates(Form::Doubles(points))))
    }

    /// The stored form.
    pub fn form(&self) -> &Form<D> {
        &self.0
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        match &self.0 {
            Form::Integers { numerators, .. } => numerators.len(),
            Form::Doubles(points) => points.len(),
            Form::Numbers(points) => points.len(),
        }
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The point with this index.
    pub fn vertex(&self, index: VertexId) -> [Number; D] {
        let index = index.index();
        match &self.0 {
            Form::Integers {
                numerators,
                denominator,
            } => numerators[index].map(|n| Number::from(Rational::from_signeds(n, *denominator))),
            Form::Doubles(points) => points[index].map(number_of_double),
            Form::Numbers(points) => points[index].clone(),
        }
    }

    /// All points in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = [Number; D]> + Clone + '_ {
        (0..self.len()).map(|index| self.vertex(VertexId::at(index)))
    }

    /// The points as numbers, to be changed and converted back.
    pub fn to_numbers(&self) -> Vec<[Number; D]> {
        self.iter().collect()
    }
}

impl<const D: usize> From<Vec<[Number; D]>> for Coordinates<D> {
    fn from(points: Vec<[Number; D]>) -> Self {
        as_integers(&points).unwrap_or(Coordinates(Form::Numbers(points)))
    }
}

impl<const D: usize> FromIterator<[Number; D]> for Coordinates<D> {
    fn from_iter<I: IntoIterator<Item = [Number; D]>>(points: I) -> Self {
        Coordinates::from(points.into_iter().collect::<Vec<_>>())
    }
}

fn as_integers<const D: usize>(points: &[[Number; D]]) -> Option<Coordinates<D>> {
    let mut lcm = Natural::ONE;
    for x in points.iter().flatten() {
        let denominator = x.to_rational()?.denominator_ref();
        if *denominator != Natural::ONE {
            lcm = lcm.lcm(denominator);
            i64::try_from(&lcm).ok()?;
        }
    }
    let denominator = i64::try_from(&lcm).ok()?;
    let scale = Rational::from(denominator);
    let mut numerators = Vec::with_capacity(points.len());
    for point in points {
        let mut row = [0; D];
        for (n, x) in row.iter_mut().zip(point) {
            let scaled = Integer::try_from(x.to_rational()? * &scale).ok()?;
            *n = i64::try_from(&scaled).ok()?;
        }
        numerators.push(row);
    }
    Coordinates::from_integers(numerators, denominator)
}

/// A finite double as the rational number that it is.
fn number_of_double(x: f64) -> Number {
    let (mantissa, exponent) = decompose(x);
    Number::from(Rational::from(mantissa) << exponent)
}

/// (m, e) with x = m 2^e for a finite double; m is odd, or m = e = 0.
pub fn decompose(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (biased, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let (mantissa, exponent) = match biased {
        0 => (fraction, -1074),
        _ => (fraction | 1 << 52, biased - 1075),
    };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let sign = if x < 0.0 { -1 } else { 1 };
    (sign * (mantissa >> zeros), exponent + zeros as i32)
}

/// The least k >= 0 for which all doubles are multiples of 2^-k, if it is small.
fn scale_of<const D: usize>(points: &[[f64; D]]) -> Option<i32> {
    let exponents = points.iter().flatten().map(|x| -decompose(*x).1);
    let shift = exponents.max().unwrap_or(0).max(0);
    (shift < BITS as i32).then_some(shift)
}

/// The doubles times 2^shift as integers, if they are in range.
fn scaled_doubles<const D: usize>(points: &[[f64; D]], shift: i32) -> Option<Coordinates<D>> {
    let scale = (1u64 << shift) as f64;
    let limit = (1u64 << BITS) as f64;
    // Powers of two multiply exactly.
    let is_small = |x: &f64| (x * scale).abs() < limit;
    if !points.iter().flatten().all(is_small) {
        return None;
    }
    let numerators = points.iter().map(|x| x.map(|x| (x * scale) as i64));
    Coordinates::from_integers(numerators.collect(), 1 << shift)
}
