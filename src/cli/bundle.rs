//! `acutile bundle`: an archive to deposit.

use super::input::FileArguments;
use super::limits::LimitArguments;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_file};
use super::proved::{overwritten, proved, subject};
use super::words::one_line;
use acutile_publish::bundle::metadata::{Author, Deposit, Doi, licence};
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
    /// The title of the data set; without it one made of the names of the tilings
    #[arg(long, value_name = "TITLE", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    pub title: Option<String>,
    /// An author of the data set, once for each; without one CITATION.cff names acutile alone
    #[arg(long = "author", value_name = "FAMILY, GIVEN <ORCID>")]
    pub authors: Vec<Author>,
    /// The licence of the data, an SPDX identifier like CC-BY-4.0
    #[arg(long, value_name = "SPDX", value_parser = licence)]
    pub licence: Option<String>,
    /// The DOI of the archive, where it is reserved
    #[arg(long, value_name = "DOI")]
    pub doi: Option<Doi>,
    /// The DOI of the paper that the archive supplements
    #[arg(long, value_name = "DOI")]
    pub paper: Option<Doi>,
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
        deposit: Deposit {
            title: arguments.title.clone(),
            authors: arguments.authors.clone(),
            licence: arguments.licence.clone(),
            doi: arguments.doi.clone(),
            paper: arguments.paper.clone(),
        },
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
