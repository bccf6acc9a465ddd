//! `acutile verify`: asks the kernel about certificates in either encoding.

use super::limits::LimitArguments;
use super::outcome::{Outcome, exit_outcome};
use super::output::Output;
use super::words::{name, one_line};
use acutile_core::format::{self, Encoding, json::JsonError, recognise};
use acutile_core::proved::{hexadecimal, in_words};
use acutile_core::refusal;
use acutile_kernel::{Code, Kind, Limits, Refusal, Value as Wrong, Verified, verify};
use clap::Args;
use serde_json::{Value, json};
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// Certificates (`-` for standard input)
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<OsString>,
    /// Succeed only if each certificate proves exactly the claim in this file
    #[arg(long, value_name = "FILE")]
    pub claim: Option<PathBuf>,
    /// One JSON object for each file
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// The verdict on a file.
enum Verdict {
    Verified(Box<Verified>),
    /// It proves another claim.
    OtherClaim(Box<Verified>),
    Refused(Box<Refusal>),
    Malformed(JsonError),
    /// JSON of more bytes than the limit, and its length, if it is known.
    TooLong(Option<u64>),
    Unreadable(io::Error),
}

/// Verifies every file, a line each. Gives 0 if all are verified, else the first that occurs of 1
/// (one is rejected), 2 (one is malformed or unreadable), 3 (one is declined).
pub fn run(arguments: &VerifyArguments, output: &mut Output) -> Outcome {
    let claim = match arguments.claim.as_ref().map(std::fs::read_to_string) {
        None => None,
        Some(Ok(text)) => Some(text),
        Some(Err(error)) => {
            output.complain(format!("acutile: --claim: cannot be read: {error}"));
            return Outcome::Failed;
        }
    };
    let limits = arguments.limits.limits();
    let mut code = 0;
    for file in &arguments.files {
        let verdict = judge(file, claim.as_deref(), &limits);
        let line = match arguments.json {
            true => verdict.as_json(file).to_string(),
            false => verdict.as_text(file),
        };
        output.line(line);
        code = first_of(code, verdict.exit_code());
    }
    exit_outcome(code)
}

/// The first of 1, 2, 3 that is there, else 0.
fn first_of(a: u8, b: u8) -> u8 {
    if a == 0 || (b != 0 && b < a) { b } else { a }
}

fn judge(file: &OsString, claim: Option<&str>, limits: &Limits) -> Verdict {
    let verified = match check(file, limits) {
        Ok(verified) => Box::new(verified),
        Err(verdict) => return verdict,
    };
    match claim {
        Some(claim) if verified.claim.print() != claim => Verdict::OtherClaim(verified),
        _ => Verdict::Verified(verified),
    }
}

fn check(file: &OsString, limits: &Limits) -> Result<Verified, Verdict> {
    if file == "-" {
        return check_reader(&mut io::stdin().lock(), None, limits);
    }
    let mut opened = File::open(file).map_err(Verdict::Unreadable)?;
    let metadata = opened.metadata().map_err(Verdict::Unreadable)?;
    let length = Some(metadata.len()).filter(|_| metadata.is_file());
    check_reader(&mut opened, length, limits)
}

/// CBOR is read in pieces; JSON is transcribed first.
fn check_reader(
    reader: &mut dyn Read,
    length: Option<u64>,
    limits: &Limits,
) -> Result<Verified, Verdict> {
    let mut begin = Vec::new();
    let taken = reader.take(BEGIN).read_to_end(&mut begin);
    taken.map_err(Verdict::Unreadable)?;
    let is_json = matches!(begin.first(), Some(b'{' | b' ' | b'\t' | b'\n' | b'\r'));
    if !is_json && recognise(&begin) != Some(Encoding::Json) {
        let mut rest = BufReader::new(io::Read::chain(&begin[..], reader));
        return verify(&mut rest, limits).map_err(|refusal| refused(refusal, length));
    }
    if length.is_some_and(|length| length > limits.bytes) {
        return Err(Verdict::TooLong(length));
    }
    // One byte more than the limit is enough to be declined.
    let more = limits.bytes.saturating_add(1);
    let mut bytes = begin;
    let taken = reader.take(more).read_to_end(&mut bytes);
    taken.map_err(Verdict::Unreadable)?;
    if bytes.len() as u64 > limits.bytes {
        return Err(Verdict::TooLong(length));
    }
    let cbor = format::to_cbor(&bytes).map_err(Verdict::Malformed)?;
    verify(&mut &cbor[..], limits).map_err(|refusal| Verdict::Refused(Box::new(refusal)))
}

