//! Why JSON is no certificate: the kinds of errors, and where they are.

use std::fmt;

/// Why JSON is no certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JsonError {
    /// The kind of error.
    pub code: JsonCode,
    /// The offset of the byte where it was noticed.
    pub offset: usize,
    /// The rule that is broken.
    pub problem: &'static str,
}

/// The kinds of errors, with the names of docs/format.md.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JsonCode {
    /// Not JSON of the grammar's shape.
    Json,
    /// Not the canonical text.
    Canonical,
    /// Another version.
    Version,
    /// Another kind of certificate.
    Kind,
}

impl JsonCode {
    /// The name of the refusal.
    pub fn name(self) -> &'static str {
        match self {
            JsonCode::Json => "json",
            JsonCode::Canonical => "canonical",
            JsonCode::Version => "version",
            JsonCode::Kind => "kind",
        }
    }

    /// Whether nothing is decided: a later program may read the certificate.
    pub fn is_declined(self) -> bool {
        matches!(self, JsonCode::Version | JsonCode::Kind)
    }
}

impl fmt::Display for JsonError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "byte {}: {}", self.offset, self.problem)
    }
}

impl std::error::Error for JsonError {}
