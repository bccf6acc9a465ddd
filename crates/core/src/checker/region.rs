//! The hypotheses about a region: its boundary meets itself in shared corners and edges
//! only, and no tetrahedron lies outside of it (docs/soundness.md, Theorem 4).
//!
//! The second is asked as it is meant: a point directly outside of a facet in the boundary is in no
//! tetrahedron. The kernel counts crossings of a ray instead.

use super::defect::{BOUNDARY_MEETS, Defect, Findings};
use crate::predicates::ring::common_denominator;
use crate::tiling::{Facet, Matching, Tiling};
use acutile_exact::geometry::boxes::{self, Box3};
use acutile_exact::geometry::triangle::{self, Point, Quotient, Triangle, cross};
use acutile_exact::geometry::{Scalar, linear};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::Floor;
use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Rational};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Hypotheses X and N.
pub fn check_region<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    findings: &mut Findings,
) {
    if D != 3 {
        return findings.add(Defect::RegionDimension);
    }
    // Cleared of their denominators, rational coordinates are integers.
    let unit = Number::from(Rational::from(common_denominator(
        tiling.vertices.iter().flatten().collect::<Vec<_>>().iter(),
    )));
    if tiling.frame.field.degree() == 1 {
        let integer = |x: Number| x.to_rational().map_or(Integer::ZERO, |x| x.floor());
        let number = |x: &Integer| Number::from(Rational::from(x));
        Region::new(tiling, matching, unit, integer, number).check(findings);
    } else {
        Region::new(tiling, matching, unit, |x| x, Number::clone).check(findings);
    }
}

/// So many pairs of facets in the boundary are looked at exactly: some, and for each facet some
/// more. Meshes of solids have a few dozens for each facet.
const PAIRS: usize = 500_000;
const PAIRS_PER_FACET: usize = 30;
/// So many boxes of simplices are compared with boxes of facets.
const COMPARISONS: usize = 2_000_000_000;

struct Region<'t, S, const D: usize> {
    tiling: &'t Tiling<D>,
    /// Coordinates are so many times too large.
    unit: Number,
    points: Vec<Point<S>>,
    to_number: fn(&S) -> Number,
    ranks: Vec<[u32; 3]>,
    boundary: Vec<BoundaryFacet>,
}

/// A facet in the boundary, by its vertices in an order whose normal points out.
struct BoundaryFacet {
    facet: Facet,
    vertices: [usize; 3],
}

impl BoundaryFacet {
    fn new<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> Self {
        let corners = tiling.simplex(facet.simplex as usize);
        let opposite = usize::from(facet.opposite);
        let vertex = |k: usize| corners[k + usize::from(k >= opposite)].vertex as usize;
        let order = if opposite % 2 == 0 {
            [0, 1, 2]
        } else {
            [1, 0, 2]
        };
        BoundaryFacet {
            facet,
            vertices: order.map(vertex),
        }
    }

    fn edges(&self) -> [[usize; 2]; 3] {
        let [a, b, c] = self.vertices;
        [[a, b], [b, c], [c, a]].map(|[p, q]| [p.min(q), p.max(q)])
    }
}

impl<'t, S: Scalar, const D: usize> Region<'t, S, D> {
    fn new(
        tiling: &'t Tiling<D>,
        matching: &Matching<D>,
        unit: Number,
        from_number: fn(Number) -> S,
        to_number: fn(&S) -> Number,
    ) -> Self {
        let used_once = matching.mismatches.iter().filter(|m| m.uses.len() == 1);
        let boundary = used_once.map(|m| BoundaryFacet::new(tiling, m.uses[0].0));
        let point = |vertex: [Number; D]| std::array::from_fn(|k| from_number(&vertex[k] * &unit));
        let points: Vec<Point<S>> = tiling.vertices.iter().map(point).collect();
        Region {
            tiling,
            ranks: ranks(&points),
            points,
            unit,
            to_number,
            boundary: boundary.collect(),
        }
    }

    fn check(&self, findings: &mut Findings) {
        self.check_vertices_differ(findings);
        self.check_boundary(findings);
        // A simplex that is not positively oriented has no sides.
        let is_oriented = ["flat", "negative-orientation", "repeated-corner"]
            .iter()
            .all(|code| !findings.counts().contains_key(code));
        if is_oriented {
            self.check_covering(findings);
        }
    }

