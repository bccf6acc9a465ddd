//! What can be wrong with a tiling: one variant per way, with the exact values.
//! [`super::render`] puts them into words.

use super::NearMates;
use crate::classify::NotTcp;
use crate::statement::Plane;
use crate::tiling::{Facet, SimplexId, VertexId};
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeMap;

/// One thing that is wrong. Simplices, facets and vertices are named by their
/// indices in the tiling, from zero.
#[derive(Clone, Debug, PartialEq)]
pub enum Defect {
    /// The leading principal minor of this order is not positive.
    MetricNotPositive { order: usize, minor: Number },
    /// There is nothing to tile with.
    NoSimplices,
    /// Two corners of a simplex are the same vertex with the same shift.
    RepeatedCorner {
        simplex: SimplexId,
        corners: (usize, usize),
    },
    /// D! times the volume is zero.
    Flat { simplex: SimplexId },
    /// D! times the volume is negative; exchanging the last two corners mends it.
    NegativeOrientation {
        simplex: SimplexId,
        determinant: Number,
    },
    /// No other simplex has this facet.
    UnmatchedFacet { facet: Facet },
    /// Two simplices lie on the same side of a facet.
    SameSide { facets: (Facet, Facet) },
    /// More than two simplices have the same facet.
    OverusedFacet { facets: Vec<Facet> },
    /// The volumes do not sum to the volume of the domain, `sum` and `expected`
    /// both in units of the cell.
    VolumeSum { sum: Number, expected: Number },
    /// The first vertices of a face of the domain determine no plane, or all vertices
    /// of the domain lie in it.
    FaceWithoutPlane { face: usize },
    /// A vertex of the domain is not where the plane of a face wants it: `value` is
    /// zero in the plane and positive on the inner side.
    FaceNotSupporting {
        face: usize,
        vertex: usize,
        value: Number,
    },
    /// The corners of a face of the domain are not in the order of a convex polygon.
    FaceNotConvex { face: usize },
    /// A ridge of the domain's boundary lies in another number of faces than two.
    RidgeNotShared { ridge: Vec<usize>, faces: usize },
    /// A vertex lies outside of the domain, behind this face.
    VertexOutside {
        vertex: usize,
        face: usize,
        value: Number,
    },
    /// Different vertices of a region are the same point.
    CoincidentVertices { vertices: Vec<usize> },
    /// Two facets in the boundary of a region meet in this point, which their common vertices
    /// do not span.
    BoundaryMeets {
        facets: (Facet, Facet),
        point: Vec<Number>,
    },
    /// The points directly outside of a facet in the boundary of a region, at its centroid, lie
    /// in these simplices.
    Covered {
        facet: Facet,
        simplices: Vec<SimplexId>,
    },
    /// Two simplices, the second moved by a lattice vector, have this point inside, in basis
    /// coordinates.
    Overlap {
        simplices: (SimplexId, SimplexId),
        shift: Vec<i32>,
        point: Vec<Number>,
    },
    /// Boundary facets lie against each other, and no point is in two simplices there. Of the facets
    /// on the two sides, `coincident` pairs are equal.
    NonConforming {
        sides: [Vec<Facet>; 2],
        coincident: usize,
        kind: ContactKind,
    },
    /// Simplices have the same corners.
    Duplicates { simplices: Vec<SimplexId> },
    /// The simplices fall into this many pieces, where one is required; the first simplex of each.
    NotConnected { firsts: Vec<SimplexId> },
    /// The boundary facets of a cavity, where none is allowed.
    Cavity { facets: Vec<Facet> },
    /// Edges with another number of boundary facets than two, and vertices with several rings of
    /// them, where a manifold is required.
    NotManifold {
        ridges: Vec<Vec<VertexId>>,
        vertices: Vec<VertexId>,
    },
    /// Boundary facets that are no triangles of a surface that should be filled.
    NotOnSurface { facets: Vec<Facet> },
    /// Triangles of a surface, by their indices, that are no boundary facets.
    NotBoundary { triangles: Vec<usize> },
    /// A region without boundary: it is all of space.
    NoBoundary,
    /// The boundary has more facets close to each other than are looked at: nothing is known to be
    /// wrong, and nothing is proved.
    BoundaryWork { limit: usize },
    /// Facets of a periodic mesh nearly have a mate: nothing is known to be wrong, and nothing is
    /// proved.
    NearMates(NearMates),
    /// A vertex is a corner of no simplex.
    UnusedVertex { vertex: usize },
    /// A dihedral angle is a right angle where all must be acute.
    RightAngle { angle: Angle },
    /// A dihedral angle is more than a right angle.
    ObtuseAngle { angle: Angle },
    /// A dihedral angle is not less than a bound in degrees.
    AngleNotBelow { angle: Angle, bound: Rational },
    /// A dihedral angle is not more than a bound in degrees.
    AngleNotAbove { angle: Angle, bound: Rational },
    /// The squared circumradius of a simplex over the square of its shortest edge is
    /// `squared_ratio`, not less than the square of the bound.
    RatioNotBelow {
        simplex: SimplexId,
        squared_ratio: Number,
        bound: Rational,
    },
    /// A plane that must not be crossed names a coordinate that there is not.
    PlaneBeyond { plane: Plane, dimension: usize },
    /// A simplex has corners on both sides of a translate of a plane: `sides` are the values of
    /// normal · x at two of them, and `offset` is that of the translate.
    PlaneCrossed {
        simplex: SimplexId,
        plane: Plane,
        offset: Rational,
        sides: (Number, Number),
    },
    /// The tiling is not tetrahedrally close packed.
    NotTcp { reason: NotTcp },
    /// The corner of the neighbour behind a facet lies on the circumsphere; the
    /// power is zero.
    OnCircumsphere { facet: Facet, neighbour: SimplexId },
    /// The corner of the neighbour behind a facet lies inside of the circumsphere;
    /// `power` is its power times D! times the volume.
    InsideCircumsphere {
        facet: Facet,
        neighbour: SimplexId,
        power: Number,
    },
}

