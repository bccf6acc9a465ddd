//! Transcribes a certificate's JSON into CBOR, item by item.
//!
//! A record becomes the array of its members' values, a string of decimal digits becomes an
//! integer. Then the CBOR is printed again and compared with the input, so that one certificate
//! has one JSON text. It decides nothing else: the kernel judges the CBOR.

use super::cbor;
use super::json_error::Fault;
pub use super::json_error::{JsonCode, JsonError, place_of_item};
use super::print::{self, DEEPEST, Members, PrintError, RECORDS};
use malachite::Integer;
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::str::FromStr;

/// The CBOR of a certificate in JSON.
///
/// # Errors
/// [`JsonError`] if the text is not the canonical JSON of some CBOR.
pub fn to_cbor(json: &[u8]) -> Result<Vec<u8>, JsonError> {
    transcribed(json, false).map_err(|fault| fault.within(json))
}

/// The CBOR of a claim file in JSON.
///
/// # Errors
/// As [`to_cbor`].
pub fn claim_to_cbor(json: &[u8]) -> Result<Vec<u8>, JsonError> {
    transcribed(json, true).map_err(|fault| fault.within(json))
}

fn transcribed(json: &[u8], is_claim_file: bool) -> Result<Vec<u8>, Fault> {
    let mut reader = Reader {
        json,
        offset: 0,
        cbor: Vec::with_capacity(json.len() / 2),
        version: None,
        kind: None,
    };
    let read = reader.document();
    let declined = |code, problem| Fault {
        code,
        offset: 0,
        problem,
    };
    if reader.version.is_some_and(|v| v != super::VERSION) {
        return Err(declined(JsonCode::Version, "expected version 2"));
    }
    let kind = reader.kind.as_deref().unwrap_or(super::KIND);
    let Some(members) = print::members_of(kind, is_claim_file) else {
        let problem = "expected the kind \"tiling\", \"family\" or \"patches\"";
        return Err(declined(JsonCode::Kind, problem));
    };
    read?;
    check_canonical(json, &reader.cbor, members)?;
    Ok(reader.cbor)
}

/// Prints the CBOR again, and compares.
fn check_canonical(json: &[u8], cbor: &[u8], members: Members) -> Result<(), Fault> {
    let mut comparison = Comparison {
        expected: json,
        offset: 0,
        is_other_shape: false,
    };
    let printed = print::print(cbor, members, &mut comparison);
    let offset = comparison.offset;
    match printed {
        Ok(()) if offset == json.len() => Ok(()),
        Err(PrintError::Write(_)) if comparison.is_other_shape => Err(Fault {
            code: JsonCode::Json,
            offset,
            problem: "an array stands for a record, or a record for an array",
        }),
        Ok(()) | Err(PrintError::Write(_)) => Err(Fault {
            code: JsonCode::Canonical,
            offset,
            problem: "the text is not the canonical one",
        }),
        Err(PrintError::Cbor(error)) => Err(Fault {
            code: JsonCode::Json,
            offset,
            problem: error.problem,
        }),
    }
}

/// Takes the bytes that are expected, and refuses others.
struct Comparison<'j> {
    expected: &'j [u8],
    offset: usize,
    /// Whether the bytes differ in the bracket that opens an array or a record.
    is_other_shape: bool,
}

impl Write for Comparison<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let rest = &self.expected[self.offset..];
        let equal = rest.iter().zip(bytes).take_while(|(a, b)| a == b).count();
        self.offset += equal;
        if equal == bytes.len() {
            Ok(equal)
        } else {
            let is_bracket = |byte: Option<&u8>| matches!(byte, Some(b'[' | b'{'));
            self.is_other_shape = is_bracket(rest.get(equal)) && is_bracket(bytes.get(equal));
            Err(io::ErrorKind::InvalidData.into())
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

struct Reader<'j> {
    json: &'j [u8],
    offset: usize,
    cbor: Vec<u8>,
    /// The version that the outermost record gives.
    version: Option<u64>,
    /// Its kind, if that is a text.
    kind: Option<String>,
}

