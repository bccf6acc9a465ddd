//! The hypotheses about a region of any rank (docs/soundness.md, Theorem 4).
//!
//! **X.** Two facets in the boundary, up to the lattice, meet in the hull of their common corners.
//! **W.** No simplex lies directly outside of one boundary facet of each class. Classes join facets
//! that share a ridge which no third boundary facet has.
//!
//! A pair of boundary facets is compared once, up to translation: each facet in its own place
//! with all facets that a lattice vector not before zero moves near to it.

use super::boundary::{Scale, cell, compare, ranks, vectors};
use super::contact::{self, Contacts};
use super::defect::{BOUNDARY_MEETS, BOUNDARY_WORK, Defect};
use super::findings::Findings;
use super::hypotheses::Unsided;
use super::meeting::{CoveredFacet, Found, Meeting, Region};
use super::outside::Outside;
use crate::anatomy::Union;
use crate::parallel;
use crate::tiling::coordinates::Form;
use crate::tiling::{Corner, Facet, Matching, SimplexId, Tiling, cell_of, difference};
use acutile_exact::geometry::Scalar;
use acutile_exact::geometry::boxes::{self, Box3};
use acutile_exact::geometry::triangle::{self, Point, Quotient, Triangle};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// Hypotheses X and W.
pub fn check_region<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    findings: &mut Findings,
) {
    check_region_beside(tiling, matching, &Unsided::default(), findings);
}

/// The same for a tiling with flat or negative simplices. Gives the boundary facets for which an
/// interface is reported.
pub(super) fn check_region_beside<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    unsided: &Unsided,
    findings: &mut Findings,
) -> BTreeSet<Facet> {
    if let Some(scale) = Scale::wide(tiling) {
        Region::new(tiling, matching, scale).check(unsided, findings)
    } else if tiling.frame.field.degree() == 1 {
        Region::new(tiling, matching, Scale::rational(tiling)).check(unsided, findings)
    } else {
        Region::new(tiling, matching, Scale::field(tiling)).check(unsided, findings)
    }
}

/// The most pairs of boundary facets that are compared exactly: a number, and some more for each
/// facet. Meshes of solids have a few dozens for each facet.
const PAIRS: usize = 4_000_000;
const PAIRS_PER_FACET: usize = 30;
/// The most facets that are moved by lattice vectors, beside a few for each facet.
const COPIES: usize = 200_000;
/// The most translates of simplices that are searched in a cell of the lattice.
const TRANSLATES: usize = 20_000_000;
/// The most boxes of simplices that are compared with boxes of facets.
const COMPARISONS: usize = 2_000_000_000;

