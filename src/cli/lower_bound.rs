//! `acutile lower-bound`: the finite part of the proof of the lower bounds, decided.

use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use super::record::Record;
use acutile_bounds::{Check, THEOREMS, Theorem, Verdict, checks, worst};
use clap::Args;
use serde_json::json;

#[derive(Debug, Args)]
pub struct LowerBoundArguments {}

/// Prints each check with its verdict and its place in the proof, then each theorem. Refuted when
/// a check fails; declined when one is undecided.
pub fn run(_: &LowerBoundArguments, output: &mut Output) -> Outcome {
    let progress = Progress::of("lower-bound");
    let checks = checks(&|part| progress.step(part));
    drop(progress);
    if output.is_json() {
        output.answer(Record::of(None).with(json!({
            "checks": checks.iter().map(Check::to_json).collect::<Vec<_>>(),
            "theorems": THEOREMS.map(|theorem| theorem.to_json(&checks)),
        })));
    } else {
        checks.iter().for_each(|check| output.line(check));
        output.line("");
        output.line("With the proof in docs/lower-bound.md, where all checks of a theorem hold:");
        for theorem in THEOREMS {
            output.line(in_words(&theorem, &checks));
        }
        output.line(summary(&checks));
    }
    match worst(checks.iter().map(|check| check.verdict)) {
        Verdict::Holds => Outcome::Done,
        Verdict::Fails => Outcome::Refuted,
        Verdict::Undecided => Outcome::Declined,
    }
}

/// `holds face-to-face [Theorem 1] every …`
fn in_words(theorem: &Theorem, checks: &[Check]) -> String {
    let word = theorem.verdict(checks).word();
    let Theorem {
        id,
        place,
        statement,
        ..
    } = theorem;
    format!("{word} {id} [{place}]\n  {statement}")
}

/// How many checks have each verdict.
fn summary(checks: &[Check]) -> String {
    let count = |verdict| {
        let with = checks.iter().filter(|check| check.verdict == verdict);
        format!("{} {}", with.count(), verdict.word())
    };
    let counts = [Verdict::Holds, Verdict::Fails, Verdict::Undecided].map(count);
    format!("{} checks: {}", checks.len(), counts.join(", "))
}