impl<'j> Reader<'j> {
    fn document(&mut self) -> Result<(), Fault> {
        self.value(0)?;
        self.skip_space();
        if self.offset == self.json.len() {
            Ok(())
        } else {
            Err(self.error("bytes follow the certificate"))
        }
    }

    fn error(&self, problem: &'static str) -> Fault {
        let problem = if self.offset == self.json.len() {
            "the file ends, expected the rest of a certificate"
        } else {
            problem
        };
        Fault {
            code: JsonCode::Json,
            offset: self.offset,
            problem,
        }
    }

    fn peek(&self) -> Option<u8> {
        self.json.get(self.offset).copied()
    }

    fn skip_space(&mut self) {
        while let Some(b' ' | b'\n' | b'\r' | b'\t') = self.peek() {
            self.offset += 1;
        }
    }

    /// The next byte that is no space, taken if it is this one.
    fn take(&mut self, byte: u8) -> bool {
        self.skip_space();
        let is_there = self.peek() == Some(byte);
        self.offset += usize::from(is_there);
        is_there
    }

    fn value(&mut self, depth: usize) -> Result<(), Fault> {
        if depth > DEEPEST {
            return Err(self.error("the arrays are nested too deeply"));
        }
        self.skip_space();
        match self.peek() {
            Some(b'[') => self.array(depth),
            Some(b'{') => self.record(depth),
            Some(b'"') => {
                let text = self.string()?;
                self.put(|cbor| {
                    if is_decimal(&text) {
                        cbor::integer(cbor, &Integer::from_str(&text).unwrap_or_default())
                    } else {
                        cbor::text(cbor, &text)
                    }
                });
                Ok(())
            }
            Some(b'-' | b'0'..=b'9') => {
                let value = self.number()?;
                self.put(|cbor| cbor::integer(cbor, &value));
                Ok(())
            }
            _ => Err(self.error("expected an integer, a text, an array or a record")),
        }
    }

    /// A Vec takes every byte.
    fn put(&mut self, write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) {
        let _ = write(&mut self.cbor);
    }

    fn array(&mut self, depth: usize) -> Result<(), Fault> {
        self.offset += 1;
        let start = self.cbor.len();
        let mut length = 0;
        if !self.take(b']') {
            loop {
                self.value(depth + 1)?;
                length += 1;
                if self.take(b']') {
                    break;
                }
                if !self.take(b',') {
                    return Err(self.error("expected a comma or the end of the array"));
                }
            }
        }
        self.insert_head(start, length);
        Ok(())
    }

    /// Puts the head of an array before its elements.
    fn insert_head(&mut self, start: usize, length: usize) {
        let mut head = Vec::with_capacity(9);
        // A Vec takes every byte.
        let _ = cbor::array(&mut head, length);
        self.cbor.splice(start..start, head);
    }

    fn record(&mut self, depth: usize) -> Result<(), Fault> {
        let offset = self.offset;
        self.offset += 1;
        let start = self.cbor.len();
        let mut names: Vec<String> = Vec::new();
        if !self.take(b'}') {
            loop {
                self.skip_space();
                if self.peek() != Some(b'"') {
                    return Err(self.error("expected a member's name"));
                }
                let name = self.string()?;
                if !self.take(b':') {
                    return Err(self.error("expected a colon"));
                }
                let value = self.cbor.len();
                self.value(depth + 1)?;
                if depth == 0 && name == "version" {
                    self.version = version(&self.cbor[value..]);
                }
                if depth == 0 && name == "kind" {
                    self.kind = cbor::Items::new(&self.cbor[value..])
                        .text()
                        .ok()
                        .map(str::to_owned);
                }
                names.push(name);
                if self.take(b'}') {
                    break;
                }
                if !self.take(b',') {
                    return Err(self.error("expected a comma or the end of the record"));
                }
            }
        }
        self.check_names(&names, offset)?;
        self.insert_head(start, names.len());
        Ok(())
    }

