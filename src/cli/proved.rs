//! Inputs of `acutile report`, `acutile appendix` and `acutile bundle`: certificates, or whatever
//! else is a tiling, which is proved first. Nothing gets past here that the kernel does not confirm.

use super::input::{self, FileArguments, TextOrMesh};
use super::named::{InputError, Named};
use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use super::refutation::Refuted;
use super::refuted_page::LISTED;
use super::report::Article;
use super::second;
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
    let named = match opened(input, options, limits, output)? {
        Opened::Proved(proved) => return Ok(*proved),
        Opened::Named(named) => named,
    };
    prove(input, &named, limits).map_err(|error| refused(input, &error))
}

/// The same; a tiling that is refuted is an article with its defects.
///
/// # Errors
/// Where it is neither proved nor refuted, a message that names the input.
pub fn shown(
    input: &str,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Article, InputError> {
    let named = match opened(input, options, limits, output)? {
        Opened::Proved(proved) => return Ok(Article::Proved(proved)),
        Opened::Named(named) => named,
    };
    match prove(input, &named, limits) {
        Ok(proved) => Ok(Article::Proved(Box::new(proved))),
        Err(error) => match *error.reason {
            proved::NotProved::Refuted(findings) => {
                let options = options_of(&named, limits);
                let second = with_dimension!(&named.tiling, AnyTiling, t => {
                    second::look(t, &findings, &options)
                });
                let refuted = Refuted {
                    second,
                    ..Refuted::of(&named, findings)
                };
                Ok(Article::Refuted(Box::new(refuted.article(&stem(input)))))
            }
            _ => Err(refused(input, &error)),
        },
    }
}

/// An input before it is proved.
enum Opened {
    Proved(Box<Proved>),
    Named(Box<Named>),
}

/// Why nothing is shown as proved.
pub fn refused(input: &str, error: &NotProved) -> InputError {
    InputError {
        message: format!("{input}: {error}"),
        outcome: outcome(&error.reason),
    }
}

fn opened(
    input: &str,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Opened, InputError> {
    let is_file = catalog::find(input).is_none() && (input == "-" || Path::new(input).exists());
    let named = match is_file {
        false => input::tiling(input, None, options, output)?,
        true => match input::text_or_mesh(Path::new(input), &options.mesh)? {
            TextOrMesh::Certificate(bytes) => {
                return Proved::of_certificate(stem(input), String::new(), &bytes, limits)
                    .map(|proved| Opened::Proved(Box::new(proved)))
                    .map_err(|error| refused(input, &error));
            }
            other => input::of_content(input, other, options, output)?,
        },
    };
    Ok(Opened::Named(Box::new(named)))
}

fn prove(input: &str, named: &Named, limits: &Limits) -> Result<Proved, NotProved> {
    let name = match catalog::find(input) {
        Some(_) => named.name.clone(),
        None => stem(input),
    };
    let options = options_of(named, limits);
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    let description = named.description.clone();
    Proved::of_tiling(name, description, &named.tiling, &options, &step)
}

fn options_of(named: &Named, limits: &Limits) -> checker::Options {
    checker::Options {
        limits: limits.clone(),
        sides: named.sides.clone(),
        defect_limit: LISTED,
        ..checker::Options::default()
    }
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
pub fn stem(path: &str) -> String {
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