/// The kernel does not know how long a file is that it refuses to read to its end.
fn refused(mut refusal: Refusal, length: Option<u64>) -> Verdict {
    if let Wrong::Limit("bytes", enough) = &mut refusal.value {
        *enough = enough.or(length);
    }
    Verdict::Refused(Box::new(refusal))
}

/// Bytes that tell the encodings apart.
const BEGIN: u64 = 1024;

impl Verdict {
    fn exit_code(&self) -> u8 {
        match self {
            Verdict::Verified(_) => 0,
            Verdict::OtherClaim(_) => 1,
            Verdict::Refused(refusal) => match refusal.code.kind() {
                _ if refusal.code == Code::Unreadable => 2,
                Kind::Rejected => 1,
                Kind::Malformed => 2,
                Kind::Declined => 3,
            },
            Verdict::Malformed(error) if error.code.is_declined() => 3,
            Verdict::Malformed(_) | Verdict::Unreadable(_) => 2,
            Verdict::TooLong(_) => 3,
        }
    }

    fn as_text(&self, file: &OsString) -> String {
        let verdict = match self {
            Verdict::Verified(verified) => format!("verified: {}", summary(verified)),
            _ if self.word() == self.code() => format!("{}: {}", self.word(), self.message()),
            _ => format!("{} [{}] {}", self.word(), self.code(), self.message()),
        };
        format!("{}: {}", name(file), one_line(&verdict))
    }

    fn word(&self) -> &'static str {
        match self {
            Verdict::Verified(_) => "verified",
            Verdict::OtherClaim(_) => "rejected",
            Verdict::Refused(refusal) if refusal.code == Code::Unreadable => "unreadable",
            Verdict::Refused(refusal) => refusal.code.kind().text(),
            Verdict::Malformed(_) => match self.exit_code() {
                3 => "declined",
                _ => "malformed",
            },
            Verdict::TooLong(_) => "declined",
            Verdict::Unreadable(_) => "unreadable",
        }
    }

    fn code(&self) -> &'static str {
        match self {
            Verdict::Verified(_) => "verified",
            Verdict::OtherClaim(_) => "other-claim",
            Verdict::Refused(refusal) => refusal.code.text(),
            Verdict::Malformed(error) => error.code.name(),
            Verdict::TooLong(_) => "too-many-bytes",
            Verdict::Unreadable(_) => "unreadable",
        }
    }

    fn message(&self) -> String {
        match self {
            Verdict::Verified(verified) => in_words(verified),
            Verdict::OtherClaim(verified) => {
                format!("it proves another claim: {}", in_words(verified))
            }
            Verdict::Refused(refusal) => refusal::message(refusal),
            Verdict::Malformed(error) => error.to_string(),
            Verdict::TooLong(length) => {
                format!("the file is {}", refusal::exceeded("bytes", *length))
            }
            Verdict::Unreadable(error) => error.to_string(),
        }
    }

    /// Members: file, verdict; claim, words, vertices, simplices, sha256 of a verified one; code,
    /// message of any other.
    fn as_json(&self, file: &OsString) -> Value {
        let file = file.to_string_lossy();
        match self {
            Verdict::Verified(verified) => json!({
                "file": file, "verdict": "verified", "claim": claim_json(verified),
                "words": in_words(verified), "vertices": verified.vertices,
                "simplices": verified.simplices, "sha256": hexadecimal(&verified.sha256),
            }),
            _ => json!({
                "file": file, "verdict": self.word(), "code": self.code(),
                "message": self.message(),
            }),
        }
    }
}

/// The claim as the kernel prints it.
pub fn claim_json(verified: &Verified) -> Value {
    let file: Value = serde_json::from_str(verified.claim.print()).unwrap_or_default();
    file["claim"].clone()
}

/// The claim in words with counts and digest, in a line.
pub fn summary(verified: &Verified) -> String {
    let vertices = match verified.vertices {
        1 => "1 vertex".to_owned(),
        n => format!("{n} vertices"),
    };
    format!(
        "{}. ({vertices}, {} simplices, sha256 {})",
        in_words(verified),
        verified.simplices,
        hexadecimal(&verified.sha256)
    )
}
