//! Why a mesh file could not be read: where, what was expected, what was found.

use std::fmt;

/// Where in a file something is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of text, counted from 1.
    Line(u64),
    /// A byte of a binary file, counted from 0.
    Byte(u64),
}

/// A file that is no mesh. The caller knows the file's name and prints it in front.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshError {
    /// Where.
    pub place: Place,
    /// The expected and the found value.
    pub problem: String,
    /// Whether a stated limit is the reason, and not the file.
    pub is_limit: bool,
}

impl MeshError {
    /// Something is wrong at this place.
    pub fn at(place: Place, problem: impl fmt::Display) -> Self {
        MeshError {
            place,
            problem: problem.to_string(),
            is_limit: false,
        }
    }

    /// Something is wrong with the whole file.
    pub fn of_file(problem: impl fmt::Display) -> Self {
        MeshError::at(Place::File, problem)
    }

    /// The file may be right, but it is more than the stated limit.
    pub fn limit(problem: impl fmt::Display) -> Self {
        MeshError {
            is_limit: true,
            ..MeshError::of_file(problem)
        }
    }
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.place {
            Place::File => write!(f, "{}", self.problem),
            Place::Line(line) => write!(f, "line {line}: {}", self.problem),
            Place::Byte(byte) => write!(f, "byte {byte}: {}", self.problem),
        }
    }
}

impl std::error::Error for MeshError {}
