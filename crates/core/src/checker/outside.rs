//! The simplices that contain the points directly outside of a boundary facet.
//!
//! Doubles with a margin leave out simplices, and lattice translates of them, whose box is away
//! from the facet's centroid. The others are decided exactly.

use super::apart::conormal;
use super::boundary::{BoundaryFacet, Scale};
use crate::parallel;
use crate::tiling::coordinates::Form;
use crate::tiling::{Corner, SimplexId, Tiling, VertexId};
use acutile_exact::geometry::triangle::Point;
use acutile_exact::geometry::{Scalar, linear};
use acutile_exact::number::Number;

/// A tiling made ready for the search.
pub(super) struct Outside<'t, S, const D: usize> {
    tiling: &'t Tiling<D>,
    scale: &'t Scale<'t, S, D>,
    /// The vertices, each coordinate up to a relative error of 2^-51.
    floats: Vec<[f64; D]>,
}

/// The number of simplices in the work of one thread at a time.
const CHUNK: usize = 1 << 10;

/// Larger than the relative error of a sum of two coordinates and a shift of 2^26 steps.
const MARGIN: f64 = 1.0 / (1u64 << 40) as f64;

impl<'t, S: Scalar, const D: usize> Outside<'t, S, D> {
    pub(super) fn new(tiling: &'t Tiling<D>, scale: &'t Scale<'t, S, D>) -> Self {
        let floats = match tiling.vertices.form() {
            // Three roundings.
            Form::Integers {
                numerators,
                denominator,
            } => {
                let double = |x: &i64| *x as f64 / *denominator as f64;
                parallel::map(numerators.len(), |v| numerators[v].each_ref().map(double))
            }
            _ => parallel::map(tiling.vertices.len(), |v| {
                let vertex = tiling.vertices.vertex(VertexId::at(v));
                vertex.map(|x| Number::approximate(&x))
            }),
        };
        Outside {
            tiling,
            scale,
            floats,
        }
    }

    /// The simplices, in order, a translate of which contains the points, and the lattice vector.
    pub(super) fn simplices(&self, facet: &BoundaryFacet<D>) -> Vec<(SimplexId, [i32; D])> {
        let points = facet
            .corners
            .each_ref()
            .map(|c| self.scale.point(self.tiling, c));
        let normal = outward(&points);
        let corners = facet.corners.each_ref().map(|corner| self.position(corner));
        let centroid: [f64; D] =
            std::array::from_fn(|k| corners.iter().map(|corner| corner[k]).sum::<f64>() / D as f64);
        let contains = |simplex: SimplexId| {
            let mut near = self.near(simplex, &centroid).into_iter();
            let by = near.find(|by| self.contains(simplex, *by, &points, &normal))?;
            Some((simplex, by))
        };
        let found = parallel::by_chunks(self.tiling.len(), CHUNK, |simplices| {
            let simplices = simplices.map(SimplexId::at);
            simplices.filter_map(contains).collect::<Vec<_>>()
        });
        found.concat()
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

/// The covector that grows outwards. In the plane the inside is on the left, and (y, -x) is on
/// the right of (x, y).
fn outward<S: Scalar, const D: usize>(points: &[Point<S>; D]) -> Point<S> {
    let points: Vec<&Point<S>> = points.iter().collect();
    conormal(&points)
}
