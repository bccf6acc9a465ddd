//! Why a region fails: simplices overlap, or boundary facets only lie against each other.
//!
//! Let N(x) be the number of simplices, and of their translates under the lattice, with x in their
//! interior, for a region whose facets match in pairs or are boundary. N changes only at boundary facets.
//! Let two simplices overlap. If N >= 2 almost everywhere, let f be any boundary facet; else some
//! boundary facet f lies in the boundary of the set N >= 2. Let s be its simplex. At a generic
//! point of f, on the side where N >= 2, either another simplex has the point inside and overlaps s, or
//! another boundary facet lies in the same plane on the same side, and its simplex overlaps s. In
//! both cases a simplex that comes near f overlaps s. So interiors are disjoint if s and each such
//! simplex are, for all boundary facets; there is at least one.

use super::apart::{are_against, are_apart};
use super::boundary::{cell, compare, ranks, vectors};
use super::defect::{ContactKind, Defect};
use super::findings::Findings;
use super::interfaces::{Interfaces, two_sides};
use super::meeting::{Found, Meeting, Region};
use crate::advice::overlap;
use crate::tiling::{Corner, Facet, SimplexId, difference};
use acutile_exact::geometry::Scalar;
use acutile_exact::geometry::boxes::{self, Box3};
use acutile_exact::geometry::triangle::Point;
use rayon::prelude::*;
use std::collections::{BTreeSet, HashMap};

/// The most pairs of boxes that are compared to decide whether interiors are disjoint.
const PAIRS: usize = 8_000_000;

/// The most translates of simplices that are compared for this decision.
const TRANSLATES: usize = 4_000_000;

/// The causes of other defects, and the boundary facets of the interfaces among them.
pub(super) struct Contacts {
    pub findings: Findings,
    pub facets: BTreeSet<Facet>,
}

/// Two simplices, the second moved by a lattice vector.
type Pair<const D: usize> = (SimplexId, SimplexId, [i32; D]);

/// The pair with its simplices in order, of a simplex with itself the vector not before zero.
fn ordered<const D: usize>((s, t, by): Pair<D>) -> Pair<D> {
    let back = difference([0; D], by);
    match (s.cmp(&t), by < [0; D]) {
        (std::cmp::Ordering::Greater, _) | (std::cmp::Ordering::Equal, true) => (t, s, back),
        _ => (s, t, by),
    }
}

/// The causes of the defects of a region. `None` where they are not decided.
pub(super) fn explain<S: Scalar, const D: usize>(
    region: &Region<S, D>,
    found: &Found<D>,
    plain: &Findings,
) -> Option<Contacts> {
    let contact = Contact { region };
    let overlaps = contact.overlaps(found);
    let mut contacts = Contacts {
        findings: Findings::new(plain.limit()),
        facets: BTreeSet::new(),
    };
    if overlaps.is_empty() {
        let overlaps = contact.all_overlaps()?;
        if overlaps.is_empty() {
            contact.report_interfaces(&found.meeting, &mut contacts);
        } else {
            contact.report_overlaps(&overlaps, &mut contacts.findings);
        }
    } else {
        contact.report_overlaps(&overlaps, &mut contacts.findings);
        let involved: BTreeSet<SimplexId> = overlaps.iter().flat_map(|o| [o.0, o.1]).collect();
        let is_left = |meeting: &&Meeting<D>| {
            let simplex = |f: usize| region.boundary[f].facet.simplex;
            let (f, g) = meeting.facets;
            !involved.contains(&simplex(f)) && !involved.contains(&simplex(g))
        };
        let left: Vec<Meeting<D>> = found.meeting.iter().filter(is_left).copied().collect();
        contact.report_interfaces(&left, &mut contacts);
    }
    if contacts.findings.is_empty() {
        return None;
    }
    contacts.findings.add_consequences(plain);
    Some(contacts)
}

struct Contact<'r, 't, S, const D: usize> {
    region: &'r Region<'t, S, D>,
}

