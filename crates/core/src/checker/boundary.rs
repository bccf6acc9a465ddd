//! A boundary facet in its place, and its coordinates as scalars.

use crate::tiling::coordinates::Form;
use crate::tiling::{Corner, Facet, Tiling, cell_of, difference};
use acutile_exact::geometry::triangle::{Point, Quotient};
use acutile_exact::geometry::{I512, Scalar};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::Floor;
use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Rational};
use std::array::from_fn;
use std::cmp::Ordering;

/// How coordinates become scalars, and back.
pub(super) struct Scale<'t, S, const D: usize> {
    /// All coordinates are multiplied by this number.
    unit: Number,
    from: Coordinates<'t, S, D>,
    to_number: fn(&S) -> Number,
}

enum Coordinates<'t, S, const D: usize> {
    /// The numerators that the tiling stores, and one step of the lattice in the same unit.
    Integers(&'t [[i64; D]], i64, fn(i128) -> S),
    Numbers(fn(Number) -> S),
}

/// Where a lattice moves corners, integers of 512 bits serve for denominators below this.
const MOVED: i64 = 1 << 50;

impl<'t, const D: usize> Scale<'t, I512, D> {
    /// For coordinates that are stored as integers. With a lattice, the denominator must be small.
    ///
    /// Then a coordinate is less than 2^82 in absolute value: it is stored with 64 bits, and moved
    /// by at most 2^31 steps. Values have at most the degree 4 in coordinates, and factors the
    /// degree 3. Sums add less than 9 bits: factors have less than 255 bits, and values less than 340.
    pub(super) fn wide(tiling: &'t Tiling<D>) -> Option<Self> {
        let Form::Integers {
            numerators,
            denominator,
        } = tiling.vertices.form()
        else {
            return None;
        };
        let is_moved = || tiling.corners.iter().any(|corner| corner.shift != [0; D]);
        if *denominator >= MOVED && (tiling.frame.rank() > 0 || is_moved()) {
            return None;
        }
        Some(Scale {
            unit: Number::from(Rational::from(*denominator)),
            from: Coordinates::Integers(numerators, *denominator, I512::from),
            to_number: |x| Number::from(Rational::from(Integer::from(x))),
        })
    }
}

impl<const D: usize> Scale<'_, Integer, D> {
    /// For rational coordinates.
    pub(super) fn rational(tiling: &Tiling<D>) -> Self {
        Scale {
            unit: common_denominator(tiling),
            from: Coordinates::Numbers(|x| x.to_rational().map_or(Integer::ZERO, |x| x.floor())),
            to_number: |x| Number::from(Rational::from(x)),
        }
    }
}

impl<const D: usize> Scale<'_, Number, D> {
    /// For coordinates in a field.
    pub(super) fn field(tiling: &Tiling<D>) -> Self {
        Scale {
            unit: common_denominator(tiling),
            from: Coordinates::Numbers(|x| x),
            to_number: Number::clone,
        }
    }
}

/// Cleared of their denominators, rational coordinates are integers.
fn common_denominator<const D: usize>(tiling: &Tiling<D>) -> Number {
    let numbers: Vec<Number> = tiling.vertices.iter().flatten().collect();
    Number::from(Rational::from(Number::common_denominator(numbers.iter())))
}

impl<S: Scalar, const D: usize> Scale<'_, S, D> {
    /// The position of a corner; in the plane the third coordinate is zero.
    pub(super) fn point(&self, tiling: &Tiling<D>, corner: &Corner<D>) -> Point<S> {
        match &self.from {
            Coordinates::Integers(numerators, step, scalar) => {
                let vertex = &numerators[corner.vertex.index()];
                from_fn(|k| {
                    let moved =
                        |x: &i64| i128::from(*x) + i128::from(corner.shift[k]) * i128::from(*step);
                    scalar(vertex.get(k).map_or(0, moved))
                })
            }
            Coordinates::Numbers(scalar) => {
                let position = tiling.position(corner);
                from_fn(|k| {
                    let entry = position.get(k).map(|x| x * &self.unit);
                    scalar(entry.unwrap_or_else(Number::zero))
                })
            }
        }
    }

    /// The point in the coordinates of the tiling; `None` for a denominator that is zero.
    pub(super) fn position(&self, point: &Quotient<S>, dimension: usize) -> Option<Vec<Number>> {
        let denominator = (self.to_number)(&point.denominator) * &self.unit;
        let coordinate = |x: &S| {
            let numerator = (self.to_number)(x);
            numerator.divide(&denominator)
        };
        point.numerators[..dimension]
            .iter()
            .map(coordinate)
            .collect()
    }
}

