//! `acutile records`: the best certified tilings, the literature, and lower bounds.

use super::extension::{self, Format};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::progress::Progress;
use super::record::Record;
use acutile_paper::records::{self, records};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct RecordsArguments {
    /// The output format. The default is that of the file name, or text
    #[arg(long, value_enum)]
    pub format: Option<RecordsFormat>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// How the table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RecordsFormat {
    Text,
    Markdown,
    Latex,
    Html,
    /// That of --json
    #[value(skip)]
    Json,
}

const FORMATS: [Format<RecordsFormat>; 5] = [
    (RecordsFormat::Text, "text", extension::TEXT),
    (RecordsFormat::Markdown, "Markdown", &["md", "markdown"]),
    (RecordsFormat::Latex, "LaTeX", &["tex"]),
    (RecordsFormat::Html, "HTML", &["html", "htm"]),
    (RecordsFormat::Json, "JSON", &["json"]),
];

/// Proves all candidates, and prints the table.
pub fn run(arguments: &RecordsArguments, output: &mut Output) -> Outcome {
    match write(arguments, output) {
        Ok(()) => Outcome::Done,
        Err(error) => output.fail(None, &error),
    }
}

fn write(arguments: &RecordsArguments, output: &mut Output) -> Result<(), InputError> {
    let path = arguments.output.as_deref();
    let asked = extension::asked(arguments.format, RecordsFormat::Json, output)?;
    let format = extension::format(path, asked, &FORMATS)?;
    let progress = Progress::of("records");
    let found = records(&|step| progress.step(step));
    drop(progress);
    let found = found.map_err(|message| InputError {
        message,
        outcome: Outcome::Refuted,
    })?;
    let text = match format {
        RecordsFormat::Text => records::text(&found),
        RecordsFormat::Markdown => records::markdown(&found),
        RecordsFormat::Latex => records::latex(&found),
        RecordsFormat::Html => records::html(&found),
        RecordsFormat::Json => {
            let record = output.record(Record::of(None).with(records::json(&found)));
            format!("{}\n", record.text())
        }
    };
    write_bytes(path, text.as_bytes(), output)
}
