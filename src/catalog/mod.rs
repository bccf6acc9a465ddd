//! The catalogue: the constructions of the paper by name, each a recipe.
//!
//! | file | constructions |
//! |---|---|
//! | `square_triangle` | TCP structures from tilings by squares and triangles |
//! | `kagome` | Laves phases, Z and mixtures as stacked layers |
//! | `selected` | lattices with selected circumcentres: A15 and C15 |
//! | `congruent` | Sommerville, Goldberg, cubes |
//! | `recipe` | what they share |
//!
//! Names are a contract. Nothing here is proved; the checker does that.

mod congruent;
mod kagome;
mod recipe;
mod selected;
pub mod square_triangle;

pub use kagome::WORD_LIMIT;

use crate::delaunay::{DelaunayError, Ties, triangulate};
use crate::geometry::Sign;
use crate::number::{FieldError, Number};
use crate::tiling::{AnyTiling, Tiling};
use std::fmt;

/// A construction.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name, or for a family of words the prefix with a colon, `kagome:`.
    pub name: &'static str,
    /// One line.
    pub description: &'static str,
    /// Where it is described.
    pub source: &'static str,
    /// `space` or `plane`: what is tiled.
    pub domain: &'static str,
    /// The number that it depends on, if it does.
    pub parameter: Option<Parameter>,
    recipe: Recipe,
}

/// A positive number on which a construction depends.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// A short name, `a/e`.
    pub name: &'static str,
    /// Numerator and denominator of the value where none is given.
    pub default: (i64, i64),
}

#[derive(Clone, Copy, Debug)]
enum Recipe {
    Fixed(fn() -> Result<AnyTiling, CatalogError>),
    Ratio(fn(&Number) -> Tiling<3>),
    Word(fn(&str) -> Result<Tiling<3>, CatalogError>),
}

/// Why a construction fails.
#[derive(Clone, Debug)]
pub enum CatalogError {
    /// There is no construction with this name.
    UnknownName(String),
    /// The construction takes no parameter, or one that must be positive.
    Parameter(String),
    /// Not a word of `z`, `+`, `-` with 1 to [`WORD_LIMIT`] letters.
    Word(String),
    /// Two neighbouring edges at this vertex enclose an angle, in degrees, that is neither of a
    /// triangle nor of a square: not an edge-to-edge tiling by squares and triangles.
    NotSquareTriangle {
        /// Index of the vertex.
        vertex: usize,
        /// The angle between neighbouring edges.
        angle: usize,
    },
    /// The tetrahedra cannot be coloured black and white.
    NotTwoColourable,
    /// The lattice vectors are dependent.
    Degenerate,
    /// The field could not be made.
    Field(FieldError),
    /// The points have no Delaunay triangulation.
    Delaunay(DelaunayError),
}

impl From<DelaunayError> for CatalogError {
    fn from(error: DelaunayError) -> Self {
        CatalogError::Delaunay(error)
    }
}

impl From<FieldError> for CatalogError {
    fn from(error: FieldError) -> Self {
        CatalogError::Field(error)
    }
}

