//! `acutile cite`: BibTeX and a paragraph on methods for a certificate.

use super::extension;
use super::input::FileArguments;
use super::limits::LimitArguments;
use super::name::InputName;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_output;
use super::proved::subject_of;
use super::record::Record;
use acutile_core::refusal;
use acutile_kernel::verify;
use acutile_publish::cite::citation;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct CiteArguments {
    /// A name of the catalogue, a tiling or mesh file, a point set (CIF too), or a certificate
    #[arg(value_name = "NAME|FILE|CERTIFICATE", hide_possible_values = true)]
    pub input: InputName,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE.bib")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Writes the text; nothing is written where the input is not proved.
pub fn run(arguments: &CiteArguments, output: &mut Output) -> Outcome {
    output.document_goes_to(arguments.output.as_deref());
    match write(arguments, output) {
        Ok(sha256) => {
            let record = Record::of(Some(&arguments.input)).verdict("proved");
            output.done(record.certificate(None, &sha256))
        }
        Err(error) => output.fail(Some(&arguments.input), &error),
    }
}

/// Gives the digest of the certificate.
fn write(arguments: &CiteArguments, output: &mut Output) -> Result<String, InputError> {
    let input = &arguments.input;
    let target = arguments.output.as_deref();
    check_output(target, "-o", std::slice::from_ref(input))?;
    extension::check(target, "BibTeX", &["bib", "tex", "txt"])?;
    let limits = arguments.limits.limits();
    let subject = subject_of(input, &arguments.file, &limits, output)?;
    let mut bytes = subject.certificate();
    let verified = verify(&mut bytes, &limits).map_err(|refused| InputError {
        message: format!("{input}: {}", refusal::in_words(&refused)),
        outcome: Outcome::Declined,
    })?;
    let text = citation(&subject, &verified);
    write_bytes(target, text.as_bytes(), output)?;
    Ok(subject.sha256().to_owned())
}
