//! `acutile certify`: proves tilings and writes their certificates.

use super::args::CertifyArguments;
use super::input::{self, Named};
use super::output::{Output, write_file};
use super::progress::Progress;
use super::{Outcome, verify};
use crate::catalog;
use crate::certificate::{self, Statement};
use crate::checker::{self, Options, Refutation, describe};
use crate::tiling::Tiling;
use crate::verifier::{self, Limits, Verified};
use crate::with_dimension;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Certifies every input; the outcome is the worst of all.
pub fn run(arguments: &CertifyArguments, output: &mut Output) -> Outcome {
    let mut inputs = arguments.inputs.clone();
    if arguments.all {
        inputs.extend(catalog::entries().iter().map(|entry| entry.name.to_owned()));
    }
    let several = inputs.len() > 1;
    inputs.iter().fold(Outcome::Done, |outcome, input| {
        outcome.and(certify(input, several, arguments, output))
    })
}

/// What became of one input.
enum Answer {
    Proved {
        verified: Verified,
        written: Option<PathBuf>,
    },
    Refuted {
        counts: Value,
        defects: Vec<(&'static str, String)>,
    },
    Failed(String),
    Declined(String),
}

fn certify(
    input: &str,
    several: bool,
    arguments: &CertifyArguments,
    output: &mut Output,
) -> Outcome {
    let answer = match input::tiling(input) {
        Ok(named) => answer(named, several, arguments, output),
        Err(message) => Answer::Failed(message),
    };
    if arguments.json {
        output.line(in_json(input, &answer));
    } else {
        in_words(input, &answer, output);
    }
    match answer {
        Answer::Proved { .. } => Outcome::Done,
        Answer::Refuted { .. } => Outcome::Refuted,
        Answer::Failed(_) => Outcome::Failed,
        Answer::Declined(_) => Outcome::Declined,
    }
}

fn answer(
    mut named: Named,
    several: bool,
    arguments: &CertifyArguments,
    output: &mut Output,
) -> Answer {
    if arguments.reorient {
        let mended = with_dimension!(&mut named.tiling, AnyTiling, t => checker::reorient(t));
        if !mended.is_empty() {
            output.complain(format!(
                "{}: {} simplices reoriented",
                named.name,
                mended.len()
            ));
        }
    }
    with_dimension!(&named.tiling, AnyTiling, t => prove(t, &named.name, several, arguments, output))
}

fn prove<const D: usize>(
    tiling: &Tiling<D>,
    name: &str,
    several: bool,
    arguments: &CertifyArguments,
    output: &mut Output,
) -> Answer {
    let options = Options {
        required: arguments.required.clone(),
        defect_limit: arguments.max_defects,
    };
    let progress = Progress::of(name);
    let certificate = match checker::prove(tiling, &options, &|step| progress.step(step)) {
        Ok(certificate) => certificate,
        Err(refutation) => return refuted(tiling, &refutation),
    };
    let bytes = certificate::to_bytes(&certificate);
    // The kernel has the last word before anything is written.
    progress.step("verification");
    match verifier::verify(&bytes, &Limits::default()) {
        Ok(verified) => proved(verified, &bytes, name, several, arguments, output),
        Err(refusal) => Answer::Declined(format!(
            "{name}: the kernel does not confirm the certificate: {refusal}"
        )),
    }
}

fn refuted<const D: usize>(tiling: &Tiling<D>, refutation: &Refutation) -> Answer {
    let defects: Vec<_> = refutation
        .kept()
        .iter()
        .map(|defect| (defect.code(), describe(tiling, defect)))
        .collect();
    Answer::Refuted {
        counts: json!(refutation.counts()),
        defects,
    }
}

fn proved(
    verified: Verified,
    bytes: &[u8],
    name: &str,
    several: bool,
    arguments: &CertifyArguments,
    output: &mut Output,
) -> Answer {
    let Some(target) = &arguments.output else {
        return Answer::Proved {
            verified,
            written: None,
        };
    };
    if target == Path::new("-") {
        output.write(bytes);
        return Answer::Proved {
            verified,
            written: None,
        };
    }
    let path = if several || target.is_dir() {
        target.join(file_name(name))
    } else {
        target.clone()
    };
    let created = match several {
        true => std::fs::create_dir_all(target),
        false => Ok(()),
    };
    match created.and_then(|()| write_file(&path, bytes)) {
        Ok(()) => Answer::Proved {
            verified,
            written: Some(path),
        },
        Err(error) => Answer::Failed(format!("{}: cannot be written: {error}", path.display())),
    }
}

/// `a15` and `dir/a15.json` both give `a15.json`.
fn file_name(name: &str) -> String {
    let stem = Path::new(name)
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned());
    match stem.as_deref() {
        None | Some("-") => "certificate.json".to_owned(),
        Some(stem) => format!("{}.json", stem.replace([':', '/'], "-")),
    }
}

fn in_words(input: &str, answer: &Answer, output: &mut Output) {
    match answer {
        Answer::Proved { verified, written } => {
            let summary = format!("{input}: proved: {}", verify::summary(verified));
            match written {
                Some(path) => output.line(format!("{summary}; {}", path.display())),
                None => output.line(summary),
            }
        }
        Answer::Refuted { counts, defects } => {
            output.line(format!("{input}: refuted: {}", count_text(counts)));
            for (code, sentence) in defects {
                output.line(format!("  {code}: {sentence}"));
            }
        }
        Answer::Failed(message) => output.complain(format!("acutile: {message}")),
        Answer::Declined(message) => output.complain(format!("acutile: declined: {message}")),
    }
}

fn count_text(counts: &Value) -> String {
    let pairs = counts.as_object().into_iter().flatten();
    pairs
        .map(|(code, count)| format!("{count} {code}"))
        .collect::<Vec<_>>()
        .join(", ")
}

fn in_json(input: &str, answer: &Answer) -> Value {
    match answer {
        Answer::Proved { verified, written } => json!({
            "input": input,
            "verdict": "proved",
            "statements": statements(verified),
            "vertices": verified.vertices(),
            "simplices": verified.simplices(),
            "sha256": verified.sha256(),
            "certificate": written,
        }),
        Answer::Refuted { counts, defects } => json!({
            "input": input,
            "verdict": "refuted",
            "counts": counts,
            "defects": defects
                .iter()
                .map(|(code, sentence)| json!({ "code": code, "message": sentence }))
                .collect::<Vec<_>>(),
        }),
        Answer::Failed(message) => {
            json!({ "input": input, "verdict": "failed", "message": message })
        }
        Answer::Declined(message) => {
            json!({ "input": input, "verdict": "declined", "message": message })
        }
    }
}

fn statements(verified: &Verified) -> &[Statement] {
    &verified.claim().statements
}
