//! Statements and claims in words. Nothing here decides: the words follow from exact values.

use super::{Relation, Statement};
use crate::quality::{DihedralAngle, Exact, RadiusEdge, rounded_down};
use crate::tiling::{Domain, Frame};
use malachite::{Integer, Rational};
use std::fmt::Display;

/// A statement about a tiling of dimension `dimension` as a clause.
pub fn in_words(statement: &Statement, dimension: usize) -> String {
    let names = Names::of(dimension);
    match statement {
        Statement::FaceToFaceTiling => format!("a tiling, {}", names.how),
        Statement::Acute => format!("all {} are acute", names.angles),
        Statement::Nonobtuse => format!("no {} is obtuse", names.angle),
        Statement::LargestAngle(relation, angle) => {
            if is_upper(*relation) {
                format!("all {} are {}", names.angles, bound(*relation, angle))
            } else {
                format!(
                    "the largest {} of every {} is {}",
                    names.angle,
                    names.simplex,
                    bound(*relation, angle)
                )
            }
        }
        Statement::SmallestAngle(relation, angle) => {
            if is_upper(*relation) {
                format!(
                    "the smallest {} of every {} is {}",
                    names.angle,
                    names.simplex,
                    bound(*relation, angle)
                )
            } else {
                format!("all {} are {}", names.angles, bound(*relation, angle))
            }
        }
        Statement::RadiusEdge(relation, ratio) => format!(
            "every circumradius over the shortest edge of its {} is {}",
            names.simplex,
            bound(*relation, ratio)
        ),
        Statement::UncrossedPlane(plane) => format!(
            "no {} crosses {} {plane} or a translate of it by the lattice",
            names.simplex, names.plane
        ),
        Statement::Delaunay => "it is the Delaunay triangulation of its vertices".to_owned(),
        Statement::WeaklyDelaunay => "it is a Delaunay triangulation of its vertices".to_owned(),
        Statement::LocallyDelaunay => {
            format!("it is Delaunay at every {} that two share", names.facet)
        }
        Statement::LocallyWeaklyDelaunay => {
            format!(
                "it is weakly Delaunay at every {} that two share",
                names.facet
            )
        }
        Statement::NotDelaunay => format!(
            "it is no Delaunay triangulation of its vertices: one of them is inside of the {} of a {}",
            names.sphere, names.simplex
        ),
        Statement::Tcp => "it is tetrahedrally close packed: every edge is in 5 or 6 tetrahedra, \
                           and no triangle has two edges that are in 6"
            .to_owned(),
    }
}

/// A proved claim in one line: `boundary` is the number of facets in the boundary.
pub fn summary<S: Display, const D: usize>(
    frame: &Frame<D, S>,
    simplices: usize,
    boundary: usize,
    statements: &[Statement],
) -> String {
    let names = Names::of(D);
    let mut words = format!(
        "{} is tiled {} by {}",
        domain(frame),
        names.how,
        counted(simplices, names.simplex, names.simplices)
    );
    if frame.domain.is_region() {
        words += &format!(
            ", whose union it is, and its boundary by {}, which meet in common {} only",
            counted(boundary, names.facet, names.facets),
            names.corners
        );
    }
    words += &lattice(frame);
    words += &field(frame);
    for statement in statements {
        if *statement != Statement::FaceToFaceTiling {
            words += "; ";
            words += &in_words(statement, D);
        }
    }
    words
}

/// The words for things of a dimension.
struct Names {
    how: &'static str,
    simplex: &'static str,
    simplices: &'static str,
    plane: &'static str,
    facet: &'static str,
    facets: &'static str,
    angle: &'static str,
    angles: &'static str,
    corners: &'static str,
    sphere: &'static str,
}

impl Names {
    fn of(dimension: usize) -> Names {
        match dimension {
            2 => Names {
                how: "edge to edge",
                simplex: "triangle",
                simplices: "triangles",
                plane: "the line",
                facet: "edge",
                facets: "edges",
                angle: "angle",
                angles: "angles",
                corners: "vertices",
                sphere: "circumcircle",
            },
            _ => Names {
                how: "face to face",
                simplex: "tetrahedron",
                simplices: "tetrahedra",
                plane: "the plane",
                facet: "triangle",
                facets: "triangles",
                angle: "dihedral angle",
                angles: "dihedral angles",
                corners: "vertices and edges",
                sphere: "circumsphere",
            },
        }
    }
}

/// `1 vertex`, `2 vertices`
pub fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

fn is_upper(relation: Relation) -> bool {
    matches!(
        relation,
        Relation::LessThan | Relation::AtMost | Relation::Maximum
    )
}

/// `at most arccos(1/5) = 78.4630... degrees, attained`
fn bound(relation: Relation, value: &impl Bound) -> String {
    let value = value.text();
    match relation {
        Relation::LessThan => format!("less than {value}"),
        Relation::AtMost => format!("at most {value}"),
        Relation::Maximum => format!("at most {value}, attained"),
        Relation::MoreThan => format!("more than {value}"),
        Relation::AtLeast => format!("at least {value}"),
        Relation::Minimum => format!("at least {value}, attained"),
    }
}

/// The value of a bound in words.
trait Bound {
    fn text(&self) -> String;
}