impl<S: Scalar, const D: usize> Region<'_, S, D> {
    fn check(&self, unsided: &Unsided, findings: &mut Findings) -> BTreeSet<Facet> {
        let is_closed = self.boundary.is_empty() && findings.is_empty();
        if is_closed && !self.tiling.is_empty() {
            findings.add(Defect::NoBoundary);
        }
        if let Some(vertex) = self.far_vertex() {
            findings.add(Defect::VertexFar { vertex });
            return BTreeSet::new();
        }
        if self.translates() > TRANSLATES as f64 {
            findings.add(Defect::BoundaryWork { limit: TRANSLATES });
            return BTreeSet::new();
        }
        let is_without = |codes: &[&str]| {
            let mut codes = codes.iter();
            codes.all(|code| !findings.counts().contains_key(code))
        };
        // A simplex that is not positively oriented has no sides.
        let is_oriented = is_without(&["flat", "negative-orientation", "repeated-corner"]);
        let is_matched = is_without(&["same-side", "overused-facet", "unmatched-facet"]);
        let mut plain = Findings::new(findings.limit());
        self.check_vertices_differ(&mut plain);
        let meeting = self.check_boundary(unsided, &mut plain);
        let covered = if is_oriented {
            self.check_covering(&mut plain)
        } else {
            Vec::new()
        };
        let is_decided = !plain.is_empty() && !plain.counts().contains_key(BOUNDARY_WORK);
        let explained = (is_oriented && is_matched && is_decided)
            .then(|| contact::explain(self, &Found { meeting, covered }, &plain))
            .flatten();
        let Contacts {
            findings: found,
            facets,
        } = explained.unwrap_or(Contacts {
            findings: plain,
            facets: BTreeSet::new(),
        });
        findings.append(found);
        facets
    }

    /// The first vertex beyond the limit of cells.
    fn far_vertex(&self) -> Option<usize> {
        let rank = self.tiling.frame.rank();
        if rank == 0 {
            return None;
        }
        let mut vertices = self.tiling.vertices.iter();
        vertices.position(|vertex| cell_of(&vertex, rank).is_none())
    }

    /// How many translates of simplices come near a cell of the lattice, about.
    fn translates(&self) -> f64 {
        let rank = self.tiling.frame.rank();
        if rank == 0 {
            return 0.0;
        }
        let of_simplex = |corners: &[Corner<D>]| -> f64 {
            let cells: Vec<[i32; D]> = corners.iter().map(|c| cell(self.tiling, c)).collect();
            let width = |k: usize| {
                let entries = || cells.iter().map(|cell| f64::from(cell[k]));
                let (low, high) = (
                    entries().fold(f64::MAX, f64::min),
                    entries().fold(f64::MIN, f64::max),
                );
                high - low + 2.0
            };
            (0..rank).map(width).product()
        };
        self.tiling.simplices().map(of_simplex).sum()
    }

    /// Different vertices are different points, up to the lattice. This follows from the other
    /// hypotheses, and names the defect more plainly.
    fn check_vertices_differ(&self, findings: &mut Findings) {
        let rank = self.tiling.frame.rank();
        let coinciding = match self.tiling.vertices.form() {
            Form::Integers { numerators, .. } if rank == 0 => {
                equal(numerators.len(), |v, w| numerators[v].cmp(&numerators[w]))
            }
            _ => {
                let points = parallel::map(self.tiling.vertices.len(), |v| self.normal_point(v));
                equal(points.len(), |v, w| compare(&points[v], &points[w]))
            }
        };
        for vertices in coinciding {
            findings.add(Defect::CoincidentVertices { vertices });
        }
    }

    /// A vertex in the first cell of the lattice.
    fn normal_point(&self, vertex: usize) -> Point<S> {
        let corner = Corner::of(vertex as u32);
        let cell = match self.tiling.frame.rank() {
            0 => [0; D],
            _ => cell(self.tiling, &corner),
        };
        let moved = corner.moved(difference([0; D], cell));
        self.scale.point(self.tiling, &moved)
    }

    /// Any two facets in the boundary meet in the span of their common corners. Gives the pairs that do
    /// not.
    fn check_boundary(&self, unsided: &Unsided, findings: &mut Findings) -> Vec<Meeting<D>> {
        let limit = COPIES + PAIRS_PER_FACET * self.boundary.len();
        let Some(copies) = Copies::of(self, limit) else {
            findings.add(Defect::BoundaryWork { limit });
            return Vec::new();
        };
        let limit = PAIRS + PAIRS_PER_FACET * copies.list.len();
        let Some(pairs) = boxes::overlapping_pairs(&copies.extents, limit) else {
            findings.add(Defect::BoundaryWork { limit });
            return Vec::new();
        };
        let meets = parallel::map(pairs.len(), |k| {
            let (f, g) = pairs[k];
            (copies.is_base(f) || copies.is_base(g)) && copies.meeting(f, g).is_some()
        });
        let kept = pairs.into_iter().zip(meets).filter(|(_, meets)| *meets);
        let mut pairs: Vec<(usize, usize)> = kept.map(|(pair, _)| pair).collect();
        pairs.sort_unstable();
        for &(f, g) in &pairs {
            let facet = |copy: usize| self.boundary[copies.list[copy].facet].facet;
            let is_flat = |copy: usize| unsided.flat.contains(&facet(copy).simplex);
            let is_explained = self.shared.is_between(facet(f).simplex, facet(g).simplex);
            if is_flat(f) || is_flat(g) || is_explained {
                findings.add_consequence(BOUNDARY_MEETS, 1);
                continue;
            }
            findings.add_with(BOUNDARY_MEETS, || Defect::BoundaryMeets {
                facets: (facet(f), facet(g)),
                point: copies
                    .meeting(f, g)
                    .and_then(|point| self.scale.position(&point, D))
                    .expect("the pair was kept because it meets in a point"),
            });
        }
        let meeting = |(f, g): (usize, usize)| {
            let (f, g) = if copies.is_base(f) { (f, g) } else { (g, f) };
            let [f, g] = [f, g].map(|copy| &copies.list[copy]);
            Meeting {
                facets: (f.facet, g.facet),
                by: g.by,
            }
        };
        pairs.into_iter().map(meeting).collect()
    }

    /// No simplex is directly outside of the first facet of each class. Gives the facets where one is.
    fn check_covering(&self, findings: &mut Findings) -> Vec<CoveredFacet<D>> {
        let mut covered = Vec::new();
        let classes = self.first_of_classes();
        if classes.len().saturating_mul(self.tiling.len()) > COMPARISONS {
            findings.add(Defect::BoundaryWork { limit: COMPARISONS });
            return covered;
        }
        let outside = Outside::new(self.tiling, &self.scale);
        for index in classes {
            let facet = &self.boundary[index];
            let simplices = outside.simplices(facet);
            if simplices.is_empty() {
                continue;
            }
            let ids: Vec<SimplexId> = simplices.iter().map(|(simplex, _)| *simplex).collect();
            let own = facet.facet.simplex;
            if ids.iter().all(|other| self.shared.is_between(own, *other)) {
                findings.add_consequence("covered-twice", 1);
            } else {
                findings.add(Defect::Covered {
                    facet: facet.facet,
                    simplices: ids,
                });
            }
            covered.push((index, simplices));
        }
        covered
    }

    fn first_of_classes(&self) -> Vec<usize> {
        let mut at_ridge: BTreeMap<Vec<Corner<D>>, Vec<usize>> = BTreeMap::new();
        for (index, facet) in self.boundary.iter().enumerate() {
            for ridge in facet.ridges() {
                at_ridge.entry(ridge).or_default().push(index);
            }
        }
        let mut classes = Union::new(self.boundary.len());
        for facets in at_ridge.values() {
            if let [f, g] = facets[..] {
                classes.join(f, g);
            }
        }
        (0..self.boundary.len())
            .filter(|&f| classes.first(f) == f)
            .collect()
    }
}

