//! `acutile table`: the paper's Table 1, rigorously, for its rows and all others.

use super::classify::of_study;
use super::input::{self, FileArguments};
use super::outcome::Outcome;
use super::output::Output;
use acutile_catalog as catalog;
use acutile_paper::survey::{AnyStudy, Survey};
use acutile_paper::table::{self, Row};
use clap::Args;

#[derive(Debug, Args)]
pub struct TableArguments {
    /// Names of the catalogue, or tiling files; without any the whole catalogue, the
    /// paper's rows first
    #[arg(value_name = "NAME|FILE")]
    pub inputs: Vec<String>,
    /// How to write it
    #[arg(long, value_enum, default_value = "text")]
    pub format: TableFormat,
}

/// How the table is written.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum TableFormat {
    Text,
    Markdown,
    Latex,
    Csv,
    Json,
}

/// Prints the table. A construction without a row is named on standard error.
pub fn run(arguments: &TableArguments, output: &mut Output) -> Outcome {
    let wanted: Vec<&str> = match arguments.inputs.is_empty() {
        true => table::order(&catalog::names().collect::<Vec<_>>()),
        false => arguments.inputs.iter().map(String::as_str).collect(),
    };
    let (entries, _): (Vec<&str>, Vec<&str>) = wanted
        .iter()
        .partition(|name| catalog::find(name).is_some());
    let survey = Survey::of(&entries);
    let mut outcome = Outcome::Done;
    let mut rows = Vec::new();
    for name in wanted {
        match row(name, &survey, output) {
            Ok(row) => rows.push(row),
            Err((message, failure)) => {
                output.complain(format!("acutile: {message}"));
                outcome = outcome.and(failure);
            }
        }
    }
    match arguments.format {
        TableFormat::Json => output.line(table::json(&rows)),
        TableFormat::Text => output.bytes(table::text(&rows).as_bytes()),
        TableFormat::Markdown => output.bytes(table::markdown(&rows).as_bytes()),
        TableFormat::Latex => output.bytes(table::latex(&rows).as_bytes()),
        TableFormat::Csv => output.bytes(table::csv(&rows).as_bytes()),
    }
    outcome
}

fn row(name: &str, survey: &Survey, output: &mut Output) -> Result<Row, (String, Outcome)> {
    if catalog::find(name).is_some() {
        let study = survey
            .get(name)
            .map_err(|message| (message, Outcome::Refuted))?;
        return Ok(Row::of(name, study));
    }
    let named = input::tiling(name, None, &FileArguments::default(), output)
        .map_err(|error| (error.message, error.outcome))?;
    match AnyStudy::of(named.tiling) {
        Ok(study) => Ok(Row::of(name, &study)),
        Err(error) => Err((format!("{name}: {error}"), of_study(&error))),
    }
}