impl fmt::Display for CatalogError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::UnknownName(name) => write!(f, "there is no construction `{name}`"),
            Self::Parameter(name) => {
                write!(f, "`{name}` takes no parameter, or one that is positive")
            }
            Self::Word(word) => write!(
                f,
                "`{word}` is not a word of 1 to {WORD_LIMIT} letters `z`, `+`, `-`"
            ),
            Self::NotSquareTriangle { vertex, angle } => write!(
                f,
                "edges at vertex {vertex} are {angle} degrees apart: not an edge-to-edge tiling by squares and triangles, so it cannot be coloured"
            ),
            Self::NotTwoColourable => {
                write!(f, "the tetrahedra cannot be coloured black and white")
            }
            Self::Degenerate => write!(f, "the lattice vectors are dependent"),
            Self::Field(error) => error.fmt(f),
            Self::Delaunay(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for CatalogError {}

impl Entry {
    const fn space(
        name: &'static str,
        source: &'static str,
        description: &'static str,
        recipe: fn() -> Result<AnyTiling, CatalogError>,
    ) -> Entry {
        Entry {
            name,
            description,
            source,
            domain: "space",
            parameter: None,
            recipe: Recipe::Fixed(recipe),
        }
    }

    const fn ratio(
        name: &'static str,
        description: &'static str,
        recipe: fn(&Number) -> Tiling<3>,
    ) -> Entry {
        Entry {
            name,
            description,
            source: "section 2.2",
            domain: "space",
            parameter: Some(Parameter {
                name: "a/e",
                default: (1, 2),
            }),
            recipe: Recipe::Ratio(recipe),
        }
    }

    /// The construction with its default parameter; an error for a family of words, which
    /// [`build`] makes by name.
    pub fn build(&self) -> Result<AnyTiling, CatalogError> {
        match (self.recipe, self.parameter) {
            (Recipe::Fixed(recipe), _) => recipe(),
            (
                Recipe::Ratio(recipe),
                Some(Parameter {
                    default: (n, d), ..
                }),
            ) => Ok(AnyTiling::Space(recipe(&recipe::fraction(n, d)))),
            (Recipe::Ratio(_), None) => Err(CatalogError::Parameter(self.name.to_owned())),
            (Recipe::Word(recipe), _) => recipe("").map(AnyTiling::Space),
        }
    }

    /// The construction for a parameter.
    pub fn build_with(&self, parameter: &Number) -> Result<AnyTiling, CatalogError> {
        match self.recipe {
            Recipe::Ratio(recipe) if parameter.sign() == Sign::Greater => {
                Ok(AnyTiling::Space(recipe(parameter)))
            }
            _ => Err(CatalogError::Parameter(self.name.to_owned())),
        }
    }

    /// Whether the name is a prefix that a word completes.
    pub fn is_family(&self) -> bool {
        matches!(self.recipe, Recipe::Word(_))
    }
}

/// All constructions.
pub fn entries() -> &'static [Entry] {
    &ENTRIES
}

/// The names of all constructions that need no further word.
pub fn names() -> impl Iterator<Item = &'static str> {
    ENTRIES
        .iter()
        .filter(|entry| !entry.is_family())
        .map(|entry| entry.name)
}

/// The construction with this name, for `kagome:WORD` the family.
pub fn find(name: &str) -> Option<&'static Entry> {
    ENTRIES.iter().find(|entry| match entry.recipe {
        Recipe::Word(_) => name.starts_with(entry.name),
        _ => name == entry.name,
    })
}

/// The construction with this name, `kagome:z+` included, with default parameters.
pub fn build(name: &str) -> Result<AnyTiling, CatalogError> {
    let entry = find(name).ok_or_else(|| CatalogError::UnknownName(name.to_owned()))?;
    match entry.recipe {
        Recipe::Word(recipe) => recipe(&name[entry.name.len()..]).map(AnyTiling::Space),
        _ => entry.build(),
    }
}

const STRUCTURE: &str = "section 4.1";
const TILINGS: &str = "section 2.2";