/// How facets lie against each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactKind {
    /// Each facet is equal to one on the other side, with nodes of its own.
    EqualFacets,
    /// The points are equal, the facets are not.
    OtherDiagonals,
    /// So many points of one side are on no point of the other side.
    HangingNodes(usize),
    /// The facets touch in a point or along an edge.
    Touching,
}

/// A dihedral angle between two facets, with the evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Angle {
    /// The simplex.
    pub simplex: SimplexId,
    /// The two facets, each named by the corner opposite to it.
    pub facets: (usize, usize),
    /// The inner product of the inward facet normals g_i and g_j (the gradients of
    /// the barycentric coordinates, scaled): the angle is acute when it is negative.
    pub product: Number,
    /// Rational bounds of the angle in degrees.
    pub degrees: (Rational, Rational),
}

impl Defect {
    /// The simplices that it is about, in order.
    pub fn simplices(&self) -> Vec<SimplexId> {
        let of = |facet: &Facet| facet.simplex;
        let mut simplices = match self {
            Defect::RepeatedCorner { simplex, .. }
            | Defect::Flat { simplex }
            | Defect::NegativeOrientation { simplex, .. }
            | Defect::RatioNotBelow { simplex, .. } => vec![*simplex],
            Defect::RightAngle { angle }
            | Defect::ObtuseAngle { angle }
            | Defect::AngleNotBelow { angle, .. }
            | Defect::AngleNotAbove { angle, .. } => vec![angle.simplex],
            Defect::UnmatchedFacet { facet } => vec![of(facet)],
            Defect::SameSide { facets: (a, b) } | Defect::BoundaryMeets { facets: (a, b), .. } => {
                vec![of(a), of(b)]
            }
            Defect::OverusedFacet { facets }
            | Defect::Cavity { facets }
            | Defect::NotOnSurface { facets } => facets.iter().map(of).collect(),
            Defect::Overlap {
                simplices: (s, t), ..
            } => vec![*s, *t],
            Defect::NonConforming { sides, .. } => sides.iter().flatten().map(of).collect(),
            Defect::Duplicates { simplices } => simplices.clone(),
            Defect::NotConnected { firsts } => firsts.clone(),
            Defect::Covered { facet, simplices } => std::iter::once(of(facet))
                .chain(simplices.iter().copied())
                .collect(),
            Defect::OnCircumsphere { facet, neighbour }
            | Defect::InsideCircumsphere {
                facet, neighbour, ..
            } => vec![of(facet), *neighbour],
            _ => Vec::new(),
        };
        simplices.dedup();
        simplices
    }

