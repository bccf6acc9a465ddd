//! Families of tilings: Gram matrix, domain and vertices are polynomials in parameters, which range
//! over a box. The simplices do not depend on the parameters.
//!
//! | file | contains |
//! |---|---|
//! | this one | [`Family`], its members |
//! | [`cleared`] | the same with denominators cleared, over one ring of coefficients |
//! | [`conditions`] | signs of polynomials that have to hold on the box |
//! | `hypotheses`, `angles`, `ratios` | the conditions of the hypotheses and of each statement |
//! | `candidates` | the statements that imply a requirement |
//! | [`tree`] | bisection of the box until the signs are known |
//! | `zeros` | with one parameter, the exact zeros of signs that bisection leaves open |
//! | [`examine`](mod@examine) | proved with a tree, refuted with a point, or declined |
//! | `prove` | the certificate, and the kernel's word |
//! | [`maximal`] | the largest interval or box around a point |
//! | [`spans`] | enclosures of angles and ratios over the box |
//! | [`free`] | a tiling becomes a family in which some coordinates vary |
//!
//! A claim about a family is about every point of the box, word for word as for a single tiling.

pub mod angles;
mod candidates;
pub mod cleared;
pub mod conditions;
pub mod examine;
pub mod free;
pub mod hypotheses;
pub mod maximal;
mod prove;
pub mod ratios;
pub mod spans;
pub mod tree;
mod zeros;

pub use examine::{FamilyProof, NotProvable, examine};
pub use prove::{FamilyNotProved, ProvedFamily, confirm, prove};
pub use tree::Tree;

use crate::quality::rounded_down;
use crate::tiling::{Corner, Frame, SimplexId, Tiling};
use acutile_exact::geometry::RingElement;
use acutile_exact::number::Number;
use acutile_exact::number::limits::EXPONENT_LIMIT;
use acutile_exact::polynomial::{Cuboid, MOST_PARAMETERS, Polynomial, Side};
use malachite::Rational;
use std::fmt;

/// A parameter and its interval.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// `[a-z][a-z0-9_]*`, at most [`LONGEST_NAME`] characters.
    pub name: String,
    /// Its values.
    pub side: Side,
}

/// The most characters of a parameter's name.
pub const LONGEST_NAME: usize = 16;

/// A tiling for each point of a box.
#[derive(Clone, Debug)]
pub struct Family<const D: usize> {
    /// At least one.
    pub parameters: Vec<Parameter>,
    /// Basis, metric, lattice and domain.
    pub frame: Frame<D, Polynomial>,
    /// Coordinates in the basis.
    pub vertices: Vec<[Polynomial; D]>,
    /// D + 1 corners for each simplex.
    pub corners: Vec<Corner<D>>,
}

/// A family of the plane or of space.
#[derive(Clone, Debug)]
pub enum AnyFamily {
    /// D = 2
    Plane(Family<2>),
    /// D = 3
    Space(Family<3>),
}

/// Runs the same code for either dimension: `with_family!(any, family => code)`.
#[macro_export]
macro_rules! with_family {
    ($any:expr, $name:ident => $code:expr) => {
        match $any {
            $crate::family::AnyFamily::Plane($name) => $code,
            $crate::family::AnyFamily::Space($name) => $code,
        }
    };
}

/// Why parameters and polynomials are no family.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FamilyError {
    /// There is no parameter, or more than [`MOST_PARAMETERS`].
    Count(usize),
    /// Not a name of a parameter.
    Name(String),
    /// Two parameters have this name.
    SameName(String),
    /// A parameter is named like the generator of the field in all sentences.
    Generator,
    /// The lower end of this parameter's interval is above the upper end.
    Exchanged(String),
    /// The ends of this parameter's interval are equal.
    Empty(String),
    /// This parameter occurs nowhere.
    Unused(String),
    /// The degree of this parameter in some polynomial.
    Degree(String, usize),
    /// The union of the simplices has no polynomials.
    Region,
    /// The numbers of coordinates of a point and of parameters, which differ.
    Point(usize, usize),
    /// There is no vertex with this number.
    Vertex(usize),
}

