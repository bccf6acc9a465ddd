//! Inputs of `acutile report`, `acutile appendix`, `acutile bundle` and `acutile cite`. An input is read once. Whatever is no certificate
//! is proved first, so that there is one. Nothing gets past here that the kernel does not confirm.

use super::article::Article;
use super::family;
use super::input::{self, FileArguments, Loaded, Read, is_theorem};
use super::name::InputName;
use super::named::{InputError, Named, NamedFamily};
use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use super::refutation::{LISTED, Refuted};
use super::refuted_page;
use super::second;
use acutile_catalog as catalog;
use acutile_core::checker::Options;
use acutile_core::family::{AnyFamily, ProvedFamily, prove as prove_family};
use acutile_core::patches::{self, System, Theorem};
use acutile_core::proved::in_words;
use acutile_core::with_dimension;
use acutile_core::{format, proved, with_family};
use acutile_kernel::{Kind, Limits};
use acutile_publish::appendix::Subject;
use acutile_publish::bundle::{Content, Piece};
use acutile_publish::report::{self, NotProved, Proved, Refutation};

/// An input before the kernel has confirmed it.
enum Source {
    /// A certificate of any kind, with a description of what it is about.
    Certificate(String, Vec<u8>),
    Tiling(Box<Named>),
    /// A family with a member that is none.
    Refuted(Box<Refuted>),
}

