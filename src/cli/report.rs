//! `acutile report`: a page to look at.

use super::input::FileArguments;
use super::limits::LimitArguments;
use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::proved::{overwritten, proved};
use acutile_publish::report::page;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Certificates, names of the catalogue, tiling or mesh files, or point sets (CIF too)
    #[arg(value_name = "CERT|NAME|FILE", required = true)]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write the page here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Writes the page; nothing is written where an input is not proved.
pub fn run(arguments: &ReportArguments, output: &mut Output) -> Outcome {
    if let Some(input) = overwritten(&arguments.inputs, arguments.output.as_deref()) {
        output.complain(format!("acutile: -o would overwrite the input {input}"));
        return Outcome::Failed;
    }
    let limits = arguments.limits.limits();
    let mut tilings = Vec::new();
    for input in &arguments.inputs {
        match proved(input, &arguments.file, &limits, output) {
            Ok(tiling) => tilings.push(tiling),
            Err(error) => {
                output.complain(format!("acutile: {}", error.message));
                return error.outcome;
            }
        }
    }
    write_text(arguments.output.as_deref(), &page(&tilings, None), output)
}