/// Boundary facets in their own place, and moved near to others.
struct Copies<S, const D: usize> {
    /// The facets in their own place come first.
    list: Vec<Copy<D>>,
    bases: usize,
    points: Vec<Point<S>>,
    extents: Vec<Box3>,
    ranks: Vec<[u32; 3]>,
}

/// A facet that is moved by a lattice vector.
struct Copy<const D: usize> {
    facet: usize,
    by: [i32; D],
    /// Indices of its corners' points.
    points: [usize; D],
}

impl<S: Scalar, const D: usize> Copies<S, D> {
    /// `None` if there would be more than `limit`.
    fn of(region: &Region<S, D>, limit: usize) -> Option<Self> {
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
                by,
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

    fn is_base(&self, copy: usize) -> bool {
        copy < self.bases
    }

    fn extent(&self, points: &[usize]) -> Box3 {
        let at = |&p: &usize| self.ranks[p].map(|rank| (rank, rank));
        boxes::hull(points.iter().map(at))
    }

    /// A common point of two copies that is not in the hull of their common corners.
    fn meeting(&self, f: usize, g: usize) -> Option<Quotient<S>> {
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

/// The sets of two or more of 0, …, n - 1 that are equal in this order.
fn equal(n: usize, order: impl Fn(usize, usize) -> Ordering + Sync) -> Vec<Vec<usize>> {
    let mut sorted: Vec<usize> = (0..n).collect();
    sorted.par_sort_by(|v, w| order(*v, *w));
    let runs = sorted.chunk_by(|v, w| order(*v, *w).is_eq());
    let several = runs.filter(|run| run.len() > 1).map(<[usize]>::to_vec);
    let mut several: Vec<Vec<usize>> = several.collect();
    several.sort();
    several
}

fn edges([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The entries of f that g does not have.
fn rest<const N: usize>(f: &[usize; N], g: &[usize; N]) -> Vec<usize> {
    let own = f.iter().copied();
    own.filter(|point| !g.contains(point)).collect()
}