    /// Different vertices are different points. This follows from the other hypotheses, and
    /// says more plainly what is wrong.
    fn check_vertices_differ(&self, findings: &mut Findings) {
        let mut at: BTreeMap<[u32; 3], Vec<usize>> = BTreeMap::new();
        for (vertex, &ranks) in self.ranks.iter().enumerate() {
            at.entry(ranks).or_default().push(vertex);
        }
        let mut coinciding: Vec<_> = at.into_values().filter(|v| v.len() > 1).collect();
        coinciding.sort();
        for vertices in coinciding {
            findings.add(Defect::CoincidentVertices { vertices });
        }
    }

    /// Any two facets in the boundary meet in what their common vertices span.
    fn check_boundary(&self, findings: &mut Findings) {
        let points = |f: &BoundaryFacet| Triangle::new(f.vertices.map(|v| &self.points[v]));
        let triangles: Vec<Option<Triangle<S>>> = self.boundary.iter().map(points).collect();
        let extents: Vec<Box3> = self
            .boundary
            .iter()
            .map(|f| self.extent(&f.vertices))
            .collect();
        let meeting = |f: usize, g: usize| {
            // A triangle with its corners on a line belongs to a flat simplex, already reported.
            let (first, second) = (triangles[f].as_ref()?, triangles[g].as_ref()?);
            self.meeting((&self.boundary[f], first), (&self.boundary[g], second))
        };
        let limit = PAIRS + PAIRS_PER_FACET * self.boundary.len();
        let Some(pairs) = boxes::overlapping_pairs(&extents, limit) else {
            return findings.add(Defect::BoundaryWork { limit });
        };
        let mut pairs: Vec<(usize, usize)> = pairs
            .into_par_iter()
            .filter(|(f, g)| meeting(*f, *g).is_some())
            .collect();
        pairs.sort_unstable();
        for (f, g) in pairs {
            findings.add_with(BOUNDARY_MEETS, || Defect::BoundaryMeets {
                facets: (self.boundary[f].facet, self.boundary[g].facet),
                point: meeting(f, g).map_or_else(Vec::new, |point| self.position(&point)),
            });
        }
    }

    /// A common point of two triangles that is not in the hull of their common vertices.
    fn meeting(
        &self,
        (f, first): (&BoundaryFacet, &Triangle<S>),
        (g, second): (&BoundaryFacet, &Triangle<S>),
    ) -> Option<Quotient<S>> {
        let (rest_f, rest_g) = (rest(f, g), rest(g, f));
        match (&rest_f[..], &rest_g[..]) {
            (&[p], &[q]) => {
                let edge = f.edges().into_iter().find(|edge| !edge.contains(&p))?;
                let [p, q] = [p, q].map(|v| &self.points[v]);
                triangle::folded(edge.map(|v| &self.points[v]), p, q)
            }
            (&[p, q], &[r, s]) => self
                .pierced(&[[p, q]], g, second)
                .or_else(|| self.pierced(&[[r, s]], f, first)),
            _ => self
                .pierced(&f.edges(), g, second)
                .or_else(|| self.pierced(&g.edges(), f, first)),
        }
    }

    /// A point in which one of these edges meets the triangle.
    fn pierced(
        &self,
        edges: &[[usize; 2]],
        facet: &BoundaryFacet,
        triangle: &Triangle<S>,
    ) -> Option<Quotient<S>> {
        let extent = self.extent(&facet.vertices);
        let near = edges
            .iter()
            .filter(|edge| boxes::overlap(&self.extent(&edge[..]), &extent));
        near.into_iter()
            .find_map(|&[p, q]| triangle.meets_segment(&self.points[p], &self.points[q]))
    }

    fn extent(&self, vertices: &[usize]) -> Box3 {
        let at = |&v: &usize| self.ranks[v].map(|rank| (rank, rank));
        boxes::hull(vertices.iter().map(at))
    }

