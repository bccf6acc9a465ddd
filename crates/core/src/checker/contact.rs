//! Why a bounded region fails: simplices overlap, or boundary facets only lie against each other.
//!
//! Let N(x) be the number of simplices with x in their interior, for a bounded region whose facets
//! match in pairs or are boundary. N changes only at boundary facets. If two simplices overlap, the
//! set N >= 2 is bounded, so some boundary facet f of a simplex s lies in its boundary. At a generic
//! point of f there, either another simplex has the point inside and overlaps s, or another boundary
//! facet lies in the same plane on the same side, and its simplex overlaps s. In both cases a simplex
//! that comes near f overlaps s. So interiors are disjoint if s and each such simplex are.

use super::apart::{are_against, are_apart};
use super::boundary::BoundaryFacet;
use super::defect::{ContactKind, Defect, Findings};
use super::region::Region;
use crate::advice::common_point;
use crate::anatomy::Union;
use crate::tiling::{Corner, Facet, SimplexId};
use acutile_exact::geometry::Scalar;
use acutile_exact::geometry::boxes::{self, Box3};
use acutile_exact::geometry::triangle::Point;
use acutile_exact::number::Number;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// No more pairs of boxes are compared to decide whether interiors are disjoint.
const PAIRS: usize = 8_000_000;

/// What the checks of a region have found.
pub(super) struct Found {
    /// Pairs of boundary facets, by their indices, that meet where they should not.
    pub meeting: Vec<(usize, usize)>,
    /// Boundary facets, by their indices, with the simplices directly outside.
    pub covered: Vec<(usize, Vec<SimplexId>)>,
}

/// The defects behind those of a bounded region. `None` where that is not decided.
pub(super) fn explain<S: Scalar, const D: usize>(
    region: &Region<S, D>,
    found: &Found,
    plain: &Findings,
) -> Option<Findings> {
    let contact = Contact { region };
    let overlaps = contact.overlaps(found);
    let mut findings = Findings::new(plain.limit());
    if overlaps.is_empty() {
        let overlaps = contact.all_overlaps()?;
        if overlaps.is_empty() {
            contact.report_interfaces(&found.meeting, &mut findings);
        } else {
            contact.report_overlaps(&overlaps, &mut findings);
        }
    } else {
        contact.report_overlaps(&overlaps, &mut findings);
        let involved: BTreeSet<SimplexId> = overlaps.iter().flat_map(|&(s, t)| [s, t]).collect();
        let is_left = |&&(f, g): &&(usize, usize)| {
            let simplex = |f: usize| region.boundary[f].facet.simplex;
            !involved.contains(&simplex(f)) && !involved.contains(&simplex(g))
        };
        let left: Vec<(usize, usize)> = found.meeting.iter().filter(is_left).copied().collect();
        contact.report_interfaces(&left, &mut findings);
    }
    if findings.is_empty() {
        return None;
    }
    findings.add_consequences(plain);
    Some(findings)
}

struct Contact<'r, 't, S, const D: usize> {
    region: &'r Region<'t, S, D>,
}

impl<S: Scalar, const D: usize> Contact<'_, '_, S, D> {
    fn point(&self, corner: &Corner<D>) -> Point<S> {
        self.region.scale.point(self.region.tiling, corner)
    }

    fn simplex(&self, simplex: SimplexId) -> Vec<Point<S>> {
        let corners = self.region.tiling.simplex(simplex).iter();
        corners.map(|corner| self.point(corner)).collect()
    }

    fn facet(&self, facet: &BoundaryFacet<D>) -> Vec<Point<S>> {
        facet.corners.iter().map(|c| self.point(c)).collect()
    }

    /// The pairs of simplices at meeting facets, and at covered ones, that overlap.
    fn overlaps(&self, found: &Found) -> Vec<(SimplexId, SimplexId)> {
        let of = |facet: usize| self.region.boundary[facet].facet.simplex;
        let at_meeting = found.meeting.iter().map(|&(f, g)| (of(f), of(g)));
        let covered = found.covered.iter();
        let at_covered =
            covered.flat_map(|(f, simplices)| simplices.iter().map(move |&t| (of(*f), t)));
        self.overlapping(at_meeting.chain(at_covered))
    }

