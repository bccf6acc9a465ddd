//! `acutile convert` for certificates: the same certificate in its other encoding.

use super::encoding::Encoding;
use super::files::is_standard;
use super::name::InputName;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::words::printable;
use acutile_catalog as catalog;
use acutile_core::format::{self, VERSION, print, recognise};
use acutile_core::refusal::exceeded;
use acutile_io::import::{ImportError, read_bytes, uncompressed_name};
use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{self, BufRead, Read};
use std::path::Path;

/// Whether a certificate changes its encoding: the output is named as one, or the input is one and no mesh
/// is asked for.
pub fn is_of_certificate(input: &InputName, path: &Path, is_to_mesh: bool) -> bool {
    let name = uncompressed_name(path);
    Encoding::of_path(&name) == Some(Encoding::Cbor) || (!is_to_mesh && is_certificate(input))
}

/// Whether an input begins as a certificate does, in either encoding.
pub fn is_certificate(input: &InputName) -> bool {
    let is_name = catalog::find(input).is_some();
    !is_name && beginning(input).is_ok_and(|bytes| recognise(&bytes).is_some())
}

/// The first bytes, which stay to be read; none of a pipe that has a name, from which they would
/// be gone.
fn beginning(input: &InputName) -> io::Result<Vec<u8>> {
    const LENGTH: u64 = 100;
    let mut bytes = Vec::new();
    if input.is_standard_input() {
        return Ok(io::stdin().lock().fill_buf()?.to_vec());
    }
    if fs::metadata(input.path())?.is_file() {
        File::open(input.path())?
            .take(LENGTH)
            .read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// Bytes of a certificate that `convert` reads if no option says more. It has both encodings in
/// memory.
pub const BYTES: u64 = 1 << 30;

/// Reads, transcribes, writes. The claim is not judged.
///
/// # Errors
/// A message that names the file.
pub fn convert(
    input: &InputName,
    path: &Path,
    has_options: bool,
    limit: u64,
    output: &mut Output,
) -> Result<(), InputError> {
    check_target(path)?;
    if catalog::find(input).is_some() {
        return Err(format!("{input}: a tiling; {}", way(input, path)).into());
    }
    check_alone(input, has_options)?;
    let bytes = read(input, limit)?;
    if recognise(&bytes).is_none() {
        return Err(format!("{input}: not a certificate; {}", way(input, path)).into());
    }
    let cbor = cbor(input, &bytes)?;
    // Both ways, so that what is written can be read again.
    let json =
        print::to_json(&cbor).map_err(|error| format!("{input}: malformed [cbor] {error}"))?;
    let written = match Encoding::of_path(path) {
        Some(Encoding::Cbor) => cbor.into_owned(),
        _ => json,
    };
    write_bytes(Some(path), &written, output)
}

/// The bytes of a certificate, if there are no more than `limit`.
fn read(input: &InputName, limit: u64) -> Result<Vec<u8>, InputError> {
    let length = fs::metadata(input.path())
        .ok()
        .map(|metadata| metadata.len());
    read_bytes(input.path(), limit).map_err(|error| match error {
        ImportError::TooLong { .. } => InputError {
            message: format!(
                "{input}: declined [too-many-bytes] {}",
                exceeded("bytes", length.filter(|_| !input.is_standard_input()))
            ),
            outcome: Outcome::Declined,
        },
        error => InputError::of_file(input.path(), &error),
    })
}

/// The CBOR of a certificate in either encoding.
///
/// # Errors
/// JSON that is not canonical, or another version.
pub fn cbor<'b>(input: &str, bytes: &'b [u8]) -> Result<Cow<'b, [u8]>, InputError> {
    let cbor = format::to_cbor(bytes).map_err(|error| {
        let is_declined = error.code.is_declined();
        refused(input, error.code.name(), &error.to_string(), is_declined)
    })?;
    match format::version(&cbor) {
        Some(version) if version != VERSION => {
            let message = format!("expected version {VERSION}, found {version}");
            Err(refused(input, "version", &message, true))
        }
        _ => Ok(cbor),
    }
}

fn refused(input: &str, code: &str, message: &str, is_declined: bool) -> InputError {
    let (verdict, outcome) = if is_declined {
        ("declined", Outcome::Declined)
    } else {
        ("malformed", Outcome::Failed)
    };
    InputError {
        message: format!("{input}: {verdict} [{code}] {message}"),
        outcome,
    }
}

/// How a tiling comes to a certificate.
fn way(input: &str, path: &Path) -> String {
    let path = printable(path);
    format!("`acutile certify {input} -o {path}` proves a tiling and writes its certificate")
}

fn check_target(path: &Path) -> Result<(), String> {
    if is_standard(path) || Encoding::of_path(path).is_some() {
        Ok(())
    } else {
        Err(format!(
            "{}: the input is a certificate, expected the extension .json or .cbor, or that of a mesh format; \
             certificates are not compressed",
            printable(path)
        ))
    }
}

/// The options are about meshes and tilings.
fn check_alone(input: &str, has_options: bool) -> Result<(), String> {
    if has_options {
        Err(format!(
            "{input}: only the encoding of the certificate changes, expected no other options, or a mesh to write"
        ))
    } else {
        Ok(())
    }
}
