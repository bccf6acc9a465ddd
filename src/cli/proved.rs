//! Inputs of `acutile report`, `acutile appendix` and `acutile bundle`: certificates, or whatever
//! else is a tiling, which is proved first. Nothing gets past here that the kernel does not confirm.

use super::input::{self, FileArguments, Loaded, TextOrMesh};
use super::named::{InputError, Named};
use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use super::refutation::Refuted;
use super::refuted_page::LISTED;
use super::report::Article;
use super::second;
use super::theorem::is_theorem;
use acutile_catalog as catalog;
use acutile_core::checker;
use acutile_core::checker::Options;
use acutile_core::family::{
    self, AnyFamily, FamilyNotProved, NotProvable, ProvedFamily, point_in_words,
};
use acutile_core::patches::{self, Theorem};
use acutile_core::with_dimension;
use acutile_core::{format, proved, refusal, with_family};
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

/// What an appendix says of an input: a construction of the catalogue, a file that is proved first, or
/// a certificate. Families and theorems about all members of a family are taken, too.
///
/// # Errors
/// A message that names the input.
pub fn subject_of(
    input: &str,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Subject, InputError> {
    if let Some(found) = system_subject(input, options, limits)? {
        return Ok(found);
    }
    if let Some(found) = family_subject(input, options, limits, output)? {
        return Ok(found);
    }
    let proved = proved(input, options, limits, output)?;
    Ok(subject(input, &proved))
}

/// The subject of a system of patches; `None` where the input is something else.
fn system_subject(
    input: &str,
    options: &FileArguments,
    limits: &Limits,
) -> Result<Option<Subject>, InputError> {
    let failed = |message: String| InputError {
        message: format!("{input}: {message}"),
        outcome: Outcome::Failed,
    };
    let refused = |error: proved::NotProved| InputError {
        message: format!("{input}: {error}"),
        outcome: outcome(&error),
    };
    let (name, description, bytes) = match catalog::theorem(input) {
        Some(entry) => {
            let system = (entry.system)().map_err(|error| failed(error.to_string()))?;
            let theorem = patches::prove(&system, limits).map_err(refused)?;
            let bytes = theorem.certificate().to_vec();
            (input.to_owned(), entry.description.to_owned(), bytes)
        }
        None => match certificate(input, options)? {
            Some(bytes) => (stem(input), String::new(), bytes),
            None => return Ok(None),
        },
    };
    let cbor = match format::to_cbor(&bytes) {
        Ok(cbor) if is_theorem(&cbor) => cbor,
        _ => return Ok(None),
    };
    let read = format::patches::certificate(&cbor).map_err(|error| failed(error.to_string()))?;
    let words = patches::in_words(&read.claim).map_err(|error| failed(error.to_string()))?;
    let (theorem, system) = Theorem::of_certificate(&cbor, limits).map_err(refused)?;
    let subject = Subject::of_system(name, description, &theorem, system, words);
    Ok(Some(subject))
}

/// The subject of a family; `None` where the input is something else.
fn family_subject(
    input: &str,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Option<Subject>, InputError> {
    let bytes = certificate(input, options)?;
    let has_kind = |bytes: &&Vec<u8>, kind: &str| {
        format::to_cbor(bytes).is_ok_and(|cbor| format::kind(&cbor) == Some(kind))
    };
    let refused = |message: String, outcome: Outcome| InputError {
        message: format!("{input}: {message}"),
        outcome,
    };
    if let Some(bytes) = bytes
        .as_ref()
        .filter(|bytes| has_kind(bytes, format::FAMILY))
    {
        let (proved, family) = ProvedFamily::of_certificate(bytes, limits)
            .map_err(|error| refused(error.to_string(), outcome(&error)))?;
        let subject = Subject::of_family(stem(input), String::new(), &proved, family);
        return Ok(Some(subject));
    }
    let is_family = catalog::find(input).is_some_and(|entry| entry.build_family().is_some());
    if bytes.is_some() || !(is_family || is_text(input)) {
        return Ok(None);
    }
    let Loaded::Family(named) = input::open(input, None, options, output)? else {
        return Ok(None);
    };
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    let settings = Options {
        limits: limits.clone(),
        ..Options::default()
    };
    let proved = with_family!(&named.family, f => family::prove(f, &settings, &step))
        .map_err(|error| of_family(input, &named.family, error))?;
    let (_, read) = ProvedFamily::of_certificate(proved.certificate(), limits)
        .map_err(|error| refused(error.to_string(), outcome(&error)))?;
    let name = if is_family { named.name } else { stem(input) };
    let subject = Subject::of_family(name, named.description, &proved, read);
    Ok(Some(match catalog::find(input) {
        Some(entry) => subject.from_source(entry.source),
        None => subject,
    }))
}

/// The bytes of a certificate; `None` if the input is no file, or another one.
fn certificate(input: &str, options: &FileArguments) -> Result<Option<Vec<u8>>, InputError> {
    if catalog::find(input).is_some() || !Path::new(input).is_file() {
        return Ok(None);
    }
    Ok(
        match input::text_or_mesh(Path::new(input), &options.mesh)? {
            TextOrMesh::Certificate(bytes) => Some(bytes),
            _ => None,
        },
    )
}

/// Whether a file is a document of JSON, in which parameters can be.
fn is_text(input: &str) -> bool {
    Path::new(input).extension().is_some_and(|e| e == "json") && Path::new(input).is_file()
}

/// Why a family has no appendix.
fn of_family(input: &str, family: &AnyFamily, error: FamilyNotProved) -> InputError {
    let names = with_family!(family, f => f.names());
    let (message, outcome) = match error {
        FamilyNotProved::Prover(NotProvable::Malformed(error)) => {
            (error.to_string(), Outcome::Failed)
        }
        FamilyNotProved::Prover(NotProvable::Declined(reason)) => {
            (reason.to_string(), Outcome::Declined)
        }
        FamilyNotProved::Prover(NotProvable::Refuted { point, .. }) => (
            format!(
                "refuted at {}; certify lists the defects",
                point_in_words(&names, &point)
            ),
            Outcome::Refuted,
        ),
        FamilyNotProved::Unconfirmed(refusal) => (
            format!(
                "the kernel does not confirm the certificate: {}",
                refusal::in_words(&refusal)
            ),
            Outcome::Declined,
        ),
    };
    InputError {
        message: format!("{input}: {message}"),
        outcome,
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