    /// The name of this kind of defect.
    pub fn code(&self) -> &'static str {
        match self {
            Defect::MetricNotPositive { .. } => "metric-not-positive",
            Defect::NoSimplices => "no-simplices",
            Defect::RepeatedCorner { .. } => "repeated-corner",
            Defect::Flat { .. } => "flat",
            Defect::NegativeOrientation { .. } => "negative-orientation",
            Defect::UnmatchedFacet { .. } => "unmatched-facet",
            Defect::SameSide { .. } => "same-side",
            Defect::OverusedFacet { .. } => "overused-facet",
            Defect::VolumeSum { .. } => "volume-sum",
            Defect::FaceWithoutPlane { .. } => "face-without-plane",
            Defect::FaceNotSupporting { .. } => "face-not-supporting",
            Defect::FaceNotConvex { .. } => "face-not-convex",
            Defect::RidgeNotShared { .. } => "ridge-not-shared",
            Defect::VertexOutside { .. } => "vertex-outside",
            Defect::CoincidentVertices { .. } => "coincident-vertices",
            Defect::BoundaryMeets { .. } => BOUNDARY_MEETS,
            Defect::Covered { .. } => "covered-twice",
            Defect::Overlap { .. } => "overlap",
            Defect::NonConforming { .. } => "non-conforming",
            Defect::Duplicates { .. } => "duplicate",
            Defect::NotConnected { .. } => "not-connected",
            Defect::Cavity { .. } => "cavity",
            Defect::NotManifold { .. } => "not-manifold",
            Defect::NotOnSurface { .. } => "not-on-surface",
            Defect::NotBoundary { .. } => "not-boundary",
            Defect::NoBoundary => "no-boundary",
            Defect::BoundaryWork { .. } => BOUNDARY_WORK,
            Defect::NearMates(_) => NEAR_MATES,
            Defect::UnusedVertex { .. } => "unused-vertex",
            Defect::RightAngle { .. } => "right-angle",
            Defect::ObtuseAngle { .. } => "obtuse-angle",
            Defect::AngleNotBelow { .. } => "angle-not-below",
            Defect::AngleNotAbove { .. } => "angle-not-above",
            Defect::RatioNotBelow { .. } => "ratio-not-below",
            Defect::PlaneBeyond { .. } => "plane-beyond",
            Defect::PlaneCrossed { .. } => "plane-crossed",
            Defect::NotTcp { .. } => "not-tcp",
            Defect::OnCircumsphere { .. } => "on-circumsphere",
            Defect::InsideCircumsphere { .. } => "inside-circumsphere",
        }
    }
}

/// The code of [`Defect::BoundaryMeets`], whose evidence is made only where it is kept.
pub(super) const BOUNDARY_MEETS: &str = "boundary-meets";
/// The code of [`Defect::BoundaryWork`].
pub(super) const BOUNDARY_WORK: &str = "boundary-work";

/// The code of [`Defect::NearMates`].
const NEAR_MATES: &str = "near-mates";

/// Collects defects: all are counted, and of each kind the first few are kept.
#[derive(Clone, Debug)]
pub struct Findings {
    limit: usize,
    counts: BTreeMap<&'static str, usize>,
    kept: Vec<Defect>,
    consequences: BTreeMap<&'static str, usize>,
}

impl Findings {
    /// Keeps up to `limit` defects of each kind.
    pub fn new(limit: usize) -> Self {
        Findings {
            limit,
            counts: BTreeMap::new(),
            kept: Vec::new(),
            consequences: BTreeMap::new(),
        }
    }

    /// How many defects of each kind are kept.
    pub fn limit(&self) -> usize {
        self.limit
    }

    /// Adds everything that other findings have.
    pub fn append(&mut self, other: Findings) {
        for (code, count) in other.counts {
            *self.counts.entry(code).or_insert(0) += count;
        }
        self.kept.extend(other.kept);
        for (code, count) in other.consequences {
            *self.consequences.entry(code).or_insert(0) += count;
        }
    }

    /// Counts the defects of others as consequences of these.
    pub fn add_consequences(&mut self, others: &Findings) {
        for (&code, count) in &others.counts {
            self.add_consequence(code, *count);
        }
    }

    /// Counts some defects that follow from these.
    pub fn add_consequence(&mut self, code: &'static str, count: usize) {
        *self.consequences.entry(code).or_insert(0) += count;
    }

    /// How many defects of each kind follow from these, and are not among them.
    pub fn consequences(&self) -> &BTreeMap<&'static str, usize> {
        &self.consequences
    }

    /// Adds a defect.
    pub fn add(&mut self, defect: Defect) {
        let count = self.counts.entry(defect.code()).or_insert(0);
        *count += 1;
        if *count <= self.limit {
            self.kept.push(defect);
        }
    }

    /// Adds a defect with this name; it is made only if it is kept.
    pub fn add_with(&mut self, code: &'static str, make: impl FnOnce() -> Defect) {
        let count = self.counts.entry(code).or_insert(0);
        *count += 1;
        if *count <= self.limit {
            self.kept.push(make());
        }
    }

    /// Whether nothing is known to be wrong, but a limit or a question left something open.
    pub fn is_declined(&self) -> bool {
        let mut codes = self.counts.keys();
        !self.is_empty() && codes.all(|code| [BOUNDARY_WORK, NEAR_MATES].contains(code))
    }

    /// Whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.counts.is_empty()
    }

    /// How many defects of each kind were found.
    pub fn counts(&self) -> &BTreeMap<&'static str, usize> {
        &self.counts
    }

    /// The first defects of each kind, in the order in which they were found.
    pub fn kept(&self) -> &[Defect] {
        &self.kept
    }
}
