//! A boundary facet in its place, and its coordinates as scalars.

use crate::tiling::{Corner, Facet, Tiling, difference, floor};
use acutile_exact::geometry::Scalar;
use acutile_exact::geometry::triangle::{Point, Quotient};
use acutile_exact::number::Number;
use std::cmp::Ordering;

/// How numbers become scalars, and back.
pub(super) struct Scale<S> {
    /// All coordinates are multiplied by this number.
    pub unit: Number,
    pub from_number: fn(Number) -> S,
    pub to_number: fn(&S) -> Number,
}

impl<S: Scalar> Scale<S> {
    /// The position of a corner; in the plane the third coordinate is zero.
    pub(super) fn point<const D: usize>(&self, tiling: &Tiling<D>, corner: &Corner<D>) -> Point<S> {
        let position = tiling.position(corner);
        std::array::from_fn(|k| match position.get(k) {
            Some(x) => (self.from_number)(x * &self.unit),
            None => (self.from_number)(Number::zero()),
        })
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

/// The cell of the lattice in which a corner lies; zero in the directions without lattice.
pub(super) fn cell<const D: usize>(tiling: &Tiling<D>, corner: &Corner<D>) -> [i32; D] {
    let rank = tiling.frame.rank();
    if rank == 0 {
        return [0; D];
    }
    let vertex = tiling.vertices.vertex(corner.vertex);
    std::array::from_fn(|k| match k < rank {
        true => floor(&vertex[k]) + corner.shift[k],
        false => 0,
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
    let length = move |k: usize| match k < rank {
        true => (high[k] - low[k] + 1).max(0) as usize,
        false => 1,
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