static ENTRIES: [Entry; 24] = [
    Entry::space(
        "z",
        STRUCTURE,
        "TCP structure Z over the triangle tiling",
        || space(square_triangle::triangles().structure()),
    ),
    Entry::space(
        "a15",
        STRUCTURE,
        "TCP structure A15 over the square tiling",
        || space(square_triangle::squares().structure()),
    ),
    Entry::space(
        "sigma",
        STRUCTURE,
        "TCP structure sigma over the tiling 3^2.4.3.4",
        || space(square_triangle::snub().structure()),
    ),
    Entry::space(
        "h",
        STRUCTURE,
        "TCP structure H over the tiling 3^3.4^2",
        || space(square_triangle::rows().structure()),
    ),
    Entry::space(
        "square-triangle-3464",
        STRUCTURE,
        "TCP structure over 3.4.6.4 with its hexagons cut into triangles",
        || space(square_triangle::rhombitrihexagonal().structure()),
    ),
    Entry::space(
        "square-triangle-inflated-3",
        STRUCTURE,
        "TCP structure over the triangle tiling inflated once",
        || space(square_triangle::triangles().inflated().structure()),
    ),
    Entry::space(
        "square-triangle-inflated-4",
        STRUCTURE,
        "TCP structure over the square tiling inflated once",
        || space(square_triangle::squares().inflated().structure()),
    ),
    Entry::space(
        "square-triangle-inflated-32434",
        STRUCTURE,
        "TCP structure over the tiling 3^2.4.3.4 inflated once",
        || space(square_triangle::snub().inflated().structure()),
    ),
    Entry::space(
        "c15",
        STRUCTURE,
        "TCP structure C15: diamond with selected circumcentres",
        || space(selected::c15()),
    ),
    Entry::space(
        "a15-bcc",
        STRUCTURE,
        "bcc with the circumcentres of the black tetrahedra",
        || space(selected::a15_bcc()),
    ),
    Entry::space(
        "c14",
        "Laves phase",
        "TCP structure C14: kagome layers +-",
        || space(kagome::kagome("+-")),
    ),
    Entry::space(
        "c36",
        "Laves phase",
        "TCP structure C36: kagome layers ++--",
        || space(kagome::kagome("++--")),
    ),
    Entry::space(
        "mu",
        "Frank and Kasper 1959",
        "TCP structure mu: kagome layers z+",
        || space(kagome::kagome("z+")),
    ),
    Entry {
        name: "kagome:",
        description: "kagome layers stacked by a word of z, +, -",
        source: "Frank and Kasper 1959",
        domain: "space",
        parameter: None,
        recipe: Recipe::Word(kagome::kagome),
    },
    Entry::space(
        "bcc",
        TILINGS,
        "Sommerville II: Delaunay triangulation of bcc",
        || space(congruent::sommerville_2()),
    ),
    Entry::space(
        "sommerville-1",
        TILINGS,
        "Sommerville I, 24 in a cube",
        || space(Ok(congruent::sommerville_1())),
    ),
    Entry::space(
        "sommerville-2",
        TILINGS,
        "Sommerville II, the same as bcc",
        || space(congruent::sommerville_2()),
    ),
    Entry::space(
        "sommerville-3",
        TILINGS,
        "Sommerville III, 12 in a cube",
        || space(Ok(congruent::sommerville_3())),
    ),
    Entry::space(
        "sommerville-4",
        TILINGS,
        "Sommerville IV, a quarter of II",
        || space(congruent::sommerville_4()),
    ),
    Entry::ratio(
        "goldberg-1",
        "Goldberg's first family",
        congruent::goldberg_1,
    ),
    Entry::ratio(
        "goldberg-2",
        "Goldberg's second family",
        congruent::goldberg_2,
    ),
    Entry::space("cube-5", TILINGS, "cubes cut into five tetrahedra", || {
        space(Ok(congruent::cube_5()))
    }),
    Entry::space("cube-6", TILINGS, "cubes cut into six tetrahedra", || {
        space(Ok(congruent::cube_6()))
    }),
    Entry {
        name: "equilateral",
        description: "equilateral triangles in the plane",
        source: "section 1",
        domain: "plane",
        parameter: None,
        recipe: Recipe::Fixed(equilateral),
    },
];

fn space(tiling: Result<Tiling<3>, CatalogError>) -> Result<AnyTiling, CatalogError> {
    tiling.map(AnyTiling::Space)
}

fn equilateral() -> Result<AnyTiling, CatalogError> {
    let lattice = recipe::rational_points([[2, 1], [1, 2]], 1, &[[0, 0]]);
    Ok(AnyTiling::Plane(triangulate(&lattice, Ties::Refuse)?))
}
