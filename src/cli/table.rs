//! `acutile table`: the paper's Table 1, rigorously, for its rows and all others.

use super::classify::of_study;
use super::input::{self, FileArguments, Loaded};
use super::name::{InputName, check_standard_input};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::record::Record;
use acutile_catalog as catalog;
use acutile_paper::survey::{AnyStudy, General, Survey};
use acutile_paper::table::{self, Row};
use clap::Args;
use serde_json::Value;

#[derive(Debug, Args)]
pub struct TableArguments {
    /// Names of the catalogue (families and theorems too) or tiling files (`-` for standard input). The default
    /// is all single tilings of the catalogue, with the rows of the paper first
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub inputs: Vec<InputName>,
    /// The output format; json is the same as --json
    #[arg(long, value_enum)]
    pub format: Option<TableFormat>,
}

/// How the table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum TableFormat {
    Text,
    Markdown,
    Latex,
    Csv,
    Json,
}

/// Prints the table. A construction without a row is named on standard error.
pub fn run(arguments: &TableArguments, output: &mut Output) -> Outcome {
    let format = match super::extension::asked(arguments.format, TableFormat::Json, output) {
        Ok(format) => format.unwrap_or(TableFormat::Text),
        Err(message) => return output.fail_with(None, message),
    };
    if let Err(message) = check_standard_input(arguments.inputs.iter().map(InputName::raw)) {
        return output.fail_with(None, message);
    }
    let wanted: Vec<InputName> = if arguments.inputs.is_empty() {
        let names: Vec<&str> = catalog::names().collect();
        let names = table::order(&names);
        names.into_iter().map(InputName::from).collect()
    } else {
        arguments.inputs.clone()
    };
    let names = wanted.iter().map(|name| &**name);
    let is_single = |name: &&str| catalog::find(name).is_some_and(|entry| !entry.has_box());
    let entries: Vec<&str> = names.filter(is_single).collect();
    let survey = Survey::of(&entries);
    let mut outcome = Outcome::Done;
    let mut rows = Vec::new();
    for name in &wanted {
        match row(name, &survey, output) {
            Ok(row) if format == TableFormat::Json => output.answer(data(name, row)),
            Ok(row) => rows.push(row),
            Err(error) => outcome = outcome.and(output.fail(Some(name), &error)),
        }
    }
    match format {
        TableFormat::Json => {}
        // Where every input failed there is no table.
        _ if rows.is_empty() => {}
        TableFormat::Text => output.bytes(table::text(&rows).as_bytes()),
        TableFormat::Markdown => output.bytes(table::markdown(&rows).as_bytes()),
        TableFormat::Latex => output.bytes(table::latex(&rows).as_bytes()),
        TableFormat::Csv => output.bytes(table::csv(&rows).as_bytes()),
    }
    outcome
}

/// A row as an answer: a proved tiling with the digest of its certificate.
fn data(name: &InputName, row: Row) -> Record {
    let certificate = row.certificate.clone();
    let mut table = table::json(&[row]);
    let mut body = table["rows"][0].take();
    if let Value::Object(members) = &mut body {
        members.remove("certificate");
    }
    let record = Record::of(Some(name)).verdict("proved");
    record.certificate(None, &certificate).with(body)
}

fn row(name: &InputName, survey: &Survey, output: &mut Output) -> Result<Row, InputError> {
    let failed = |message: String, outcome: Outcome| InputError { message, outcome };
    let refuted = |message: String| failed(message, Outcome::Refuted);
    let entry = catalog::find(name);
    if catalog::theorem(name).is_some() || entry.is_some_and(|entry| entry.has_box()) {
        return Row::of_general(name).map_err(refuted);
    }
    if entry.is_some() {
        return Ok(Row::of(name, survey.get(name).map_err(refuted)?));
    }
    let options = FileArguments::default();
    let loaded = input::open(name, None, &options, output)?;
    let declined = |message: String| failed(message, Outcome::Declined);
    if let Loaded::Family(named) = loaded {
        let general = General::of(named.family, Vec::new());
        let general = general.map_err(|message| declined(format!("{name}: {message}")))?;
        return table::of_family(name, &general).map_err(declined);
    }
    let named = loaded.tiling(name, &options, output)?;
    AnyStudy::of(named.tiling)
        .map(|study| Row::of(name, &study))
        .map_err(|error| failed(format!("{name}: {error}"), of_study(&error)))
}
