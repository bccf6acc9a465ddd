//! The front of the kernel: reads certificate files, prints verdicts, gives exit
//! codes. Both programs use it; what "verified" means is decided in
//! [`crate::verifier`] alone.

use crate::certificate::cbor::is_cbor;
use crate::verifier::{Kind, Limits, Refusal, Verified, verify, verify_file};
use serde_json::json;
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read, Write};

/// Verifies files one after the other, a line each, `-` for standard input. Gives
/// the exit code: 0 if all are verified, else the first that occurs of 1 (one is
/// rejected), 2 (one is malformed or unreadable), 3 (one is declined).
///
/// # Errors
/// Where `out` cannot be written.
pub fn verify_files(
    files: &[OsString],
    limits: &Limits,
    json: bool,
    out: &mut impl Write,
) -> io::Result<u8> {
    let mut code = 0;
    for file in files {
        let outcome = look_at(file, limits);
        let line = if json {
            as_json(file, &outcome)
        } else {
            as_text(file, &outcome)
        };
        writeln!(out, "{line}")?;
        out.flush()?;
        code = first_of(code, outcome.exit_code());
    }
    Ok(code)
}

/// The first of 1, 2, 3 that is there, else 0.
fn first_of(a: u8, b: u8) -> u8 {
    if a == 0 || (b != 0 && b < a) { b } else { a }
}

enum Outcome {
    Verified(Verified),
    Refused(Refusal),
    Unreadable(io::Error),
}

impl Outcome {
    fn exit_code(&self) -> u8 {
        match self {
            Outcome::Verified(_) => 0,
            Outcome::Refused(refusal) => match refusal.kind() {
                Kind::False => 1,
                Kind::Malformed => 2,
                Kind::Declined => 3,
            },
            Outcome::Unreadable(_) => 2,
        }
    }
}

fn look_at(file: &OsString, limits: &Limits) -> Outcome {
    let answer = match read(file, limits) {
        Ok(Input::Bytes(bytes)) => verify(&bytes, limits),
        Ok(Input::File(file)) => verify_file(&file, limits),
        Err(error) => return Outcome::Unreadable(error),
    };
    match answer {
        Ok(verified) => Outcome::Verified(verified),
        Err(refusal) => Outcome::Refused(refusal),
    }
}

enum Input {
    Bytes(Vec<u8>),
    /// CBOR, which is read in pieces.
    File(File),
}

/// Bytes are at most one more than the limit, which is enough to be refused.
fn read(name: &OsString, limits: &Limits) -> io::Result<Input> {
    if name == "-" {
        return rest(io::stdin().lock(), Vec::new(), limits);
    }
    let file = File::open(name)?;
    let mut begin = Vec::new();
    (&file).take(1).read_to_end(&mut begin)?;
    match is_cbor(&begin) && file.metadata()?.is_file() {
        true => Ok(Input::File(file)),
        false => rest(file, begin, limits),
    }
}

/// All bytes of what begins with these.
fn rest(from: impl Read, mut bytes: Vec<u8>, limits: &Limits) -> io::Result<Input> {
    let more = (limits.bytes.saturating_add(1)).saturating_sub(bytes.len() as u64);
    from.take(more).read_to_end(&mut bytes)?;
    Ok(Input::Bytes(bytes))
}

fn as_text(file: &OsString, outcome: &Outcome) -> String {
    let verdict = match outcome {
        Outcome::Verified(verified) => format!(
            "verified: {verified}. ({} {}, {} simplices, sha256 {})",
            verified.vertices(),
            if verified.vertices() == 1 {
                "vertex"
            } else {
                "vertices"
            },
            verified.simplices(),
            verified.sha256()
        ),
        Outcome::Refused(refusal) => {
            format!("{} [{}] {refusal}", refusal.kind(), refusal.code())
        }
        Outcome::Unreadable(error) => format!("unreadable: {error}"),
    };
    format!("{}: {}", name(file), one_line(&verdict))
}

/// The name of a file as it is, if it holds nothing but ASCII letters, digits and
/// `._/-+=@%~`; else as a JSON string in ASCII. So its end is never in doubt.
fn name(file: &OsString) -> String {
    let text = file.to_string_lossy();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._/-+=@%~".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        return text.into_owned();
    }
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            ' '..='~' => quoted.push(c),
            _ => quoted.extend(
                c.encode_utf16(&mut [0; 2])
                    .iter()
                    .map(|u| format!("\\u{u:04x}")),
            ),
        }
    }
    quoted + "\""
}

/// Members: file, verdict; claim, words, vertices, simplices, sha256 of a
/// verified one; code, message of any other.
fn as_json(file: &OsString, outcome: &Outcome) -> String {
    let file = file.to_string_lossy();
    match outcome {
        Outcome::Verified(verified) => json!({
            "file": file, "verdict": "verified", "claim": verified.claim(),
            "words": verified.to_string(), "vertices": verified.vertices(),
            "simplices": verified.simplices(), "sha256": verified.sha256(),
        }),
        Outcome::Refused(refusal) => json!({
            "file": file, "verdict": refusal.kind().to_string(), "code": refusal.code(),
            "message": refusal.to_string(),
        }),
        Outcome::Unreadable(error) => json!({
            "file": file, "verdict": "unreadable", "code": "unreadable",
            "message": error.to_string(),
        }),
    }
    .to_string()
}

/// No text can forge a line: whatever is not printable is escaped.
pub fn one_line(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '"' | '\'' | '\\' => line.push(character),
            _ => line.extend(character.escape_debug()),
        }
    }
    line
}
