//! `acutile report`: a page to look at.

use super::Outcome;
use super::args::{FileArguments, ReportArguments};
use super::export::write_text;
use super::input::{self, InputError};
use super::output::Output;
use crate::catalog;
use crate::certificate;
use crate::front::one_line;
use crate::import::{BYTE_LIMIT, read_bytes};
use crate::report::{NotProved, Proved, page};
use crate::verifier::{Kind, Limits};
use serde::Deserialize;
use std::path::Path;

/// Writes the page; nothing is written where an input is not proved.
pub fn run(arguments: &ReportArguments, output: &mut Output) -> Outcome {
    if let Some(input) = overwritten(arguments) {
        output.complain(format!("acutile: -o would overwrite the input {input}"));
        return Outcome::Failed;
    }
    let mut tilings = Vec::new();
    for input in &arguments.inputs {
        match proved(input, &arguments.file, output) {
            Ok(tiling) => tilings.push(tiling),
            Err(error) => {
                output.complain(format!("acutile: {}", one_line(&error.message)));
                return error.outcome;
            }
        }
    }
    write_text(arguments.output.as_deref(), &page(&tilings, None), output)
}

/// The input that the page would replace.
fn overwritten(arguments: &ReportArguments) -> Option<&String> {
    let target = arguments.output.as_ref()?.canonicalize().ok()?;
    let is_target = |input: &&String| Path::new(input).canonicalize().is_ok_and(|p| p == target);
    arguments.inputs.iter().find(is_target)
}

/// A certificate that the kernel confirms: a file, or that of a tiling which is proved first.
fn proved(input: &str, options: &FileArguments, output: &mut Output) -> Result<Proved, InputError> {
    let refused = |error: NotProved| InputError {
        message: format!("{input}: {error}"),
        outcome: outcome(&error),
    };
    if let Some(bytes) = certificate_file(input)? {
        // What the file is called says nothing of what it proves.
        let description = "the certificate in a file of this name".to_owned();
        return Proved::of_certificate(stem(input), description, bytes, &Limits::DEFAULT)
            .map_err(refused);
    }
    let named = input::tiling(input, None, options, output)?;
    let name = match catalog::find(input) {
        Some(_) => named.name,
        None => stem(input),
    };
    Proved::of_tiling(name, named.description, &named.tiling).map_err(refused)
}

/// The name of a file; readers of a page need not know in whose folder it was.
fn stem(path: &str) -> String {
    let stem = Path::new(path).file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// The bytes of a certificate; `None` for everything that says it is something else.
fn certificate_file(input: &str) -> Result<Option<Vec<u8>>, InputError> {
    if catalog::find(input).is_some() || input == "-" || !Path::new(input).exists() {
        return Ok(None);
    }
    let bytes =
        read_bytes(Path::new(input), BYTE_LIMIT).map_err(|error| format!("{input}: {error}"))?;
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
