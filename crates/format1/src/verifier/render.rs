//! The words for what is wrong. Not trusted: whatever they say, it is a refusal.
//!
//! Indices are counted from zero, as in the file. Text from the file is quoted
//! with its control characters escaped.

use super::{Kind, Refusal};
use std::fmt::{self, Display, Formatter, Result};

impl Display for Kind {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(match self {
            Kind::Malformed => "malformed",
            Kind::False => "rejected",
            Kind::Declined => "declined",
        })
    }
}

impl std::error::Error for Refusal {}

/// What is wrong, where, and the exact value found; without the code.
impl Display for Refusal {
    fn fmt(&self, f: &mut Formatter) -> Result {
        use Refusal::*;
        match self {
            TooManyBytes { found, limit } => {
                write!(f, "at least {found} bytes, more than the limit of {limit}")
            }
            Json { message } => write!(f, "{}", message.escape_debug()),
            Cbor { offset, message } => {
                write!(f, "{} at offset {offset}", message.escape_debug())
            }
            Changed { message } => write!(
                f,
                "the file cannot be read again as it was: {}",
                message.escape_debug()
            ),
            Format { found } => write!(f, "the format is {found:?}, not \"acutile-certificate\""),
            Version { found } => write!(f, "version {found} is unknown; this program knows 1"),
            Canonical { offset } => {
                write!(
                    f,
                    "not in canonical form: the first wrong byte is at offset {offset}"
                )
            }
            Dimension { found } => write!(f, "dimension {found}; it must be 2 or 3"),
            Statements { index: 0 } => {
                write!(f, "the first statement must be \"face-to-face tiling\"")
            }
            Statements { index } => {
                write!(
                    f,
                    "statement {index} is out of order or repeats the one before it"
                )
            }
            TcpDomain {} => write!(f, "\"TCP\" is stated of all of three-space only"),
            DelaunayDomain {} => write!(
                f,
                "Delaunay is not stated of a region, which need not be convex"
            ),
            PrismDimension {} => write!(f, "a prism has dimension 3"),
            RegionDimension {} => write!(f, "a region has dimension 3"),
            DomainVertexLength {
                vertex,
                found,
                expected,
            } => {
                write!(
                    f,
                    "vertex {vertex} of the domain has {found} coordinates, not {expected}"
                )
            }
            FaceCount { found, least } => {
                write!(f, "the domain has {found} faces, fewer than {least}")
            }
            FaceLength { face, found } => {
                write!(f, "face {face} of the domain has {found} vertices")
            }
            FaceVertices { face, found } => write!(
                f,
                "vertex {found} of face {face} of the domain does not exist or is there twice"
            ),
            FaceRepeated { face } => {
                write!(f, "face {face} of the domain is the same as another")
            }
            UnusedDomainVertex { vertex } => {
                write!(f, "vertex {vertex} of the domain is in no face")
            }
            GramShape {} => write!(f, "the Gram matrix is not square of the dimension's size"),
            GramAsymmetric { row, column } => {
                write!(
                    f,
                    "gram[{row}][{column}] is not the same text as gram[{column}][{row}]"
                )
            }
            NoSimplices {} => write!(f, "there are no simplices"),
            TooManySimplices { found, limit } => {
                write!(f, "{found} simplices, more than the limit of {limit}")
            }
            VertexLength {
                vertex,
                found,
                expected,
            } => {
                write!(f, "vertex {vertex} has {found} coordinates, not {expected}")
            }
            SimplexLength {
                simplex,
                found,
                expected,
            } => {
                write!(f, "simplex {simplex} has {found} corners, not {expected}")
            }
            CornerLength {
                simplex,
                corner,
                found,
                expected,
            } => {
                write!(
                    f,
                    "{} has {found} entries, not {expected}",
                    corner_of(*simplex, *corner)
                )
            }
            VertexRange {
                simplex,
                corner,
                found,
                vertices,
            } => {
                let corner = corner_of(*simplex, *corner);
                write!(
                    f,
                    "{corner} is at vertex {found}; there are {vertices} vertices"
                )
            }
            ShiftRange {
                simplex,
                corner,
                found,
            } => {
                let corner = corner_of(*simplex, *corner);
                write!(
                    f,
                    "{corner} is shifted by {found}, not between -2^31 and 2^31"
                )
            }
            UnusedVertex { vertex } => write!(f, "vertex {vertex} is no corner of any simplex"),
            MatesLength { found, expected } => {
                write!(f, "{found} rows of mates for {expected} simplices")
            }
            MateRowLength {
                simplex,
                found,
                expected,
            } => {
                write!(f, "simplex {simplex} has {found} mates, not {expected}")
            }
            MateLength {
                simplex,
                facet,
                found,
                expected,
            } => {
                let facet = facet_of(*simplex, *facet);
                write!(f, "the mate of {facet} has {found} entries, not {expected}")
            }
            MateRange {
                simplex,
                facet,
                found,
            } => {
                let facet = facet_of(*simplex, *facet);
                write!(f, "the mate of {facet}, {found:?}, does not exist")
            }
            MateShiftRange {
                simplex,
                facet,
                found,
            } => {
                let facet = facet_of(*simplex, *facet);
                write!(
                    f,
                    "the mate of {facet} is shifted by {found}, not between -2^31 and 2^31"
                )
            }
            Number {
                place,
                text,
                reason,
            } => write!(f, "{place}: {text:?}: {reason}"),
            TooManyDigits {
                place,
                found,
                limit,
            } => {
                write!(f, "{place}: {found} digits, more than the limit of {limit}")
            }
            Polynomial { reason } => write!(f, "the field's polynomial: {reason}"),
            Degree { found, limit } => {
                write!(
                    f,
                    "the field has degree {found}, more than the limit of {limit}"
                )
            }
            RootOrder {} => write!(f, "the root's interval does not rise"),
            RootSigns {} => write!(
                f,
                "the field's polynomial does not have opposite signs at the ends of the root's interval"
            ),
            RootDerivative {} => write!(
                f,
                "the derivative of the field's polynomial is not shown to keep its sign on the root's interval"
            ),
            Coefficients { place, reason } => write!(f, "{place}: coefficients: {reason}"),
            AngleRange { found } => {
                write!(
                    f,
                    "an angle bound of {found} degrees, out of the range from 0 to 180"
                )
            }
            RatioRange { found } => write!(f, "a ratio of {found}; it must be positive"),
            CommonDenominator { of, limit } => {
                write!(
                    f,
                    "{of}: the common denominator has more than {limit} digits"
                )
            }
            Work { of, found, limit } => {
                write!(
                    f,
                    "{found} word products {of}, more than the limit of {limit}"
                )
            }
            SignUndecided { of, value } => {
                write!(
                    f,
                    "the sign of the {of}, {value}, is not decided by the bisections allowed"
                )
            }
            GramNotPositive { order, minor } => write!(
                f,
                "the Gram matrix is not positive definite: its leading principal minor {order} is {minor}"
            ),
            FaceNotFacet {
                face,
                vertex,
                value,
            } => write!(
                f,
                "face {face} is no facet of the domain: vertex {vertex} of the domain has the determinant {value}"
            ),
            FaceNotConvex {
                face,
                vertices: (p, q, t),
            } => write!(
                f,
                "face {face} of the domain is no convex polygon: vertex {t} is not on the inner side of the line through {p} and {q}"
            ),
            FacesNotClosed { ridge, faces } => write!(
                f,
                "the ridge of the domain with the vertices {ridge:?} is in {faces} faces, not in 2"
            ),
            VertexOutside {
                vertex,
                face,
                value,
            } => write!(
                f,
                "vertex {vertex} is outside of face {face} of the domain: the determinant is {value}"
            ),
            BoundaryFacet {
                simplex,
                facet,
                face,
                value,
            } => write!(
                f,
                "{} does not lie in face {face} of the domain: a corner has the determinant {value}, not 0",
                facet_of(*simplex, *facet)
            ),
            Orientation {
                simplex,
                determinant,
            } => {
                write!(
                    f,
                    "simplex {simplex} has the determinant {determinant}, not a positive one"
                )
            }
            MateNotMutual {
                simplex,
                facet,
                back,
            } => {
                let facet = facet_of(*simplex, *facet);
                write!(f, "the mate of {facet} has {back:?} for its mate")
            }
            MateCorners {
                simplex,
                facet,
                mate,
                missing,
            } => {
                let facet = facet_of(*simplex, *facet);
                write!(
                    f,
                    "{facet} and its mate {mate:?} have different corners, for one {missing:?}"
                )
            }
            MateSide {
                simplex,
                facet,
                mate,
            } => {
                let facet = facet_of(*simplex, *facet);
                write!(
                    f,
                    "{facet} and its mate {mate:?} have their simplices on the same side"
                )
            }
            VolumeSum { sum, expected } => {
                write!(
                    f,
                    "the volumes of the simplices sum to {sum} times the cell"
                )?;
                match expected.0 == ["1"] {
                    true => Ok(()),
                    false => write!(f, "; the domain has {expected}"),
                }
            }
            BoundaryMeets {
                first,
                second,
                shared,
            } => write!(
                f,
                "{} and {} in the boundary have {} in common and meet elsewhere",
                facet_of(first.0, first.1),
                facet_of(second.0, second.1),
                match shared {
                    0 => "no corner".to_owned(),
                    1 => "one corner".to_owned(),
                    _ => format!("{shared} corners"),
                }
            ),
            Covering {
                simplex,
                facet,
                outside,
            } => write!(
                f,
                "directly outside of {} in the boundary the covering number is {outside}, not 0",
                facet_of(*simplex, *facet)
            ),
            NotAcute {
                simplex,
                facets: (i, j),
                product,
            } => write!(
                f,
                "the angle of facets {i} and {j} of simplex {simplex} is not acute: \
                 their scaled normals have the product {product}, not a negative one"
            ),
            NotNonobtuse {
                simplex,
                facets: (i, j),
                product,
            } => write!(
                f,
                "the angle of facets {i} and {j} of simplex {simplex} is obtuse: \
                 their scaled normals have the positive product {product}"
            ),
            AngleNotBelow {
                simplex,
                facets: (i, j),
                degrees,
            } => {
                write!(
                    f,
                    "the angle of facets {i} and {j} of simplex {simplex} is not below {degrees} degrees"
                )
            }
            AngleNotAbove {
                simplex,
                facets: (i, j),
                degrees,
            } => {
                write!(
                    f,
                    "the angle of facets {i} and {j} of simplex {simplex} is not above {degrees} degrees"
                )
            }
            RatioNotBelow {
                simplex,
                corners: (i, j),
                ratio,
            } => write!(
                f,
                "the circumradius of simplex {simplex} is not below {ratio} times the edge from corner {i} to {j}"
            ),
            EdgeValence { ends, valence } => write!(
                f,
                "the edge between the vertices {} and {}, shifted by {:?}, is in {valence} tetrahedra",
                ends[0],
                ends[1],
                &ends[2..]
            ),
            TriangleValence { simplex, facet } => write!(
                f,
                "{} has two edges that are in 6 tetrahedra",
                facet_of(*simplex, *facet)
            ),
            AngleUndecided {
                simplex,
                facets: (i, j),
                degrees,
            } => write!(
                f,
                "the angle of facets {i} and {j} of simplex {simplex} is too near to {degrees} degrees to be decided"
            ),
            NotDelaunay {
                simplex,
                facet,
                power,
            } => write!(
                f,
                "the corner behind {} has the scaled power {power} and is not outside of the circumsphere",
                facet_of(*simplex, *facet)
            ),
            NotWeaklyDelaunay {
                simplex,
                facet,
                power,
            } => write!(
                f,
                "the corner behind {} has the scaled power {power} and is inside of the circumsphere",
                facet_of(*simplex, *facet)
            ),
        }
    }
}

fn corner_of(simplex: usize, corner: usize) -> impl fmt::Display {
    format!("corner {corner} of simplex {simplex}")
}

fn facet_of(simplex: usize, facet: usize) -> impl fmt::Display {
    format!("facet {facet} of simplex {simplex}")
}
