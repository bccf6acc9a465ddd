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
    TooLong {
        /// The limit in bytes.
        limit: u64,
    },
    /// A compressed file of `length` bytes that has more than `growth` bytes of content.
    GrowsTooMuch {
        /// The length of the file in bytes.
        length: u64,
        /// The greatest length of the content in bytes.
        growth: u64,
    },
    /// Not UTF-8 from this byte on.
    NotText {
        /// The first byte that is not UTF-8, from zero.
        offset: usize,
    },
    /// Nothing but white space.
    Empty,
    /// Not JSON, or not the members that were expected; names line and column.
    Json(serde_json::Error),
    /// JSON of another shape than expected at this place.
    Shape {
        /// The path of the entry.
        place: String,
        /// The error of the JSON reader.
        error: serde_json::Error,
    },
    /// JSON of another format.
    Format {
        /// The value of `format`.
        found: String,
        /// The values that are read.
        expected: Vec<String>,
    },
    /// An unknown version of the format.
    Version {
        /// The value of `version`.
        found: u64,
    },
    /// Something about the entry at `place`, like `vertices[3][1]`.
    Entry {
        /// The path of the entry.
        place: String,
        /// The problem with it.
        problem: String,
    },
    /// At `place` a stated limit is exceeded.
    Limit {
        /// The path of the entry.
        place: String,
        /// The limit, and the value that exceeds it.
        problem: String,
    },
    /// A number that cannot be read.
    Number {
        /// The path of the entry.
        place: String,
        /// The error of the number reader.
        error: ReadError,
    },
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
            ImportError::Unreadable(error) => {
                write!(f, "cannot be read: {}", words::of_io(error))
            }
            ImportError::TooLong { limit } => {
                write!(f, "is longer than the limit of {limit} bytes")
            }
            ImportError::GrowsTooMuch { length, growth } => write!(
                f,
                "has {length} bytes compressed and more than {growth} bytes of content, \
                 expected at most {growth}; if this is intended, decompress the file first"
            ),
            ImportError::NotText { offset } => {
                write!(
                    f,
                    "byte {offset} is not UTF-8: neither text nor a binary format that is read"
                )
            }
            ImportError::Empty => write!(
                f,
                "is empty, expected an input file; acutile new writes examples"
            ),
            ImportError::Json(error) | ImportError::Shape { error, .. } => write!(
                f,
                "{} (line {}, column {})",
                self.words(),
                error.line(),
                error.column()
            ),
            ImportError::Format { found, expected } => {
                let expected: Vec<String> = expected.iter().map(|e| format!("{e:?}")).collect();
                let expected = expected.join(" or ");
                write!(f, "format is {found:?}, expected {expected}")?;
                f.write_str(words::use_of(found))
            }
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