    fn overlapping(
        &self,
        pairs: impl Iterator<Item = (SimplexId, SimplexId)>,
    ) -> Vec<(SimplexId, SimplexId)> {
        let ordered = pairs.filter(|(s, t)| s != t);
        let pairs: BTreeSet<_> = ordered.map(|(s, t)| (s.min(t), s.max(t))).collect();
        let pairs: Vec<_> = pairs.into_iter().collect();
        let overlap =
            |&(s, t): &(SimplexId, SimplexId)| !are_apart(&self.simplex(s), &self.simplex(t));
        pairs.into_par_iter().filter(overlap).collect()
    }

    /// All pairs of a simplex with a boundary facet and a simplex near that facet that overlap;
    /// `None` if there are too many pairs.
    fn all_overlaps(&self) -> Option<Vec<(SimplexId, SimplexId)>> {
        let tiling = self.region.tiling;
        let ranks = self.region.vertex_ranks();
        let extent = |corners: &[Corner<D>]| -> Box3 {
            boxes::hull(
                corners
                    .iter()
                    .map(|c| ranks[c.vertex.index()].map(|r| (r, r))),
            )
        };
        let facets = self.region.boundary.iter().map(|f| extent(&f.corners));
        let bases = self.region.boundary.len();
        let all: Vec<Box3> = facets.chain(tiling.simplices().map(extent)).collect();
        let pairs = boxes::overlapping_pairs(&all, PAIRS)?;
        let near = pairs.into_iter().filter(|&(f, t)| f < bases && t >= bases);
        let simplices = near.map(|(f, t)| {
            let s = self.region.boundary[f].facet.simplex;
            (s, SimplexId::at(t - bases))
        });
        Some(self.overlapping(simplices))
    }

    fn report_overlaps(&self, pairs: &[(SimplexId, SimplexId)], findings: &mut Findings) {
        let tiling = self.region.tiling;
        let corners = |simplex: SimplexId| -> Vec<[Number; D]> {
            let corners = tiling.simplex(simplex).iter();
            corners.map(|corner| tiling.position(corner)).collect()
        };
        for &(s, t) in pairs {
            findings.add_with("overlap", || Defect::Overlap {
                simplices: (s, t),
                point: common_point(&corners(s), &corners(t)).map_or(Vec::new(), Vec::from),
            });
        }
    }

    /// One defect for each set of facets that lie against each other, and one for each other pair that
    /// touches away from them.
    fn report_interfaces(&self, meeting: &[(usize, usize)], findings: &mut Findings) {
        let against: Vec<(usize, usize)> = meeting
            .par_iter()
            .filter(|(f, g)| {
                let boundary = &self.region.boundary;
                are_against(&self.facet(&boundary[*f]), &self.facet(&boundary[*g]))
            })
            .copied()
            .collect();
        let mut interfaces = Interfaces::of(self.region, &against);
        let mut vertices: BTreeSet<Vec<String>> = BTreeSet::new();
        for pairs in interfaces.groups(&against) {
            let defect = self.interface(&pairs);
            vertices.extend(pairs.iter().flat_map(|(f, g)| [*f, *g]).flat_map(|f| {
                let corners = self.region.boundary[f].corners.iter();
                corners.map(|corner| self.key(corner)).collect::<Vec<_>>()
            }));
            findings.add(defect);
        }
        for &(f, g) in meeting {
            // Facets that touch at the rim of an interface are part of it.
            let is_near = |f: usize| {
                let corners = self.region.boundary[f].corners.iter();
                corners
                    .map(|corner| self.key(corner))
                    .any(|key| vertices.contains(&key))
            };
            if !is_near(f) && !is_near(g) {
                let facet = |f: usize| self.region.boundary[f].facet;
                findings.add(Defect::NonConforming {
                    sides: [vec![facet(f)], vec![facet(g)]],
                    coincident: 0,
                    kind: ContactKind::Touching,
                });
            }
        }
    }

    /// A point as text, equal for equal points.
    fn key(&self, corner: &Corner<D>) -> Vec<String> {
        let position = self.region.tiling.position(corner);
        position.iter().map(ToString::to_string).collect()
    }

