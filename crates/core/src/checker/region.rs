//! The hypotheses about a region of any rank (docs/soundness.md, Theorem 4).
//!
//! **X.** Two facets in the boundary, up to the lattice, meet in the hull of their common corners.
//! **W.** No simplex lies directly outside of one boundary facet of each class. Classes join facets
//! that share a ridge which no third boundary facet has.
//!
//! A pair of boundary facets is compared once, up to translation: each facet in its own place
//! with all facets that a lattice vector not before zero moves near to it.

use super::copies::Copies;
use super::defect::{BOUNDARY_MEETS, Defect, Findings};
use super::outside::Outside;
use crate::predicates::ring::common_denominator;
use crate::tiling::{Corner, Facet, Matching, Tiling, difference, floor};
use acutile_exact::geometry::Scalar;
use acutile_exact::geometry::boxes::{self, Box3};
use acutile_exact::geometry::triangle::{self, Point, Quotient, Triangle};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::Floor;
use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Rational};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Hypotheses X and W.
pub fn check_region<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    findings: &mut Findings,
) {
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

/// So many pairs of facets in the boundary are compared exactly: some, and for each facet some
/// more. Meshes of solids have a few dozens for each facet.
const PAIRS: usize = 500_000;
const PAIRS_PER_FACET: usize = 30;
/// So many boxes of simplices are compared with boxes of facets.
const COMPARISONS: usize = 2_000_000_000;

/// How numbers become scalars, and back.
pub(super) struct Scale<S> {
    /// Coordinates are so many times too large.
    unit: Number,
    from_number: fn(Number) -> S,
    to_number: fn(&S) -> Number,
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

    /// The point in the coordinates of the tiling.
    fn position(&self, point: &Quotient<S>, dimension: usize) -> Vec<Number> {
        let denominator = (self.to_number)(&point.denominator) * &self.unit;
        let coordinate = |x: &S| {
            let numerator = (self.to_number)(x);
            numerator.divide(&denominator).unwrap_or_else(Number::zero)
        };
        point.numerators[..dimension]
            .iter()
            .map(coordinate)
            .collect()
    }
}

pub(super) struct Region<'t, S, const D: usize> {
    pub tiling: &'t Tiling<D>,
    pub scale: Scale<S>,
    pub boundary: Vec<BoundaryFacet<D>>,
}

/// A facet in the boundary, by its corners in an order whose normal points out. It is moved to
/// where its least coordinate in each direction of the lattice is in the first cell.
pub(super) struct BoundaryFacet<const D: usize> {
    pub facet: Facet,
    pub corners: [Corner<D>; D],
    /// Steps of the lattice that the facet reaches to, in each direction.
    pub reach: [i32; D],
}

impl<const D: usize> BoundaryFacet<D> {
    fn new(tiling: &Tiling<D>, facet: Facet) -> Self {
        let simplex = tiling.simplex(facet.simplex as usize);
        let opposite = usize::from(facet.opposite);
        let mut corners: [Corner<D>; D] =
            std::array::from_fn(|k| simplex[k + usize::from(k >= opposite)]);
        if opposite % 2 == 1 {
            corners.swap(D - 2, D - 1);
        }
        let cells: Vec<[i32; D]> = corners.iter().map(|corner| cell(tiling, corner)).collect();
        let entries = |k: usize| cells.iter().map(move |cell| cell[k]);
        let least: [i32; D] = std::array::from_fn(|k| entries(k).min().unwrap_or(0));
        BoundaryFacet {
            facet,
            corners: corners.map(|c| c.moved(difference([0; D], least))),
            reach: std::array::from_fn(|k| entries(k).max().unwrap_or(0) - least[k] + 1),
        }
    }

