//! One variant for each way in which a file can fail to be read.

use super::words;
use acutile_exact::number::ReadError;
use std::fmt;
use std::io;

/// Why a file could not be read. The caller knows the file's name and prints it
/// in front.
#[derive(Debug)]
pub enum ImportError {
    /// The operating system refused.
    Unreadable(io::Error),
    /// More bytes than the limit.
    TooLong { limit: u64 },
    /// A compressed file of `length` bytes that has more than `growth` bytes of content.
    GrowsTooMuch { length: u64, growth: u64 },
    /// Not UTF-8 from this byte on.
    NotText { offset: usize },
    /// Nothing but white space.
    Empty,
    /// Not JSON, or not the members that were expected; names line and column.
    Json(serde_json::Error),
    /// JSON, but not what was expected at this place.
    Shape {
        place: String,
        error: serde_json::Error,
    },
    /// JSON of another format.
    Format { found: String },
    /// An unknown version of the format.
    Version { found: u64 },
    /// Something about the entry at `place`, like `vertices[3][1]`.
    Entry { place: String, problem: String },
    /// At `place` a stated limit is exceeded.
    Limit { place: String, problem: String },
    /// A number that cannot be read.
    Number { place: String, error: ReadError },
}

impl ImportError {
    /// An error about the entry at `place`.
    pub fn entry(place: impl Into<String>, problem: impl fmt::Display) -> Self {
        ImportError::Entry {
            place: place.into(),
            problem: problem.to_string(),
        }
    }

    /// A limit exceeded at `place`.
    pub fn limit(place: impl Into<String>, problem: impl fmt::Display) -> Self {
        ImportError::Limit {
            place: place.into(),
            problem: problem.to_string(),
        }
    }

    /// The message without line and column, for callers that show the place in another way.
    pub fn words(&self) -> String {
        match self {
            ImportError::Json(error) => words::of_json(error),
            ImportError::Shape { place, error } => format!("{place}: {}", words::of_json(error)),
            _ => self.to_string(),
        }
    }

    /// Whether a stated limit, or a version of tomorrow, is the reason.
    pub fn is_limit(&self) -> bool {
        match self {
            ImportError::TooLong { .. }
            | ImportError::GrowsTooMuch { .. }
            | ImportError::Version { .. }
            | ImportError::Limit { .. } => true,
            ImportError::Number { error, .. } => error.is_limit(),
            _ => false,
        }
    }
}

impl fmt::Display for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            ImportError::Unreadable(error) => write!(f, "cannot be read: {error}"),
            ImportError::TooLong { limit } => {
                write!(f, "is longer than the limit of {limit} bytes")
            }
            ImportError::GrowsTooMuch { length, growth } => write!(
                f,
                "has {length} bytes compressed and more than {growth} bytes of content, \
                 expected at most {growth}; if this is intended, decompress the file first"
            ),
            ImportError::NotText { offset } => {
                write!(f, "byte {offset}: not UTF-8 text")
            }
            ImportError::Empty => write!(f, "is empty, expected a tiling or point-set file"),
            ImportError::Json(error) | ImportError::Shape { error, .. } => write!(
                f,
                "{} (line {}, column {})",
                self.words(),
                error.line(),
                error.column()
            ),
            ImportError::Format { found } => write!(
                f,
                "format is {found:?}, expected \"acutile-tiling\" or \"acutile-points\""
            ),
            ImportError::Version { found } => {
                write!(f, "version is {found}, expected 1")
            }
            ImportError::Entry { place, problem } | ImportError::Limit { place, problem } => {
                write!(f, "{place}: {problem}")
            }
            ImportError::Number { place, error } => write!(f, "{place}: {error}"),
        }
    }
}

impl std::error::Error for ImportError {}
