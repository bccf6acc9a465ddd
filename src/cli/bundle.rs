//! `acutile bundle`: an archive to deposit.

use super::input::FileArguments;
use super::limits::LimitArguments;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_file};
use super::proved::{overwritten, proved, subject};
use super::words::one_line;
use acutile_publish::bundle::{Options, Piece, archive, bundle};
use clap::Args;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct BundleArguments {
    /// Certificates, names of the catalogue, tiling or mesh files, or point sets (CIF too)
    #[arg(value_name = "CERT|NAME|FILE", required = true)]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Leave out the PDF, even if there is TeX
    #[arg(long)]
    pub no_pdf: bool,
    /// Write the archive here (`-` for standard output)
    #[arg(short, long, value_name = "FILE.zip")]
    pub output: PathBuf,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Writes the archive; nothing is written where an input is not proved.
pub fn run(arguments: &BundleArguments, output: &mut Output) -> Outcome {
    match write(arguments, output) {
        Ok(()) => Outcome::Done,
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            error.outcome
        }
    }
}

fn write(arguments: &BundleArguments, output: &mut Output) -> Result<(), InputError> {
    let target = arguments.output.as_path();
    if let Some(input) = overwritten(&arguments.inputs, Some(target)) {
        return Err(format!("-o would overwrite the input {input}").into());
    }
    let limits = arguments.limits.limits();
    let mut pieces = Vec::new();
    for input in &arguments.inputs {
        let proved = proved(input, &arguments.file, &limits, output)?;
        let subject = subject(input, &proved);
        pieces.push(Piece { proved, subject });
    }
    let options = Options {
        pdf: !arguments.no_pdf,
    };
    let bundle = bundle(pieces, &options)?;
    let bytes = archive(&bundle.files)?;
    for note in bundle.notes {
        output.complain(format!("acutile: {}", one_line(&note)));
    }
    if target == Path::new("-") {
        output.bytes(&bytes);
        return Ok(());
    }
    write_file(target, &bytes)
        .map_err(|error| format!("{}: cannot be written: {error}", target.display()).into())
}
