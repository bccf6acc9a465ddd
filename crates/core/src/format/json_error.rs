//! Why JSON is no certificate: the kinds of errors, and where they are.
//!
//! The kernel names bytes of the CBOR. [`place_of_item`] finds the line and column of JSON that they come from.

use super::print;
use std::fmt;
use std::io::{self, Write};

/// Why JSON is no certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JsonError {
    /// The kind of error.
    pub code: JsonCode,
    /// The line where it was noticed, counted from 1.
    pub line: usize,
    /// The byte of the line where it was noticed, counted from 1.
    pub column: usize,
    /// The text of this line, which is cut if it is long.
    pub text: String,
    /// The rule that is broken.
    pub problem: &'static str,
}

/// An error at a byte of the text.
pub(super) struct Fault {
    pub code: JsonCode,
    pub offset: usize,
    pub problem: &'static str,
}

impl Fault {
    pub fn within(self, json: &[u8]) -> JsonError {
        let (line, column, text) = line_at(json, self.offset);
        JsonError {
            code: self.code,
            line,
            column,
            text,
            problem: self.problem,
        }
    }
}

/// Characters of a line that an error quotes.
const QUOTED: usize = 60;

/// The line and column of a byte, both counted from 1, and the text of the line. The text begins at this
/// byte if that is far from the start. A file cannot bring control characters into a message.
fn line_at(json: &[u8], offset: usize) -> (usize, usize, String) {
    let (before, after) = json.split_at(offset.min(json.len()));
    let ends = before.iter().filter(|byte| **byte == b'\n').count();
    let start = before.iter().rposition(|byte| *byte == b'\n');
    let start = start.map_or(0, |end| end + 1);
    let is_far = before.len() - start > QUOTED;
    let first = if is_far { before.len() } else { start };
    let length = after.iter().position(|byte| *byte == b'\n');
    let end = length.map_or(json.len(), |length| before.len() + length);
    let line = json[first..end].trim_ascii();
    let line = line.strip_suffix(b",").unwrap_or(line);
    let plain = |byte: &u8| match *byte {
        b' '..=b'~' => char::from(*byte),
        _ => '?',
    };
    let quoted: String = line.iter().take(QUOTED).map(plain).collect();
    let marker = if is_far { "... " } else { "" };
    let rest = if line.len() > QUOTED { " ..." } else { "" };
    let column = offset.min(json.len()) - start + 1;
    (ends + 1, column, format!("{marker}{quoted}{rest}"))
}

/// The place in canonical JSON of the item that ends at this byte of the certificate's CBOR.
///
/// The CBOR is printed up to this byte. So the printed text ends where the item begins.
pub fn place_of_item(json: &[u8], cbor: &[u8], byte: u64) -> Option<String> {
    let members = print::members_of(super::kind(cbor)?, false)?;
    let end = usize::try_from(byte).ok()?.checked_sub(1)?;
    let mut printed = Length(0);
    // It fails at the item that is cut.
    let _ = print::print(cbor.get(..end)?, members, &mut printed);
    let is_between = |byte: &&u8| byte.is_ascii_whitespace() || **byte == b',';
    let skipped = json.get(printed.0..)?.iter().take_while(is_between).count();
    let (line, column, text) = line_at(json, printed.0 + skipped);
    Some(format!("line {line}, column {column} ({text})"))
}

/// Counts the bytes that are written.
struct Length(usize);

impl Write for Length {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 += bytes.len();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The kinds of errors, with the names of docs/format.md.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JsonCode {
    /// Not JSON of the grammar's shape.
    Json,
    /// Not the canonical text.
    Canonical,
    /// Another version.
    Version,
    /// Another kind of certificate.
    Kind,
}

impl JsonCode {
    /// The name of the refusal.
    pub fn name(self) -> &'static str {
        match self {
            JsonCode::Json => "json",
            JsonCode::Canonical => "canonical",
            JsonCode::Version => "version",
            JsonCode::Kind => "kind",
        }
    }

    /// Whether nothing is decided: a later program may read the certificate.
    pub fn is_declined(self) -> bool {
        matches!(self, JsonCode::Version | JsonCode::Kind)
    }
}

impl fmt::Display for JsonError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self {
            line,
            column,
            text,
            problem,
            ..
        } = self;
        write!(f, "line {line}, column {column} ({text}): {problem}")
    }
}

impl std::error::Error for JsonError {}
