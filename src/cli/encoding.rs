//! `acutile convert` for certificates: the same certificate in its other encoding.

use super::Outcome;
use super::args::{ConvertArguments, Encoding};
use super::input::InputError;
use super::output::{Output, write_file};
use acutile_catalog as catalog;
use acutile_format1::certificate::{FORMAT, cbor::is_cbor};
use acutile_format1::verifier::{Kind, Limits, to_cbor, to_json};
use acutile_io::import::{read_bytes, uncompressed_name};
use std::fs::{self, File};
use std::io::{self, BufRead, Read};
use std::path::Path;

/// Whether this is about a certificate: one that is there, or one that is to be.
pub fn is_of_certificate(arguments: &ConvertArguments) -> bool {
    let name = uncompressed_name(&arguments.output);
    Encoding::of_path(&name) == Some(Encoding::Cbor) || is_certificate(&arguments.input)
}

/// Whether an input begins as a certificate does, in either encoding.
fn is_certificate(input: &str) -> bool {
    let is_name = catalog::find(input).is_some();
    !is_name && beginning(input).is_ok_and(|bytes| begins_as_certificate(&bytes))
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

fn begins_as_certificate(bytes: &[u8]) -> bool {
    let start = format!("{{\"format\":\"{FORMAT}\"");
    let letters = bytes.iter().filter(|byte| !byte.is_ascii_whitespace());
    is_cbor(bytes) || letters.take(start.len()).eq(start.as_bytes())
}

/// Reads, transcribes, writes. What the certificate claims is not looked at.
///
/// # Errors
/// A message that names the file.
pub fn convert(arguments: &ConvertArguments, output: &mut Output) -> Result<(), InputError> {
    let (input, path) = (&arguments.input, arguments.output.as_path());
    check_target(arguments)?;
    if catalog::find(input).is_some() {
        return Err(format!("{input}: a tiling; {}", way(arguments)).into());
    }
    check_alone(arguments)?;
    let bytes =
        read_bytes(Path::new(input), u64::MAX - 1).map_err(|error| format!("{input}: {error}"))?;
    if !begins_as_certificate(&bytes) {
        return Err(format!("{input}: not a certificate; {}", way(arguments)).into());
    }
    let limits = Limits {
        bytes: u64::MAX,
        ..Limits::DEFAULT
    };
    let written = match Encoding::of_path(path) {
        Some(Encoding::Cbor) => to_cbor(&bytes, &limits),
        _ => to_json(&bytes, &limits),
    };
    let written = written.map_err(|refusal| InputError {
        message: format!("{input}: {} [{}] {refusal}", refusal.kind(), refusal.code()),
        outcome: match refusal.kind() {
            Kind::Declined => Outcome::Declined,
            _ => Outcome::Failed,
        },
    })?;
    if path == Path::new("-") {
        output.bytes(&written);
        return Ok(());
    }
    let message = |error| format!("{}: cannot be written: {error}", path.display());
    Ok(write_file(path, &written).map_err(message)?)
}

/// How a tiling comes to a certificate.
fn way(arguments: &ConvertArguments) -> String {
    let (input, path) = (&arguments.input, arguments.output.display());
    format!("`acutile certify {input} -o {path}` proves a tiling and writes its certificate")
}

fn check_target(arguments: &ConvertArguments) -> Result<(), String> {
    let path = arguments.output.as_path();
    match path == Path::new("-") || Encoding::of_path(path).is_some() {
        true => Ok(()),
        false => Err(format!(
            "{}: a certificate is written as .json or .cbor, not compressed",
            path.display()
        )),
    }
}

/// The options are about meshes and tilings.
fn check_alone(arguments: &ConvertArguments) -> Result<(), String> {
    let has_options = arguments.param.is_some()
        || arguments.to.is_some()
        || !arguments.supercell.is_empty()
        || arguments.patch.is_some()
        || arguments.round;
    match has_options {
        true => Err(format!(
            "{}: a certificate takes no options, only its encoding changes",
            arguments.input
        )),
        false => Ok(()),
    }
}
