//! What became of an input of `certify`, in words and as data.

use super::certify::CertifyArguments;
use super::outcome::Outcome;
use super::output::{Output, Staged, write_file};
use super::refutation::Refuted;
use super::region::Description;
use super::target::Target;
use super::verify::{claim_json, summary};
use acutile_core::proved::hexadecimal;
use acutile_kernel::Verified;
use serde_json::{Value, json};
use std::io;

/// What became of one input.
pub enum Answer {
    Proved {
        verified: Verified,
        certificate: Written,
    },
    /// The same, with the certificate in its place.
    Confirmed(Verified),
    /// By the prover, without a certificate.
    Examined(Box<Examined>),
    /// Something else that the prover alone says: a sentence, and data.
    Said(String, Value),
    Refuted(Box<Refuted>),
    Failed(String),
    Declined(String),
}

/// What the prover alone says.
pub struct Examined {
    pub vertices: usize,
    pub simplices: usize,
    pub words: String,
    /// The statements as the claim of a certificate has them.
    pub statements: Value,
}

/// What is said beside a proof.
#[derive(Default)]
pub struct Beside {
    /// What the region looks like.
    pub description: Option<Description>,
    /// Elements of other types: all, and whether some fill space.
    pub others: Option<(String, bool)>,
    /// What is added to the main sentence.
    pub added: Vec<String>,
}

/// A certificate that nobody can read as yet.
pub enum Written {
    Bytes(Vec<u8>),
    File(Staged),
}

impl Written {
    /// Puts it where it is to be.
    fn put(self, target: &Target, output: &mut Output) -> io::Result<()> {
        match (self, target) {
            (Written::Bytes(bytes), Target::StandardOutput) => output.bytes(&bytes),
            (Written::Bytes(bytes), Target::File(path)) => write_file(path, &bytes)?,
            (Written::File(staged), _) => staged.persist()?,
            (Written::Bytes(_), Target::Nowhere) => {}
        }
        Ok(())
    }
}

pub fn unwritten(target: &Target, error: &io::Error) -> Answer {
    let place = match target {
        Target::File(path) => path.display().to_string(),
        _ => "the certificate".to_owned(),
    };
    Answer::Failed(format!("{place}: cannot be written: {error}"))
}

impl Answer {
    /// Puts a certificate where it is to be; where that fails, so does the input.
    pub fn write(self, target: &Target, output: &mut Output) -> Answer {
        let Answer::Proved {
            verified,
            certificate,
        } = self
        else {
            return self;
        };
        match certificate.put(target, output) {
            Ok(()) => Answer::Confirmed(verified),
            Err(error) => unwritten(target, &error),
        }
    }

    pub fn outcome(&self) -> Outcome {
        match self {
            Answer::Proved { .. }
            | Answer::Confirmed(_)
            | Answer::Examined(..)
            | Answer::Said(..) => Outcome::Done,
            Answer::Refuted(_) => Outcome::Refuted,
            Answer::Failed(_) => Outcome::Failed,
            Answer::Declined(_) => Outcome::Declined,
        }
    }

    /// Tells the answer, on standard error where standard output has the certificate.
    pub fn report(
        &self,
        input: &str,
        target: &Target,
        arguments: &CertifyArguments,
        notes: &[String],
        beside: &Beside,
        output: &mut Output,
    ) {
        let as_json = arguments.json;
        let to_error = matches!(target, Target::StandardOutput);
        let (mut words, mut data) = match self {
            Answer::Refuted(refuted) => return refuted.tell(input, as_json, to_error, output),
            Answer::Proved { verified, .. } | Answer::Confirmed(verified) => {
                let (words, data) = proved(verified, input, target);
                match arguments.cite {
                    true => (format!("{words}; {}", notes.join("; ")), data),
                    false => (words, data),
                }
            }
            Answer::Examined(examined) => examined.report(input),
            Answer::Said(words, data) => (format!("{input}: {words}"), data.clone()),
            Answer::Failed(message) => (
                format!("acutile: {message}"),
                json!({ "input": input, "verdict": "failed", "message": message }),
            ),
            Answer::Declined(message) => (
                format!("acutile: declined: {message}"),
                json!({ "input": input, "verdict": "declined", "message": message }),
            ),
        };
        let is_failure = matches!(self, Answer::Failed(_) | Answer::Declined(_));
        data["notes"] = json!(notes);
        let mut lines = Vec::new();
        if !is_failure {
            if let Some((others, _)) = &beside.others {
                words.push_str(&format!("; not checked: {others}"));
                data["not_checked"] = json!(others);
            }
            for added in &beside.added {
                words.push_str(&format!("; {added}"));
            }
            if let Some(description) = &beside.description {
                lines.clone_from(&description.lines);
                data["region"] = description.data.clone();
            }
        }
        if arguments.file.mesh.identify.is_some() && !is_failure {
            words.push_str("; this is about the mesh with its nodes moved by --identify");
        }
        match as_json {
            true if to_error => output.complain(data),
            true => output.line(data),
            false if to_error || is_failure => output.complain(words),
            false => output.line(words),
        }
        for line in lines.iter().filter(|_| !as_json) {
            match to_error {
                true => output.complain(format!("  {line}")),
                false => output.line(format!("  {line}")),
            }
        }
    }
}

/// A proof in words and as data.
fn proved(verified: &Verified, input: &str, target: &Target) -> (String, Value) {
    let path = match target {
        Target::File(path) => Some(path.to_string_lossy()),
        _ => None,
    };
    let words = format!("{input}: proved: {}", summary(verified));
    let data = json!({
        "input": input,
        "verdict": "proved",
        "statements": claim_json(verified)["statements"],
        "vertices": verified.vertices,
        "simplices": verified.simplices,
        "sha256": hexadecimal(&verified.sha256),
        "certificate": path,
    });
    match path {
        Some(path) => (format!("{words}; {path}"), data),
        None => (words, data),
    }
}

impl Examined {
    /// A proof without a certificate, which says so.
    fn report(&self, input: &str) -> (String, Value) {
        let Examined {
            vertices,
            simplices,
            words,
            statements,
        } = self;
        let words = format!(
            "{input}: proved by the prover alone, no certificate: {words} ({vertices} vertices, {simplices} simplices)"
        );
        let data = json!({
            "input": input,
            "verdict": "proved",
            "statements": statements,
            "vertices": vertices,
            "simplices": simplices,
            "certificate": null,
            "kernel": false,
        });
        (words, data)
    }
}
