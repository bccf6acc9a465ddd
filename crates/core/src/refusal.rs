//! The kernel's refusals in words. The kernel gives a code, a place and an exact value; nothing
//! here decides. All numbers count from zero.

use crate::format::json::place_of_item;
use acutile_kernel::{Code, Limits, Place, Refusal, Value};
use malachite::Integer;
use std::fmt;
use std::str::FromStr;

/// The kernel's refusal of a file. The kernel reads CBOR and names its bytes. If the file is JSON, a
/// byte becomes a line and a column.
#[derive(Debug)]
pub struct Refused {
    /// The kernel's verdict.
    pub refusal: Box<Refusal>,
    place: Option<String>,
    /// The bytes of a file that ends early.
    cut: Option<u64>,
}

impl From<Refusal> for Refused {
    fn from(refusal: Refusal) -> Self {
        let refusal = Box::new(refusal);
        Refused {
            refusal,
            place: None,
            cut: None,
        }
    }
}

impl Refused {
    /// The refusal of `cbor`, which is the certificate of the file with these bytes.
    pub fn of_file(file: &[u8], cbor: &[u8], refusal: Refusal) -> Refused {
        let length = cbor.len() as u64;
        let (place, cut) = match refusal.place {
            Place::Byte(byte) if file != cbor => (place_of_item(file, cbor, byte), None),
            // The kernel names the byte that is missing.
            Place::Byte(byte) if refusal.code == Code::Cbor && byte > length => {
                (None, Some(length))
            }
            _ => (None, None),
        };
        let refusal = Box::new(refusal);
        Refused {
            refusal,
            place,
            cut,
        }
    }

    /// The place, the rule, and the value, without the code.
    pub fn message(&self) -> String {
        match (&self.place, self.cut) {
            (_, Some(length)) => {
                format!("the file ends after {length} bytes, expected the rest of a certificate")
            }
            (Some(place), None) => message_at(&self.refusal, place.clone()),
            (None, None) => message(&self.refusal),
        }
    }
}

/// Verdict, code and message, such as `malformed [dimension] line 6, column 13 ("dimension":4): …`.
impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let code = self.refusal.code;
        let (kind, name) = (code.kind().text(), code.text());
        write!(f, "{kind} [{name}] {}", self.message())
    }
}

/// `rejected [orientation] simplex 3: expected a positive determinant, found 0`
pub fn in_words(refusal: &Refusal) -> String {
    format!(
        "{} [{}] {}",
        refusal.code.kind().text(),
        refusal.code.text(),
        message(refusal)
    )
}

/// The place, the rule, and the value, without the code.
pub fn message(refusal: &Refusal) -> String {
    message_at(refusal, place(refusal.place))
}

/// The same with other words for the place.
fn message_at(refusal: &Refusal, place: String) -> String {
    let place = match point(&refusal.point) {
        Some(point) => format!("{place} at {point}"),
        None => place,
    };
    let rule = rule(refusal.code);
    match &refusal.value {
        Value::Nothing => format!("{place}: {rule}"),
        Value::Integer(value) => format!("{place}: {rule}, found {value}"),
        Value::Quotient(p, q) => format!(
            "{place}: {rule}, found {}",
            quotient(&integers(p), &integers(q))
        ),
        Value::Limit(limit, enough) => format!("{place}: {}", exceeded(limit, *enough)),
    }
}

/// `c2 = 8/3, x = 0`: the point of a family's box at which a condition does not hold.
fn point(point: &[(String, Value)]) -> Option<String> {
    let coordinates = point.iter().map(|(name, value)| match value {
        Value::Quotient(p, q) => format!("{name} = {}", quotient(&integers(p), &integers(q))),
        _ => name.clone(),
    });
    let coordinates: Vec<String> = coordinates.collect();
    (!coordinates.is_empty()).then(|| coordinates.join(", "))
}

/// The digits of the kernel's integers are those of ours.
fn integers(row: &[impl ToString]) -> Vec<Integer> {
    row.iter()
        .map(|n| Integer::from_str(&n.to_string()).unwrap_or_default())
        .collect()
}