impl<S: Scalar, const D: usize> Contact<'_, '_, S, D> {
    fn points<'c>(
        &self,
        corners: impl IntoIterator<Item = &'c Corner<D>>,
        by: [i32; D],
    ) -> Vec<Point<S>> {
        let Region { tiling, scale, .. } = self.region;
        let corners = corners.into_iter();
        corners
            .map(|corner| scale.point(tiling, &corner.moved(by)))
            .collect()
    }

    fn simplex(&self, simplex: SimplexId, by: [i32; D]) -> Vec<Point<S>> {
        self.points(self.region.tiling.simplex(simplex), by)
    }

    fn facet(&self, facet: usize, by: [i32; D]) -> Vec<Point<S>> {
        self.points(&self.region.boundary[facet].corners, by)
    }

    /// The pairs of simplices at meeting facets, and at covered ones, that overlap.
    fn overlaps(&self, found: &Found<D>) -> Vec<Pair<D>> {
        let boundary = &self.region.boundary;
        let at_meeting = found.meeting.iter().map(|meeting| {
            let (f, g) = (&boundary[meeting.facets.0], &boundary[meeting.facets.1]);
            let by = difference(g.by, difference(f.by, meeting.by));
            (f.facet.simplex, g.facet.simplex, by)
        });
        let at_covered = found.covered.iter().flat_map(|(facet, simplices)| {
            let facet = &boundary[*facet];
            let pair = |(t, by): &(SimplexId, [i32; D])| {
                (facet.facet.simplex, *t, difference(*by, facet.by))
            };
            simplices.iter().map(pair)
        });
        self.overlapping(at_meeting.chain(at_covered))
    }

    fn overlapping(&self, pairs: impl Iterator<Item = Pair<D>>) -> Vec<Pair<D>> {
        let different = pairs.filter(|(s, t, by)| s != t || *by != [0; D]);
        let pairs: BTreeSet<Pair<D>> = different.map(ordered).collect();
        let pairs: Vec<_> = pairs.into_iter().collect();
        let overlap =
            |&(s, t, by): &Pair<D>| !are_apart(&self.simplex(s, [0; D]), &self.simplex(t, by));
        pairs.into_par_iter().filter(overlap).collect()
    }

    /// All pairs of a simplex with a boundary facet and a simplex near that facet that overlap;
    /// `None` if there are too many pairs.
    fn all_overlaps(&self) -> Option<Vec<Pair<D>>> {
        let boundary = &self.region.boundary;
        let translates = self.translates()?;
        let mut places = Places::new(self.region);
        let facets: Vec<Vec<usize>> = boundary
            .iter()
            .map(|f| places.of(&f.corners, [0; D]))
            .collect();
        let simplices: Vec<Vec<usize>> = translates
            .iter()
            .map(|(t, by)| places.of(self.region.tiling.simplex(*t), *by))
            .collect();
        let ranks = ranks(&places.points);
        let extent = |corners: &Vec<usize>| -> Box3 {
            boxes::hull(corners.iter().map(|&place| ranks[place].map(|r| (r, r))))
        };
        let all: Vec<Box3> = facets.iter().chain(&simplices).map(extent).collect();
        let pairs = boxes::overlapping_pairs(&all, PAIRS)?;
        let bases = boundary.len();
        let near = pairs.into_iter().filter(|&(f, t)| f < bases && t >= bases);
        let near = near.map(|(f, t)| {
            let (facet, (t, by)) = (&boundary[f], translates[t - bases]);
            (facet.facet.simplex, t, difference(by, facet.by))
        });
        Some(self.overlapping(near))
    }

    /// The simplices moved near to boundary facets; `None` if there are too many.
    fn translates(&self) -> Option<Vec<(SimplexId, [i32; D])>> {
        let Region {
            tiling, boundary, ..
        } = self.region;
        let rank = tiling.frame.rank();
        let reach: [i32; D] =
            std::array::from_fn(|k| boundary.iter().map(|f| f.reach[k]).max().unwrap_or(0));
        let mut translates = Vec::new();
        for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
            let cells: Vec<[i32; D]> = corners.iter().map(|c| cell(tiling, c)).collect();
            let entries = |k: usize| cells.iter().map(move |cell| cell[k]);
            // In cells, the facets reach from 0 to `reach`.
            let low = std::array::from_fn(|k| -entries(k).max().unwrap_or(0) - 1);
            let high = std::array::from_fn(|k| reach[k] - entries(k).min().unwrap_or(0));
            translates.extend(vectors(low, high, rank).map(|by| (simplex, by)));
            if translates.len() > TRANSLATES {
                return None;
            }
        }
        Some(translates)
    }

    fn report_overlaps(&self, pairs: &[Pair<D>], findings: &mut Findings) {
        for &(s, t, by) in pairs {
            let found = || overlap(self.region.tiling, (s, t), by);
            findings.add_with("overlap", || Defect::Overlap {
                simplices: (s, t),
                shift: by.to_vec(),
                point: found().map_or(Vec::new(), |overlap| overlap.point.to_vec()),
            });
        }
    }

    /// One defect for each set of facets that lie against each other, and one for each set of others
    /// that touch away from them.
    fn report_interfaces(&self, meeting: &[Meeting<D>], contacts: &mut Contacts) {
        let is_against = |meeting: &&Meeting<D>| {
            let (f, g) = meeting.facets;
            are_against(&self.facet(f, [0; D]), &self.facet(g, meeting.by))
        };
        let against: Vec<Meeting<D>> = meeting.par_iter().filter(is_against).copied().collect();
        let mut interfaces = Interfaces::of(self.region, &against);
        let mut vertices: BTreeSet<Vec<String>> = BTreeSet::new();
        for pairs in interfaces.groups(&against) {
            let defect = self.interface(&pairs);
            for f in pairs.iter().flat_map(|pair| [pair.facets.0, pair.facets.1]) {
                let facet = &self.region.boundary[f];
                contacts.facets.insert(facet.facet);
                vertices.extend(facet.corners.iter().map(|corner| self.key(corner)));
            }
            contacts.findings.add(defect);
        }
        // Facets that touch at the rim of an interface are part of it.
        let is_near = |f: usize| {
            let mut corners = self.region.boundary[f].corners.iter();
            corners.any(|corner| vertices.contains(&self.key(corner)))
        };
        let is_away = |meeting: &&Meeting<D>| {
            let (f, g) = meeting.facets;
            !is_near(f) && !is_near(g)
        };
        let touching: Vec<Meeting<D>> = meeting.iter().filter(is_away).copied().collect();
        for pairs in Interfaces::of(self.region, &touching).groups(&touching) {
            let sides = two_sides(self.region, &pairs).map(|side| self.facets(&side));
            contacts.facets.extend(sides.iter().flatten());
            contacts.findings.add(Defect::NonConforming {
                sides,
                coincident: 0,
                kind: ContactKind::Touching,
            });
        }
    }

    /// Boundary facets by their indices, sorted.
    fn facets(&self, indices: &[usize]) -> Vec<Facet> {
        let facets = indices.iter().map(|&f| self.region.boundary[f].facet);
        let mut facets: Vec<Facet> = facets.collect();
        facets.sort_unstable();
        facets
    }

    /// A point as text, equal for points that are equal up to the lattice.
    fn key(&self, corner: &Corner<D>) -> Vec<String> {
        let tiling = self.region.tiling;
        let moved = corner.moved(difference([0; D], cell(tiling, corner)));
        let position = tiling.position(&moved);
        position.iter().map(ToString::to_string).collect()
    }

    /// Whether the facets of a pair are equal, with different vertices.
    fn are_equal(&self, pair: &Meeting<D>) -> bool {
        let sorted = |facet: usize, by: [i32; D]| {
            let mut points = self.facet(facet, by);
            points.sort_by(compare);
            points
        };
        let (f, g) = (
            sorted(pair.facets.0, [0; D]),
            sorted(pair.facets.1, pair.by),
        );
        f.iter().zip(&g).all(|(p, q)| compare(p, q).is_eq())
    }

    /// The defect of facets that lie against each other in pairs.
    fn interface(&self, pairs: &[Meeting<D>]) -> Defect {
        let sides = two_sides(self.region, pairs);
        let equal: Vec<&Meeting<D>> = pairs.iter().filter(|pair| self.are_equal(pair)).collect();
        let in_equal: BTreeSet<usize> = equal
            .iter()
            .flat_map(|pair| [pair.facets.0, pair.facets.1])
            .collect();
        let points = |side: &Vec<usize>| -> BTreeSet<Vec<String>> {
            let corners = side.iter().flat_map(|&f| &self.region.boundary[f].corners);
            corners.map(|corner| self.key(corner)).collect()
        };
        let [a, b] = sides.each_ref().map(points);
        let kind = if sides.iter().flatten().all(|f| in_equal.contains(f)) {
            ContactKind::EqualFacets
        } else if a == b {
            ContactKind::OtherDiagonals
        } else {
            ContactKind::HangingNodes(a.symmetric_difference(&b).count())
        };
        Defect::NonConforming {
            sides: sides.map(|side| self.facets(&side)),
            coincident: equal.len(),
            kind,
        }
    }
}

/// Points of corners, each once.
struct Places<'r, 't, S, const D: usize> {
    region: &'r Region<'t, S, D>,
    indices: HashMap<Corner<D>, usize>,
    points: Vec<Point<S>>,
}

impl<'r, 't, S: Scalar, const D: usize> Places<'r, 't, S, D> {
    fn new(region: &'r Region<'t, S, D>) -> Self {
        Places {
            region,
            indices: HashMap::new(),
            points: Vec::new(),
        }
    }

    /// The indices of the points of corners that are moved by a lattice vector.
    fn of(&mut self, corners: &[Corner<D>], by: [i32; D]) -> Vec<usize> {
        let Region { tiling, scale, .. } = self.region;
        let mut place = |corner: &Corner<D>| {
            let corner = corner.moved(by);
            *self.indices.entry(corner).or_insert_with(|| {
                self.points.push(scale.point(tiling, &corner));
                self.points.len() - 1
            })
        };
        corners.iter().map(&mut place).collect()
    }
}
