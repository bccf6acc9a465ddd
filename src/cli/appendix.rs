//! `acutile appendix`: certificates, or constructions proved on the spot, as a LaTeX
//! appendix in a directory.
//!
//! A directory that is there is added to. A file in it is replaced only if `acutile appendix` wrote it and
//! nobody has changed it since, or with `--force`. All files are checked before the first is written.

use super::files::{check_directory, unwritten, write_files};
use super::input::FileArguments;
use super::limits::LimitArguments;
use super::name::InputName;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::overwriting::{check_not_an_input, check_replaceable};
use super::proved;
use super::record::Record;
use super::words::printable;
use acutile_catalog as catalog;
use acutile_publish::appendix::{self, File, Options, Subject, is_unchanged};
use clap::Args;
use rayon::prelude::*;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct AppendixArguments {
    /// Certificates, names of the catalogue, tiling files, or point sets (CIF too)
    #[arg(
        value_name = "CERT|NAME|FILE",
        required_unless_present = "all",
        hide_possible_values = true
    )]
    pub inputs: Vec<InputName>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write about the whole catalogue
    #[arg(long)]
    pub all: bool,
    /// Write the files into this directory
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Replace existing files, even if acutile did not write them or they were edited
    #[arg(long)]
    pub force: bool,
    /// Print decimals with the package siunitx
    #[arg(long)]
    pub siunitx: bool,
    /// Set the text in two columns, and the long tables after it in one column
    #[arg(long)]
    pub two_column: bool,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// The input that is not proved, if it is about one, and why.
type Failure = (Option<InputName>, InputError);

/// Writes the appendix; nothing is written unless everything asked for is proved.
pub fn run(arguments: &AppendixArguments, output: &mut Output) -> Outcome {
    match write(arguments, output) {
        Ok(count) => {
            let place = printable(&arguments.output);
            let words = format!("{place}: {count} files; run `pdflatex main` three times there");
            output.done_in_words(Record::of(None), words)
        }
        Err((input, error)) => output.fail(input.as_deref(), &error),
    }
}

fn write(arguments: &AppendixArguments, output: &mut Output) -> Result<usize, Failure> {
    check_directory(&arguments.output).map_err(|message| (None, message.into()))?;
    let mut inputs: Vec<InputName> = Vec::new();
    let all = catalog::names().filter(|_| arguments.all);
    let all = all.map(InputName::from);
    for input in arguments.inputs.iter().cloned().chain(all) {
        if !inputs.contains(&input) {
            inputs.push(input);
        }
    }
    let (subjects, notes): (Vec<_>, Vec<_>) = subjects(&inputs, arguments)?.into_iter().unzip();
    check_different(&subjects)?;
    let options = Options {
        siunitx: arguments.siunitx,
        two_column: arguments.two_column,
    };
    let files = appendix::appendix(&subjects, &options);
    write_into(&arguments.output, &files, &inputs, arguments.force)
        .map_err(|message| (None, message.into()))?;
    if output.is_json() {
        for ((input, subject), notes) in inputs.iter().zip(&subjects).zip(&notes) {
            let record = Record::of(Some(input)).verdict("proved").notes(notes);
            output.answer(record.certificate(None, subject.sha256()));
        }
    }
    for file in &files {
        output.wrote(&arguments.output.join(&file.path), file.bytes.len());
    }
    Ok(files.len())
}

/// The subjects of all inputs, several at a time; the first failure in their order.
fn subjects(
    inputs: &[InputName],
    arguments: &AppendixArguments,
) -> Result<Vec<(Subject, Vec<String>)>, Failure> {
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
            return Err((None, message.into()));
        }
    }
    Ok(())
}

/// A construction of the catalogue, or a tiling file, proved; or a certificate. With the notes on it.
fn subject(
    input: &InputName,
    arguments: &AppendixArguments,
) -> Result<(Subject, Vec<String>), Failure> {
    let limits = arguments.limits.limits();
    let mut output = Output::standard();
    proved::subject_of(input, &arguments.file, &limits, &mut output)
        .map(|subject| (subject, output.take_notes()))
        .map_err(|error| (Some(input.clone()), error))
}

fn write_into(
    directory: &Path,
    files: &[File],
    inputs: &[InputName],
    force: bool,
) -> Result<(), String> {
    let targets: Vec<(PathBuf, &[u8])> = files
        .iter()
        .map(|file| (directory.join(&file.path), file.bytes.as_slice()))
        .collect();
    for (path, bytes) in &targets {
        check_not_an_input(Some(path), "-o", inputs)?;
        check_replaceable(path, |found| found == *bytes || is_unchanged(found), force)?;
    }
    let unwritten = |path: &Path, error| unwritten(path, &error).message;
    for parent in targets.iter().filter_map(|(path, _)| path.parent()) {
        std::fs::create_dir_all(parent).map_err(|error| unwritten(parent, error))?;
    }
    write_files(&targets).map_err(|(path, error)| unwritten(&path, error))
}
