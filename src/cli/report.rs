//! `acutile report`: a page to look at.

use super::Outcome;
use super::args::ReportArguments;
use super::export::write_text;
use super::output::Output;
use super::proved::{overwritten, proved};
use acutile_publish::report::page;

/// Writes the page; nothing is written where an input is not proved.
pub fn run(arguments: &ReportArguments, output: &mut Output) -> Outcome {
    if let Some(input) = overwritten(&arguments.inputs, arguments.output.as_deref()) {
        output.complain(format!("acutile: -o would overwrite the input {input}"));
        return Outcome::Failed;
    }
    let mut tilings = Vec::new();
    for input in &arguments.inputs {
        match proved(input, &arguments.file, output) {
            Ok(tiling) => tilings.push(tiling),
            Err(error) => {
                output.complain(format!("acutile: {}", error.message));
                return error.outcome;
            }
        }
    }
    write_text(arguments.output.as_deref(), &page(&tilings, None), output)
}
