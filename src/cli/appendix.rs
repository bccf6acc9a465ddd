//! `acutile appendix`: certificates, or constructions proved on the spot, as a LaTeX
//! appendix in a directory.
//!
//! A directory that is there is added to. A file in it is replaced only where it is what some
//! `acutile appendix` wrote and nobody has changed since, or where `--force` is given; that is looked
//! at for all files before the first is written.

use super::input::FileArguments;
use super::limits::LimitArguments;
use super::outcome::Outcome;
use super::output::{Output, write_files};
use super::proved;
use acutile_catalog as catalog;
use acutile_publish::appendix::{self, File, Options, Subject, is_unchanged};
use clap::Args;
use rayon::prelude::*;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct AppendixArguments {
    /// Certificates, names of the catalogue, tiling files, or point sets (CIF too)
    #[arg(value_name = "CERT|NAME|FILE", required_unless_present = "all")]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// The whole catalogue
    #[arg(long)]
    pub all: bool,
    /// Write the files into this directory
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Replace files that are there, even if they are others' or were edited
    #[arg(long)]
    pub force: bool,
    /// Print decimals with the package siunitx
    #[arg(long)]
    pub siunitx: bool,
    /// Set the text in two columns, with the long tables after it in one
    #[arg(long)]
    pub two_column: bool,
    #[command(flatten)]
    pub limits: LimitArguments,
}

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
    let subjects = subjects(&inputs, arguments)?;
    check_different(&subjects)?;
    let options = Options {
        siunitx: arguments.siunitx,
        two_column: arguments.two_column,
    };
    let files = appendix::appendix(&subjects, &options);
    write_into(&arguments.output, &files, arguments.force)
        .map_err(|message| (message, Outcome::Failed))?;
    Ok(files.len())
}

/// The subjects of all inputs, several at a time; the first failure in their order.
fn subjects(inputs: &[&str], arguments: &AppendixArguments) -> Result<Vec<Subject>, Failure> {
    let found: Vec<_> = inputs
        .par_iter()
        .map(|input| subject(input, arguments))
        .collect();
    found.into_iter().collect()
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

/// A construction of the catalogue, or a tiling file, proved; or a certificate.
fn subject(input: &str, arguments: &AppendixArguments) -> Result<Subject, Failure> {
    let limits = arguments.limits.limits();
    proved::subject_of(input, &arguments.file, &limits, &mut Output::standard())
        .map_err(|error| (error.message, error.outcome))
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
