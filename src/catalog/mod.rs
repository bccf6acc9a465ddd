//! The catalogue: one short recipe for each construction.
//!
//! A recipe makes a tiling from points, paths or a description, exactly; it holds no
//! list of computed tetrahedra. Where the construction is a point set, the
//! tetrahedra come from [`crate::delaunay`]. Nothing is proved here.

mod cubes;
mod plane;
mod points;
mod sommerville;
mod tcp;

use crate::delaunay::DelaunayError;
use crate::number::ReadError;
use crate::tiling::AnyTiling;
use std::fmt;

/// A construction by its name, which is a contract.
pub struct Entry {
    /// The name on the command line.
    pub name: &'static str,
    /// What it is, in a line.
    pub description: &'static str,
    /// Where it is described.
    pub source: &'static str,
    recipe: fn() -> Result<AnyTiling, CatalogError>,
}

impl Entry {
    /// Follows the recipe.
    ///
    /// # Errors
    /// [`CatalogError`] where the recipe does not lead to a tiling.
    pub fn build(&self) -> Result<AnyTiling, CatalogError> {
        (self.recipe)()
    }
}

/// All constructions, in the order in which they are listed.
pub fn entries() -> &'static [Entry] {
    ENTRIES
}

/// The construction with this name.
pub fn find(name: &str) -> Option<&'static Entry> {
    ENTRIES.iter().find(|entry| entry.name == name)
}

const ENTRIES: &[Entry] = &[
    Entry {
        name: "z",
        description: "TCP structure Z, from the tiling of the plane by triangles",
        source: "Eppstein, Sullivan, Ungor, section 4.1",
        recipe: tcp::z,
    },
    Entry {
        name: "a15",
        description: "TCP structure A15 (beta tungsten, Weaire-Phelan)",
        source: "Eppstein, Sullivan, Ungor, section 4.1",
        recipe: tcp::a15,
    },
    Entry {
        name: "c15",
        description: "TCP structure C15 (cubic Friauf-Laves phase), primitive cell",
        source: "Eppstein, Sullivan, Ungor, section 4.1",
        recipe: tcp::c15,
    },
    Entry {
        name: "bcc",
        description: "Delaunay triangulation of the body-centred cubic lattice (Sommerville II)",
        source: "Sommerville 1923; Eppstein, Sullivan, Ungor, section 2.2",
        recipe: sommerville::bcc,
    },
    Entry {
        name: "cube-5",
        description: "cubes cut into five tetrahedra: four corners and a regular one",
        source: "Eppstein, Sullivan, Ungor, section 2.2, figure of the cubes (a)",
        recipe: cubes::cube_5,
    },
    Entry {
        name: "cube-6",
        description: "cubes cut into six tetrahedra along a diagonal",
        source: "Eppstein, Sullivan, Ungor, section 2.2, figure of the cubes (b)",
        recipe: cubes::cube_6,
    },
    Entry {
        name: "equilateral",
        description: "the plane tiled by equilateral triangles",
        source: "Eppstein, Sullivan, Ungor, section 1",
        recipe: plane::equilateral,
    },
];

/// Why a recipe does not lead to a tiling.
#[derive(Debug)]
pub enum CatalogError {
    /// A number of the recipe cannot be read.
    Number(ReadError),
    /// The points have no Delaunay triangulation.
    Delaunay(DelaunayError),
}

impl fmt::Display for CatalogError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            CatalogError::Number(error) => write!(f, "{error}"),
            CatalogError::Delaunay(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for CatalogError {}

impl From<ReadError> for CatalogError {
    fn from(error: ReadError) -> Self {
        CatalogError::Number(error)
    }
}

impl From<DelaunayError> for CatalogError {
    fn from(error: DelaunayError) -> Self {
        CatalogError::Delaunay(error)
    }
}
