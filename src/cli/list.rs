//! `acutile list`: the catalogue.

use super::outcome::Outcome;
use super::output::Output;
use super::record::Record;
use acutile_catalog as catalog;
use acutile_catalog::Entry;
use clap::Args;
use serde_json::json;

#[derive(Debug, Args)]
pub struct ListArguments {}

/// Prints a line for each construction and each theorem.
pub fn run(_: &ListArguments, output: &mut Output) -> Outcome {
    let lengths = catalog::entries().iter().map(|entry| entry.name.len());
    let width = lengths.max().unwrap_or(0);
    for entry in catalog::entries() {
        if output.is_json() {
            output.answer(data(entry))
        } else {
            let name = format!("{}{}", entry.name, word(entry));
            output.line(format!("{name:width$}  {}", entry.description));
        }
    }
    for theorem in catalog::THEOREMS {
        if output.is_json() {
            output.answer(Record::of(Some(theorem.name)).with(json!({
                "name": theorem.name,
                "description": theorem.description,
                "theorem": true,
                "family": theorem.family,
            })))
        } else {
            output.line(format!("{:width$}  {}", theorem.name, theorem.description))
        }
    }
    Outcome::Done
}

/// The part of a name that the user chooses.
fn word(entry: &Entry) -> &'static str {
    if entry.is_family() { "WORD" } else { "" }
}

fn data(entry: &Entry) -> Record {
    Record::of(Some(entry.name)).with(json!({
        "name": entry.name,
        "description": entry.description,
        "source": entry.source,
        "domain": entry.domain,
        "family": entry.is_family(),
        "box": entry.has_box(),
        "parameter": entry.parameter.map(|parameter| json!({
            "name": parameter.name,
            "default": parameter.default,
        })),
    }))
}
