//! `acutile report`: a page to look at.

use super::Outcome;
use super::args::ReportArguments;
use super::export::write_text;
use super::input::{self, InputError};
use super::output::Output;
use crate::catalog;
use crate::front::one_line;
use crate::import::read_text;
use crate::report::{NotProved, Proved, page};
use crate::verifier::{Kind, Limits};
use std::path::Path;

/// Writes the page; nothing is written where an input is not proved.
pub fn run(arguments: &ReportArguments, output: &mut Output) -> Outcome {
    let mut tilings = Vec::new();
    for input in &arguments.inputs {
        match proved(input) {
            Ok(tiling) => tilings.push(tiling),
            Err(error) => {
                output.complain(format!("acutile: {}", one_line(&error.message)));
                return error.outcome;
            }
        }
    }
    write_text(arguments.output.as_deref(), &page(&tilings, None), output)
}

/// A certificate that the kernel confirms: a file, or that of a tiling which is proved first.
fn proved(input: &str) -> Result<Proved, InputError> {
    let refused = |error: NotProved| InputError {
        message: format!("{input}: {error}"),
        outcome: outcome(&error),
    };
    if let Some(bytes) = certificate_file(input)? {
        let stem = Path::new(input).file_stem().unwrap_or_default();
        let name = stem.to_string_lossy().into_owned();
        let description = catalog::find(&name).map_or("", |entry| entry.description);
        return Proved::of_certificate(name, description.to_owned(), bytes, &Limits::DEFAULT)
            .map_err(refused);
    }
    let named = input::tiling(input, None)?;
    Proved::of_tiling(named.name, named.description, &named.tiling).map_err(refused)
}

/// The bytes of a certificate; `None` for everything that says it is something else.
fn certificate_file(input: &str) -> Result<Option<Vec<u8>>, InputError> {
    if catalog::find(input).is_some() || input == "-" || !Path::new(input).exists() {
        return Ok(None);
    }
    let text = read_text(Path::new(input)).map_err(|error| format!("{input}: {error}"))?;
    let is_certificate = text.contains("\"acutile-certificate\"");
    Ok(is_certificate.then(|| text.into_bytes()))
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
