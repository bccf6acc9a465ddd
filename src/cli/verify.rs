//! `acutile verify`: asks the kernel about certificates in either encoding.

use super::claim::{claim_json, statements, summary};
use super::counts::Counts;
use super::limits::LimitArguments;
use super::name::check_standard_input;
use super::outcome::{Outcome, exit_outcome};
use super::output::Output;
use super::record::Record;
use super::words::{name, one_line, printable};
use acutile_catalog as catalog;
use acutile_core::format::json::JsonError;
use acutile_core::format::{self, CLAIM_FORMAT, Encoding, recognise};
use acutile_core::proved::{hexadecimal, in_words};
use acutile_core::refusal::{self, Refused};
use acutile_io::import::{BYTE_LIMIT, io_words, read_bytes};
use acutile_io::mesh::unknown;
use acutile_kernel::{Code, Kind, Limits, Place, Refusal, Value as Wrong, Verified, verify};
use clap::Args;
use serde_json::json;
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// Certificates (`-` for standard input)
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<OsString>,
    /// Succeed only if each certificate proves exactly the claim in this file (`-` for standard input)
    #[arg(long, value_name = "FILE")]
    pub claim: Option<PathBuf>,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// The verdict on a file.
enum Verdict {
    Verified(Box<Verified>),
    /// It proves another claim.
    OtherClaim(Box<Verified>),
    Refused(Refused),
    Malformed(JsonError),
    /// Its first bytes are those of something else.
    NoCertificate(String),
    /// It is another file of the project.
    OtherFormat(String),
    /// JSON of more bytes than the limit, and its length, if it is known.
    TooLong(Option<u64>),
    Unreadable(io::Error),
    /// There is no such file, but a construction with its name.
    NoFile(String),
}

/// Verifies every file, a line each. Gives 0 if all are verified. Else it gives 1 if one is rejected,
/// else 2 if one is malformed or unreadable, else 3: one is declined.
pub fn run(arguments: &VerifyArguments, output: &mut Output) -> Outcome {
    let files = arguments.files.iter().map(OsString::as_os_str);
    let claim = arguments.claim.iter().map(|path| path.as_os_str());
    let claim = check_standard_input(files.chain(claim))
        .and_then(|()| arguments.claim.as_deref().map(read_claim).transpose());
    let claim = match claim {
        Ok(claim) => claim,
        Err(message) => return output.fail_with(None, message),
    };
    let limits = arguments.limits.limits();
    let mut code = 0;
    let mut counts = Counts::default();
    for file in &arguments.files {
        let verdict = judge(file, claim.as_deref(), &limits);
        if output.is_json() {
            output.answer(verdict.record(file))
        } else {
            verdict.tell(file, output)
        }
        counts.add(verdict.word());
        code = first_of(code, verdict.exit_code());
    }
    counts.tell(output);
    exit_outcome(code)
}

/// The claim file of --claim, or of standard input for `-`.
fn read_claim(path: &Path) -> Result<String, String> {
    let bytes = read_bytes(path, BYTE_LIMIT);
    let text = bytes.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let text = text.map_err(|error| format!("--claim: {}: {error}", printable(path)))?;
    match format_of(text.as_bytes()).as_deref() {
        Some(CLAIM_FORMAT) => Ok(text),
        found => Err(format!(
            "--claim: {}: found {}, expected a claim file; `acutile-verify --print-claim F.cbor` prints one",
            printable(path),
            found.map_or("no claim".to_owned(), |found| format!(
                "the format {found:?}"
            ))
        )),
    }
}

/// The member `format` of JSON, which comes first.
fn format_of(json: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(&json[..json.len().min(BEGIN as usize)]);
    let after = text.trim_start().strip_prefix('{')?.trim_start();
    let value = after.strip_prefix("\"format\"")?.trim_start();
    let value = value.strip_prefix(':')?.trim_start().strip_prefix('"')?;
    let (format, _) = value.split_once('"')?;
    let is_plain = format.chars().all(|c| c.is_ascii_graphic());
    is_plain.then(|| format.to_owned())
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
    let mut opened = File::open(file).map_err(|error| unopened(file, error))?;
    let metadata = opened.metadata().map_err(Verdict::Unreadable)?;
    let length = Some(metadata.len()).filter(|_| metadata.is_file());
    check_reader(&mut opened, length, limits)
}

/// A name of the catalogue stands where a file belongs, or the file cannot be opened.
fn unopened(file: &OsString, error: io::Error) -> Verdict {
    let name = file.to_string_lossy();
    if error.kind() != io::ErrorKind::NotFound || catalog::find(&name).is_none() {
        return Verdict::Unreadable(error);
    }
    Verdict::NoFile(format!(
        "found a name of the catalogue, expected a certificate; `acutile certify {name} -o {name}.cbor` writes one"
    ))
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
    if let Some(found) = other_format(&begin) {
        return Err(Verdict::OtherFormat(found));
    }
    if let Some(found) = something_else(&begin) {
        return Err(Verdict::NoCertificate(found));
    }
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
    verify(&mut &cbor[..], limits)
        .map_err(|refusal| Verdict::Refused(Refused::of_file(&bytes, &cbor, refusal)))
}