    /// The names are those of a record. Whether it stands in its place is seen in printing.
    fn check_names(&self, names: &[String], offset: usize) -> Result<(), Fault> {
        let error = |code, problem| Fault {
            code,
            offset,
            problem,
        };
        let is = |members: &Members| members.iter().map(|(name, _)| name).eq(names);
        if RECORDS.iter().any(is) {
            return Ok(());
        }
        let sorted: BTreeSet<&str> = names.iter().map(String::as_str).collect();
        let has_these = |members: &Members| {
            let expected: BTreeSet<&str> = members.iter().map(|(name, _)| *name).collect();
            expected == sorted
        };
        Err(if RECORDS.iter().any(has_these) {
            error(
                JsonCode::Canonical,
                "a member is repeated, or the order is another",
            )
        } else {
            error(JsonCode::Json, "the members are not those of a record")
        })
    }

    /// A string of printable ASCII. Escapes are read, and are not canonical.
    fn string(&mut self) -> Result<String, Fault> {
        self.offset += 1;
        let mut text = String::new();
        loop {
            match self.peek() {
                Some(b'"') => break,
                Some(b'\\') => text.push(self.escaped()?),
                Some(byte @ 0x20..0x7f) => text.push(char::from(byte)),
                _ => return Err(self.error("expected printable ASCII and a closing quote")),
            }
            self.offset += 1;
        }
        self.offset += 1;
        Ok(text)
    }

    /// The character of the escape that begins here; the last byte of it is left.
    fn escaped(&mut self) -> Result<char, Fault> {
        self.offset += 1;
        match self.peek() {
            Some(byte @ (b'"' | b'\\' | b'/')) => Ok(char::from(byte)),
            Some(b'u') => {
                let digits = self.json.get(self.offset + 1..self.offset + 5);
                let digits = digits.and_then(|digits| std::str::from_utf8(digits).ok());
                let code = digits.and_then(|digits| u8::from_str_radix(digits, 16).ok());
                match code {
                    Some(code @ 0x20..0x7f) => {
                        self.offset += 4;
                        Ok(char::from(code))
                    }
                    _ => Err(self.error("expected printable ASCII")),
                }
            }
            _ => Err(self.error("expected printable ASCII")),
        }
    }

    /// An integer. `1.0` and `1e3` are integers, too, and not canonical.
    fn number(&mut self) -> Result<Integer, Fault> {
        let start = self.offset;
        let is_part = |byte: &u8| matches!(byte, b'0'..=b'9' | b'-' | b'+' | b'.' | b'e' | b'E');
        let length = self.json[start..].iter().take_while(|b| is_part(b)).count();
        self.offset += length;
        let text = std::str::from_utf8(&self.json[start..self.offset]).unwrap_or_default();
        integer(text).ok_or(Fault {
            code: JsonCode::Json,
            offset: start,
            problem: "expected an integer",
        })
    }
}

/// The value of a number as JSON writes it, if it is an integer.
fn integer(text: &str) -> Option<Integer> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = match mantissa.split_once('.') {
        Some((_, "")) => return None,
        Some((whole, fraction)) => (whole, fraction),
        None => (mantissa, ""),
    };
    let is_whole = is_decimal(whole) || whole == "0" || whole == "-0";
    if !is_whole || !fraction.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let zeros = i64::from(exponent) - i64::try_from(fraction.len()).ok()?;
    let mut digits = format!("{whole}{fraction}");
    if zeros.unsigned_abs() > LONGEST_EXPONENT {
        return None;
    }
    for _ in 0..zeros {
        digits.push('0');
    }
    for _ in zeros..0 {
        digits = digits.strip_suffix('0')?.to_owned();
    }
    Integer::from_str(&digits).ok()
}

/// No exponent is larger.
const LONGEST_EXPONENT: u64 = 400;

/// `-?[1-9][0-9]*`
fn is_decimal(text: &str) -> bool {
    let digits = text.strip_prefix('-').unwrap_or(text).as_bytes();
    matches!(digits, [b'1'..=b'9', rest @ ..] if rest.iter().all(u8::is_ascii_digit))
}

/// The value of a version, if it is a small integer.
fn version(cbor: &[u8]) -> Option<u64> {
    let value = cbor::Items::new(cbor).small().ok()?;
    u64::try_from(value).ok()
}