    /// The point in the coordinates of the tiling.
    fn position(&self, point: &Quotient<S>) -> Vec<Number> {
        let denominator = (self.to_number)(&point.denominator) * &self.unit;
        let coordinate = |x: &S| {
            let numerator = (self.to_number)(x);
            numerator.divide(&denominator).unwrap_or_else(Number::zero)
        };
        point.numerators.iter().map(coordinate).collect()
    }

    /// No tetrahedron is directly outside of a facet in the boundary, asked once for each class
    /// of facets that are joined by edges which no third one has.
    fn check_covering(&self, findings: &mut Findings) {
        let classes = self.first_of_classes();
        if classes.len().saturating_mul(self.tiling.len()) > COMPARISONS {
            return findings.add(Defect::BoundaryWork { limit: COMPARISONS });
        }
        let tiles: Vec<Box3> = self
            .tiling
            .simplices()
            .map(|corners| boxes::hull(corners.iter().map(|c| self.extent(&[c.vertex as usize]))))
            .collect();
        for facet in classes {
            let extent = self.extent(&facet.vertices);
            let near = (0..tiles.len()).filter(|&t| boxes::overlap(&tiles[t], &extent));
            let simplices: Vec<usize> = near.filter(|&t| self.is_outside_in(facet, t)).collect();
            if !simplices.is_empty() {
                findings.add(Defect::Covered {
                    facet: facet.facet,
                    simplices,
                });
            }
        }
    }

    /// Whether the points directly outside of the centroid m of a facet lie in a simplex. The points are
    /// m + δ (n + ε e_1 + ε² e_2 + ε³ e_3), for the outward normal n and small δ and ε; a
    /// barycentric coordinate with the gradient g has the sign there of the first that is not zero of its value at m,
    /// g · n and the entries of g. For a coordinate system let n be the covector itself: it
    /// is positive at itself.
    fn is_outside_in(&self, facet: &BoundaryFacet, simplex: usize) -> bool {
        let corners = self.tiling.simplex(simplex);
        let [a, b, c] = facet.vertices.map(|v| &self.points[v]);
        let normal = cross(&linear::subtract(b, a), &linear::subtract(c, a));
        (0..4).all(|opposite| {
            let others: Vec<&Point<S>> = (0..4)
                .filter(|&k| k != opposite)
                .map(|k| &self.points[corners[k].vertex as usize])
                .collect();
            let Some(plane) = Triangle::new([others[0], others[1], others[2]]) else {
                return false;
            };
            let inner = plane
                .value(&self.points[corners[opposite].vertex as usize])
                .sign();
            let at_centroid = plane.value(a).plus(&plane.value(b)).plus(&plane.value(c));
            let signs = [
                at_centroid.sign(),
                linear::dot(&plane.normal, &normal).sign(),
            ];
            let signs = signs.into_iter().chain(plane.normal.iter().map(S::sign));
            inner.is_ne() && signs.into_iter().find(|sign| sign.is_ne()) == Some(inner)
        })
    }

    fn first_of_classes(&self) -> Vec<&BoundaryFacet> {
        let mut at_edge: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (index, facet) in self.boundary.iter().enumerate() {
            for edge in facet.edges() {
                at_edge.entry(edge).or_default().push(index);
            }
        }
        let mut classes = Classes((0..self.boundary.len()).collect());
        for facets in at_edge.values() {
            if let [f, g] = facets[..] {
                classes.join(f, g);
            }
        }
        let firsts = (0..self.boundary.len()).filter(|&f| classes.first(f) == f);
        firsts.map(|f| &self.boundary[f]).collect()
    }
}

/// Disjoint sets; each is named by its least element, to which the entries lead, the shorter
/// the oftener they are followed.
struct Classes(Vec<usize>);

impl Classes {
    fn first(&mut self, mut item: usize) -> usize {
        while self.0[item] != item {
            self.0[item] = self.0[self.0[item]];
            item = self.0[item];
        }
        item
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.first(a), self.first(b));
        self.0[a.max(b)] = a.min(b);
    }
}

/// The vertices of f that g does not have.
fn rest(f: &BoundaryFacet, g: &BoundaryFacet) -> Vec<usize> {
    let own = f.vertices.into_iter();
    own.filter(|vertex| !g.vertices.contains(vertex)).collect()
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
