//! Boundary facets in their own place and moved near to others, and the points in which two meet.
//!
//! Coordinates are compared by their ranks among all, so that boxes are exact.

use super::region::Region;
use crate::tiling::Corner;
use acutile_exact::geometry::Scalar;
use acutile_exact::geometry::boxes::{self, Box3};
use acutile_exact::geometry::triangle::{self, Point, Quotient, Triangle};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Boundary facets in their own place, and moved near to others.
pub(super) struct Copies<S, const D: usize> {
    /// The facets in their own place come first.
    pub list: Vec<Copy<D>>,
    bases: usize,
    points: Vec<Point<S>>,
    pub extents: Vec<Box3>,
    ranks: Vec<[u32; 3]>,
}

/// A facet that is moved by a lattice vector.
pub(super) struct Copy<const D: usize> {
    /// Index of the boundary facet.
    pub facet: usize,
    /// Indices of its corners' points.
    points: [usize; D],
}

impl<S: Scalar, const D: usize> Copies<S, D> {
    /// `None` if there would be more than `limit`.
    pub(super) fn of(region: &Region<S, D>, limit: usize) -> Option<Self> {
        let rank = region.tiling.frame.rank();
        let boundary = &region.boundary;
        let reach: [i32; D] =
            std::array::from_fn(|k| boundary.iter().map(|f| f.reach[k]).max().unwrap_or(0));
        let mut indices: BTreeMap<Corner<D>, usize> = BTreeMap::new();
        let mut list = Vec::new();
        let mut add = |facet: usize, by: [i32; D]| {
            let corners = boundary[facet].corners.map(|corner| corner.moved(by));
            list.push(Copy {
                facet,
                points: corners.map(|corner| {
                    let next = indices.len();
                    *indices.entry(corner).or_insert(next)
                }),
            });
            list.len() <= limit
        };
        for facet in 0..boundary.len() {
            add(facet, [0; D]);
        }
        for facet in 0..boundary.len() {
            // A copy that overlaps the first cells is moved by at most `reach`.
            let low = boundary[facet].reach.map(|steps| -steps);
            for by in vectors(low, reach, rank).filter(|by| *by > [0; D]) {
                if !add(facet, by) {
                    return None;
                }
            }
        }
        let mut corners: Vec<(Corner<D>, usize)> = indices.into_iter().collect();
        corners.sort_unstable_by_key(|(_, index)| *index);
        let point = |(corner, _): &(Corner<D>, usize)| region.scale.point(region.tiling, corner);
        let points: Vec<Point<S>> = corners.iter().map(point).collect();
        let mut copies = Copies {
            ranks: ranks(&points),
            points,
            bases: boundary.len(),
            extents: Vec::new(),
            list,
        };
        copies.extents = copies
            .list
            .iter()
            .map(|c| copies.extent(&c.points))
            .collect();
        Some(copies)
    }

    pub(super) fn is_base(&self, copy: usize) -> bool {
        copy < self.bases
    }

    fn extent(&self, points: &[usize]) -> Box3 {
        let at = |&p: &usize| self.ranks[p].map(|rank| (rank, rank));
        boxes::hull(points.iter().map(at))
    }

    /// A common point of two copies that is not in the hull of their common corners.
    pub(super) fn meeting(&self, f: usize, g: usize) -> Option<Quotient<S>> {
        let (f, g) = (&self.list[f].points[..], &self.list[g].points[..]);
        match (f, g) {
            (&[a, b, c], &[p, q, r]) => self.triangles_meet([a, b, c], [p, q, r]),
            (&[a, b], &[p, q]) => self.segments_meet([a, b], [p, q]),
            _ => None,
        }
    }

    fn segments_meet(&self, f: [usize; 2], g: [usize; 2]) -> Option<Quotient<S>> {
        let at = |point: usize| &self.points[point];
        match (&rest(&f, &g)[..], &rest(&g, &f)[..]) {
            (&[p], &[q]) => {
                let common = f.into_iter().find(|point| *point != p)?;
                triangle::aligned(at(common), at(p), at(q))
            }
            _ => triangle::segments_meet((at(f[0]), at(f[1])), (at(g[0]), at(g[1]))),
        }
    }

    fn triangles_meet(&self, f: [usize; 3], g: [usize; 3]) -> Option<Quotient<S>> {
        let triangle = |f: [usize; 3]| Triangle::new(f.map(|point| &self.points[point]));
        // A triangle with its corners on a line belongs to a flat simplex, already reported.
        let (first, second) = (triangle(f)?, triangle(g)?);
        match (&rest(&f, &g)[..], &rest(&g, &f)[..]) {
            (&[p], &[q]) => {
                let edge = edges(f).into_iter().find(|edge| !edge.contains(&p))?;
                let [p, q] = [p, q].map(|v| &self.points[v]);
                triangle::folded(edge.map(|v| &self.points[v]), p, q)
            }
            (&[p, q], &[r, s]) => self
                .pierced(&[[p, q]], g, &second)
                .or_else(|| self.pierced(&[[r, s]], f, &first)),
            _ => self
                .pierced(&edges(f), g, &second)
                .or_else(|| self.pierced(&edges(g), f, &first)),
        }
    }

    /// A point in which one of these edges meets the triangle.
    fn pierced(
        &self,
        edges: &[[usize; 2]],
        corners: [usize; 3],
        triangle: &Triangle<S>,
    ) -> Option<Quotient<S>> {
        let extent = self.extent(&corners);
        let near = edges
            .iter()
            .filter(|edge| boxes::overlap(&self.extent(&edge[..]), &extent));
        near.into_iter()
            .find_map(|&[p, q]| triangle.meets_segment(&self.points[p], &self.points[q]))
    }
}

fn edges([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The entries of f that g does not have.
fn rest<const N: usize>(f: &[usize; N], g: &[usize; N]) -> Vec<usize> {
    let own = f.iter().copied();
    own.filter(|point| !g.contains(point)).collect()
}

/// All integer vectors from `low` to `high` in the first `rank` directions.
fn vectors<const D: usize>(
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

/// The ranks of each point's coordinates among all; equal ones have equal ranks.
fn ranks<S: Scalar>(points: &[Point<S>]) -> Vec<[u32; 3]> {
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
