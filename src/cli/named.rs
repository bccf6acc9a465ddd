//! A tiling with its name, or why there is none.

use super::outcome::Outcome;
use super::words::printable;
use acutile_core::checker::Sides;
use acutile_core::curved::Element;
use acutile_core::family::AnyFamily;
use acutile_core::tiling::{AnyTiling, SimplexId};
use acutile_io::import::ImportError;
use acutile_io::mesh::{MeshError, Origin};
use std::collections::BTreeMap;
use std::path::Path;

/// Where a tiling comes from, with its name for messages and for the file name of
/// its certificate.
pub struct Named {
    /// A name of the catalogue, or a path.
    pub name: String,
    /// What it is, in a line.
    pub description: String,
    /// The tiling.
    pub tiling: AnyTiling,
    /// The numbers of a mesh file.
    pub origin: Option<Origin>,
    /// What is known of the sides of a periodic mesh.
    pub sides: Sides,
    /// Elements of other types in a mesh file, by name.
    pub others: BTreeMap<String, usize>,
    /// The curved elements of a mesh.
    pub curved: Vec<(SimplexId, Element)>,
    /// Notes on a mesh file or a crystal structure: nodes moved, tetrahedra turned, parts not read.
    pub notes: Vec<String>,
    /// For each vertex the label of its site; empty if there are none.
    pub labels: Vec<String>,
}

/// A family with its name.
pub struct NamedFamily {
    /// A name of the catalogue, or a path.
    pub name: String,
    /// What it is, in a line.
    pub description: String,
    /// The family.
    pub family: AnyFamily,
}

impl NamedFamily {
    /// For commands that take single tilings.
    pub fn is_no_tiling(&self) -> InputError {
        let name = &self.name;
        InputError::from(format!(
            "{name}: a tiling for each point of a box of parameters, expected a single tiling; \
             `acutile certify` and `acutile show` take it"
        ))
    }
}

impl Named {
    /// A tiling that comes from no mesh.
    pub fn of(name: &str, description: String, tiling: AnyTiling) -> Self {
        Named {
            name: name.to_owned(),
            description,
            tiling,
            origin: None,
            sides: Sides::default(),
            others: BTreeMap::new(),
            curved: Vec::new(),
            notes: Vec::new(),
            labels: Vec::new(),
        }
    }
}

/// Why there is no input, in words that name it, and what that makes of the command.
pub struct InputError {
    pub message: String,
    pub outcome: Outcome,
}

impl From<String> for InputError {
    fn from(message: String) -> Self {
        InputError {
            message,
            outcome: Outcome::Failed,
        }
    }
}

impl InputError {
    /// A mesh file could not be read.
    pub fn of_mesh(input: &str, error: &MeshError) -> Self {
        InputError {
            message: format!("{input}: {error}"),
            outcome: outcome(error.is_limit),
        }
    }

    /// A text could not be read: line, column and the line with a caret, if it is at one place.
    pub fn of_text(path: &Path, text: &str, error: &ImportError) -> Self {
        let Some(excerpt) = error.excerpt(text) else {
            return Self::of_file(path, error);
        };
        let (path, line, column) = (printable(path), excerpt.line, excerpt.column);
        InputError {
            message: format!(
                "{path}:{line}:{column}: {}\n{}",
                error.words(),
                excerpt.lines
            ),
            outcome: outcome(error.is_limit()),
        }
    }

    /// One of the program's own files could not be read.
    pub fn of_file(path: &Path, error: &ImportError) -> Self {
        InputError {
            message: format!("{}: {error}", printable(path)),
            outcome: outcome(error.is_limit()),
        }
    }
}

fn outcome(is_limit: bool) -> Outcome {
    if is_limit {
        Outcome::Declined
    } else {
        Outcome::Failed
    }
}
