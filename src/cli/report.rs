//! `acutile report`: a page to look at, of proved and of refuted tilings.

use super::article::{self, Article};
use super::extension;
use super::input::FileArguments;
use super::limits::LimitArguments;
use super::name::{InputName, check_standard_input};
use super::outcome::Outcome;
use super::output::Output;
use super::overwriting::check_output;
use super::proved::shown;
use super::record::Record;
use clap::Args;
use serde_json::json;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Certificates, names of the catalogue (families and theorems too), tiling or mesh files, or point sets (CIF too)
    #[arg(
        value_name = "CERT|NAME|FILE",
        required = true,
        hide_possible_values = true
    )]
    pub inputs: Vec<InputName>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Writes the page; nothing is written where an input is neither proved nor refuted.
pub fn run(arguments: &ReportArguments, output: &mut Output) -> Outcome {
    let path = arguments.output.as_deref();
    output.document_goes_to(path);
    let checked = check_standard_input(arguments.inputs.iter().map(InputName::raw))
        .and_then(|()| check_output(path, "-o", &arguments.inputs))
        .and_then(|()| extension::check(path, "a page", extension::PAGE));
    if let Err(message) = checked {
        return output.fail_with(None, message);
    }
    let limits = arguments.limits.limits();
    let mut articles = Vec::new();
    let mut worst = Outcome::Done;
    for input in &arguments.inputs {
        let article = match shown(input, &arguments.file, &limits, output) {
            Ok(article) => article,
            Err(error) => return output.fail(Some(input), &error),
        };
        worst = worst.and(tell(input, &article, output));
        articles.push(article);
    }
    worst.and(match article::write(&articles, path, output) {
        Outcome::Done => output.done(Record::of(None)),
        failed => failed,
    })
}

/// The verdict on an input: an object with --json, else a line for a refuted one.
fn tell(input: &InputName, article: &Article, output: &mut Output) -> Outcome {
    let record = Record::of(Some(input));
    match article {
        Article::Confirmed(content) => {
            let sha256 = content.sha256();
            output.done(record.verdict("proved").certificate(None, &sha256))
        }
        Article::Refuted(refutation) => {
            let words = refutation.verdict.trim_start_matches("Refuted: ");
            // A certificate that the kernel rejects says nothing about the tiling.
            let (word, verdict) = if refutation.refused.is_some() {
                ("not proved", "rejected")
            } else {
                ("refuted", "refuted")
            };
            if output.is_json() {
                let record = record.verdict(verdict).member("message", json!(words));
                output.answer(record.member("counts", json!(refutation.counts)));
            } else {
                output.complain(format!("acutile: {input}: {word}: {words}"))
            }
            Outcome::Refuted
        }
    }
}
