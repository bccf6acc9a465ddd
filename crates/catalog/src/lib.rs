//! The catalogue: the constructions of the paper by name, each a recipe.
//!
//! | file | constructions |
//! |---|---|
//! | `square_triangle` | TCP structures from tilings by squares and triangles |
//! | `plane_tiling`, `plane_file` | such tilings: built in, inflated, checked, the text of a file |
//! | `z_c15` | the variant that mixes Z and C15 |
//! | `blank`, `search` | the blank edges that the variant needs |
//! | `icosahedral` | layers of icosahedra |
//! | `slab` | the slab, and the slab repeated |
//! | `kagome` | Laves phases, Z and mixtures as stacked layers |
//! | `selected` | lattices with selected circumcentres: A15 and C15 |
//! | `congruent` | Sommerville, Goldberg, cubes |
//! | `solid` | single tetrahedra, and two that are not Delaunay |
//! | `planar` | the square, and tilings by triangles |
//! | `recipe` | what they share |
//! | `entries` | the table of names |
//!
//! Names are a contract. Nothing here is proved; the checker does that.

mod blank;
mod congruent;
mod entries;
mod error;
mod icosahedral;
mod kagome;
mod planar;
pub mod plane_file;
pub mod plane_tiling;
mod recipe;
mod search;
mod selected;
mod slab;
mod solid;
mod square_triangle;
mod z_c15;

pub use error::CatalogError;
pub use kagome::WORD_LIMIT;

use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_exact::geometry::Sign;
use acutile_exact::number::{Number, numbers};
use entries::ENTRIES;
use plane_tiling::PlaneTiling;

/// A construction.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name, or for a family of words the prefix with a colon, `kagome:`.
    pub name: &'static str,
    /// One line.
    pub description: &'static str,
    /// Where it is described.
    pub source: &'static str,
    /// What is tiled: `space`, `slab`, `polyhedron`, `plane` or `polygon`.
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
    /// The value where none is given, in the syntax of [`acutile_exact::number::text`].
    pub default: &'static str,
}

#[derive(Clone, Copy, Debug)]
enum Recipe {
    Fixed(fn() -> Result<AnyTiling, CatalogError>),
    Number(fn(&Number) -> Tiling<3>),
    Word(fn(&str) -> Result<AnyTiling, CatalogError>),
    Plane(fn(&PlaneTiling) -> Result<AnyTiling, CatalogError>),
}

impl Entry {
    /// The construction with its default parameter; an error for a family of words, which
    /// [`build`] makes by name.
    pub fn build(&self) -> Result<AnyTiling, CatalogError> {
        match (self.recipe, self.parameter) {
            (Recipe::Fixed(recipe), _) => recipe(),
            (Recipe::Word(recipe), _) => recipe(""),
            (Recipe::Plane(recipe), _) => recipe(&built_in("")?),
            (Recipe::Number(_), Some(parameter)) => self.build_with_text(parameter.default),
            (Recipe::Number(_), None) => Err(CatalogError::NoParameter(self.name.to_owned())),
        }
    }

    /// The construction for a parameter, a text like `3/7` or `sqrt(2)/4`.
    pub fn build_with_text(&self, parameter: &str) -> Result<AnyTiling, CatalogError> {
        let values = numbers(&[parameter])
            .map_err(|error| CatalogError::Number(parameter.to_owned(), error))?;
        self.build_with(&values[0])
    }

    /// The construction for a parameter.
    pub fn build_with(&self, parameter: &Number) -> Result<AnyTiling, CatalogError> {
        match self.recipe {
            Recipe::Number(_) if parameter.sign() != Sign::Greater => {
                Err(CatalogError::NotPositive(parameter.to_string()))
            }
            Recipe::Number(recipe) => Ok(AnyTiling::Space(recipe(parameter))),
            _ => Err(CatalogError::NoParameter(self.name.to_owned())),
        }
    }

    /// Whether the name is a prefix that a word completes.
    pub fn is_family(&self) -> bool {
        matches!(self.recipe, Recipe::Word(_) | Recipe::Plane(_))
    }
}

/// All constructions.
pub fn entries() -> &'static [Entry] {
    ENTRIES
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
        Recipe::Word(_) | Recipe::Plane(_) => name.starts_with(entry.name),
        _ => name == entry.name,
    })
}

/// The construction with this name, `kagome:z+` included, with default parameters.
pub fn build(name: &str) -> Result<AnyTiling, CatalogError> {
    let entry = find(name).ok_or_else(|| CatalogError::UnknownName(name.to_owned()))?;
    match entry.recipe {
        Recipe::Word(recipe) => recipe(&name[entry.name.len()..]),
        Recipe::Plane(recipe) => recipe(&built_in(&name[entry.name.len()..])?),
        _ => entry.build(),
    }
}

/// The file name FILE in `square-triangle:FILE` or `z-c15:FILE`; `None` for any other name and
/// for a plane tiling that is built in. The caller reads the file and calls [`build_over`].
pub fn plane_file(name: &str) -> Option<&str> {
    let entry = find(name)?;
    let word = &name[entry.name.len()..];
    let is_plane = matches!(entry.recipe, Recipe::Plane(_));
    (is_plane && !word.is_empty() && plane_tiling::named(word).is_none()).then_some(word)
}

/// The construction with this name, `square-triangle:FILE` or `z-c15:FILE`, over the plane tiling
/// of that file.
pub fn build_over(name: &str, plane: &PlaneTiling) -> Result<AnyTiling, CatalogError> {
    match find(name).map(|entry| entry.recipe) {
        Some(Recipe::Plane(recipe)) => recipe(plane),
        _ => Err(CatalogError::UnknownName(name.to_owned())),
    }
}

/// The plane tiling that is built in under this name.
fn built_in(name: &str) -> Result<PlaneTiling, CatalogError> {
    plane_tiling::named(name).ok_or_else(|| {
        CatalogError::File(format!(
            "found {name:?} after the colon, expected a plane-tiling file or a built-in tiling: 3, \
             4, 33344, 32434, 3464, inflated-NAME of these"
        ))
    })
}

/// The construction with this name for a parameter, a text like `3/7`.
pub fn build_with(name: &str, parameter: &str) -> Result<AnyTiling, CatalogError> {
    let entry = find(name).ok_or_else(|| CatalogError::UnknownName(name.to_owned()))?;
    entry.build_with_text(parameter)
}