/// Adds the length of the file, which the kernel does not know. A file that ends too early is named as
/// such: the kernel names the byte that is missing.
fn refused(mut refusal: Refusal, length: Option<u64>) -> Verdict {
    if let (Code::Cbor, Place::Byte(byte), Some(length)) = (refusal.code, refusal.place, length)
        && byte > length
    {
        return Verdict::NoCertificate(format!(
            "the file ends after {length} bytes, expected the rest of a certificate"
        ));
    }
    if let Wrong::Limit("bytes", enough) = &mut refusal.value {
        *enough = enough.or(length);
    }
    Verdict::Refused(refusal.into())
}

/// The format of another file of the project, and the use of such a file.
fn other_format(begin: &[u8]) -> Option<String> {
    let format = format_of(begin)?;
    let hint = match format.as_str() {
        "acutile-tiling" | "acutile-points" => "; `acutile certify` writes one",
        CLAIM_FORMAT => "; --claim compares a claim with one",
        "acutile-plane-tiling" | "acutile-answer" => "",
        _ => return None,
    };
    Some(format!(
        "found the format {format}, expected a certificate{hint}"
    ))
}

/// The description of a file that begins as no certificate does: neither with a brace nor with a map of
/// CBOR.
fn something_else(begin: &[u8]) -> Option<String> {
    let expected = "expected a certificate";
    if begin.is_empty() {
        return Some(format!("is empty, {expected}"));
    }
    if let Some(name) = unknown::name(Path::new(""), begin) {
        return Some(format!("found {name}, {expected}"));
    }
    let first = begin.trim_ascii_start().first()?;
    let is_text = first.is_ascii_graphic() && *first != b'{';
    is_text.then(|| {
        format!(
            "begins with {:?}, {expected}; `acutile certify` proves a tiling or a mesh, and writes one",
            char::from(*first)
        )
    })
}

/// Bytes by which the encodings differ.
const BEGIN: u64 = 1024;

impl Verdict {
    fn exit_code(&self) -> u8 {
        match self {
            Verdict::Verified(_) => 0,
            Verdict::OtherClaim(_) => 1,
            Verdict::Refused(refused) => match refused.refusal.code.kind() {
                _ if refused.refusal.code == Code::Unreadable => 2,
                Kind::Rejected => 1,
                Kind::Malformed => 2,
                Kind::Declined => 3,
            },
            Verdict::Malformed(error) if error.code.is_declined() => 3,
            Verdict::Malformed(_) | Verdict::NoCertificate(_) | Verdict::OtherFormat(_) => 2,
            Verdict::Unreadable(_) | Verdict::NoFile(_) => 2,
            Verdict::TooLong(_) => 3,
        }
    }

    /// On a terminal a statement a line, elsewhere one line for the file.
    fn tell(&self, file: &OsString, output: &mut Output) {
        let words = match self {
            Verdict::Verified(verified) => statements(&summary(verified)),
            _ => vec![self.message()],
        };
        output.tell(&name(file), self.word(), &words, &self.as_text(file));
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
            Verdict::Refused(refused) if refused.refusal.code == Code::Unreadable => "unreadable",
            Verdict::Refused(refused) => refused.refusal.code.kind().text(),
            Verdict::Malformed(_) => match self.exit_code() {
                3 => "declined",
                _ => "malformed",
            },
            Verdict::NoCertificate(_) | Verdict::OtherFormat(_) => "malformed",
            Verdict::TooLong(_) => "declined",
            Verdict::Unreadable(_) | Verdict::NoFile(_) => "unreadable",
        }
    }

    fn code(&self) -> &'static str {
        match self {
            Verdict::Verified(_) => "verified",
            Verdict::OtherClaim(_) => "other-claim",
            Verdict::Refused(refused) => refused.refusal.code.text(),
            Verdict::Malformed(error) => error.code.name(),
            Verdict::NoCertificate(_) => "cbor",
            Verdict::OtherFormat(_) => "format",
            Verdict::TooLong(_) => "too-many-bytes",
            Verdict::Unreadable(_) | Verdict::NoFile(_) => "unreadable",
        }
    }

    fn message(&self) -> String {
        match self {
            Verdict::Verified(verified) => in_words(verified),
            Verdict::OtherClaim(verified) => {
                format!("it proves another claim: {}", in_words(verified))
            }
            Verdict::Refused(refused) => refused.message(),
            Verdict::Malformed(error) => error.to_string(),
            Verdict::NoCertificate(found) | Verdict::OtherFormat(found) => found.clone(),
            Verdict::TooLong(length) => {
                format!("the file is {}", refusal::exceeded("bytes", *length))
            }
            Verdict::Unreadable(error) => io_words(error),
            Verdict::NoFile(message) => message.clone(),
        }
    }

    /// A verified file with its claim; any other one with a code and the reason, which is an error unless
    /// the file is rejected.
    fn record(&self, file: &OsString) -> Record {
        let record = Record::of(Some(&file.to_string_lossy())).verdict(self.word());
        let record = match self {
            Verdict::Verified(verified) | Verdict::OtherClaim(verified) => record
                .certificate(Some(Path::new(file)), &hexadecimal(&verified.sha256))
                .with(json!({
                    "claim": claim_json(verified),
                    "words": in_words(verified),
                    "vertices": verified.vertices,
                    "simplices": verified.simplices,
                })),
            _ => record,
        };
        let reason = match self.word() {
            "verified" => return record,
            "rejected" => "message",
            _ => "error",
        };
        let record = record.member("code", json!(self.code()));
        record.member(reason, json!(self.message()))
    }
}