impl fmt::Display for FamilyError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            FamilyError::Count(count) => {
                write!(f, "{count} parameters, expected 1 to {MOST_PARAMETERS}")
            }
            FamilyError::Name(name) => write!(
                f,
                "{name:?} cannot name a parameter; expected a lower-case letter, then at most {} \
                 lower-case letters, digits or underscores",
                LONGEST_NAME - 1
            ),
            FamilyError::SameName(name) => write!(f, "two parameters are named {name:?}"),
            FamilyError::Generator => write!(
                f,
                "a parameter is named \"a\", as the root of the field is in a certificate; choose another name"
            ),
            FamilyError::Exchanged(name) => write!(
                f,
                "box ends exchanged: the lower end of {name:?} is above the upper end; exchange them"
            ),
            FamilyError::Empty(name) => write!(
                f,
                "empty box: the ends of {name:?} are equal; replace the parameter by its value"
            ),
            FamilyError::Unused(name) => write!(
                f,
                "unused parameter: {name:?} occurs in no Gram entry and no coordinate; remove it"
            ),
            FamilyError::Degree(name, degree) => write!(
                f,
                "polynomial of too high degree: {degree} in {name:?}, expected at most {EXPONENT_LIMIT}"
            ),
            FamilyError::Point(found, expected) => {
                write!(f, "the point has {found} coordinates, expected {expected}")
            }
            FamilyError::Vertex(vertex) => {
                write!(f, "vertex {vertex} does not exist; vertices count from 0")
            }
            FamilyError::Region => write!(
                f,
                "a region with parameters; expected \"space\", a slab, a prism or a solid"
            ),
        }
    }
}

impl std::error::Error for FamilyError {}

impl<const D: usize> Family<D> {
    /// The box of the parameters.
    pub fn cuboid(&self) -> Cuboid {
        let sides = self
            .parameters
            .iter()
            .map(|parameter| parameter.side.clone());
        Cuboid {
            sides: sides.collect(),
        }
    }

    /// The same family over another box.
    pub fn with_box(&self, cuboid: &Cuboid) -> Self {
        let mut family = self.clone();
        for (parameter, side) in family.parameters.iter_mut().zip(&cuboid.sides) {
            parameter.side = side.clone();
        }
        family
    }

    /// The names of the parameters.
    pub fn names(&self) -> Vec<String> {
        let names = self
            .parameters
            .iter()
            .map(|parameter| parameter.name.clone());
        names.collect()
    }

    /// The number of simplices in a cell.
    pub fn len(&self) -> usize {
        self.corners.len() / (D + 1)
    }

    /// The indices of the simplices.
    pub fn simplices(&self) -> impl ExactSizeIterator<Item = SimplexId> + use<D> {
        (0..self.len() as u32).map(SimplexId::new)
    }

    /// Whether there is no simplex at all.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// All polynomials: the upper triangle of the Gram matrix, the domain, the vertices.
    pub fn polynomials(&self) -> impl Iterator<Item = &Polynomial> {
        let rows = self.frame.gram.iter().enumerate();
        let gram = rows.flat_map(|(i, row)| &row[i..]);
        let polytope = self.frame.domain.polytope().into_iter();
        let domain = polytope.flat_map(|p| p.vertices.iter().flatten());
        gram.chain(domain).chain(self.vertices.iter().flatten())
    }

    /// The member at a point. Its field is that of the point where the family is rational.
    pub fn at(&self, point: &[Number]) -> Tiling<D> {
        let value = |p: &Polynomial| p.value(point);
        let field = point.iter().find_map(Number::field);
        let gram = self.frame.gram.each_ref();
        let vertices = self
            .vertices
            .iter()
            .map(|vertex| vertex.each_ref().map(value));
        Tiling {
            frame: Frame {
                field: field.unwrap_or(&self.frame.field).clone(),
                gram: gram.map(|row| row.each_ref().map(value)),
                domain: self.frame.domain.map(value),
            },
            vertices: vertices.collect(),
            corners: self.corners.clone(),
        }
    }

