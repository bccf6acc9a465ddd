//! The reasons for which a certificate is not verified: a code, a place and an exact value.
//!
//! The kernel writes no sentences. Programs build them from these three.

use num_bigint::BigInt;

/// Refuses unless a condition holds.
macro_rules! ensure {
    ($condition:expr, $code:ident, $place:expr $(, $value:expr)?) => {
        if !$condition && !$crate::refusal::is_left_out(file!(), line!()) {
            #[allow(unused_mut, unused_assignments)]
            let mut value = $crate::refusal::Value::Nothing;
            $(value = $value.into();)?
            let code = $crate::refusal::Code::$code;
            return Err($crate::refusal::Refusal::new(code, $place, value, line!()).into());
        }
    };
}

/// Writes the enumeration, the names and the kinds of the codes from one list.
macro_rules! codes {
    ($($kind:ident { $($name:ident $text:literal,)* })*) => {
        /// The condition that does not hold. The order is that of the checks, within each kind.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code { $($($name,)*)* }

        impl Code {
            /// All codes.
            pub const ALL: &[Code] = &[$($(Code::$name,)*)*];

            /// The name in documents and in the program's output.
            pub fn text(self) -> &'static str {
                match self { $($(Code::$name => $text,)*)* }
            }

            pub fn kind(self) -> Kind {
                match self { $($(Code::$name => Kind::$kind,)*)* }
            }
        }
    };
}

/// The verdict that a refusal means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// A statement of the certificate does not hold.
    Rejected,
    /// The bytes are no certificate.
    Malformed,
    /// Neither: a limit, an unknown version, a sign that is not decided.
    Declined,
}

codes! {
    Malformed {
        Cbor "cbor",
        Canonical "canonical",
        Format "format",
        Dimension "dimension",
        Polynomial "polynomial",
        RootOrder "root-order",
        RootDerivative "root-derivative",
        PrismDimension "prism-dimension",
        RegionRank "region-rank",
        Denominator "denominator",
        FaceCount "face-count",
        FaceLength "face-length",
        FaceVertices "face-vertices",
        FaceRepeated "face-repeated",
        UnusedDomainVertex "unused-domain-vertex",
        Statements "statements",
        BoundRange "bound-range",
        StatementDomain "statement-domain",
        BoundaryDomain "boundary-domain",
        NoSimplices "no-simplices",
        VertexRange "vertex-range",
        ShiftRange "shift-range",
        CornerOrder "corner-order",
        Sixes "sixes",
        BoundaryRepeated "boundary-repeated",
        UnusedVertex "unused-vertex",
    }
    Rejected {
        RootSigns "root-signs",
        GramNotPositive "gram-not-positive",
        FaceNotFacet "face-not-facet",
        FaceNotConvex "face-not-convex",
        FacesNotClosed "faces-not-closed",
        DenominatorDomain "denominator-domain",
        VertexOutside "vertex-outside",
        BoundaryMeets "boundary-meets",
        FacetSide "facet-side",
        TriangleValence "triangle-valence",
        EdgeValence "edge-valence",
        Orientation "orientation",
        Covering "covering",
        NotAcute "not-acute",
        NotNonobtuse "not-nonobtuse",
        AngleBound "angle-bound",
        RatioBound "ratio-bound",
        NotDelaunay "not-delaunay",
        NotWeaklyDelaunay "not-weakly-delaunay",
        OpenFacet "open-facet",
        BoundaryOpen "boundary-open",
        VolumeSum "volume-sum",
        NotAttained "not-attained",
    }
    Declined {
        Unreadable "unreadable",
        TooManyBytes "too-many-bytes",
        Version "version",
        UnknownKind "kind",
        Degree "degree",
        TooManyDigits "too-many-digits",
        TooManySimplices "too-many-simplices",
        SignUndecided "sign-undecided",
        Work "work",
    }
}

/// The part of the certificate to which a refusal belongs. All numbers count from zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// An offset in the file.
    Byte(u64),
    /// The field, the Gram matrix or the domain.
    Field,
    /// A leading principal minor of the Gram matrix, by its number of rows.
    Minor(usize),
    Domain,
    Face(usize),
    Statement(usize),
    Vertex(u32),
    /// A facet in the list `boundary`.
    Boundary(u64),
    /// Two facets in the list `boundary`.
    BoundaryPair(u64, u64),
    Simplex(u64),
    /// A facet of a simplex, by the sorted corner that it does not have.
    Facet(u64, usize),
    /// An edge of a simplex, by its two sorted corners.
    Edge(u64, usize, usize),
    /// The angle of a simplex between two facets, by the corners of the row that they do not have.
    Angle(u64, usize, usize),
    /// The witness as a whole.
    Witness,
}

/// A limit that declines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    Bytes,
    Simplices,
    Bits,
    Degree,
    Work,
}

/// The exact value that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    Nothing,
    Integer(BigInt),
    /// A quotient of two numbers of the field, each by its coefficients of 1, a, a², …
    Quotient(Vec<BigInt>, Vec<BigInt>),
    /// A limit that is too small, and a value that suffices for this check, if it is known.
    Exceeds(Limit, Option<u64>),
}

impl From<BigInt> for Value {
    fn from(value: BigInt) -> Value {
        Value::Integer(value)
    }
}

impl From<i64> for Value {
    fn from(value: i64) -> Value {
        Value::Integer(value.into())
    }
}

impl From<u64> for Value {
    fn from(value: u64) -> Value {
        Value::Integer(value.into())
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    pub code: Code,
    pub place: Place,
    pub value: Value,
    /// The line of the check in the kernel's source, for the tests that leave checks out.
    pub line: u32,
}

/// The box keeps results small.
pub type Checked<T = ()> = Result<T, Box<Refusal>>;

impl Refusal {
    #[cold]
    #[inline(never)]
    pub(crate) fn new(code: Code, place: Place, value: Value, line: u32) -> Box<Refusal> {
        Box::new(Refusal {
            code,
            place,
            value,
            line,
        })
    }
}

/// A result does not fit the integers in use, or its sign is not visible at their precision.
/// The caller starts again with larger ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Larger;

/// The reasons for which the judgement of a simplex stops.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    Larger,
    Refused(Box<Refusal>),
}

impl From<Larger> for Stop {
    fn from(_: Larger) -> Stop {
        Stop::Larger
    }
}

impl From<Box<Refusal>> for Stop {
    fn from(refusal: Box<Refusal>) -> Stop {
        Stop::Refused(refusal)
    }
}

impl Stop {
    /// The refusal, where no larger integers are left.
    pub(crate) fn at_last(self, place: Place) -> Box<Refusal> {
        match self {
            Stop::Refused(refusal) => refusal,
            Stop::Larger => Refusal::new(Code::SignUndecided, place, Value::Nothing, line!()),
        }
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
