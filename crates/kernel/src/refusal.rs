//! The reasons for which a certificate is not verified: a code, a place and an exact value.
//!
//! The kernel writes no sentences. Programs build them from these three.

use num_bigint::BigInt;

/// Refuses unless a condition holds.
macro_rules! ensure {
    ($condition:expr, $code:ident, $place:expr) => {
        ensure!($condition, $code, $place, $crate::refusal::Value::Nothing)
    };
    ($condition:expr, $code:ident, $place:expr, $value:expr) => {
        if !$condition && !$crate::refusal::is_left_out(file!(), line!()) {
            let code = $crate::refusal::Code::$code;
            return Err($crate::refusal::Stop::refuse(code, $place, $value.into()));
        }
    };
}

/// The content of an option; refuses where there is none.
macro_rules! some {
    ($option:expr, $($refusal:tt)*) => {{
        let option = $option;
        ensure!(option.is_some(), $($refusal)*);
        option.unwrap_or_default()
    }};
}

/// An enumeration of which each value has a text.
macro_rules! texts {
    ($(#[$doc:meta])* $name:ident { $first:ident $first_text:literal, $($value:ident $text:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name { #[doc = $first_text] #[default] $first, $(#[doc = $text] $value,)* }

        impl $name {
            /// All values, in the order of their definition.
            pub const ALL: &[$name] = &[$name::$first, $($name::$value,)*];

            /// The text of a value.
            pub fn text(self) -> &'static str {
                match self { $name::$first => $first_text, $($name::$value => $text,)* }
            }

            /// The value with a text.
            pub fn find(text: &str) -> Option<$name> {
                $name::ALL.iter().copied().find(|value| value.text() == text)
            }
        }
    };
}

texts! {
    /// The verdict that a refusal means.
    Kind {
        // A statement of the certificate does not hold.
        Rejected "rejected",
        // The bytes are no certificate, or they cannot be read.
        Malformed "malformed",
        // Neither: a limit, an unknown version, a sign that is not decided.
        Declined "declined",
    }
}

texts! {
    /// The condition that does not hold.
    Code {
        // Malformed.
        Unreadable "unreadable", Cbor "cbor", Canonical "canonical", Format "format",
        Dimension "dimension", Polynomial "polynomial", RootOrder "root-order",
        RootDerivative "root-derivative", PrismDimension "prism-dimension",
        RegionRank "region-rank", Denominator "denominator", FaceCount "face-count",
        FaceLength "face-length", FaceVertices "face-vertices", FaceRepeated "face-repeated",
        UnusedDomainVertex "unused-domain-vertex", Statements "statements",
        BoundRange "bound-range", StatementDomain "statement-domain",
        BoundaryDomain "boundary-domain", NoSimplices "no-simplices", VertexRange "vertex-range",
        ShiftRange "shift-range", CornerOrder "corner-order", Sixes "sixes",
        FamilyDomain "family-domain", Parameters "parameters",
        ParameterName "parameter-name", BoxExchanged "box-exchanged", BoxEmpty "box-empty",
        UnusedParameter "unused-parameter", Exponent "exponent", Terms "terms", Tree "tree",
        Rank "rank", TileCount "tile-count", SideCount "side-count", PyramidForm "pyramid",
        BoundaryRepeated "boundary-repeated", UnusedVertex "unused-vertex",
        // Rejected.
        RootSigns "root-signs", GramNotPositive "gram-not-positive",
        FaceNotFacet "face-not-facet", FaceNotConvex "face-not-convex",
        FacesNotClosed "faces-not-closed", DenominatorDomain "denominator-domain",
        VertexOutside "vertex-outside", BoundaryMeets "boundary-meets", FacetSide "facet-side",
        TriangleValence "triangle-valence", EdgeValence "edge-valence",
        Orientation "orientation", Covering "covering", NotAcute "not-acute",
        NotNonobtuse "not-nonobtuse", AngleBound "angle-bound", RatioBound "ratio-bound",
        NotDelaunay "not-delaunay", NotWeaklyDelaunay "not-weakly-delaunay",
        PlaneCrossed "plane-crossed",
        OpenFacet "open-facet", BoundaryOpen "boundary-open", VolumeSum "volume-sum",
        GramBlocks "gram-blocks", TileOrder "tile-order", PyramidSide "pyramid-side",
        WallPattern "wall-pattern", WallReversal "wall-reversal", SideClasses "side-classes",
        MissingJoin "missing-join", NoneInside "none-inside", NotAttained "not-attained",
        // Declined.
        CornerAngle "corner-angle",
        TooManyBytes "too-many-bytes", Version "version", UnknownKind "kind", Degree "degree",
        TooManyDigits "too-many-digits", TooManySimplices "too-many-simplices",
        TreeSize "tree-size", SignUndecided "sign-undecided", Work "work",
    }
}

