//! The catalogue: the constructions of the paper by name, each a recipe.
//!
//! | file | constructions |
//! |---|---|
//! | `square_triangle` | TCP structures from tilings by squares and triangles |
//! | `plane_tiling`, `plane_file` | such tilings: built in, inflated, checked, the text of a file |
//! | `z_c15` | the variant that mixes Z and C15 |
//! | `blank`, `search` | the blank edges that the variant needs |
//! | `icosahedral` | layers of icosahedra |
//! | `best` | C14, Z and the slab with the best angles known of their types |
//! | `slab` | the slab, and the slab repeated |
//! | `kagome` | Laves phases, Z and mixtures as stacked layers |
//! | `selected` | lattices with selected circumcentres: A15 and C15 |
//! | `congruent` | Sommerville, Goldberg, cubes |
//! | `solid` | single tetrahedra, and two that are not Delaunay |
//! | `cell600` | polyhedra cut into acute tetrahedra, with the 600-cell |
//! | `planar` | the square, and tilings by triangles |
//! | [`places`] | the special places of a square/triangle tiling, for searches |
//! | `families` | constructions for all values of their parameters in a box |
//! | [`patches`] | theorems about all tilings over squares and triangles, and all kagome words |
//! | `recipe` | their common parts |
//! | `entry`, `entries` | one construction, and the table of all |
//! | [`limits`] | words and entries beyond them are refused |
//!
//! Names are a contract. Nothing here is proved; the checker does that.

mod best;
mod blank;
mod cell600;
mod congruent;
mod entries;
mod entry;
mod error;
mod families;
mod icosahedral;
mod kagome;
pub mod limits;
pub mod patches;
pub mod places;
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

pub use entry::{Entry, Parameter};
pub use error::CatalogError;
pub use kagome::blocks as kagome_blocks;

use acutile_core::patches::System;
use acutile_core::tiling::AnyTiling;
use entries::ENTRIES;
use entry::Recipe;
use plane_tiling::{PlaneTiling, built_in};

/// All constructions.
pub fn entries() -> &'static [Entry] {
    &ENTRIES
}

/// A theorem about all members of a family: a system of patches.
#[derive(Debug)]
pub struct Theorem {
    /// The name of the construction.
    pub name: &'static str,
    /// One line for the list of the catalogue.
    pub description: &'static str,
    /// The name of the family, before the word.
    pub family: &'static str,
    /// The letters of the tiles in a word; none where the word is no list of tiles.
    pub letters: &'static str,
    /// Builds the system of patches.
    pub system: fn() -> Result<System, CatalogError>,
}

/// All theorems.
pub static THEOREMS: &[Theorem] = &[
    Theorem {
        name: "square-triangle-all",
        description: "all TCP structures over tilings by squares and triangles, periodic or not",
        family: "square-triangle:",
        letters: "",
        system: patches::square_triangle_all,
    },
    Theorem {
        name: "kagome-all",
        description: "all stacks of kagome layers, periodic or not",
        family: "kagome:",
        letters: "z+-",
        system: patches::kagome_all,
    },
];

/// The theorem with this name.
pub fn theorem(name: &str) -> Option<&'static Theorem> {
    THEOREMS.iter().find(|theorem| theorem.name == name)
}

/// The names of all single tilings that need no further word, without the large ones.
pub fn names() -> impl Iterator<Item = &'static str> {
    single()
        .filter(|entry| !entry.is_large)
        .map(|entry| entry.name)
}

/// The names without variants, which have the combinatorial type of another.
pub fn types() -> impl Iterator<Item = &'static str> {
    let is_variant = |name: &&str| find(name).is_some_and(|entry| entry.variant_of.is_some());
    names().filter(move |name| !is_variant(name))
}

/// The names of the large ones.
pub fn large_names() -> impl Iterator<Item = &'static str> {
    single()
        .filter(|entry| entry.is_large)
        .map(|entry| entry.name)
}

fn single() -> impl Iterator<Item = &'static Entry> {
    ENTRIES
        .iter()
        .filter(|entry| !entry.is_family() && !entry.has_box())
}

/// The names of all constructions for boxes of parameters.
pub fn family_names() -> impl Iterator<Item = &'static str> {
    let families = ENTRIES.iter().filter(|entry| entry.has_box());
    families.map(|entry| entry.name)
}

/// The construction with this name, for `kagome:WORD` the family. Upper and lower case are the
/// same, but in words.
pub fn find(name: &str) -> Option<&'static Entry> {
    ENTRIES.iter().find(|entry| match entry.recipe {
        Recipe::Word(_) | Recipe::Plane(_) => name
            .get(..entry.name.len())
            .is_some_and(|head| head.eq_ignore_ascii_case(entry.name)),
        _ => name.eq_ignore_ascii_case(entry.name),
    })
}

/// The name of the catalogue that is most like a wrong one, if any is much like it.
/// Where the user chooses a part of the name, it is `WORD`.
pub fn suggestion(wrong: &str) -> Option<String> {
    /// One less the share of letters that must be changed, put in, left out or exchanged.
    const MUCH: f64 = 0.6;
    let wrong = wrong.to_ascii_lowercase();
    let similarity = |entry: &'static Entry| {
        let similarity = strsim::normalized_damerau_levenshtein(&wrong, entry.name);
        (similarity, entry)
    };
    let entries = ENTRIES.iter().map(similarity);
    let best = entries.max_by(|a, b| a.0.total_cmp(&b.0));
    let (_, entry) = best.filter(|(similarity, _)| *similarity >= MUCH)?;
    let word = if entry.is_family() { "WORD" } else { "" };
    Some(format!("{}{word}", entry.name))
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

/// The construction with this name for a parameter, a text like `3/7`.
pub fn build_with(name: &str, parameter: &str) -> Result<AnyTiling, CatalogError> {
    let entry = find(name).ok_or_else(|| CatalogError::UnknownName(name.to_owned()))?;
    entry.build_with_text(parameter)
}
