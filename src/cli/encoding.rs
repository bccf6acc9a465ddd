//! The two encodings of a certificate.

use clap::ValueEnum;
use std::path::Path;

/// How a certificate is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Encoding {
    /// For people and for every verifier
    Json,
    /// For large ones: shorter, written and verified in pieces
    Cbor,
}

impl Encoding {
    /// That of a file with this name, if the name says it; `.CBOR` says what `.cbor` does.
    pub fn of_path(path: &Path) -> Option<Encoding> {
        let extension = path.extension()?;
        [Encoding::Json, Encoding::Cbor]
            .into_iter()
            .find(|encoding| extension.eq_ignore_ascii_case(encoding.extension()))
    }

    /// What names of files end in.
    pub fn extension(self) -> &'static str {
        match self {
            Encoding::Json => "json",
            Encoding::Cbor => "cbor",
        }
    }
}