    /// The defect of facets that lie against each other in pairs.
    fn interface(&self, pairs: &[(usize, usize)]) -> Defect {
        let sides = two_sides(self.region, pairs);
        let points = |facet: &usize| -> BTreeSet<Vec<String>> {
            let corners = self.region.boundary[*facet].corners.iter();
            corners.map(|corner| self.key(corner)).collect()
        };
        let facets = |side: &Vec<usize>| side.iter().map(points).collect::<BTreeSet<_>>();
        let [a, b] = [facets(&sides[0]), facets(&sides[1])];
        let coincident = a.intersection(&b).count();
        let all = |facets: &BTreeSet<BTreeSet<Vec<String>>>| {
            facets.iter().flatten().cloned().collect::<BTreeSet<_>>()
        };
        let (points_a, points_b) = (all(&a), all(&b));
        let kind = if a == b {
            ContactKind::EqualFacets
        } else if points_a == points_b {
            ContactKind::OtherDiagonals
        } else {
            let hanging = points_a.symmetric_difference(&points_b).count();
            ContactKind::HangingNodes(hanging)
        };
        let named = |side: &Vec<usize>| -> Vec<Facet> {
            let mut facets: Vec<Facet> = side
                .iter()
                .map(|&f| self.region.boundary[f].facet)
                .collect();
            facets.sort_unstable();
            facets
        };
        Defect::NonConforming {
            sides: [named(&sides[0]), named(&sides[1])],
            coincident,
            kind,
        }
    }
}

/// Sets of facets that lie against each other, through pairs and through common ridges.
struct Interfaces(Union);

impl Interfaces {
    fn of<S: Scalar, const D: usize>(region: &Region<S, D>, pairs: &[(usize, usize)]) -> Self {
        let mut union = Union::new(region.boundary.len());
        let involved: BTreeSet<usize> = pairs.iter().flat_map(|&(f, g)| [f, g]).collect();
        let mut at_ridge: BTreeMap<Vec<Corner<D>>, usize> = BTreeMap::new();
        for &facet in &involved {
            for ridge in region.boundary[facet].ridges() {
                match at_ridge.get(&ridge) {
                    Some(&other) => union.join(facet, other),
                    None => drop(at_ridge.insert(ridge, facet)),
                }
            }
        }
        for &(f, g) in pairs {
            union.join(f, g);
        }
        Interfaces(union)
    }

    fn groups(&mut self, pairs: &[(usize, usize)]) -> Vec<Vec<(usize, usize)>> {
        let mut groups: BTreeMap<usize, Vec<(usize, usize)>> = BTreeMap::new();
        for &pair in pairs {
            groups.entry(self.0.first(pair.0)).or_default().push(pair);
        }
        groups.into_values().collect()
    }
}

/// The facets of an interface by side: facets of a pair are on different sides, and facets with a common
/// ridge on the same one.
fn two_sides<S: Scalar, const D: usize>(
    region: &Region<S, D>,
    pairs: &[(usize, usize)],
) -> [Vec<usize>; 2] {
    let mut opposite: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for &(f, g) in pairs {
        opposite.entry(f).or_default().push(g);
        opposite.entry(g).or_default().push(f);
    }
    let mut at_ridge: BTreeMap<Vec<Corner<D>>, Vec<usize>> = BTreeMap::new();
    for &facet in opposite.keys() {
        for ridge in region.boundary[facet].ridges() {
            at_ridge.entry(ridge).or_default().push(facet);
        }
    }
    let mut side: BTreeMap<usize, usize> = BTreeMap::new();
    for &start in opposite.keys() {
        if side.contains_key(&start) {
            continue;
        }
        side.insert(start, 0);
        let mut waiting = vec![start];
        while let Some(facet) = waiting.pop() {
            let here = side[&facet];
            let across = opposite[&facet].iter().map(|&other| (other, 1 - here));
            let ridges = region.boundary[facet].ridges();
            let beside = ridges.flat_map(|ridge| at_ridge[&ridge].clone());
            for (other, there) in across.chain(beside.map(|other| (other, here))) {
                if side
                    .insert(other, side.get(&other).copied().unwrap_or(there))
                    .is_none()
                {
                    waiting.push(other);
                }
            }
        }
    }
    let of = |wanted: usize| {
        let on_side = side.iter().filter(move |(_, side)| **side == wanted);
        on_side.map(|(facet, _)| *facet).collect()
    };
    [of(0), of(1)]
}
