//! The verdict on an input of `certify`, in words and as data.

use super::certify_arguments::CertifyArguments;
use super::claim::{claim_json, statements, summary};
use super::files::{self, Staged, write_file};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::record::Record;
use super::refutation::Refuted;
use super::region::Description;
use super::target::Target;
use super::words::printable;
use acutile_core::proved::hexadecimal;
use acutile_core::statement::counted;
use acutile_kernel::Verified;
use serde_json::{Value, json};
use std::io;
use std::path::Path;

/// The verdict on one input.
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

/// The answer of the prover alone.
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
    /// The anatomy of the region.
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
        Target::File(path) => path.as_path(),
        _ => Path::new("the certificate"),
    };
    Answer::Failed(files::unwritten(place, error).message)
}

/// Why an input cannot be certified.
impl From<InputError> for Answer {
    fn from(error: InputError) -> Answer {
        match error.outcome {
            Outcome::Declined => Answer::Declined(error.message),
            _ => Answer::Failed(error.message),
        }
    }
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

    /// Tells the answer.
    pub fn report(
        &self,
        input: &str,
        target: &Target,
        arguments: &CertifyArguments,
        notes: &[String],
        beside: &Beside,
        output: &mut Output,
    ) {
        let told = match self {
            Answer::Refuted(refuted) => return refuted.tell(input, output),
            Answer::Failed(message) => {
                let error = InputError::from(message.clone());
                return no_answer(input, &error, "acutile", notes, output);
            }
            Answer::Declined(message) => {
                let error = InputError {
                    message: message.clone(),
                    outcome: Outcome::Declined,
                };
                return no_answer(input, &error, "acutile: declined", notes, output);
            }
            Answer::Proved { verified, .. } | Answer::Confirmed(verified) => {
                let mut told = proved(verified, input, target);
                told.sentences
                    .extend(notes.iter().filter(|_| arguments.cite).cloned());
                told
            }
            Answer::Examined(examined) => examined.told(input),
            Answer::Said(words, data) => Told {
                sentences: vec![words.clone()],
                record: Record::of(Some(input)).verdict("proved").with(data.clone()),
            },
        };
        told.with(beside, arguments)
            .print(input, notes, beside, output);
    }
}

/// Why there is no answer.
fn no_answer(input: &str, error: &InputError, start: &str, notes: &[String], output: &mut Output) {
    if output.is_json() {
        output.answer(Record::failed(Some(input), error).notes(notes))
    } else {
        output.complain(format!("{start}: {}", error.message))
    }
}

/// A proof in sentences and as data.
struct Told {
    sentences: Vec<String>,
    record: Record,
}

impl Told {
    /// The same with what is said beside it.
    fn with(mut self, beside: &Beside, arguments: &CertifyArguments) -> Self {
        if let Some((others, _)) = &beside.others {
            self.sentences.push(format!("not checked: {others}"));
            self.record = self.record.member("not_checked", json!(others));
        }
        self.sentences.extend(beside.added.iter().cloned());
        if !beside.added.is_empty() {
            self.record = self.record.member("added", json!(beside.added));
        }
        if let Some(description) = &beside.description {
            self.record = self.record.member("region", description.data.clone());
        }
        if arguments.file.mesh.identify.is_some() {
            let words = "this is about the mesh with its nodes moved by --identify";
            self.sentences.push(words.to_owned());
        }
        self
    }

    fn print(self, input: &str, notes: &[String], beside: &Beside, output: &mut Output) {
        if output.is_json() {
            return output.answer(self.record.notes(notes));
        }
        let details = beside.description.iter().flat_map(|d| &d.lines);
        let details: Vec<&String> = details.collect();
        if output.look().is_none() {
            output.say(format!("{input}: {}", self.sentences.join("; ")));
            details
                .iter()
                .for_each(|line| output.say(format!("  {line}")));
            return;
        }
        let sentences = self.sentences.join("; ");
        let sentences = sentences.strip_prefix("proved: ").unwrap_or(&sentences);
        let mut statements = statements(sentences);
        statements.extend(details.into_iter().cloned());
        output.tell(input, "proved", &statements, "");
    }
}

/// A proof in words and as data.
fn proved(verified: &Verified, input: &str, target: &Target) -> Told {
    let path = match target {
        Target::File(path) => Some(path.as_path()),
        _ => None,
    };
    let record = Record::of(Some(input)).verdict("proved").with(json!({
        "statements": claim_json(verified)["statements"],
        "vertices": verified.vertices,
        "simplices": verified.simplices,
    }));
    let mut sentences = vec![format!("proved: {}", summary(verified))];
    sentences.extend(path.map(printable));
    Told {
        sentences,
        record: record.certificate(path, &hexadecimal(&verified.sha256)),
    }
}

impl Examined {
    /// A proof without a certificate, which says so.
    fn told(&self, input: &str) -> Told {
        let Examined {
            vertices,
            simplices,
            words,
            statements,
        } = self;
        let words = format!(
            "proved by the prover alone, no certificate: {words} ({}, {})",
            counted(*vertices, "vertex", "vertices"),
            counted(*simplices, "simplex", "simplices")
        );
        let record = Record::of(Some(input)).verdict("proved").with(json!({
            "statements": statements,
            "vertices": vertices,
            "simplices": simplices,
            "kernel": false,
        }));
        Told {
            sentences: vec![words],
            record,
        }
    }
}
