//! Short forms for rows of the table.

use crate::CatalogError;
use crate::entry::{Entry, Parameter, Recipe};
use crate::plane_tiling::PlaneTiling;
use acutile_core::family::AnyFamily;
use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_exact::number::Number;

pub const STRUCTURE: &str = "section 4.1";
pub const TILINGS: &str = "section 2.2";

pub const SPACE: &str = "space";
pub const SLAB: &str = "slab";
pub const PRISM: &str = "prism";
pub const SOLID: &str = "polyhedron";
pub const PLANE: &str = "plane";
pub const POLYGON: &str = "polygon";

/// An entry without a parameter and without statements of its own.
const fn entry(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: Recipe,
) -> Entry {
    Entry {
        name,
        description,
        source,
        domain,
        parameter: None,
        is_large: false,
        stated: &[],
        variant_of: None,
        recipe,
    }
}

pub const fn fixed(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn() -> Result<AnyTiling, CatalogError>,
) -> Entry {
    entry(name, domain, source, description, Recipe::Fixed(recipe))
}

pub const fn family(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn(&str) -> Result<AnyTiling, CatalogError>,
) -> Entry {
    entry(name, domain, source, description, Recipe::Word(recipe))
}

/// A large tiling: commands about the whole catalogue leave it out, and take it by name.
pub const fn large(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn() -> Result<AnyTiling, CatalogError>,
) -> Entry {
    Entry {
        is_large: true,
        ..fixed(name, domain, source, description, recipe)
    }
}

/// The construction, with requirements that its certificate states.
pub const fn stating(entry: Entry, stated: &'static [&'static str]) -> Entry {
    Entry { stated, ..entry }
}

/// The source of numbers.
pub const OPTIMIZED: &str = "acutile optimize";

/// The construction `of` with the numbers that `acutile optimize` found.
pub const fn optimized(of: &'static str, entry: Entry) -> Entry {
    Entry {
        variant_of: Some(of),
        ..entry
    }
}

/// A family over plane tilings by squares and triangles.
pub const fn over_plane(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn(&PlaneTiling) -> Result<AnyTiling, CatalogError>,
) -> Entry {
    entry(name, domain, source, description, Recipe::Plane(recipe))
}

pub const fn number(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    parameter: Parameter,
    recipe: fn(&Number) -> Tiling<3>,
) -> Entry {
    Entry {
        parameter: Some(parameter),
        ..entry(name, domain, source, description, Recipe::Number(recipe))
    }
}

/// A tiling for each point of a box.
pub const fn parameters(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn() -> Result<AnyFamily, CatalogError>,
) -> Entry {
    entry(
        name,
        domain,
        source,
        description,
        Recipe::Parameters(recipe),
    )
}

pub fn space(tiling: Result<Tiling<3>, CatalogError>) -> Result<AnyTiling, CatalogError> {
    tiling.map(AnyTiling::Space)
}

pub fn plane(tiling: Result<Tiling<2>, CatalogError>) -> Result<AnyTiling, CatalogError> {
    tiling.map(AnyTiling::Plane)
}
