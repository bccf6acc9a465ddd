//! Inputs of `acutile report`, `acutile appendix` and `acutile bundle`: certificates, or whatever
//! else is a tiling, which is proved first. Nothing gets past here that the kernel does not confirm.

use super::certify::in_words;
use super::input::{self, FileArguments, TextOrMesh};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use acutile_catalog as catalog;
use acutile_core::checker;
use acutile_core::proved;
use acutile_core::with_dimension;
use acutile_kernel::{Kind, Limits};
use acutile_publish::appendix::Subject;
use acutile_publish::report::{NotProved, Proved};
use std::path::Path;

/// A certificate that the kernel confirms: a file, or that of a tiling which is proved first.
///
/// # Errors
/// A message that names the input.
pub fn proved(
    input: &str,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Proved, InputError> {
    let refused = |error: NotProved| InputError {
        message: format!("{input}: {error}"),
        outcome: outcome(&error.reason),
    };
    let is_file = catalog::find(input).is_none() && (input == "-" || Path::new(input).exists());
    let named = match is_file {
        false => input::tiling(input, None, options, output)?,
        true => match input::text_or_mesh(Path::new(input), &options.mesh)? {
            TextOrMesh::Certificate(bytes) => {
                return Proved::of_certificate(stem(input), String::new(), &bytes, limits)
                    .map_err(refused);
            }
            other => input::of_content(input, other, options, output)?,
        },
    };
    if let Some(near) = named.sides.near {
        let defect = checker::Defect::NearMates(near);
        let words = with_dimension!(&named.tiling, AnyTiling, t => in_words(t, &defect));
        return Err(InputError {
            message: format!("{input}: {words}"),
            outcome: Outcome::Declined,
        });
    }
    if !named.sides.facets.is_empty() {
        return Err(InputError {
            message: format!(
                "{input}: {} facets on the sides of the periodic mesh have no mate; certify lists them",
                named.sides.facets.len()
            ),
            outcome: Outcome::Refuted,
        });
    }
    let name = match catalog::find(input) {
        Some(_) => named.name,
        None => stem(input),
    };
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    Proved::of_tiling(name, named.description, &named.tiling, limits, &step).map_err(refused)
}

/// What an appendix can say of it, with the place that the catalogue names.
pub fn subject(input: &str, proved: &Proved) -> Subject {
    let subject = Subject::of_proved(proved);
    match catalog::find(input) {
        Some(entry) => subject.from_source(entry.source),
        None => subject,
    }
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

/// How a command ends that needs a proof.
pub fn outcome(error: &proved::NotProved) -> Outcome {
    match error {
        proved::NotProved::Refuted(_) => Outcome::Refuted,
        proved::NotProved::Unconfirmed(refusal) => match refusal.code.kind() {
            Kind::Rejected => Outcome::Refuted,
            Kind::Malformed => Outcome::Failed,
            Kind::Declined => Outcome::Declined,
        },
        proved::NotProved::Json(error) if !error.code.is_declined() => Outcome::Failed,
        proved::NotProved::Io(_) => Outcome::Failed,
        _ => Outcome::Declined,
    }
}
