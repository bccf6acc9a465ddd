//! Inputs of `acutile report`, `acutile appendix` and `acutile bundle`: certificates, or whatever
//! else is a tiling, which is proved first. Nothing gets past here that the kernel does not confirm.

use super::input::{self, FileArguments};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use acutile_catalog as catalog;
use acutile_format1::certificate::{self, cbor::is_cbor};
use acutile_format1::verifier::{Kind, Limits, to_json};
use acutile_io::import::{BYTE_LIMIT, read_bytes};
use acutile_publish::appendix::Subject;
use acutile_publish::report::{NotProved, Proved};
use serde::Deserialize;
use std::path::Path;

/// A certificate that the kernel confirms: a file, or that of a tiling which is proved first.
///
/// # Errors
/// A message that names the input.
pub fn proved(
    input: &str,
    options: &FileArguments,
    output: &mut Output,
) -> Result<Proved, InputError> {
    let refused = |error| refused(input, &error);
    if let Some(bytes) = certificate_file(input)? {
        let json = match is_cbor(&bytes) {
            true => transcribed(input, &bytes)?,
            false => bytes,
        };
        return Proved::of_certificate(stem(input), String::new(), json, &Limits::DEFAULT)
            .map_err(refused);
    }
    let named = input::tiling(input, None, options, output)?;
    let name = match catalog::find(input) {
        Some(_) => named.name,
        None => stem(input),
    };
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    Proved::of_tiling(name, named.description, &named.tiling, &step).map_err(refused)
}

fn refused(input: &str, error: &NotProved) -> InputError {
    InputError {
        message: format!("{input}: {error}"),
        outcome: outcome(error),
    }
}

/// A certificate in CBOR as JSON, for pages and their verifier read that.
fn transcribed(input: &str, bytes: &[u8]) -> Result<Vec<u8>, InputError> {
    let limits = Limits::DEFAULT;
    let json =
        to_json(bytes, &limits).map_err(|refusal| refused(input, &NotProved::Refused(refusal)))?;
    check_size(input, json.len() as u64, limits.bytes)?;
    Ok(json)
}

/// The limit is that of a file, and its JSON is not the file that was named.
fn check_size(input: &str, size: u64, limit: u64) -> Result<(), InputError> {
    match size <= limit {
        true => Ok(()),
        false => Err(InputError {
            message: format!(
                "{input}: declined [too-many-bytes] the certificate has {size} bytes in JSON, which this command needs; the limit is {limit}"
            ),
            outcome: Outcome::Declined,
        }),
    }
}

/// What an appendix can say of it, with the place that the catalogue names; nothing for a region.
pub fn subject(input: &str, proved: &Proved) -> Option<Subject> {
    let subject = Subject::of_proved(proved)?;
    Some(match catalog::find(input) {
        Some(entry) => subject.from_source(entry.source),
        None => subject,
    })
}

/// The input that would be replaced by what is written to `target`.
pub fn overwritten<'i>(inputs: &'i [String], target: Option<&Path>) -> Option<&'i String> {
    let target = target?.canonicalize().ok()?;
    let is_target = |input: &&String| Path::new(input).canonicalize().is_ok_and(|p| p == target);
    inputs.iter().find(is_target)
}

/// The name of a file; readers of a page need not know in whose folder it was.
fn stem(path: &str) -> String {
    let stem = Path::new(path).file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// The bytes of a certificate, in either encoding; `None` for everything that says it is something else.
fn certificate_file(input: &str) -> Result<Option<Vec<u8>>, InputError> {
    if catalog::find(input).is_some() || input == "-" || !Path::new(input).exists() {
        return Ok(None);
    }
    let bytes =
        read_bytes(Path::new(input), BYTE_LIMIT).map_err(|error| format!("{input}: {error}"))?;
    if is_cbor(&bytes) {
        return Ok(Some(bytes));
    }
    let Ok(text) = str::from_utf8(&bytes) else {
        return Ok(None);
    };
    let is_certificate = match serde_json::from_str::<Header>(text) {
        Ok(header) => header.format == certificate::FORMAT,
        // The kernel says best what is wrong with half a certificate.
        Err(_) => text.contains(certificate::FORMAT),
    };
    Ok(is_certificate.then_some(bytes))
}

/// What says of a file what it is.
#[derive(Deserialize)]
struct Header {
    format: String,
}

fn outcome(error: &NotProved) -> Outcome {
    match error {
        NotProved::Refuted(_) => Outcome::Refuted,
        NotProved::Refused(refusal) => match refusal.kind() {
            Kind::False => Outcome::Refuted,
            Kind::Malformed => Outcome::Failed,
            Kind::Declined => Outcome::Declined,
        },
        NotProved::Unreadable(_) => Outcome::Declined,
    }
}