impl Bound for DihedralAngle {
    fn text(&self) -> String {
        if let Some(degrees) = self.rational() {
            return format!("{} degrees", exact_decimal(&degrees));
        }
        let decimals = decimals(self);
        match self.closed_form().filter(|text| is_short(text)) {
            Some(closed) => format!("{closed} = {decimals} degrees"),
            None => format!("{decimals} degrees"),
        }
    }
}

impl Bound for RadiusEdge {
    fn text(&self) -> String {
        let closed = self.closed_form().filter(|text| is_short(text));
        if let (Some(_), Some(value)) = (self.rational(), &closed) {
            return value.clone();
        }
        let decimals = decimals(self);
        match closed {
            Some(closed) => format!("{closed} = {decimals}"),
            None => decimals,
        }
    }
}

/// Longer closed forms are left out; the claim has them.
const LONGEST: usize = 60;

fn is_short(text: &str) -> bool {
    text.chars().count() <= LONGEST
}

/// Digits that are printed after the point.
const DIGITS: u64 = 4;

/// The first digits of a value that is no short decimal: `78.4630...`
fn decimals(value: &impl Exact) -> String {
    let mut width = Rational::from_signeds(1, 10_000_000);
    for _ in 0..ROUNDS {
        let (low, high) = value.enclosure(&width);
        let (low, high) = (rounded_down(&low, DIGITS), rounded_down(&high, DIGITS));
        if low == high {
            return format!("{low}...");
        }
        width *= Rational::from_signeds(1, 1_000_000);
    }
    let (low, _) = value.enclosure(&width);
    format!("about {}", rounded_down(&low, DIGITS))
}

/// Only a value with that many digits 0 after the point is not decided then.
const ROUNDS: usize = 8;

/// A rational as a decimal where that is exact and short.
fn exact_decimal(value: &Rational) -> String {
    let ten = Rational::from(10);
    let mut scaled = value.clone();
    for digits in 0..=18 {
        if Integer::try_from(scaled.clone()).is_ok() {
            return rounded_down(value, digits);
        }
        scaled *= &ten;
    }
    value.to_string()
}

/// The set that is tiled; x_1, …, x_D are coordinates in the basis.
fn domain<S: Display, const D: usize>(frame: &Frame<D, S>) -> String {
    let (name, polytope) = match (&frame.domain, D) {
        (Domain::Space, 2) => return "the plane".to_owned(),
        (Domain::Space, _) => return "three-space".to_owned(),
        (Domain::Region(0), 2) => return "a bounded region of the plane".to_owned(),
        (Domain::Region(0), _) => return "a bounded region of three-space".to_owned(),
        (Domain::Region(_), 2) => return "a periodic region of the plane".to_owned(),
        (Domain::Region(_), _) => return "a periodic region of three-space".to_owned(),
        (Domain::Slab(polytope), 2) => ("strip", polytope),
        (Domain::Slab(polytope), _) => ("slab", polytope),
        (Domain::Prism(polytope), _) => ("prism", polytope),
        (Domain::Solid(polytope), 2) => ("polygon", polytope),
        (Domain::Solid(polytope), _) => ("polyhedron", polytope),
    };
    let first = frame.rank() + 1;
    format!(
        "the {name} of the points whose coordinates [{}] lie in the convex hull of {}",
        join((first..=D).map(|i| format!("x_{i}"))),
        join(polytope.vertices.iter().map(|vertex| row(vertex)))
    )
}

fn lattice<S: Display, const D: usize>(frame: &Frame<D, S>) -> String {
    let how = match (&frame.domain, frame.rank()) {
        (_, 0) => ", in the basis with",
        (_, rank) if rank == D => " and their translates under the lattice whose basis has",
        (_, 1) => {
            " and their translates by the integer multiples of the first vector of the basis with"
        }
        _ => " and their translates under the lattice of the first two vectors of the basis with",
    };
    let rows = frame.gram.iter().map(|entries| row(entries));
    format!("{how} the Gram matrix [{}]", join(rows))
}

fn field<S, const D: usize>(frame: &Frame<D, S>) -> String {
    if frame.field.is_rationals() {
        return String::new();
    }
    let (low, high) = frame.field.root();
    let a = frame.field.symbol();
    format!(
        ", where {a} is the root of {} between {low} and {high}",
        polynomial(frame.field.polynomial(), a)
    )
}

/// Coefficients from the constant term up, written as a sum in the generator a.
fn polynomial(coefficients: &[Integer], a: &str) -> String {
    let mut text = String::new();
    for (power, c) in coefficients.iter().enumerate().filter(|(_, c)| **c != 0) {
        let sign = match (*c < 0, text.is_empty()) {
            (true, true) => "-",
            (true, false) => " - ",
            (false, true) => "",
            (false, false) => " + ",
        };
        text += sign;
        let size = c.unsigned_abs_ref();
        text += &match (power, *size == 1u32) {
            (0, _) => size.to_string(),
            (1, true) => a.to_owned(),
            (1, false) => format!("{size} {a}"),
            (_, true) => format!("{a}^{power}"),
            (_, false) => format!("{size} {a}^{power}"),
        };
    }
    text
}

fn row(numbers: &[impl Display]) -> String {
    format!("[{}]", join(numbers.iter()))
}

fn join(items: impl Iterator<Item = impl Display>) -> String {
    items
        .map(|item| item.to_string())
        .collect::<Vec<_>>()
        .join(", ")
}