    /// The ridges of the facet up to translation.
    fn ridges(&self) -> impl Iterator<Item = Vec<Corner<D>>> {
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
fn cell<const D: usize>(tiling: &Tiling<D>, corner: &Corner<D>) -> [i32; D] {
    let rank = tiling.frame.rank();
    if rank == 0 {
        return [0; D];
    }
    let vertex = tiling.vertices.vertex(corner.vertex as usize);
    std::array::from_fn(|k| match k < rank {
        true => floor(&vertex[k]) + corner.shift[k],
        false => 0,
    })
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
        Region {
            tiling,
            scale: Scale {
                unit,
                from_number,
                to_number,
            },
            boundary: boundary.collect(),
        }
    }

    fn check(&self, findings: &mut Findings) {
        let is_closed = self.boundary.is_empty() && findings.is_empty();
        if is_closed && !self.tiling.is_empty() {
            findings.add(Defect::NoBoundary);
        }
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

    /// Different vertices are different points, up to the lattice. This follows from the other
    /// hypotheses, and says more plainly what is wrong.
    fn check_vertices_differ(&self, findings: &mut Findings) {
        let rank = self.tiling.frame.rank();
        let normal = |vertex: usize| {
            let corner = Corner::of(vertex as u32);
            let cell = if rank == 0 {
                [0; D]
            } else {
                cell(self.tiling, &corner)
            };
            let moved = corner.moved(difference([0; D], cell));
            self.scale.point(self.tiling, &moved)
        };
        let vertices = 0..self.tiling.vertices.len();
        let points: Vec<Point<S>> = vertices.into_par_iter().map(normal).collect();
        let order = |v: &usize, w: &usize| compare(&points[*v], &points[*w]);
        let mut sorted: Vec<usize> = (0..points.len()).collect();
        sorted.par_sort_by(order);
        let runs = sorted.chunk_by(|v, w| order(v, w).is_eq());
        let mut coinciding: Vec<Vec<usize>> = runs
            .filter(|run| run.len() > 1)
            .map(<[usize]>::to_vec)
            .collect();
        coinciding.sort();
        for vertices in coinciding {
            findings.add(Defect::CoincidentVertices { vertices });
        }
    }

    /// Any two facets in the boundary meet in what their common corners span.
    fn check_boundary(&self, findings: &mut Findings) {
        let limit = PAIRS + PAIRS_PER_FACET * self.boundary.len();
        let Some(copies) = Copies::of(self, limit) else {
            return findings.add(Defect::BoundaryWork { limit });
        };
        let limit = PAIRS + PAIRS_PER_FACET * copies.list.len();
        let Some(pairs) = boxes::overlapping_pairs(&copies.extents, limit) else {
            return findings.add(Defect::BoundaryWork { limit });
        };
        let mut pairs: Vec<(usize, usize)> = pairs
            .into_par_iter()
            .filter(|(f, g)| copies.is_base(*f) || copies.is_base(*g))
            .filter(|(f, g)| copies.meeting(*f, *g).is_some())
            .collect();
        pairs.sort_unstable();
        for (f, g) in pairs {
            let facet = |copy: usize| self.boundary[copies.list[copy].facet].facet;
            findings.add_with(BOUNDARY_MEETS, || Defect::BoundaryMeets {
                facets: (facet(f), facet(g)),
                point: copies
                    .meeting(f, g)
                    .map_or_else(Vec::new, |point| self.scale.position(&point, D)),
            });
        }
    }

    /// No simplex is directly outside of the first facet of each class.
    fn check_covering(&self, findings: &mut Findings) {
        let classes = self.first_of_classes();
        if classes.len().saturating_mul(self.tiling.len()) > COMPARISONS {
            return findings.add(Defect::BoundaryWork { limit: COMPARISONS });
        }
        let outside = Outside::new(self.tiling, &self.scale);
        for facet in classes {
            let simplices = outside.simplices(facet);
            if !simplices.is_empty() {
                findings.add(Defect::Covered {
                    facet: facet.facet,
                    simplices,
                });
            }
        }
    }

    fn first_of_classes(&self) -> Vec<&BoundaryFacet<D>> {
        let mut at_ridge: BTreeMap<Vec<Corner<D>>, Vec<usize>> = BTreeMap::new();
        for (index, facet) in self.boundary.iter().enumerate() {
            for ridge in facet.ridges() {
                at_ridge.entry(ridge).or_default().push(index);
            }
        }
        let mut classes = Classes((0..self.boundary.len()).collect());
        for facets in at_ridge.values() {
            if let [f, g] = facets[..] {
                classes.join(f, g);
            }
        }
        let firsts = (0..self.boundary.len()).filter(|&f| classes.first(f) == f);
        firsts.map(|f| &self.boundary[f]).collect()
    }
}

fn compare<S: Scalar>(p: &Point<S>, q: &Point<S>) -> Ordering {
    let entries = p.iter().zip(q).map(|(x, y)| x.minus(y).sign());
    entries.fold(Ordering::Equal, Ordering::then)
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