    /// Checks everything that can be checked without geometry.
    ///
    /// # Errors
    /// The first rule that is broken.
    pub fn check(&self) -> Result<(), FamilyError> {
        let count = self.parameters.len();
        if !(1..=MOST_PARAMETERS).contains(&count) {
            return Err(FamilyError::Count(count));
        }
        if self.frame.domain.is_region() {
            return Err(FamilyError::Region);
        }
        for (k, Parameter { name, side }) in self.parameters.iter().enumerate() {
            if !is_name(name) {
                return Err(FamilyError::Name(name.clone()));
            }
            if name == "a" && !self.frame.field.is_rationals() {
                return Err(FamilyError::Generator);
            }
            if self.parameters[..k].iter().any(|other| other.name == *name) {
                return Err(FamilyError::SameName(name.clone()));
            }
            if side.low.value > side.high.value {
                return Err(FamilyError::Exchanged(name.clone()));
            }
            if side.low.value == side.high.value {
                return Err(FamilyError::Empty(name.clone()));
            }
            match self.polynomials().map(|p| p.degree(k)).max() {
                None | Some(0) => return Err(FamilyError::Unused(name.clone())),
                Some(degree) if degree > EXPONENT_LIMIT => {
                    return Err(FamilyError::Degree(name.clone(), degree));
                }
                Some(_) => {}
            }
        }
        Ok(())
    }
}

fn is_name(name: &str) -> bool {
    let mut characters = name.chars();
    let is_first = characters.next().is_some_and(|c| c.is_ascii_lowercase());
    let is_other = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    is_first && name.len() <= LONGEST_NAME && characters.all(is_other)
}

/// A box as `c2 in [8/3, 7/2), z in [1/16, 1/8]`.
pub fn box_in_words(names: &[String], cuboid: &Cuboid) -> String {
    let side = |(name, side): (&String, &Side)| format!("{name} in {side}");
    let sides: Vec<String> = names.iter().zip(&cuboid.sides).map(side).collect();
    sides.join(", ")
}

/// A point as `c2 = 3, z = 1/16`; a rational multiple of the generator of its field as `t = 1.414213562..., a root of
/// t^2 - 2`.
pub fn point_in_words(names: &[String], point: &[Number]) -> String {
    let value = |(k, (name, x)): (usize, (&String, &Number))| match minimal_polynomial(x, k) {
        Some(p) => format!("{name} = {}, a root of {}", decimals(x), p.shown(names)),
        None => format!("{name} = {x}"),
    };
    let values: Vec<String> = names.iter().zip(point).enumerate().map(value).collect();
    values.join(", ")
}

/// For an irrational c a, with the generator a of its field and c in Q: the polynomial p(x / c) of the parameter
/// x of this number, where p(a) = 0.
fn minimal_polynomial(x: &Number, parameter: usize) -> Option<Polynomial> {
    let field = x.field()?;
    let [zero, c, rest @ ..] = x.coefficients() else {
        return None;
    };
    if *c == 0 || *zero != 0 || rest.iter().any(|c| *c != 0) {
        return None;
    }
    let over = Number::from(Rational::from(1) / c);
    let x = Polynomial::parameter(parameter).map(|one: &Number| one * &over);
    let coefficients = field.polynomial().iter().rev();
    let sum = coefficients.fold(Polynomial::zero(), |sum, c| {
        let c = Number::from(Rational::from(c));
        sum.times(&x).plus(&Polynomial::constant(c))
    });
    Some(sum.reduced())
}

/// The first nine decimals, `1.414213562...`.
pub fn decimals(x: &Number) -> String {
    if x.sign().is_lt() {
        return format!("-{}", decimals(&-x));
    }
    let (below, _) = x.enclosure(&Rational::from_signeds(1, 1_000_000_000_000i64));
    format!("{}...", rounded_down(&below, 9))
}
