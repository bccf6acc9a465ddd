//! The statements that a user can require of a tiling.

use super::plane::{self, Plane};
use acutile_exact::number::parse_rational;
use malachite::Rational;
use std::fmt;
use std::str::FromStr;

/// A statement that must hold, in the words of the command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Requirement {
    /// `tiling`: every proved tiling has this property.
    Tiling,
    /// `acute`
    Acute,
    /// `nonobtuse`
    Nonobtuse,
    /// `dihedral<DEGREES` or `dihedral-below=DEGREES`
    DihedralBelow(Rational),
    /// `dihedral>DEGREES` or `dihedral-above=DEGREES`
    DihedralAbove(Rational),
    /// `radius-edge<RATIO` or `radius-edge-below=RATIO`
    RadiusEdgeBelow(Rational),
    /// `delaunay`; of a region, locally.
    Delaunay,
    /// `weakly-delaunay`; of a region, locally.
    WeaklyDelaunay,
    /// `not-delaunay`: some vertex is inside of a circumsphere.
    NotDelaunay,
    /// `plane:EQUATION`, like `plane:x2+x3=1/2`: no simplex crosses it.
    UncrossedPlane(Plane),
    /// `tcp`
    Tcp,
    /// `connected`: one piece. The prover decides it; no certificate states it.
    Connected,
    /// `no-cavities`, as [`Requirement::Connected`].
    NoCavities,
    /// `manifold-boundary`, as [`Requirement::Connected`].
    ManifoldBoundary,
}

/// The words that are known. Shells treat `<` and `>` as redirections, so each bound has a form
/// without them.
const EXPECTED: &str = "expected acute, nonobtuse, delaunay, weakly-delaunay, not-delaunay, tcp, tiling, \
                        dihedral-below=DEGREES, dihedral-above=DEGREES, radius-edge-below=RATIO, \
                        plane:EQUATION like plane:x2+x3=1/2, \
                        connected, no-cavities or manifold-boundary";

/// The ways to begin a bound, and the meaning of its number.
const BOUNDS: [(&str, Bound); 6] = [
    ("dihedral<", Bound::DihedralBelow),
    ("dihedral-below=", Bound::DihedralBelow),
    ("dihedral>", Bound::DihedralAbove),
    ("dihedral-above=", Bound::DihedralAbove),
    ("radius-edge<", Bound::RadiusEdgeBelow),
    ("radius-edge-below=", Bound::RadiusEdgeBelow),
];

#[derive(Clone, Copy)]
enum Bound {
    DihedralBelow,
    DihedralAbove,
    RadiusEdgeBelow,
}

impl Bound {
    fn requirement(self, text: &str) -> Result<Requirement, String> {
        match self {
            Bound::DihedralBelow => bound(text, Some(180)).map(Requirement::DihedralBelow),
            Bound::DihedralAbove => bound(text, Some(180)).map(Requirement::DihedralAbove),
            Bound::RadiusEdgeBelow => bound(text, None).map(Requirement::RadiusEdgeBelow),
        }
    }
}

impl FromStr for Requirement {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // Upper and lower case are the same in words. The letters of an equation are not words.
        let lower = text.to_ascii_lowercase();
        match lower.as_str() {
            "tiling" => return Ok(Requirement::Tiling),
            "acute" => return Ok(Requirement::Acute),
            "nonobtuse" => return Ok(Requirement::Nonobtuse),
            "delaunay" => return Ok(Requirement::Delaunay),
            "weakly-delaunay" => return Ok(Requirement::WeaklyDelaunay),
            "not-delaunay" => return Ok(Requirement::NotDelaunay),
            "tcp" => return Ok(Requirement::Tcp),
            "connected" => return Ok(Requirement::Connected),
            "no-cavities" => return Ok(Requirement::NoCavities),
            "manifold-boundary" => return Ok(Requirement::ManifoldBoundary),
            _ => {}
        }
        if lower.starts_with("plane:") {
            return plane::parse(&text["plane:".len()..]).map(Requirement::UncrossedPlane);
        }
        let bound = BOUNDS.iter().find_map(|(prefix, bound)| {
            let number = lower.strip_prefix(prefix)?;
            Some(bound.requirement(number))
        });
        bound.unwrap_or_else(|| Err(EXPECTED.to_owned()))
    }
}

/// Two requirements that no tiling fulfils together.
pub fn contradiction(required: &[Requirement]) -> Option<(&Requirement, &Requirement)> {
    let pairs = required
        .iter()
        .flat_map(|x| required.iter().map(move |y| (x, y)));
    pairs.into_iter().find(|(x, y)| excludes(x, y))
}

/// Whether x excludes y. A lower bound for angles excludes an upper bound that is not above it.
fn excludes(x: &Requirement, y: &Requirement) -> bool {
    use Requirement::{Acute, Delaunay, DihedralAbove, DihedralBelow, Nonobtuse};
    use Requirement::{NotDelaunay, WeaklyDelaunay};
    match (x, y) {
        (Delaunay | WeaklyDelaunay, NotDelaunay) => true,
        (Acute | Nonobtuse, DihedralAbove(low)) => *low >= 90,
        (DihedralBelow(high), DihedralAbove(low)) => low >= high,
        _ => false,
    }
}

/// A positive number, at most `largest`.
fn bound(text: &str, largest: Option<u8>) -> Result<Rational, String> {
    let bound = parse_rational(text).map_err(|error| {
        if error.is_limit() {
            error.to_string()
        } else {
            format!("found {text:?}, expected a number like 90, 78.5 or 157/2")
        }
    })?;
    if bound <= 0 {
        return Err(format!("found {text}, expected more than 0"));
    }
    match largest {
        Some(largest) if bound > largest => {
            Err(format!("found {text}, expected at most {largest}"))
        }
        _ => Ok(bound),
    }
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Requirement::Tiling => write!(f, "tiling"),
            Requirement::Acute => write!(f, "acute"),
            Requirement::Nonobtuse => write!(f, "nonobtuse"),
            Requirement::DihedralBelow(bound) => write!(f, "dihedral<{bound}"),
            Requirement::DihedralAbove(bound) => write!(f, "dihedral>{bound}"),
            Requirement::RadiusEdgeBelow(bound) => write!(f, "radius-edge<{bound}"),
            Requirement::Delaunay => write!(f, "delaunay"),
            Requirement::WeaklyDelaunay => write!(f, "weakly-delaunay"),
            Requirement::NotDelaunay => write!(f, "not-delaunay"),
            Requirement::UncrossedPlane(plane) => write!(f, "plane:{plane}"),
            Requirement::Tcp => write!(f, "tcp"),
            Requirement::Connected => write!(f, "connected"),
            Requirement::NoCavities => write!(f, "no-cavities"),
            Requirement::ManifoldBoundary => write!(f, "manifold-boundary"),
        }
    }
}
