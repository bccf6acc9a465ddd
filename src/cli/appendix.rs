//! `acutile appendix`: certificates, or constructions proved on the spot, as a LaTeX
//! appendix in a directory.
//!
//! A directory that is there is added to. A file in it is replaced only where it is what some
//! `acutile appendix` wrote and nobody has changed since, or where `--force` is given; that is looked
//! at for all files before the first is written.

use super::args::{AppendixArguments, FileArguments};
use super::output::{Output, write_files};
use super::progress::Progress;
use super::{Outcome, exit_outcome, input};
use crate::appendix::{self, File, NotASubject, Options, Subject, is_unchanged};
use crate::catalog;
use crate::certificate;
use crate::checker;
use crate::tiling::Tiling;
use crate::verifier::{Kind, Limits};
use crate::with_dimension;
use std::path::{Path, PathBuf};

type Failure = (String, Outcome);

/// Writes the appendix; nothing is written unless everything asked for is proved.
pub fn run(arguments: &AppendixArguments, output: &mut Output) -> Outcome {
    match write(arguments) {
        Ok(count) => {
            let place = arguments.output.display();
            output.line(format!(
                "{place}: {count} files; pdflatex main, three times"
            ));
            Outcome::Done
        }
        Err((message, outcome)) => {
            output.complain(format!("acutile: {message}"));
            outcome
        }
    }
}

fn write(arguments: &AppendixArguments) -> Result<usize, Failure> {
    let mut inputs: Vec<&str> = Vec::new();
    let given = arguments.inputs.iter().map(String::as_str);
    let all: Vec<&str> = catalog::names().filter(|_| arguments.all).collect();
    for input in given.chain(all) {
        if !inputs.contains(&input) {
            inputs.push(input);
        }
    }
    let subjects = subjects(&inputs, &arguments.file)?;
    check_different(&subjects)?;
    let options = Options {
        siunitx: arguments.siunitx,
    };
    let files = appendix::appendix(&subjects, &options);
    write_into(&arguments.output, &files, arguments.force)
        .map_err(|message| (message, Outcome::Failed))?;
    Ok(files.len())
}

/// The subjects of all inputs, several at a time; the first failure in their order.
fn subjects(inputs: &[&str], options: &FileArguments) -> Result<Vec<Subject>, Failure> {
    let next = std::sync::atomic::AtomicUsize::new(0);
    let found = std::sync::Mutex::new(std::collections::BTreeMap::new());
    let work = || {
        loop {
            let index = next.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            let Some(input) = inputs.get(index) else {
                break;
            };
            let subject = subject(input, options);
            if let Ok(mut found) = found.lock() {
                found.insert(index, subject);
            }
        }
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 1..workers {
            scope.spawn(work);
        }
        work();
    });
    found
        .into_inner()
        .unwrap_or_default()
        .into_values()
        .collect()
}

/// Two subjects of one name would be written to the same files.
fn check_different(subjects: &[Subject]) -> Result<(), Failure> {
    for (index, subject) in subjects.iter().enumerate() {
        if let Some(other) = subjects[..index]
            .iter()
            .find(|o| o.slug() == subject.slug())
        {
            let message = format!(
                "{} and {} would both be written to {}",
                other.name,
                subject.name,
                subject.certificate_path()
            );
            return Err((message, Outcome::Failed));
        }
    }
    Ok(())
}

/// The first defect in words.
fn first<const D: usize>(tiling: &Tiling<D>, refutation: &checker::Refutation) -> String {
    let names = checker::Names::of(tiling);
    let first = refutation.kept().first();
    first.map_or(String::new(), |defect| {
        checker::describe::<D>(&names, defect)
    })
}

/// A construction of the catalogue, or a tiling file, proved; or a certificate.
fn subject(input: &str, options: &FileArguments) -> Result<Subject, Failure> {
    if catalog::find(input).is_none()
        && let Some(bytes) = certificate_bytes(input)
    {
        let stem = Path::new(input).file_stem().map(|s| s.to_string_lossy());
        let name = stem.as_deref().unwrap_or("tiling");
        return Subject::of_certificate(name, "", bytes, &Limits::DEFAULT)
            .map_err(|error| refused(input, error));
    }
    let mut output = Output::standard();
    let named = input::tiling(input, None, options, &mut output)
        .map_err(|error| (error.message, error.outcome))?;
    let bytes = with_dimension!(&named.tiling, AnyTiling, tiling => {
        let progress = Progress::of(input);
        checker::prove(tiling, &checker::Options::default(), &|step| progress.step(step))
            .map_err(|refutation| (format!("{input}: refuted: {}", first(tiling, &refutation)), Outcome::Refuted))
            .map(|certificate| certificate::to_bytes(&certificate))
    })?;
    // Its size is no reason to doubt what was proved here.
    let limits = Limits {
        bytes: u64::MAX,
        simplices: usize::MAX,
        ..Limits::DEFAULT
    };
    let entry = catalog::find(input);
    let name = match entry {
        Some(_) => input.to_owned(),
        None => Path::new(input)
            .file_stem()
            .map_or_else(|| "tiling".to_owned(), |s| s.to_string_lossy().into_owned()),
    };
    let subject = Subject::of_certificate(&name, &named.description, bytes, &limits)
        .map_err(|error| refused(input, error))?;
    Ok(match entry {
        Some(entry) => subject.from_source(entry.source),
        None => subject,
    })
}

/// The bytes of a file that begins as certificates do.
fn certificate_bytes(input: &str) -> Option<Vec<u8>> {
    let bytes = match input {
        "-" => return None,
        path => std::fs::read(path).ok()?,
    };
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]).into_owned();
    start.contains(certificate::FORMAT).then_some(bytes)
}

fn refused(input: &str, error: NotASubject) -> Failure {
    let outcome = match error.kind {
        Some(Kind::False) => exit_outcome(1),
        Some(Kind::Malformed) => exit_outcome(2),
        Some(Kind::Declined) | None => exit_outcome(3),
    };
    (format!("{input}: {}", error.message), outcome)
}

fn write_into(directory: &Path, files: &[File], force: bool) -> Result<(), String> {
    let targets: Vec<(PathBuf, &[u8])> = files
        .iter()
        .map(|file| (directory.join(&file.path), file.bytes.as_slice()))
        .collect();
    for (path, bytes) in &targets {
        check_replaceable(path, bytes, force)?;
    }
    let unwritten = |path: &Path, error| format!("{}: cannot be written: {error}", path.display());
    for parent in targets.iter().filter_map(|(path, _)| path.parent()) {
        std::fs::create_dir_all(parent).map_err(|error| unwritten(parent, error))?;
    }
    write_files(&targets).map_err(|(path, error)| unwritten(&path, error))
}

/// A foreign file, or one that was edited, stays.
fn check_replaceable(path: &Path, bytes: &[u8], force: bool) -> Result<(), String> {
    let Ok(metadata) = path.symlink_metadata() else {
        return Ok(());
    };
    if !metadata.is_file() {
        return Err(format!(
            "{}: is there and is no ordinary file",
            path.display()
        ));
    }
    if force {
        return Ok(());
    }
    let found = std::fs::read(path).unwrap_or_default();
    match found == bytes || is_unchanged(&found) {
        true => Ok(()),
        false => Err(format!(
            "{}: is there and is not what acutile appendix wrote; --force replaces it",
            path.display()
        )),
    }
}
