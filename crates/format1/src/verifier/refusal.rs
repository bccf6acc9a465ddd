//! Every way in which a certificate can fail to be verified, as one table.
//!
//! A refusal carries what was found, with indices counted from zero as in the
//! file; the sentences are in [`super::render`]. docs/format.md lists the codes
//! beside the clauses that raise them.

use crate::certificate::Number;

/// What a refusal says about the certificate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Not a certificate: the bytes do not follow the grammar.
    Malformed,
    /// A certificate in which something stated does not hold.
    False,
    /// Nothing was found wrong, and nothing is proved: a limit, an unknown
    /// version, a sign that could not be decided.
    Declined,
}

/// Writes the enum, its codes and its kinds from one list, so that none of the
/// three can miss a variant.
macro_rules! refusals {
    ($($kind:ident $code:literal $(#[$doc:meta])* $name:ident { $($field:ident : $type:ty),* $(,)? })*) => {
        /// Why a certificate is not verified. One variant for each way.
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub enum Refusal {
            $($(#[$doc])* #[allow(missing_docs)] $name { $($field: $type),* },)*
        }

        impl Refusal {
            /// The code of every variant, in the order of the checks.
            pub const CODES: &'static [(&'static str, Kind)] = &[$(($code, Kind::$kind)),*];

            /// The stable name of this refusal, in kebab case.
            pub fn code(&self) -> &'static str {
                match self { $(Refusal::$name { .. } => $code,)* }
            }

            /// Malformed, false or declined.
            pub fn kind(&self) -> Kind {
                match self { $(Refusal::$name { .. } => Kind::$kind,)* }
            }
        }
    };
}

refusals! {
    // The bytes.
    Declined "too-many-bytes"
    /// The file, or what is to be held of it, is larger than the limit. `found` is 1 + limit where reading stopped there.
    TooManyBytes { found: u64, limit: u64 }
    Malformed "json"
    /// Not JSON, or not of the grammar's shape: a missing, unknown, repeated or mistyped member.
    Json { message: String }
    Malformed "cbor"
    /// Not CBOR of the kinds that occur, or not of the grammar's shape.
    Cbor { offset: u64, message: String }
    Declined "changed"
    /// The file could not be read again, or has other bytes than before.
    Changed { message: String }
    Malformed "format"
    /// Some other format.
    Format { found: String }
    Declined "version"
    /// A version of the format that this program does not know.
    Version { found: u64 }
    Malformed "canonical"
    /// The certificate, written again, differs first at this byte.
    Canonical { offset: usize }

    // Lengths, ranges and order.
    Malformed "dimension"
    /// Neither 2 nor 3.
    Dimension { found: usize }
    Malformed "statements"
    /// Not strictly increasing, or the first is not the tiling.
    Statements { index: usize }
    Malformed "tcp-domain"
    /// TCP is claimed of something else than all of three-space.
    TcpDomain {}
    Malformed "delaunay-domain"
    /// Delaunay is claimed of a region, which need not be convex.
    DelaunayDomain {}
    Malformed "gram-shape"
    /// Not D rows of D numbers.
    GramShape {}
    Malformed "gram-asymmetric"
    /// Two opposite entries are not the same text.
    GramAsymmetric { row: usize, column: usize }
    Malformed "prism-dimension"
    /// A prism in another dimension than 3.
    PrismDimension {}
    Malformed "region-dimension"
    /// A region in another dimension than 3.
    RegionDimension {}
    Malformed "domain-vertex-length"
    /// Not k coordinates.
    DomainVertexLength { vertex: usize, found: usize, expected: usize }
    Malformed "face-count"
    /// Fewer faces than a polytope of dimension k has.
    FaceCount { found: usize, least: usize }
    Malformed "face-length"
    /// Not one vertex for k = 1, two for k = 2, at least three for k = 3.
    FaceLength { face: usize, found: usize }
    Malformed "face-vertices"
    /// A vertex of the domain that does not exist, or is in the face twice.
    FaceVertices { face: usize, found: usize }
    Malformed "face-repeated"
    /// A face with the same vertices as an earlier one.
    FaceRepeated { face: usize }
    Malformed "unused-domain-vertex"
    /// A vertex of the domain that is in no face.
    UnusedDomainVertex { vertex: usize }
    Malformed "no-simplices"
    /// An empty list of simplices tiles nothing.
    NoSimplices {}
    Declined "too-many-simplices"
    /// More simplices than the limit.
    TooManySimplices { found: usize, limit: usize }
    Malformed "vertex-length"
    /// Not D coordinates.
    VertexLength { vertex: usize, found: usize, expected: usize }
    Malformed "simplex-length"
    /// Not D + 1 corners.
    SimplexLength { simplex: usize, found: usize, expected: usize }
    Malformed "corner-length"
    /// Not a vertex and r entries of a shift.
    CornerLength { simplex: usize, corner: usize, found: usize, expected: usize }
    Malformed "vertex-range"
    /// A corner at a vertex that does not exist.
    VertexRange { simplex: usize, corner: usize, found: i64, vertices: usize }
    Malformed "shift-range"
    /// An entry of a lattice shift that does not lie between -2^31 and 2^31.
    ShiftRange { simplex: usize, corner: usize, found: i64 }
    Malformed "unused-vertex"
    /// A vertex that is no corner of any simplex.
    UnusedVertex { vertex: usize }
    Malformed "mates-length"
    /// Not one row of mates for each simplex.
    MatesLength { found: usize, expected: usize }
    Malformed "mate-row-length"
    /// Not one mate for each facet of the simplex.
    MateRowLength { simplex: usize, found: usize, expected: usize }
    Malformed "mate-length"
    /// Not a simplex, a corner and r entries of a shift.
    MateLength { simplex: usize, facet: usize, found: usize, expected: usize }
    Malformed "mate-range"
    /// A mate in a simplex, opposite to a corner or in a face that does not exist.
    MateRange { simplex: usize, facet: usize, found: Vec<i64> }
    Malformed "mate-shift-range"
    /// An entry of a mate's shift that does not lie between -2^31 and 2^31.
    MateShiftRange { simplex: usize, facet: usize, found: i64 }

    // Numbers and the field.
    Malformed "number"
    /// Text that is no rational number in lowest terms.
    Number { place: String, text: String, reason: &'static str }
    Declined "too-many-digits"
    /// A number with more digits than the limit.
    TooManyDigits { place: String, found: usize, limit: usize }
    Malformed "polynomial"
    /// Not monic of degree at least two with integer coefficients.
    Polynomial { reason: &'static str }
    Declined "degree"
    /// A field of larger degree than the limit.
    Degree { found: usize, limit: usize }
    Malformed "root-order"
    /// The lower end of the root's interval is not below the upper one.
    RootOrder {}
    False "root-signs"
    /// The polynomial does not have opposite strict signs at the ends.
    RootSigns {}
    Malformed "root-derivative"
    /// The derivative could not be shown to keep its sign on the interval.
    RootDerivative {}
    Malformed "coefficients"
    /// No coefficient, more than the degree, or a trailing zero.
    Coefficients { place: String, reason: &'static str }
    Malformed "angle-range"
    /// An angle bound outside of 0 < Q <= 180 degrees, or of 0 <= Q < 180 from below.
    AngleRange { found: String }
    Malformed "ratio-range"
    /// A bound of the radius-edge ratios that is not positive.
    RatioRange { found: String }
    Declined "common-denominator"
    /// The common denominator of the numbers has more digits than the limit.
    CommonDenominator { of: &'static str, limit: usize }
    Declined "work"
    /// More arithmetic than the limit.
    Work { of: &'static str, found: u64, limit: u64 }

    // Geometry.
    Declined "sign-undecided"
    /// The value is not identically zero, and its sign is not proved either.
    SignUndecided { of: String, value: Number }
    False "gram-not-positive"
    /// A leading principal minor is not positive.
    GramNotPositive { order: usize, minor: Number }
    False "face-not-facet"
    /// A face's determinant is not zero at one of its vertices, or does not have one strict sign at the others.
    FaceNotFacet { face: usize, vertex: usize, value: Number }
    False "face-not-convex"
    /// The third vertex is not on the inner side of the first two, which follow one another.
    FaceNotConvex { face: usize, vertices: (usize, usize, usize) }
    False "faces-not-closed"
    /// The ridge with these vertices is not in two faces.
    FacesNotClosed { ridge: Vec<usize>, faces: usize }
    False "vertex-outside"
    /// A vertex of the tiling on the outer side of a face; `value` is the face's determinant there.
    VertexOutside { vertex: usize, face: usize, value: Number }
    False "orientation"
    /// A simplex whose determinant in basis coordinates is not positive.
    Orientation { simplex: usize, determinant: Number }
    False "mate-not-mutual"
    /// The mate of the mate is another facet.
    MateNotMutual { simplex: usize, facet: usize, back: Vec<i64> }
    False "mate-corners"
    /// A facet and its mate have different corners.
    MateCorners { simplex: usize, facet: usize, mate: Vec<i64>, missing: Vec<i64> }
    False "mate-side"
    /// A facet and its mate have their simplices on the same side.
    MateSide { simplex: usize, facet: usize, mate: Vec<i64> }
    False "boundary-facet"
    /// A facet that is said to lie in a face of the domain has a corner outside of its plane.
    BoundaryFacet { simplex: usize, facet: usize, face: usize, value: Number }
    False "volume-sum"
    /// The volumes of the simplices, in units of the cell, do not sum to that of the domain.
    VolumeSum { sum: Number, expected: Number }
    False "boundary-meets"
    /// Two facets (simplex, facet) in the boundary of a region that have `shared` corners in common and meet elsewhere.
    BoundaryMeets { first: (usize, usize), second: (usize, usize), shared: usize }
    False "covering"
    /// Directly outside of a facet in the boundary of a region, `outside` simplices cover each point, less those that would have to be taken away.
    Covering { simplex: usize, facet: usize, outside: i64 }
    False "not-acute"
    /// The angle between two facets is not acute; `product` is that of their inward normals, scaled.
    NotAcute { simplex: usize, facets: (usize, usize), product: Number }
    False "not-nonobtuse"
    /// The angle between two facets is obtuse; `product` as for [`Refusal::NotAcute`].
    NotNonobtuse { simplex: usize, facets: (usize, usize), product: Number }
    False "angle-not-below"
    /// The angle between two facets is at least the bound, in degrees.
    AngleNotBelow { simplex: usize, facets: (usize, usize), degrees: String }
    False "angle-not-above"
    /// The angle between two facets is at most the bound, in degrees.
    AngleNotAbove { simplex: usize, facets: (usize, usize), degrees: String }
    Declined "angle-undecided"
    /// The angle is too near to the bound for the kernel's enclosure of its cosine.
    AngleUndecided { simplex: usize, facets: (usize, usize), degrees: String }
    False "ratio-not-below"
    /// The circumradius is at least the bound times the edge between two corners.
    RatioNotBelow { simplex: usize, corners: (usize, usize), ratio: String }
    False "not-delaunay"
    /// The corner behind a facet is not outside of the circumsphere; `power` is its scaled power.
    NotDelaunay { simplex: usize, facet: usize, power: Number }
    False "not-weakly-delaunay"
    /// The corner behind a facet is inside of the circumsphere; `power` is its scaled power.
    NotWeaklyDelaunay { simplex: usize, facet: usize, power: Number }
    False "edge-valence"
    /// An edge in neither 5 nor 6 tetrahedra; its two vertices and the shift from one to the other.
    EdgeValence { ends: Vec<i64>, valence: usize }
    False "triangle-valence"
    /// A triangle with two edges that are in 6 tetrahedra.
    TriangleValence { simplex: usize, facet: usize }
}
