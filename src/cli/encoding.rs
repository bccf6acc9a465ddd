//! `acutile convert` for certificates: the same certificate in its other encoding.

use super::Outcome;
use super::args::{ConvertArguments, Encoding};
use super::input::InputError;
use super::output::{Output, write_file};
use crate::catalog;
use crate::certificate::cbor::is_cbor;
use crate::verifier::{Kind, Limits, to_cbor, to_json};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Whether this is about a certificate: one in CBOR, or one that is to be.
pub fn is_of_certificate(arguments: &ConvertArguments) -> bool {
    let is_file = catalog::find(&arguments.input).is_none();
    let to_cbor = Encoding::of_path(&arguments.output) == Some(Encoding::Cbor);
    is_file && (to_cbor || begins_as_cbor(Path::new(&arguments.input)))
}

fn begins_as_cbor(path: &Path) -> bool {
    let mut first = [0];
    let read = File::open(path).and_then(|mut file| file.read_exact(&mut first));
    read.is_ok() && is_cbor(&first)
}

/// Reads, transcribes, writes. What the certificate claims is not looked at.
///
/// # Errors
/// A message that names the file.
pub fn convert(arguments: &ConvertArguments, output: &mut Output) -> Result<(), InputError> {
    let (input, path) = (&arguments.input, arguments.output.as_path());
    check_alone(arguments)?;
    let bytes = std::fs::read(input).map_err(|error| format!("{input}: {error}"))?;
    let limits = Limits {
        bytes: u64::MAX,
        ..Limits::DEFAULT
    };
    let written = match Encoding::of_path(path) {
        Some(Encoding::Cbor) => to_cbor(&bytes, &limits),
        Some(Encoding::Json) => to_json(&bytes, &limits),
        None if path == Path::new("-") => to_json(&bytes, &limits),
        None => {
            let path = path.display();
            return Err(format!("{path}: a certificate is written as .json or .cbor").into());
        }
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
