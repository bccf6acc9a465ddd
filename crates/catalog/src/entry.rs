//! One construction of the catalogue.

use super::CatalogError;
use super::plane_tiling::{PlaneTiling, built_in};
use acutile_core::family::AnyFamily;
use acutile_core::statement::Requirement;
use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_exact::geometry::Sign;
use acutile_exact::number::{Number, numbers};

/// A construction.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name, or for a family of words the prefix with a colon, `kagome:`.
    pub name: &'static str,
    /// One line.
    pub description: &'static str,
    /// Where it is described.
    pub source: &'static str,
    /// The domain: `space`, `slab`, `prism`, `polyhedron`, `plane` or `polygon`.
    pub domain: &'static str,
    /// The number that it depends on, if it does.
    pub parameter: Option<Parameter>,
    /// Whether it has thousands of simplices: lists of all constructions leave it out.
    pub is_large: bool,
    /// Requirements like `plane:x1+x2=0`. Its certificate states them beside the statements that the prover
    /// finds.
    pub stated: &'static [&'static str],
    /// The construction of which it has the combinatorial type, with other numbers.
    pub variant_of: Option<&'static str>,
    pub(super) recipe: Recipe,
}

/// A positive number on which a construction depends.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// A short name, `a/e`.
    pub name: &'static str,
    /// The value where none is given, in the syntax of [`acutile_exact::number::text`].
    pub default: &'static str,
}

/// How it is made.
#[derive(Clone, Copy, Debug)]
pub(super) enum Recipe {
    Fixed(fn() -> Result<AnyTiling, CatalogError>),
    Number(fn(&Number) -> Tiling<3>),
    Word(fn(&str) -> Result<AnyTiling, CatalogError>),
    Plane(fn(&PlaneTiling) -> Result<AnyTiling, CatalogError>),
    Parameters(fn() -> Result<AnyFamily, CatalogError>),
}

impl Entry {
    /// The construction with its default parameter; an error for a family of words, which
    /// [`build`](super::build) makes by name.
    pub fn build(&self) -> Result<AnyTiling, CatalogError> {
        match (self.recipe, self.parameter) {
            (Recipe::Fixed(recipe), _) => recipe(),
            (Recipe::Word(recipe), _) => recipe(""),
            (Recipe::Plane(recipe), _) => recipe(&built_in("")?),
            (Recipe::Number(_), Some(parameter)) => self.build_with_text(parameter.default),
            (Recipe::Parameters(_), _) => Err(CatalogError::Family(self.name.to_owned())),
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

    /// The construction for all values of its parameters in a box; `None` for a single tiling.
    pub fn build_family(&self) -> Option<Result<AnyFamily, CatalogError>> {
        match self.recipe {
            Recipe::Parameters(recipe) => Some(recipe()),
            _ => None,
        }
    }

    /// The requirements of `stated`.
    ///
    /// # Errors
    /// One is none, in words.
    pub fn requirements(&self) -> Result<Vec<Requirement>, String> {
        self.stated.iter().map(|text| text.parse()).collect()
    }

    /// Whether it is a tiling for each point of a box of parameters.
    pub fn has_box(&self) -> bool {
        matches!(self.recipe, Recipe::Parameters(_))
    }

    /// Whether the name is a prefix that a word completes.
    pub fn is_family(&self) -> bool {
        matches!(self.recipe, Recipe::Word(_) | Recipe::Plane(_))
    }
}
