//! The parts of a VTU file before its XML is read: the XML, the appended data after it, and
//! the lines of bytes.

use super::error::{MeshError, Place};
use std::io::BufRead;

/// The bytes after the tag `AppendedData`, and their encoding.
#[derive(Clone, Copy)]
pub struct Appended<'a> {
    /// The bytes after the underscore.
    pub data: &'a [u8],
    /// Whether they are in base64.
    pub is_base64: bool,
    /// The byte of the file where `data` begins.
    pub start: usize,
}

/// The XML before the appended data, and these.
pub fn split(bytes: &[u8]) -> Result<(&str, Option<Appended<'_>>), MeshError> {
    let start = position(bytes, b"<AppendedData");
    let head = &bytes[..start.unwrap_or(bytes.len())];
    let xml = std::str::from_utf8(head).map_err(|error| {
        let byte = error.valid_up_to() as u64;
        MeshError::at(Place::Byte(byte), "not UTF-8 text, expected XML")
    })?;
    let Some(start) = start else {
        return Ok((xml, None));
    };
    let wrong = |problem| MeshError::at(Place::Byte(start as u64), problem);
    let rest = &bytes[start..];
    let close = rest.iter().position(|&byte| byte == b'>');
    let close = close.ok_or_else(|| wrong("the tag AppendedData does not end"))?;
    let tag = String::from_utf8_lossy(&rest[..close]).replace('\'', "\"");
    let is_base64 = match tag
        .split("encoding=\"")
        .nth(1)
        .and_then(|t| t.split('"').next())
    {
        Some("base64") => true,
        Some("raw") => false,
        _ => {
            return Err(wrong(
                "AppendedData has no encoding, expected \"raw\" or \"base64\"",
            ));
        }
    };
    let underscore = rest[close..].iter().position(|&byte| byte == b'_');
    let underscore = underscore.ok_or_else(|| wrong("the appended data have no underscore"))?;
    let data = close + underscore + 1;
    if let Some(second) = position(&rest[data..], b"<VTKFile") {
        let place = Place::Byte((start + data + second) as u64);
        return Err(MeshError::at(place, SECOND));
    }
    Ok((
        xml,
        Some(Appended {
            data: &rest[data..],
            is_base64,
            start: start + data,
        }),
    ))
}

/// What is wrong with a file that has another one behind it.
pub const SECOND: &str = "found a second VTKFile, expected the end of the file";

/// Where this tag, which begins with its bracket, is in the bytes.
fn position(bytes: &[u8], tag: &[u8]) -> Option<usize> {
    let mut at = 0;
    loop {
        at += length_before(&bytes[at..], b'<');
        if at == bytes.len() {
            return None;
        }
        if bytes[at..].starts_with(tag) {
            return Some(at);
        }
        at += 1;
    }
}

/// How many bytes there are before the first of this value, or at all.
pub fn length_before(mut bytes: &[u8], mark: u8) -> usize {
    let before = bytes;
    // Reading from memory does not fail; this is the search of the standard library.
    let read = bytes.skip_until(mark).unwrap_or(0);
    match before[..read].last() {
        Some(last) if *last == mark => read - 1,
        _ => read,
    }
}

/// Lines of bytes, asked for in ascending order.
pub struct Lines<'a> {
    xml: &'a str,
    at: usize,
    line: u64,
}

impl<'a> Lines<'a> {
    /// From the first line on.
    pub fn new(xml: &'a str) -> Self {
        Lines {
            xml,
            at: 0,
            line: 1,
        }
    }

    /// The line of a byte.
    pub fn of(&mut self, at: usize) -> Place {
        let at = at.clamp(self.at, self.xml.len());
        let between = &self.xml.as_bytes()[self.at..at];
        self.line += between.iter().filter(|&&byte| byte == b'\n').count() as u64;
        self.at = at;
        Place::Line(self.line)
    }
}
