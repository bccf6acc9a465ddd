//! Exact coordinates in machine integers, and the predicates over 128 or 512 bits.
//!
//! Points of a lattice with a small denominator have many cospherical sets, where
//! doubles never decide. There big integers spend their time in the allocator, and these
//! do not. Called by `predicates`, between the doubles and the numbers without bound.
//!
//! The text of the predicate is evaluated over [`Bound`]s for edges whose entries are
//! below 2^b: this bounds every value on the way, and every factor, which in [`I512`] has
//! half of the bits. So for either width there is a largest b for which nothing is lost; an
//! edge with more bits is not for this file.

use super::model::Model;
use super::predicates::{cleared, common_denominator};
use crate::tiling::Corner;
use acutile_exact::geometry::{Bound, I512, Scalar, Sign, Simplex};
use malachite::Integer;

/// Denominators and coordinates are at most 2^62 and shifts differ by less than 2^33, so
/// edges are below 2^96 and do not overflow.
const COORDINATE_LIMIT: i64 = 1 << 62;

/// Rational points over one denominator.
#[derive(Clone, Debug)]
pub struct Narrow<const D: usize> {
    /// In units of 1/`unit`; without the witnesses.
    points: Vec<[i64; D]>,
    unit: i64,
    medium: Width<i128, D>,
    wide: Width<I512, D>,
}

/// The Gram matrix in a kind of integers.
#[derive(Clone, Debug)]
struct Width<S, const D: usize> {
    gram: [[S; D]; D],
    /// Edges may have so many bits.
    bits: u32,
}

impl<const D: usize> Narrow<D> {
    /// The points of a model, if all is rational and small.
    pub fn new(model: &Model<D>) -> Option<Self> {
        let points = &model.points[..model.names.len()];
        let unit = common_denominator(points)?;
        let metric = common_denominator(&model.lattice.gram)?;
        let mut gram = [[0i128; D]; D];
        for (row, exact) in gram.iter_mut().zip(&model.lattice.gram) {
            let integers = cleared(exact, &metric)?;
            for (entry, integer) in row.iter_mut().zip(&integers) {
                *entry = i64::try_from(integer).ok()?.into();
            }
        }
        let points = points
            .iter()
            .map(|x| cleared(x, &unit).and_then(small))
            .collect::<Option<Vec<_>>>()?;
        Some(Narrow {
            points,
            unit: i64::try_from(&unit)
                .ok()
                .filter(|x| *x <= COORDINATE_LIMIT)?,
            medium: Width {
                gram,
                bits: safe_bits(&gram, 127, 127)?,
            },
            wide: Width {
                gram: gram.map(|row| row.map(I512::from)),
                bits: safe_bits(&gram, 511, 255)?,
            },
        })
    }

    /// The vector from `origin` to `p`, in units; `None` for a witness.
    fn edge(&self, origin: &Corner<D>, p: &Corner<D>) -> Option<[i128; D]> {
        let a = self.points.get(origin.vertex as usize)?;
        let b = self.points.get(p.vertex as usize)?;
        Some(std::array::from_fn(|k| {
            let shift = i128::from(p.shift[k]) - i128::from(origin.shift[k]);
            i128::from(b[k]) - i128::from(a[k]) + i128::from(self.unit) * shift
        }))
    }

    fn edges(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Option<[[i128; D]; D]> {
        let mut edges = [[0; D]; D];
        for (k, edge) in edges.iter_mut().enumerate() {
            *edge = self.edge(&facet[0], facet.get(k + 1).unwrap_or(apex))?;
        }
        Some(edges)
    }

    /// The sign of the determinant of the edges from the first corner, if it fits.
    pub fn orientation(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Option<Sign> {
        let edges = self.edges(facet, apex)?;
        match bits(&edges) {
            b if b <= self.medium.bits => Some(Simplex::from_edges(edges).determinant.sign()),
            b if b <= self.wide.bits => Some(Simplex::from_edges(lift(edges)).determinant.sign()),
            _ => None,
        }
    }

    /// The sign of the power of p, see [`Simplex::power`], if it fits.
    pub fn in_sphere(
        &self,
        facet: &[Corner<D>; D],
        apex: &Corner<D>,
        p: &Corner<D>,
    ) -> Option<Sign> {
        let edges = self.edges(facet, apex)?;
        let offset = self.edge(&facet[0], p)?;
        match bits(&edges).max(bits(&[offset])) {
            b if b <= self.medium.bits => Some(self.medium.side(edges, &offset)),
            b if b <= self.wide.bits => Some(self.wide.side(lift(edges), &offset.map(I512::from))),
            _ => None,
        }
    }
}

impl<S: Scalar, const D: usize> Width<S, D> {
    fn side(&self, edges: [[S; D]; D], offset: &[S; D]) -> Sign {
        Simplex::from_edges(edges).power(&self.gram, offset).sign()
    }
}

fn lift<const D: usize>(edges: [[i128; D]; D]) -> [[I512; D]; D] {
    edges.map(|edge| edge.map(I512::from))
}

fn small<const D: usize>(point: [Integer; D]) -> Option<[i64; D]> {
    let mut row = [0; D];
    for (entry, integer) in row.iter_mut().zip(&point) {
        *entry = i64::try_from(integer)
            .ok()
            .filter(|x| x.abs() <= COORDINATE_LIMIT)?;
    }
    Some(row)
}

/// The number of bits of the largest entry.
fn bits<const D: usize>(vectors: &[[i128; D]]) -> u32 {
    let largest = vectors
        .iter()
        .flatten()
        .fold(0, |m, x| m | x.unsigned_abs());
    128 - largest.leading_zeros()
}

/// The largest b such that for entries of at most 2^b no value of the predicates
/// reaches 2^width and no factor 2^factors; `None` if there is none.
fn safe_bits<const D: usize>(gram: &[[i128; D]; D], width: i32, factors: i32) -> Option<u32> {
    let gram = gram.map(|row| row.map(|x| Bound::given(x.unsigned_abs() as f64 * 1.001, 0.0)));
    let fits = |b: &i32| {
        let vector = [Bound::given(2f64.powi(*b), 0.0); D];
        let simplex = Simplex::from_edges([vector; D]);
        let power = simplex.power(&gram, &vector);
        power.top < 2f64.powi(width) && power.factor < 2f64.powi(factors)
    };
    (0..=90).take_while(fits).last().map(|b| b as u32)
}
