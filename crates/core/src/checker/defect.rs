//! The defects of tilings: one variant for each kind, with the exact values.
//! [`super::render`] puts them into words.

use super::NearMates;
use crate::classify::NotTcp;
use crate::statement::Plane;
use crate::tiling::{Facet, SimplexId, VertexId};
use acutile_exact::number::Number;
use malachite::Rational;

/// One thing that is wrong. Simplices, facets and vertices are named by their
/// indices in the tiling, from zero.
#[derive(Clone, Debug, PartialEq)]
pub enum Defect {
    /// The leading principal minor of this order is not positive.
    MetricNotPositive {
        /// The number of rows of the minor.
        order: usize,
        /// Its value, zero or less.
        minor: Number,
    },
    /// There is nothing to tile with.
    NoSimplices,
    /// Two corners of a simplex are the same vertex with the same shift.
    RepeatedCorner {
        /// The simplex.
        simplex: SimplexId,
        /// The two corners, from 0 to D.
        corners: (usize, usize),
    },
    /// D! times the volume is zero.
    Flat {
        /// The simplex.
        simplex: SimplexId,
    },
    /// D! times the volume is negative. Exchanging the last two corners makes it positive.
    NegativeOrientation {
        /// The simplex.
        simplex: SimplexId,
        /// D! times the volume in basis coordinates, which is negative.
        determinant: Number,
    },
    /// No other simplex has this facet.
    UnmatchedFacet {
        /// The facet.
        facet: Facet,
    },
    /// Two simplices lie on the same side of a facet.
    SameSide {
        /// The facet, as a facet of each of the two simplices.
        facets: (Facet, Facet),
    },
    /// More than two simplices have the same facet.
    OverusedFacet {
        /// The facet, as a facet of each simplex that has it.
        facets: Vec<Facet>,
    },
    /// The volumes do not sum to the volume of the domain, `sum` and `expected`
    /// both in units of the cell.
    VolumeSum {
        /// The sum of the volumes.
        sum: Number,
        /// The volume of the domain.
        expected: Number,
    },
    /// The first vertices of a face of the domain determine no plane, or all vertices
    /// of the domain lie in it.
    FaceWithoutPlane {
        /// The face, by its index.
        face: usize,
    },
    /// A vertex of the domain is not where the plane of a face wants it: `value` is
    /// zero in the plane and positive on the inner side.
    FaceNotSupporting {
        /// The face, by its index.
        face: usize,
        /// The vertex of the domain, by its index.
        vertex: usize,
        /// Zero in the plane, positive on the inner side.
        value: Number,
    },
    /// The corners of a face of the domain are not in the order of a convex polygon.
    FaceNotConvex {
        /// The face, by its index.
        face: usize,
    },
    /// A ridge of the domain's boundary lies in another number of faces than two.
    RidgeNotShared {
        /// The vertices of the domain that span the ridge, by their indices.
        ridge: Vec<usize>,
        /// The number of faces that contain it.
        faces: usize,
    },
    /// A vertex lies outside of the domain, on the outer side of this face.
    VertexOutside {
        /// The vertex of the tiling, by its index.
        vertex: usize,
        /// The face of the domain, by its index.
        face: usize,
        /// The value of the plane's equation there, which is negative.
        value: Number,
    },
    /// Different vertices of a region are the same point.
    CoincidentVertices {
        /// The vertices, by their indices.
        vertices: Vec<usize>,
    },
    /// Two facets in the boundary of a region meet in this point, which their common vertices
    /// do not span.
    BoundaryMeets {
        /// The two facets.
        facets: (Facet, Facet),
        /// A common point, in basis coordinates.
        point: Vec<Number>,
    },
    /// The points directly outside of a facet in the boundary of a region, at its centroid, lie
    /// in these simplices.
    Covered {
        /// The facet.
        facet: Facet,
        /// The simplices that cover the points outside of it.
        simplices: Vec<SimplexId>,
    },
    /// Two simplices, the second moved by a lattice vector, have this point inside, in basis
    /// coordinates.
    Overlap {
        /// The two simplices.
        simplices: (SimplexId, SimplexId),
        /// The lattice vector that moves the second one.
        shift: Vec<i32>,
        /// A point inside both.
        point: Vec<Number>,
    },
    /// Boundary facets lie against each other, and no point is in two simplices there. Of the facets
    /// on the two sides, `coincident` pairs are equal.
    NonConforming {
        /// The facets of each side.
        sides: [Vec<Facet>; 2],
        /// The number of pairs of equal facets.
        coincident: usize,
        /// How the two sides differ.
        kind: ContactKind,
    },
    /// Simplices have the same corners.
    Duplicates {
        /// The simplices with the same corners.
        simplices: Vec<SimplexId>,
    },
    /// The simplices fall into this many pieces, where one is required; the first simplex of each.
    NotConnected {
        /// The first simplex of each piece.
        firsts: Vec<SimplexId>,
    },
    /// The boundary facets of a cavity, where none is allowed.
    Cavity {
        /// The facets around the cavity.
        facets: Vec<Facet>,
    },
    /// Edges with another number of boundary facets than two, and vertices with several rings of
    /// them, where a manifold is required.
    NotManifold {
        /// The edges, each by its vertices.
        ridges: Vec<Vec<VertexId>>,
        /// The vertices with several rings.
        vertices: Vec<VertexId>,
    },
    /// Boundary facets that are no triangles of a surface that should be filled.
    NotOnSurface {
        /// The boundary facets that the surface lacks.
        facets: Vec<Facet>,
    },
    /// Triangles of a surface, by their indices, that are no boundary facets.
    NotBoundary {
        /// The triangles of the surface, by their indices.
        triangles: Vec<usize>,
    },
    /// No vertex is inside of a circumsphere, where one is required.
    NoneInside,
    /// A region without boundary: it is all of space.
    NoBoundary,
    /// The boundary has too many facets close to each other: nothing is known to be
    /// wrong, and nothing is proved.
    BoundaryWork {
        /// The limit that is exceeded: of translates, of pairs, or of comparisons.
        limit: usize,
    },
    /// Facets of a periodic mesh nearly have a mate: nothing is known to be wrong, and nothing is
    /// proved.
    NearMates(NearMates),
    /// A vertex of a region is more than [`CELL_LIMIT`](crate::tiling::CELL_LIMIT) lattice vectors
    /// away from the origin: nothing is known to be wrong, and nothing is proved.
    VertexFar {
        /// The vertex, by its index.
        vertex: usize,
    },
    /// A vertex is a corner of no simplex.
    UnusedVertex {
        /// The vertex, by its index.
        vertex: usize,
    },
    /// A dihedral angle is a right angle where all must be acute.
    RightAngle {
        /// The angle.
        angle: Angle,
    },
    /// A dihedral angle is more than a right angle.
    ObtuseAngle {
        /// The angle.
        angle: Angle,
    },
    /// A dihedral angle is not less than a bound in degrees.
    AngleNotBelow {
        /// The angle.
        angle: Angle,
        /// The bound in degrees.
        bound: Rational,
    },
    /// A dihedral angle is not more than a bound in degrees.
    AngleNotAbove {
        /// The angle.
        angle: Angle,
        /// The bound in degrees.
        bound: Rational,
    },
    /// The squared circumradius of a simplex over the square of its shortest edge is
    /// `squared_ratio`, not less than the square of the bound.
    RatioNotBelow {
        /// The simplex.
        simplex: SimplexId,
        /// The square of its radius-edge ratio.
        squared_ratio: Number,
        /// The bound of the ratio, not squared.
        bound: Rational,
    },
    /// A plane that must not be crossed names a coordinate that there is not.
    PlaneBeyond {
        /// The plane.
        plane: Plane,
        /// The dimension of the tiling.
        dimension: usize,
    },
    /// A simplex has corners on both sides of a translate of a plane: `sides` are the values of
    /// normal · x at two of them, and `offset` is that of the translate.
    PlaneCrossed {
        /// The simplex.
        simplex: SimplexId,
        /// The plane that was named.
        plane: Plane,
        /// The offset of the translate that is crossed.
        offset: Rational,
        /// The values of normal · x at two corners, on different sides of the offset.
        sides: (Number, Number),
    },
    /// The tiling is not tetrahedrally close packed.
    NotTcp {
        /// The edge or triangle that TCP forbids.
        reason: NotTcp,
    },
    /// The corner of the neighbour across a facet lies on the circumsphere; the
    /// power is zero.
    OnCircumsphere {
        /// The facet, as one of the simplex with the sphere.
        facet: Facet,
        /// The simplex on the other side of the facet.
        neighbour: SimplexId,
    },
    /// The corner of the neighbour across a facet lies inside of the circumsphere;
    /// `power` is its power times D! times the volume.
    InsideCircumsphere {
        /// The facet, as one of the simplex with the sphere.
        facet: Facet,
        /// The simplex on the other side of the facet.
        neighbour: SimplexId,
        /// The power of the corner times D! times the volume, which is negative.
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
    /// The number of points of one side that are on no point of the other side.
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
            Defect::VertexFar { .. } => VERTEX_FAR,
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
            Defect::NoneInside => "none-inside",
            Defect::OnCircumsphere { .. } => "on-circumsphere",
            Defect::InsideCircumsphere { .. } => "inside-circumsphere",
        }
    }
}

/// The code of [`Defect::BoundaryMeets`], whose evidence is made only where it is kept.
pub(super) const BOUNDARY_MEETS: &str = "boundary-meets";
/// The code of [`Defect::BoundaryWork`].
pub(super) const BOUNDARY_WORK: &str = "boundary-work";

/// The code of [`Defect::VertexFar`].
pub(super) const VERTEX_FAR: &str = "vertex-far";
/// The code of [`Defect::NearMates`].
pub(super) const NEAR_MATES: &str = "near-mates";