fn place(place: Place) -> String {
    match place {
        Place::Byte(offset) => format!("byte {offset}"),
        Place::Field => "the field".to_owned(),
        Place::Minor(rows) => format!("the leading {rows} x {rows} minor of the Gram matrix"),
        Place::Domain => "the domain".to_owned(),
        Place::Face(face) => format!("face {face} of the domain"),
        Place::Statement(statement) => format!("statement {statement}"),
        Place::Vertex(vertex) => format!("vertex {vertex}"),
        Place::Parameter(parameter) => format!("parameter {parameter}"),
        Place::Boundary(facet) => format!("boundary facet {facet}"),
        Place::BoundaryPair(first, second) => format!("boundary facets {first} and {second}"),
        Place::Simplex(simplex) => format!("simplex {simplex}"),
        Place::Facet(simplex, facet) => format!("simplex {simplex}, facet {facet}"),
        Place::Edge(simplex, i, j) => format!("simplex {simplex}, edge {i} {j}"),
        Place::Angle(simplex, i, j) => {
            format!("simplex {simplex}, the angle between its facets {i} and {j}")
        }
        Place::Tile(tile) => format!("tile {tile}"),
        Place::Side(tile, side) => format!("tile {tile}, side {side}"),
        Place::Witness => "the witness".to_owned(),
    }
}

/// The condition that each code stands for.
fn rule(code: Code) -> &'static str {
    match code {
        Code::Cbor => "expected an item that the format allows here (docs/format.md)",
        Code::Canonical => "expected the canonical encoding, in lowest terms",
        Code::Format => "expected the format \"acutile-certificate\"",
        Code::Dimension => "expected the dimension 2 or 3",
        Code::Polynomial => "expected a monic polynomial of degree at least 2",
        Code::RootOrder => "expected low < high over a positive denominator",
        Code::RootDerivative => "expected a derivative without zero in the interval",
        Code::PrismDimension => "expected dimension 3 for a prism",
        Code::RegionRank => "expected a rank from 0 to the dimension",
        Code::Denominator => "expected a positive denominator",
        Code::FaceCount => "expected as many faces as a polytope needs",
        Code::FaceLength => "expected as many vertices as a face has",
        Code::FaceVertices => "expected different vertices of the polytope",
        Code::FaceRepeated => "expected different faces",
        Code::UnusedDomainVertex => "expected every vertex of the polytope in a face",
        Code::Statements => "expected known statements in their order, the tiling first",
        Code::BoundRange => "expected a bound in its range",
        Code::StatementDomain => "expected a statement that this domain allows",
        Code::BoundaryDomain => "expected boundary facets of a region, and of nothing else",
        Code::NoSimplices => "expected at least one simplex",
        Code::VertexRange => "expected the number of a vertex",
        Code::ShiftRange => "expected a shift of less than 2^29 steps",
        Code::CornerOrder => "expected sorted corners, the first without shift",
        Code::Sixes => "expected six bits",
        Code::BoundaryRepeated => "expected every boundary facet once",
        Code::UnusedVertex => "expected every vertex in a simplex",
        Code::RootSigns => "expected opposite signs of the polynomial at the ends",
        Code::GramNotPositive => "expected a positive number",
        Code::FaceNotFacet => "expected the other vertices of the polytope on its inner side",
        Code::FaceNotConvex => "expected its corners in the cyclic order of a convex polygon",
        Code::FacesNotClosed => "expected every ridge of the polytope in two faces",
        Code::DenominatorDomain => "expected that the polytope's denominator divides the witness's",
        Code::VertexOutside => "expected a vertex in the domain",
        Code::BoundaryMeets => "expected boundary facets that meet in common faces only",
        Code::FacetSide => "expected simplices on different sides of the facet",
        Code::TriangleValence => "expected no triangle with two edges of valence 6",
        Code::EdgeValence => "expected the valence 5 or 6, as the hint says",
        Code::PlaneCrossed => {
            "expected a simplex in one closed side of every translate of each plane"
        }
        Code::Orientation => "expected a positive determinant",
        Code::Covering => "expected no simplex directly outside of a boundary facet",
        Code::NotAcute => "expected an acute angle",
        Code::NotNonobtuse => "expected no obtuse angle",
        Code::AngleBound => "expected angles within the bound",
        Code::RatioBound => "expected a squared radius-edge ratio within the bound",
        Code::NotDelaunay => "expected the neighbour's corner outside of the circumsphere",
        Code::NotWeaklyDelaunay => "expected the neighbour's corner not inside of the circumsphere",
        Code::OpenFacet => "expected a mate of every facet",
        Code::BoundaryOpen => "expected a simplex at every boundary facet",
        Code::VolumeSum => "expected volumes that sum to that of the domain",
        Code::NoneInside => "expected a vertex inside of a circumsphere",
        Code::NotAttained => "expected a simplex that attains the bound",
        Code::Unreadable => "the bytes cannot be read",
        Code::TooManyBytes => "the certificate is too long",
        Code::Version => "expected version 2",
        Code::UnknownKind => "expected the kind \"tiling\", \"family\" or \"patches\"",
        Code::FamilyDomain => "expected another domain than a region for a family",
        Code::Parameters => "expected 1 to 64 parameters",
        Code::ParameterName => {
            "expected different names of at most 16 characters: a small letter, then small letters, digits and _"
        }
        Code::BoxExchanged => "box ends exchanged: expected low < high",
        Code::BoxEmpty => "empty box: expected low < high",
        Code::UnusedParameter => "unused parameter: expected every parameter in some polynomial",
        Code::Exponent => "polynomial of too high degree: expected exponents from 0 to 15",
        Code::Terms => "expected terms that are not zero, in the order of their exponents",
        Code::Tree => "expected the number of a parameter as the axis",
        Code::TreeSize => "expected at most 4,096 leaves and 64 halvings of one leaf",
        Code::Rank => "expected the rank 1 or 2",
        Code::TileCount => "expected tiles, and a patch for each",
        Code::SideCount => "expected three corners or more of a polygon, two of a segment",
        Code::PyramidForm => {
            "expected an apex and a polygon of three different corners or more, the first without shift"
        }
        Code::GramBlocks => "expected a base orthogonal to the lattice",
        Code::TileOrder => "expected corners in counterclockwise or increasing order",
        Code::PyramidSide => "expected a polygon in one side and an apex in none, pyramid",
        Code::WallPattern => "expected the wall pattern of the first side of its class",
        Code::WallReversal => "expected a wall pattern that looks the same from the other tile",
        Code::SideClasses => {
            "expected classes and offsets that are consistent around every vertex of the tiles"
        }
        Code::MissingJoin => {
            "expected a join: the axis between two apexes must cross their polygon, a determinant"
        }
        Code::CornerAngle => "expected angles that are multiples of a turn over 60 or less",
        Code::Degree => "the degree of the field is beyond the limit",
        Code::TooManyDigits => "an integer is beyond the limit",
        Code::TooManySimplices => "there are more simplices than the limit",
        Code::SignUndecided => {
            "a sign is not decided, by the enclosures of the root or on the whole box of a leaf"
        }
        Code::Work => "the work is beyond the limit",
    }
}