/// Reads an input. Families and systems of patches become their certificates.
fn source(
    input: &InputName,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Source, InputError> {
    if let Some(entry) = catalog::theorem(input) {
        let bytes = certificate_of_system(input, entry, limits)?;
        return Ok(Source::Certificate(entry.description.to_owned(), bytes));
    }
    match input::read(input, None, options, output)? {
        Read::Certificate(bytes) => Ok(Source::Certificate(String::new(), bytes)),
        Read::Loaded(Loaded::Family(named)) => of_family(input, named, limits),
        Read::Loaded(loaded) => {
            let named = loaded.tiling(input, options, output)?;
            Ok(Source::Tiling(Box::new(named)))
        }
    }
}

/// A certificate that the kernel has confirmed, with its subject.
enum Confirmed {
    Tiling(Box<Proved>),
    Family(Box<ProvedFamily>, Box<AnyFamily>),
    System(Box<Theorem>, Box<System>),
}

impl Confirmed {
    /// The certificate of a tiling, a family or a system of patches.
    fn of(
        input: &InputName,
        description: &str,
        bytes: &[u8],
        limits: &Limits,
    ) -> Result<Confirmed, NotProved> {
        // A certificate that cannot be read is refused as that of a tiling.
        let cbor = format::to_cbor(bytes).unwrap_or_default();
        if is_theorem(&cbor) {
            let (theorem, system) = Theorem::of_certificate(bytes, limits)?;
            return Ok(Confirmed::System(Box::new(theorem), Box::new(system)));
        }
        if format::kind(&cbor) == Some(format::FAMILY) {
            let (proved, family) = ProvedFamily::of_certificate(bytes, limits)?;
            return Ok(Confirmed::Family(Box::new(proved), Box::new(family)));
        }
        Proved::of_certificate(title(input), description.to_owned(), bytes, limits)
            .map(|proved| Confirmed::Tiling(Box::new(proved)))
    }

    fn content(self, input: &InputName, description: String) -> Content {
        let name = title(input);
        let theorem = match self {
            Confirmed::Tiling(proved) => return Content::Tiling(proved),
            Confirmed::Family(proved, family) => {
                report::Theorem::of_family(name, description, &proved, *family)
            }
            Confirmed::System(theorem, system) => {
                report::Theorem::of_system(name, description, &theorem, *system)
            }
        };
        let letters = catalog::theorem(input).map_or("", |entry| entry.letters);
        Content::Theorem(Box::new(theorem.with_letters(letters)))
    }

    fn subject(&self, input: &InputName, description: String) -> Subject {
        let name = title(input);
        let subject = match self {
            Confirmed::Tiling(proved) => Subject::of_proved(proved),
            Confirmed::Family(proved, family) => {
                Subject::of_family(name, description, proved, (**family).clone())
            }
            Confirmed::System(theorem, system) => {
                let words = in_words(theorem.verified());
                Subject::of_system(name, description, theorem, (**system).clone(), words)
            }
        };
        with_source(input, subject)
    }
}

/// The article of a page about an input. A refuted input and a rejected certificate have articles, too.
///
/// # Errors
/// Where it is neither proved nor refuted, a message that names the input.
pub fn shown(
    input: &InputName,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Article, InputError> {
    let named = match source(input, options, limits, output)? {
        Source::Certificate(description, bytes) => {
            return article(input, description, &bytes, limits);
        }
        Source::Refuted(refuted) => {
            return Ok(Article::Refuted(Box::new(refuted.article(&title(input)))));
        }
        Source::Tiling(named) => named,
    };
    let error = match prove(input, &named, limits) {
        Ok(proved) => return Ok(Article::Confirmed(Content::Tiling(Box::new(proved)))),
        Err(error) => error,
    };
    let proved::NotProved::Refuted(findings) = *error.reason else {
        return Err(refused(input, &error));
    };
    let options = options_of(&named, limits);
    let second = with_dimension!(&named.tiling, AnyTiling, t => {
        second::look(t, &findings, &options)
    });
    let refuted = Refuted {
        second,
        ..Refuted::of(&named, findings)
    };
    Ok(Article::Refuted(Box::new(refuted.article(&title(input)))))
}

/// The article of a page about a certificate.
///
/// # Errors
/// Where the kernel neither confirms nor rejects it, or it describes no tiling, a message that names the input.
pub fn article(
    input: &InputName,
    description: String,
    bytes: &[u8],
    limits: &Limits,
) -> Result<Article, InputError> {
    match Confirmed::of(input, &description, bytes, limits) {
        Ok(confirmed) => Ok(Article::Confirmed(confirmed.content(input, description))),
        Err(error) => match rejected(input, bytes, &error) {
            Some(refutation) => Ok(Article::Refuted(Box::new(refutation))),
            None => Err(refused(input, &error)),
        },
    }
}

/// The article of a certificate that the kernel rejects, if it describes a tiling.
fn rejected(input: &InputName, bytes: &[u8], error: &NotProved) -> Option<Refutation> {
    match &*error.reason {
        proved::NotProved::Unconfirmed(refused)
            if refused.refusal.code.kind() == Kind::Rejected =>
        {
            refuted_page::refused(title(input), bytes, &refused.refusal)
        }
        _ => None,
    }
}

/// The subject of an appendix: a construction of the catalogue, a file that is proved first, or a
/// certificate. Families and theorems about all members of a family are taken, too.
///
/// # Errors
/// A message that names the input.
pub fn subject_of(
    input: &InputName,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Subject, InputError> {
    let (description, confirmed) = confirmed(input, options, limits, output)?;
    Ok(confirmed.subject(input, description))
}

/// The part of an archive about an input: the result of [`subject_of`], and the content of the page.
///
/// # Errors
/// A message that names the input.
pub fn piece(
    input: &InputName,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<Piece, InputError> {
    let (description, confirmed) = confirmed(input, options, limits, output)?;
    Ok(Piece {
        subject: confirmed.subject(input, description.clone()),
        content: confirmed.content(input, description),
    })
}

/// The confirmed certificate of an input, and its description.
fn confirmed(
    input: &InputName,
    options: &FileArguments,
    limits: &Limits,
    output: &mut Output,
) -> Result<(String, Confirmed), InputError> {
    let (description, confirmed) = match source(input, options, limits, output)? {
        Source::Certificate(description, bytes) => {
            let confirmed = Confirmed::of(input, &description, &bytes, limits);
            (description, confirmed)
        }
        Source::Refuted(refuted) => {
            let point = refuted.point.unwrap_or_default();
            let message = format!("{input}: refuted at {point}; certify lists the defects");
            let outcome = Outcome::Refuted;
            return Err(InputError { message, outcome });
        }
        Source::Tiling(named) => {
            let proved = prove(input, &named, limits);
            (
                named.description,
                proved.map(|proved| Confirmed::Tiling(Box::new(proved))),
            )
        }
    };
    let confirmed = confirmed.map_err(|error| refused(input, &error))?;
    Ok((description, confirmed))
}

fn with_source(input: &str, subject: Subject) -> Subject {
    match catalog::find(input) {
        Some(entry) => subject.from_source(entry.source),
        None => subject,
    }
}

/// Why nothing is shown as proved.
fn refused(input: &str, error: &NotProved) -> InputError {
    InputError {
        message: format!("{input}: {error}"),
        outcome: outcome(&error.reason),
    }
}

fn prove(input: &InputName, named: &Named, limits: &Limits) -> Result<Proved, NotProved> {
    let options = options_of(named, limits);
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    let description = named.description.clone();
    Proved::of_tiling(title(input), description, &named.tiling, &options, &step)
}

fn options_of(named: &Named, limits: &Limits) -> Options {
    Options {
        limits: limits.clone(),
        sides: named.sides.clone(),
        defect_limit: LISTED,
        ..Options::default()
    }
}

fn certificate_of_system(
    input: &InputName,
    entry: &catalog::Theorem,
    limits: &Limits,
) -> Result<Vec<u8>, InputError> {
    let system = (entry.system)().map_err(|error| format!("{input}: {error}"))?;
    let theorem = patches::prove(&system, limits).map_err(|error| refused(input, &error.into()))?;
    Ok(theorem.certificate().to_vec())
}

fn of_family(input: &InputName, named: NamedFamily, limits: &Limits) -> Result<Source, InputError> {
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    let stated = catalog::find(input).map_or(Ok(Vec::new()), |entry| entry.requirements());
    let settings = Options {
        required: stated.map_err(|message| format!("{input}: {message}"))?,
        limits: limits.clone(),
        ..Options::default()
    };
    match with_family!(&named.family, f => prove_family(f, &settings, &step)) {
        Ok(proved) => {
            let bytes = proved.certificate().to_vec();
            Ok(Source::Certificate(named.description, bytes))
        }
        Err(error) => family::refuted(&named.family, input, error)
            .map(|refuted| Source::Refuted(Box::new(refuted))),
    }
}

/// The title of an input: a name of the catalogue, or the name of a file. Readers of a page need not know
/// the folder of the file.
pub fn title(input: &InputName) -> String {
    let path = input.path();
    match path.file_stem() {
        _ if input.is_standard_input() => "standard input".to_owned(),
        Some(stem) if !is_catalogued(input) => stem.to_string_lossy().into_owned(),
        _ => input.to_string(),
    }
}

fn is_catalogued(input: &InputName) -> bool {
    catalog::find(input).is_some() || catalog::theorem(input).is_some()
}

/// How a command ends that needs a proof.
pub fn outcome(error: &proved::NotProved) -> Outcome {
    match error {
        proved::NotProved::Refuted(_) => Outcome::Refuted,
        proved::NotProved::Unconfirmed(refused) => match refused.refusal.code.kind() {
            Kind::Rejected => Outcome::Refuted,
            Kind::Malformed => Outcome::Failed,
            Kind::Declined => Outcome::Declined,
        },
        proved::NotProved::Json(error) if !error.code.is_declined() => Outcome::Failed,
        proved::NotProved::Io(_) => Outcome::Failed,
        _ => Outcome::Declined,
    }
}
