//! `acutile list`: the catalogue.

use super::outcome::Outcome;
use super::output::Output;
use acutile_catalog as catalog;
use clap::Args;
use serde_json::json;

#[derive(Debug, Args)]
pub struct ListArguments {
    /// One JSON object for each construction
    #[arg(long)]
    pub json: bool,
}

/// Prints a line for each construction.
pub fn run(arguments: &ListArguments, output: &mut Output) -> Outcome {
    let width = catalog::entries()
        .iter()
        .map(|entry| entry.name.len())
        .max()
        .unwrap_or(0);
    for entry in catalog::entries() {
        if arguments.json {
            output.line(json!({
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
            }));
        } else {
            let name = if entry.is_family() {
                format!("{}WORD", entry.name)
            } else {
                entry.name.to_owned()
            };
            output.line(format!("{name:width$}  {}", entry.description));
        }
    }
    for theorem in catalog::THEOREMS {
        if arguments.json {
            output.line(json!({
                "name": theorem.name,
                "description": theorem.description,
                "theorem": true,
                "family": theorem.family,
            }));
        } else {
            output.line(format!("{:width$}  {}", theorem.name, theorem.description));
        }
    }
    Outcome::Done
}
