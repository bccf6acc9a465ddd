//! Files in which a line is an item: lines with their words and numbers.

use super::error::{MeshError, Place};
use super::source::{decimal_double, shown, without_mark};

/// The lines of a text, without their ends, numbered from 1.
pub fn numbered(bytes: &[u8]) -> impl Iterator<Item = (u64, &[u8])> {
    let lines = without_mark(bytes).split(|&byte| byte == b'\n');
    (1..).zip(lines.map(|line| line.strip_suffix(b"\r").unwrap_or(line)))
}

/// The lines that have words, separated by white space and commas, before a comment.
pub fn words(bytes: &[u8], comment: u8) -> impl Iterator<Item = Line<'_>> {
    numbered(bytes)
        .map(move |(number, line)| Line::of(number, line, comment))
        .filter(|line| !line.words.is_empty())
}

/// Lines one after the other.
pub struct Lines<'a> {
    lines: Box<dyn Iterator<Item = Line<'a>> + 'a>,
    /// The bytes of the file.
    pub length: usize,
    last: u64,
}

impl<'a> Lines<'a> {
    /// The lines of a file of this many bytes.
    pub fn new(lines: impl Iterator<Item = Line<'a>> + 'a, length: usize) -> Self {
        Lines {
            lines: Box::new(lines),
            length,
            last: 0,
        }
    }

    /// The next line; `what` says what it should be.
    pub fn next(&mut self, what: &str) -> Result<Line<'a>, MeshError> {
        match self.lines.next() {
            Some(line) => {
                self.last = line.number;
                Ok(line)
            }
            None => {
                let place = Place::Line(self.last + 1);
                let problem = format!("the file ends, expected {what}");
                Err(MeshError::at(place, problem))
            }
        }
    }

    /// No line is left.
    pub fn expect_end(&mut self, what: &str) -> Result<(), MeshError> {
        match self.lines.next() {
            None => Ok(()),
            Some(line) => {
                let found = shown(line.words[0]);
                let problem =
                    format!("found {found}, expected the end after the last of the {what}");
                Err(line.error(problem))
            }
        }
    }
}

/// A line with its words.
pub struct Line<'a> {
    /// Counted from 1.
    pub number: u64,
    /// Its words.
    pub words: Vec<&'a [u8]>,
}

impl<'a> Line<'a> {
    fn of(number: u64, line: &'a [u8], comment: u8) -> Self {
        let is_separator = |byte: &u8| byte.is_ascii_whitespace() || *byte == b',';
        let end = line.iter().position(|&byte| byte == comment);
        let line = &line[..end.unwrap_or(line.len())];
        let words = line.split(is_separator).filter(|word| !word.is_empty());
        Line {
            number,
            words: words.collect(),
        }
    }

    /// An error in this line.
    pub fn error(&self, problem: impl std::fmt::Display) -> MeshError {
        MeshError::at(Place::Line(self.number), problem)
    }

    /// The number in a column; `what` says what it should be.
    pub fn parsed<T: std::str::FromStr>(&self, column: usize, what: &str) -> Result<T, MeshError> {
        let Some(word) = self.words.get(column) else {
            let found = self.words.len();
            return Err(self.error(format!("the line has {found} columns, expected {what}")));
        };
        let value = std::str::from_utf8(word).ok().and_then(|w| w.parse().ok());
        value.ok_or_else(|| self.error(format!("found {}, expected {what}", shown(word))))
    }

    /// An entry of a head, 0 where the line is shorter.
    pub fn entry(&self, column: usize, what: &str) -> Result<usize, MeshError> {
        if self.words.len() > column {
            self.parsed(column, what)
        } else {
            Ok(0)
        }
    }

    /// The finite double in a column.
    pub fn coordinate(&self, column: usize) -> Result<f64, MeshError> {
        let Some(word) = self.words.get(column) else {
            let found = self.words.len();
            return Err(self.error(format!(
                "the line has {found} columns, expected a coordinate"
            )));
        };
        decimal_double(word)
            .filter(|value| value.is_finite())
            .ok_or_else(|| {
                self.error(format!(
                    "found {}, expected a coordinate, a number in the range of doubles",
                    shown(word)
                ))
            })
    }
}
