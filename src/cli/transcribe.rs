//! `acutile convert` for certificates: the same certificate in its other encoding.

use super::encoding::Encoding;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_file};
use acutile_catalog as catalog;
use acutile_core::format::{self, json::JsonCode, print, recognise};
use acutile_io::import::{read_bytes, uncompressed_name};
use std::fs::{self, File};
use std::io::{self, BufRead, Read};
use std::path::Path;

/// Whether this is about a certificate: one that is there, or one that is to be.
pub fn is_of_certificate(input: &str, path: &Path) -> bool {
    let name = uncompressed_name(path);
    Encoding::of_path(&name) == Some(Encoding::Cbor) || is_certificate(input)
}

/// Whether an input begins as a certificate does, in either encoding.
fn is_certificate(input: &str) -> bool {
    let is_name = catalog::find(input).is_some();
    !is_name && beginning(input).is_ok_and(|bytes| recognise(&bytes).is_some())
}

/// The first bytes, which stay to be read; none of a pipe that has a name, from which they would
/// be gone.
fn beginning(input: &str) -> io::Result<Vec<u8>> {
    const LENGTH: u64 = 100;
    let mut bytes = Vec::new();
    if input == "-" {
        return Ok(io::stdin().lock().fill_buf()?.to_vec());
    }
    if fs::metadata(input)?.is_file() {
        File::open(input)?.take(LENGTH).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// Reads, transcribes, writes. What the certificate claims is not looked at.
///
/// # Errors
/// A message that names the file.
pub fn convert(
    input: &str,
    path: &Path,
    has_options: bool,
    output: &mut Output,
) -> Result<(), InputError> {
    check_target(path)?;
    if catalog::find(input).is_some() {
        return Err(format!("{input}: a tiling; {}", way(input, path)).into());
    }
    check_alone(input, has_options)?;
    let bytes =
        read_bytes(Path::new(input), u64::MAX - 1).map_err(|error| format!("{input}: {error}"))?;
    if recognise(&bytes).is_none() {
        return Err(format!("{input}: not a certificate; {}", way(input, path)).into());
    }
    let cbor = format::to_cbor(&bytes).map_err(|error| InputError {
        message: format!("{input}: malformed [{}] {error}", error.code.name()),
        outcome: match error.code {
            JsonCode::Version => Outcome::Declined,
            _ => Outcome::Failed,
        },
    })?;
    // Both ways, so that what is written can be read again.
    let json =
        print::to_json(&cbor).map_err(|error| format!("{input}: malformed [cbor] {error}"))?;
    let written = match Encoding::of_path(path) {
        Some(Encoding::Cbor) => cbor.into_owned(),
        _ => json,
    };
    if path == Path::new("-") {
        output.bytes(&written);
        return Ok(());
    }
    let message = |error| format!("{}: cannot be written: {error}", path.display());
    Ok(write_file(path, &written).map_err(message)?)
}

/// How a tiling comes to a certificate.
fn way(input: &str, path: &Path) -> String {
    let path = path.display();
    format!("`acutile certify {input} -o {path}` proves a tiling and writes its certificate")
}

fn check_target(path: &Path) -> Result<(), String> {
    if path == Path::new("-") || Encoding::of_path(path).is_some() {
        Ok(())
    } else {
        Err(format!(
            "{}: a certificate is written as .json or .cbor, not compressed",
            path.display()
        ))
    }
}

/// The options are about meshes and tilings.
fn check_alone(input: &str, has_options: bool) -> Result<(), String> {
    if has_options {
        Err(format!(
            "{input}: a certificate takes no options, only its encoding changes"
        ))
    } else {
        Ok(())
    }
}
