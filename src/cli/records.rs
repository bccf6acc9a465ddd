//! `acutile records`: the best certified tilings, the literature, and lower bounds.

use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::progress::Progress;
use acutile_paper::records::{self, records};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct RecordsArguments {
    /// How to write it
    #[arg(long, value_enum, default_value = "text")]
    pub format: RecordsFormat,
    /// One JSON object
    #[arg(long, conflicts_with = "format")]
    pub json: bool,
    /// Write here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// How the table is written.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum RecordsFormat {
    Text,
    Markdown,
    Latex,
    Html,
}

/// Proves all candidates, and prints the table.
pub fn run(arguments: &RecordsArguments, output: &mut Output) -> Outcome {
    let progress = Progress::of("records");
    let found = records(&|step| progress.step(step));
    drop(progress);
    let found = match found {
        Ok(found) => found,
        Err(message) => {
            output.complain(format!("acutile: {message}"));
            return Outcome::Refuted;
        }
    };
    let text = match (arguments.json, arguments.format) {
        (true, _) => format!("{}\n", records::json(&found)),
        (_, RecordsFormat::Text) => records::text(&found),
        (_, RecordsFormat::Markdown) => records::markdown(&found),
        (_, RecordsFormat::Latex) => records::latex(&found),
        (_, RecordsFormat::Html) => records::html(&found),
    };
    write_text(arguments.output.as_deref(), &text, output)
}
