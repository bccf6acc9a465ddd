//! `acutile bundle`: an archive to deposit.

use super::extension;
use super::input::FileArguments;
use super::limits::LimitArguments;
use super::name::{InputName, check_standard_input};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_output;
use super::proved::piece;
use super::record::Record;
use acutile_publish::bundle::metadata::{Author, Deposit, Doi, licence};
use acutile_publish::bundle::{Options, Piece, archive, bundle};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct BundleArguments {
    /// Certificates, names of the catalogue, tiling or mesh files, or point sets (CIF too)
    #[arg(
        value_name = "CERT|NAME|FILE",
        required = true,
        hide_possible_values = true
    )]
    pub inputs: Vec<InputName>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Leave out the PDF of the appendix. Without it a PDF is made if pdflatex is installed
    #[arg(long)]
    pub no_pdf: bool,
    /// Add each claim as a theorem for Coq
    #[arg(long)]
    pub coq: bool,
    /// The title of the data set. The default is made of the names of the tilings
    #[arg(long, value_name = "TITLE", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    pub title: Option<String>,
    /// An author of the data set; repeat the option for each author. Without it CITATION.cff names acutile
    #[arg(long = "author", value_name = "FAMILY, GIVEN <ORCID>")]
    pub authors: Vec<Author>,
    /// The licence of the data, an SPDX identifier like CC-BY-4.0
    #[arg(long, value_name = "SPDX", value_parser = licence)]
    pub licence: Option<String>,
    /// The DOI of the archive, if one is reserved
    #[arg(long, value_name = "DOI")]
    pub doi: Option<Doi>,
    /// The DOI of the paper that the archive supplements
    #[arg(long, value_name = "DOI")]
    pub paper: Option<Doi>,
    /// Write the archive to this file (`-` for standard output)
    #[arg(short, long, value_name = "FILE.zip")]
    pub output: PathBuf,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Writes the archive; nothing is written where an input is not proved.
pub fn run(arguments: &BundleArguments, output: &mut Output) -> Outcome {
    output.document_goes_to(Some(&arguments.output));
    match write(arguments, output) {
        Ok(()) => output.done(Record::of(None)),
        Err((input, error)) => output.fail(input.map(|input| &**input), &error),
    }
}

/// The input that is not proved, if it is about one, and why.
type Failure<'a> = (Option<&'a InputName>, InputError);

fn write<'a>(arguments: &'a BundleArguments, output: &mut Output) -> Result<(), Failure<'a>> {
    let target = arguments.output.as_path();
    let failed = |error: InputError| (None, error);
    check_standard_input(arguments.inputs.iter().map(InputName::raw))
        .and_then(|()| check_output(Some(target), "-o", &arguments.inputs))
        .and_then(|()| extension::check(Some(target), "an archive", &["zip"]))
        .map_err(|message| failed(message.into()))?;
    let limits = arguments.limits.limits();
    let mut pieces = Vec::new();
    for input in &arguments.inputs {
        let piece = piece(input, &arguments.file, &limits, output);
        pieces.push(piece.map_err(|error| (Some(input), error))?);
    }
    let options = Options {
        pdf: !arguments.no_pdf,
        coq: arguments.coq,
        deposit: Deposit {
            title: arguments.title.clone(),
            authors: arguments.authors.clone(),
            licence: arguments.licence.clone(),
            doi: arguments.doi.clone(),
            paper: arguments.paper.clone(),
        },
    };
    let digest = |piece: &Piece| piece.subject.sha256().to_owned();
    let digests: Vec<String> = pieces.iter().map(digest).collect();
    let bundle = bundle(pieces, &options).map_err(|message| failed(message.into()))?;
    let bytes = archive(&bundle.files).map_err(|message| failed(message.into()))?;
    for note in bundle.notes {
        output.note("acutile", &note);
    }
    if output.is_json() {
        for (input, sha256) in arguments.inputs.iter().zip(&digests) {
            let record = Record::of(Some(input)).verdict("proved");
            output.answer(record.certificate(None, sha256));
        }
    }
    write_bytes(Some(target), &bytes, output).map_err(failed)
}
