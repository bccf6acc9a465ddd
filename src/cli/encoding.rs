//! The two encodings of a certificate, and files of certificates.

use super::extension::{self, Format};
use super::named::InputError;
use super::output::{Output, write_bytes};
use acutile_core::format::print;
use clap::ValueEnum;
use std::borrow::Cow;
use std::io;
use std::path::Path;

/// How a certificate is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Encoding {
    /// Text, which people can read
    Json,
    /// Bytes, shorter: the form that acutile-verify and the checker in Coq read
    Cbor,
}

const FORMATS: [Format<Encoding>; 2] = [
    (Encoding::Json, "a certificate in JSON", &["json"]),
    (Encoding::Cbor, "a certificate in CBOR", &["cbor"]),
];

impl Encoding {
    /// The encoding that is asked for, or that the name of the file says; JSON where neither says anything.
    ///
    /// # Errors
    /// The two disagree, or the name promises something else.
    pub fn of(path: Option<&Path>, asked: Option<Encoding>) -> Result<Encoding, String> {
        extension::format(path, asked, &FORMATS)
    }

    /// That of a file with this name, if the name says it; `.CBOR` says what `.cbor` does.
    pub fn of_path(path: &Path) -> Option<Encoding> {
        let extension = path.extension()?;
        [Encoding::Json, Encoding::Cbor]
            .into_iter()
            .find(|encoding| extension.eq_ignore_ascii_case(encoding.extension()))
    }

    /// The extension of file names.
    pub fn extension(self) -> &'static str {
        match self {
            Encoding::Json => "json",
            Encoding::Cbor => "cbor",
        }
    }

    /// A certificate in this encoding.
    pub fn encode(self, cbor: &[u8]) -> io::Result<Cow<'_, [u8]>> {
        match self {
            Encoding::Cbor => Ok(Cow::Borrowed(cbor)),
            Encoding::Json => print::to_json(cbor)
                .map(Cow::Owned)
                .map_err(io::Error::other),
        }
    }
}

/// Writes a certificate; the answer names it, so it is not among the files.
///
/// # Errors
/// A message that names the file.
pub fn write_certificate(
    path: &Path,
    encoding: Encoding,
    cbor: &[u8],
    output: &mut Output,
) -> Result<(), InputError> {
    let bytes = encoding
        .encode(cbor)
        .map_err(|error| format!("the certificate: {error}"))?;
    write_bytes(Some(path), &bytes, output)
}
