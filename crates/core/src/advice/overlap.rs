//! Two simplices that overlap, and a point inside of both.

use super::place::{Extent, Places};
use crate::tiling::{Corner, Facet, SimplexId, Tiling, difference};
use acutile_exact::geometry::{Sign, Simplex, linear};
use acutile_exact::number::Number;
use malachite::Rational;

/// Two simplices with a common inner point.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlap<const D: usize> {
    /// Their indices; the second is moved by `shift`.
    pub simplices: (SimplexId, SimplexId),
    /// The lattice vector that moves the second.
    pub shift: [i32; D],
    /// A point in the interior of both, in basis coordinates.
    pub point: [Number; D],
}

/// No search looks at more translates of one simplex.
const TRANSLATES_LIMIT: f64 = 1e4;

/// A simplex or a translate that overlaps with simplex `index`.
pub fn partner<const D: usize>(
    tiling: &Tiling<D>,
    places: &Places<D>,
    index: SimplexId,
) -> Option<Overlap<D>> {
    let extent = places.extent(tiling.simplex(index));
    tiling.indices().find_map(|other| {
        let there = places.extent(tiling.simplex(other));
        let shifts = shifts(&extent, &there, places.rank).into_iter();
        shifts
            .filter(|shift| other != index || *shift != [0; D])
            .find_map(|shift| overlap(tiling, (index, other), shift))
    })
}

/// The overlap of two simplices on the same side of a facet that they share.
pub fn behind_common_facet<const D: usize>(
    tiling: &Tiling<D>,
    a: Facet,
    b: Facet,
) -> Option<Overlap<D>> {
    let first = |facet: Facet| -> Option<Corner<D>> {
        let corners = tiling.simplex(facet.simplex).iter().enumerate();
        corners
            .filter(|(k, _)| *k != usize::from(facet.opposite))
            .map(|(_, corner)| *corner)
            .min()
    };
    let shift = difference(first(a)?.shift, first(b)?.shift);
    overlap(tiling, (a.simplex, b.simplex), shift)
}

/// Two simplices, the second moved by `shift`, if they overlap.
pub fn overlap<const D: usize>(
    tiling: &Tiling<D>,
    simplices: (SimplexId, SimplexId),
    shift: [i32; D],
) -> Option<Overlap<D>> {
    let corners = |index: SimplexId, shift: [i32; D]| -> Vec<[Number; D]> {
        let corners = tiling.simplex(index).iter();
        corners.map(|c| tiling.position(&c.moved(shift))).collect()
    };
    let point = common_point(&corners(simplices.0, [0; D]), &corners(simplices.1, shift))?;
    Some(Overlap {
        simplices,
        shift,
        point,
    })
}

/// The lattice vectors that may bring the second box to meet the first.
fn shifts<const D: usize>(here: &Extent<D>, there: &Extent<D>, rank: usize) -> Vec<[i32; D]> {
    let low: [f64; D] = std::array::from_fn(|k| (here.low[k] - there.high[k]).ceil());
    let high: [f64; D] = std::array::from_fn(|k| (here.high[k] - there.low[k]).floor());
    let meets = (rank..D).all(|k| low[k] <= 0.0 && high[k] >= 0.0);
    let count: f64 = (0..rank)
        .map(|k| (high[k] - low[k] + 1.0).max(0.0))
        .product();
    if !meets || !(1.0..TRANSLATES_LIMIT).contains(&count) {
        return Vec::new();
    }
    (0..rank).fold(vec![[0; D]], |shorter, k| {
        let range = low[k] as i32..=high[k] as i32;
        let longer = |shift: &[i32; D], s: i32| {
            let mut shift = *shift;
            shift[k] = s;
            shift
        };
        shorter
            .iter()
            .flat_map(|shift| range.clone().map(move |s| longer(shift, s)))
            .collect()
    })
}

/// A point in the interior of two simplices that are not flat, where there is one.
///
/// The intersection is the convex hull of two kinds of points. Some are corners of one simplex in the
/// other. The others are points of the other simplex at which an edge of one crosses the hyperplane of a
/// facet. The mean of these is in the relative interior of the hull; so it is in both interiors, or they
/// have no common point.
pub fn common_point<const D: usize>(s: &[[Number; D]], t: &[[Number; D]]) -> Option<[Number; D]> {
    let (s, t) = (Body::new(s), Body::new(t));
    let mut hull = s.points_in(&t);
    hull.extend(t.points_in(&s));
    if hull.is_empty() {
        return None;
    }
    let share = Number::from(Rational::from_signeds(1, hull.len() as i64));
    let mean = std::array::from_fn(|k| {
        let sum = hull.iter().fold(Number::zero(), |sum, p| &sum + &p[k]);
        &sum * &share
    });
    (s.has_inside(&mean) && t.has_inside(&mean)).then_some(mean)
}

/// A simplex with its barycentric coordinates.
struct Body<'c, const D: usize> {
    corners: &'c [[Number; D]],
    simplex: Simplex<Number, D>,
}

impl<'c, const D: usize> Body<'c, D> {
    fn new(corners: &'c [[Number; D]]) -> Self {
        Body {
            corners,
            simplex: Simplex::new(corners),
        }
    }

    /// |d| times the barycentric coordinates of a point, d the determinant.
    fn coordinates(&self, point: &[Number; D]) -> Vec<Number> {
        let offset = linear::subtract(point, &self.corners[0]);
        let others: Vec<Number> = self
            .simplex
            .gradients
            .iter()
            .map(|gradient| linear::dot(gradient, &offset))
            .collect();
        let rest = others
            .iter()
            .fold(self.simplex.determinant.clone(), |rest, x| &rest - x);
        let all = std::iter::once(rest).chain(others);
        match self.simplex.determinant.sign() {
            Sign::Less => all.map(|x| -x).collect(),
            _ => all.collect(),
        }
    }

    fn has_inside(&self, point: &[Number; D]) -> bool {
        let mut signs = self.coordinates(point).into_iter().map(|x| x.sign());
        signs.all(|sign| sign == Sign::Greater)
    }

    fn contains(&self, point: &[Number; D]) -> bool {
        let mut signs = self.coordinates(point).into_iter().map(|x| x.sign());
        signs.all(|sign| sign != Sign::Less)
    }

    /// The corners in `other`, and where the edges cross its facets.
    fn points_in(&self, other: &Body<D>) -> Vec<[Number; D]> {
        let coordinates: Vec<Vec<Number>> =
            self.corners.iter().map(|c| other.coordinates(c)).collect();
        let mut points: Vec<[Number; D]> = self.corners.to_vec();
        for i in 0..=D {
            for j in 0..i {
                for k in 0..=D {
                    let (a, b) = (&coordinates[i][k], &coordinates[j][k]);
                    if a.sign() == b.sign().reverse() && a.sign() != Sign::Equal {
                        points.extend(self.crossing(i, j, a, b));
                    }
                }
            }
        }
        points.retain(|point| other.contains(point));
        points
    }

    /// The point of the edge ij at which a function with the values a and b at its ends vanishes.
    fn crossing(&self, i: usize, j: usize, a: &Number, b: &Number) -> Option<[Number; D]> {
        let (p, q) = (&self.corners[i], &self.corners[j]);
        let part = a.divide(&(a - b))?;
        Some(std::array::from_fn(|k| &p[k] + &(&part * &(&q[k] - &p[k]))))
    }
}
