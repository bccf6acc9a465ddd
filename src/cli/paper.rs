//! `acutile paper`: every checkable statement of the paper with its verdict.

use super::outcome::Outcome;
use super::output::Output;
use super::record::Record;
use acutile_paper::paper::{self, Row, Verdict};
use acutile_paper::survey::Survey;
use clap::Args;
use serde_json::Value;

#[derive(Debug, Args)]
pub struct PaperArguments {}

/// Prints a row for each statement. Done when every statement was settled, whether it stands or
/// not; declined when one was not.
pub fn run(_: &PaperArguments, output: &mut Output) -> Outcome {
    let rows = paper::rows(&Survey::of_catalog());
    if output.is_json() {
        let rows: Vec<Value> = rows.iter().map(Row::to_json).collect();
        output.answer(Record::of(None).member("rows", Value::Array(rows)));
    } else {
        rows.iter().for_each(|row| output.line(row));
        output.line(summary(&rows));
    }
    if rows
        .iter()
        .any(|row| matches!(row.verdict, Verdict::Undecided))
    {
        Outcome::Declined
    } else {
        Outcome::Done
    }
}

/// How many rows have each verdict.
fn summary(rows: &[Row]) -> String {
    let mut counts = std::collections::BTreeMap::new();
    for row in rows {
        *counts.entry(row.verdict.word()).or_insert(0) += 1;
    }
    let words: Vec<String> = counts
        .iter()
        .map(|(word, n)| format!("{n} {word}"))
        .collect();
    format!("{} statements: {}", rows.len(), words.join(", "))
}