impl Code {
    /// The codes of a kind stand together.
    pub fn kind(self) -> Kind {
        if self <= Code::UnusedVertex {
            Kind::Malformed
        } else if self <= Code::NotAttained {
            Kind::Rejected
        } else {
            Kind::Declined
        }
    }
}

/// The part of the certificate to which a refusal belongs. All numbers count from zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// An offset in the file.
    Byte(u64),
    /// The field or its root.
    Field,
    /// A leading principal minor of the Gram matrix, by its number of rows.
    Minor(usize),
    /// The domain.
    Domain,
    /// A face of the domain.
    Face(usize),
    /// A statement of the claim.
    Statement(usize),
    /// A vertex.
    Vertex(u32),
    /// A parameter of a family.
    Parameter(usize),
    /// One facet, or two, in the list `boundary`.
    Boundary(u64),
    /// Two facets in the list `boundary`.
    BoundaryPair(u64, u64),
    /// A simplex.
    Simplex(u64),
    /// A facet of a simplex, by the sorted corner that it does not have.
    Facet(u64, usize),
    /// An edge of a simplex, by its two sorted corners.
    Edge(u64, usize, usize),
    /// The angle of a simplex between two facets, by the corners of the row that they do not have.
    Angle(u64, usize, usize),
    /// A tile of a system of patches, and one of its sides.
    Tile(usize),
    /// A tile, and one of its sides.
    Side(usize, u32),
    /// The witness.
    Witness,
}

/// The exact value that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// No value.
    Nothing,
    /// An integer.
    Integer(BigInt),
    /// A quotient of two numbers of the field, each by its coefficients of 1, a, a², …
    Quotient(Vec<BigInt>, Vec<BigInt>),
    /// The name of a limit, and a value that suffices for this check, if it is known.
    Limit(&'static str, Option<u64>),
}

macro_rules! integers {
    ($($integer:ty)*) => {$(
        impl From<$integer> for Value {
            fn from(value: $integer) -> Value {
                Value::Integer(value.into())
            }
        }
    )*};
}
integers! { BigInt i64 u64 usize }

/// Why a certificate is not verified.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The condition that does not hold.
    pub code: Code,
    /// The part of the certificate.
    pub place: Place,
    /// The exact value that is wrong.
    pub value: Value,
    /// Of a family: a point of the box at which the condition does not hold, by the names and the
    /// values of the parameters.
    pub point: Vec<(String, Value)>,
}

/// The reason for which a computation stops: a refusal, or nothing if a result does not fit the integers in use or a
/// sign is not visible at their precision. Then the caller starts again with larger ones. The box keeps results small.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stop(Option<Box<Refusal>>);

pub type Checked<T = ()> = Result<T, Stop>;

impl Stop {
    pub(crate) const LARGER: Stop = Stop(None);

    #[cold]
    #[inline(never)]
    pub(crate) fn refuse(code: Code, place: Place, value: Value) -> Stop {
        Stop::of(Refusal { code, place, value, point: Vec::new() })
    }

    pub(crate) fn of(refusal: Refusal) -> Stop {
        Stop(Some(Box::new(refusal)))
    }

    pub(crate) fn is_larger(&self) -> bool {
        self.0.is_none()
    }

    /// The refusal; no integers are larger.
    pub(crate) fn refusal(self) -> Refusal {
        let (code, place, value) = (Code::SignUndecided, Place::Witness, Value::Nothing);
        self.0.map_or_else(|| Refusal { code, place, value, point: Vec::new() }, |refusal| *refusal)
    }

    /// The refusal, with a place for an undecided sign.
    pub(crate) fn at(self, place: Place) -> Stop {
        if self.is_larger() { Stop::refuse(Code::SignUndecided, place, Value::Nothing) } else { self }
    }
}

/// Whether a test leaves the check on this line out.
#[cfg(not(test))]
#[inline(always)]
pub(crate) fn is_left_out(_file: &'static str, _line: u32) -> bool {
    false
}

#[cfg(test)]
pub(crate) use crate::tests::is_left_out;
