//! The simplices that contain the points directly outside of a boundary facet.
//!
//! Doubles with a margin leave out simplices, and lattice translates of them, whose box is away
//! from the facet's centroid. The others are decided exactly.

use super::boundary::{BoundaryFacet, Scale};
use crate::tiling::{Corner, SimplexId, Tiling, VertexId};
use acutile_exact::geometry::triangle::Point;
use acutile_exact::geometry::{Scalar, linear};
use acutile_exact::number::Number;
use rayon::prelude::*;

/// A tiling made ready for the search.
pub(super) struct Outside<'t, S, const D: usize> {
    tiling: &'t Tiling<D>,
    scale: &'t Scale<S>,
    /// The vertices, each coordinate up to a relative error of 2^-51.
    floats: Vec<[f64; D]>,
}

/// Larger than the relative error of a sum of two coordinates and a shift of 2^26 steps.
const MARGIN: f64 = 1.0 / (1u64 << 40) as f64;

impl<'t, S: Scalar, const D: usize> Outside<'t, S, D> {
    pub(super) fn new(tiling: &'t Tiling<D>, scale: &'t Scale<S>) -> Self {
        let vertices = (0..tiling.vertices.len()).into_par_iter();
        let double = |vertex: usize| {
            let vertex = VertexId::at(vertex);
            tiling
                .vertices
                .vertex(vertex)
                .map(|x| Number::approximate(&x))
        };
        Outside {
            tiling,
            scale,
            floats: vertices.map(double).collect(),
        }
    }

    /// The simplices, in order, a translate of which contains the points.
    pub(super) fn simplices(&self, facet: &BoundaryFacet<D>) -> Vec<SimplexId> {
        let points = facet
            .corners
            .each_ref()
            .map(|c| self.scale.point(self.tiling, c));
        let normal = outward(&points);
        let corners = facet.corners.each_ref().map(|corner| self.position(corner));
        let centroid: [f64; D] =
            std::array::from_fn(|k| corners.iter().map(|corner| corner[k]).sum::<f64>() / D as f64);
        let simplices = (0..self.tiling.len()).into_par_iter().map(SimplexId::at);
        let found = simplices.filter(|&simplex| {
            let near = self.near(simplex, &centroid);
            near.into_iter()
                .any(|by| self.contains(simplex, by, &points, &normal))
        });
        found.collect()
    }

    fn position(&self, corner: &Corner<D>) -> [f64; D] {
        let vertex = &self.floats[corner.vertex.index()];
        std::array::from_fn(|k| vertex[k] + f64::from(corner.shift[k]))
    }

    /// The lattice vectors by which the simplex's box may come to hold the point.
    fn near(&self, simplex: SimplexId, point: &[f64; D]) -> Vec<[i32; D]> {
        let rank = self.tiling.frame.rank();
        let mut ranges = [(0, 0); D];
        for k in 0..D {
            let (mut low, mut high, mut size) = (f64::INFINITY, f64::NEG_INFINITY, 1.0f64);
            for corner in self.tiling.simplex(simplex) {
                let vertex = self.floats[corner.vertex.index()][k];
                let x = vertex + f64::from(corner.shift[k]);
                (low, high) = (low.min(x), high.max(x));
                size = size.max(vertex.abs()).max(x.abs());
            }
            let margin = MARGIN * (size + point[k].abs());
            let (first, last) = (point[k] - high - margin, point[k] - low + margin);
            if k >= rank {
                if first > 0.0 || last < 0.0 {
                    return Vec::new();
                }
            } else if first.ceil() > last.floor() {
                return Vec::new();
            } else {
                ranges[k] = (first.ceil() as i32, last.floor() as i32);
            }
        }
        ranges
            .into_iter()
            .enumerate()
            .fold(vec![[0; D]], |list, (k, (first, last))| {
                let longer = |by: [i32; D]| {
                    (first..=last).map(move |step| {
                        let mut longer = by;
                        longer[k] = step;
                        longer
                    })
                };
                list.into_iter().flat_map(longer).collect()
            })
    }

    /// Whether the points directly outside of the centroid m of a facet lie in the simplex, moved.
    /// The points are m + δ (n + ε e_1 + ε² e_2 + ε³ e_3), for the outward normal n and small δ and
    /// ε. A barycentric coordinate with the gradient g has there the sign of the first that is
    /// not zero of its value at m, g · n and the entries of g. For a coordinate system let n be
    /// the covector itself: it is positive at itself.
    fn contains(
        &self,
        simplex: SimplexId,
        by: [i32; D],
        facet: &[Point<S>; D],
        normal: &Point<S>,
    ) -> bool {
        let corners = self.tiling.simplex(simplex).iter();
        let points: Vec<Point<S>> = corners
            .map(|corner| self.scale.point(self.tiling, &corner.moved(by)))
            .collect();
        (0..=D).all(|opposite| {
            let others = (0..=D).filter(|k| *k != opposite).map(|k| &points[k]);
            let others: Vec<&Point<S>> = others.collect();
            let gradient = conormal(&others);
            let value = |x: &Point<S>| linear::dot(&gradient, &linear::subtract(x, others[0]));
            let inner = value(&points[opposite]).sign();
            let at_centroid = facet.iter().map(value).reduce(|x, y| x.plus(&y));
            let signs = [
                at_centroid.map_or(inner, |x| x.sign()),
                linear::dot(&gradient, normal).sign(),
            ];
            let signs = signs.into_iter().chain(gradient.iter().map(S::sign));
            inner.is_ne() && signs.into_iter().find(|sign| sign.is_ne()) == Some(inner)
        })
    }
}

/// A covector that is constant on the hull of two points of the plane z = 0, or of three points
/// of space.
fn conormal<S: Scalar>(points: &[&Point<S>]) -> Point<S> {
    let along = linear::subtract(points[1], points[0]);
    match points.get(2) {
        Some(third) => linear::cross(&along, &linear::subtract(third, points[0])),
        None => {
            let zero = along[2].clone();
            [along[1].clone(), zero.minus(&along[0]), zero]
        }
    }
}

/// The covector that grows outwards. In the plane the inside is on the left, and (y, -x) is on
/// the right of (x, y).
fn outward<S: Scalar, const D: usize>(points: &[Point<S>; D]) -> Point<S> {
    let points: Vec<&Point<S>> = points.iter().collect();
    conormal(&points)
}