/// A facet in the boundary, by its corners in an order whose normal points out. It is moved to
/// where its least coordinate in each direction of the lattice is in the first cell.
pub(super) struct BoundaryFacet<const D: usize> {
    pub facet: Facet,
    pub corners: [Corner<D>; D],
    /// The lattice vector by which it is moved from its simplex.
    pub by: [i32; D],
    /// Steps of the lattice that the facet reaches to, in each direction.
    pub reach: [i32; D],
}

impl<const D: usize> BoundaryFacet<D> {
    pub(super) fn new(tiling: &Tiling<D>, facet: Facet) -> Self {
        let simplex = tiling.simplex(facet.simplex);
        let opposite = usize::from(facet.opposite);
        let mut corners: [Corner<D>; D] =
            std::array::from_fn(|k| simplex[k + usize::from(k >= opposite)]);
        if opposite % 2 == 1 {
            corners.swap(D - 2, D - 1);
        }
        let cells: Vec<[i32; D]> = corners.iter().map(|corner| cell(tiling, corner)).collect();
        let entries = |k: usize| cells.iter().map(move |cell| cell[k]);
        let least: [i32; D] = std::array::from_fn(|k| entries(k).min().unwrap_or(0));
        let by = difference([0; D], least);
        BoundaryFacet {
            facet,
            corners: corners.map(|corner| corner.moved(by)),
            by,
            reach: std::array::from_fn(|k| entries(k).max().unwrap_or(0) - least[k] + 1),
        }
    }

    /// The ridges of the facet up to translation.
    pub(super) fn ridges(&self) -> impl Iterator<Item = Vec<Corner<D>>> {
        (0..D).map(|left_out| {
            let rest = (0..D).filter(|k| *k != left_out);
            let mut ridge: Vec<Corner<D>> = rest.map(|k| self.corners[k]).collect();
            ridge.sort_unstable();
            let origin = ridge.first().map_or([0; D], |first| first.shift);
            for corner in &mut ridge {
                corner.shift = difference(corner.shift, origin);
            }
            ridge
        })
    }
}

/// The cell of the lattice in which a corner lies; zero in the directions without lattice. The
/// check of regions has found each vertex within the limit of cells.
pub(super) fn cell<const D: usize>(tiling: &Tiling<D>, corner: &Corner<D>) -> [i32; D] {
    let rank = tiling.frame.rank();
    if rank == 0 {
        return [0; D];
    }
    let vertex = tiling.vertices.vertex(corner.vertex);
    let own = cell_of(&vertex, rank).unwrap_or([0; D]);
    std::array::from_fn(|k| {
        if k < rank {
            own[k] + corner.shift[k]
        } else {
            0
        }
    })
}

/// The ranks of each point's coordinates among all; equal ones have equal ranks.
pub(super) fn ranks<S: Scalar>(points: &[Point<S>]) -> Vec<[u32; 3]> {
    let mut ranks = vec![[0; 3]; points.len()];
    for axis in 0..3 {
        let order = |&v: &usize, &w: &usize| points[v][axis].minus(&points[w][axis]).sign();
        let mut sorted: Vec<usize> = (0..points.len()).collect();
        sorted.sort_unstable_by(order);
        for pair in sorted.windows(2) {
            let step = u32::from(order(&pair[0], &pair[1]) == Ordering::Less);
            ranks[pair[1]][axis] = ranks[pair[0]][axis] + step;
        }
    }
    ranks
}

/// Points in lexicographic order.
pub(super) fn compare<S: Scalar>(p: &Point<S>, q: &Point<S>) -> Ordering {
    let entries = p.iter().zip(q).map(|(x, y)| x.minus(y).sign());
    entries.fold(Ordering::Equal, Ordering::then)
}

/// All integer vectors from `low` to `high` in the first `rank` directions.
pub(super) fn vectors<const D: usize>(
    low: [i32; D],
    high: [i32; D],
    rank: usize,
) -> impl Iterator<Item = [i32; D]> {
    let length = move |k: usize| {
        if k < rank {
            (high[k] - low[k] + 1).max(0) as usize
        } else {
            1
        }
    };
    let count: usize = (0..D).map(length).product();
    (0..count).map(move |mut index| {
        std::array::from_fn(|k| {
            let step = index % length(k);
            index /= length(k);
            if k < rank { low[k] + step as i32 } else { 0 }
        })
    })
}