/// The option that raises a limit, and a value that suffices, where it is known. The option has
/// the name of the limit.
pub fn exceeded(limit: &str, enough: Option<u64>) -> String {
    let unit = match limit {
        "bits" => "bits of an integer",
        "degree" => "the degree of the field",
        "work" => "units of work",
        other => other,
    };
    match enough {
        // How much work is left is not known before it is done.
        _ if limit == "work" => format!(
            "beyond the limit of {unit}; use a larger --max-work: without the option it is {}",
            Limits::DEFAULT.work
        ),
        Some(enough) => format!("beyond the limit of {unit}; --max-{limit} {enough} is enough"),
        None => format!("beyond the limit of {unit}; --max-{limit} raises it"),
    }
}

/// p/q for numbers of the field in terms of a.
fn quotient(p: &[Integer], q: &[Integer]) -> String {
    let is_rational = |row: &[Integer]| row.iter().skip(1).all(|c| *c == 0);
    let is_one = is_rational(q) && q.first().is_some_and(|c| *c == 1);
    if is_one {
        sum(p)
    } else if is_rational(p) && is_rational(q) {
        format!("{}/{}", sum(p), sum(q))
    } else {
        format!("({})/({})", sum(p), sum(q))
    }
}

fn sum(coefficients: &[Integer]) -> String {
    let terms = coefficients.iter().enumerate().filter(|(_, c)| **c != 0);
    let terms: Vec<String> = terms
        .map(|(power, c)| match power {
            0 => c.to_string(),
            1 => format!("{c} a"),
            _ => format!("{c} a^{power}"),
        })
        .collect();
    if terms.is_empty() {
        "0".to_owned()
    } else {
        terms.join(" + ")
    }
}
