//! A cursor over the bytes of a mesh file. It reads numbers in text or in binary, and knows its line
//! or its byte.

use super::error::{MeshError, Place};
use super::words::integer;
pub use super::words::{decimal_double, shown, without_mark};

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Decimal, between white space.
    Text,
    /// As in memory, the least significant byte first.
    Little,
    /// As in memory, the most significant byte first.
    Big,
}

/// The bytes, and where reading has come to.
#[derive(Clone, Debug)]
pub struct Source<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u64,
    /// How numbers are written from here on.
    pub encoding: Encoding,
    /// Text from this byte to the end of the line is passed over.
    comment: Option<u8>,
}

type Read<T> = Result<T, MeshError>;

impl<'a> Source<'a> {
    /// At the first byte after a byte order mark, numbers in text.
    pub fn new(bytes: &'a [u8]) -> Self {
        let bytes = without_mark(bytes);
        Source {
            bytes,
            at: 0,
            line: 1,
            encoding: Encoding::Text,
            comment: None,
        }
    }

    /// With comments from `mark` to the end of a line.
    pub fn with_comments(bytes: &'a [u8], mark: u8) -> Self {
        Source {
            comment: Some(mark),
            ..Source::new(bytes)
        }
    }

    /// The line of the next word.
    pub fn next_line_number(&mut self) -> u64 {
        self.skip_space();
        self.line
    }

    /// The byte of the cursor.
    pub fn position(&self) -> usize {
        self.at
    }

    /// How many bytes are left.
    pub fn remaining(&self) -> usize {
        self.bytes.len() - self.at
    }

    /// Where the cursor stands.
    pub fn place(&self) -> Place {
        match self.encoding {
            Encoding::Text => Place::Line(self.line),
            _ => Place::Byte(self.at as u64),
        }
    }

    /// An error where the cursor stands.
    pub fn error(&self, problem: impl std::fmt::Display) -> MeshError {
        MeshError::at(self.place(), problem)
    }

    fn skip_space(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if byte == b'\n' {
                self.line += 1;
            } else if Some(byte) == self.comment {
                self.skip_to_line_end();
                continue;
            } else if !byte.is_ascii_whitespace() {
                return;
            }
            self.at += 1;
        }
    }

    fn skip_to_line_end(&mut self) {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|&byte| byte == b'\n');
        self.at += length.unwrap_or(rest.len());
    }

    /// Whether nothing but white space and comments is left; these are passed over.
    pub fn is_at_text_end(&mut self) -> bool {
        self.skip_space();
        self.remaining() == 0
    }

    /// The next word of text, if there is one.
    pub fn try_word(&mut self) -> Option<&'a [u8]> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let length = rest
            .iter()
            .position(u8::is_ascii_whitespace)
            .unwrap_or(rest.len());
        self.at += length;
        (length > 0).then_some(&rest[..length])
    }

    /// The next word of text; `what` says what it should be.
    pub fn word(&mut self, what: &str) -> Read<&'a [u8]> {
        self.try_word()
            .ok_or_else(|| self.error(format!("the file ends, expected {what}")))
    }

    /// Passes over this very word.
    pub fn expect(&mut self, expected: &str) -> Read<()> {
        let word = self.word(expected)?;
        if word == expected.as_bytes() {
            Ok(())
        } else {
            Err(self.unexpected(word, expected))
        }
    }

    /// An error about a word that was just read.
    pub fn unexpected(&self, word: &[u8], expected: &str) -> MeshError {
        self.error(format!("found {}, expected {expected}", shown(word)))
    }

    /// The rest of the line without its end; the cursor goes to the next line.
    pub fn rest_of_line(&mut self) -> &'a [u8] {
        let start = self.at;
        self.skip_to_line_end();
        let line = &self.bytes[start..self.at];
        if self.at < self.bytes.len() {
            self.at += 1;
            self.line += 1;
        }
        line.trim_ascii()
    }

    /// The cursor after the next occurrence of `mark` at the end of a word. `None` where there is
    /// none.
    pub fn skip_past(&mut self, mark: &str) -> Option<()> {
        let mark = mark.as_bytes();
        loop {
            let rest = &self.bytes[self.at..];
            let length = rest.windows(mark.len()).position(|window| window == mark)?;
            let end = length + mark.len();
            self.line += rest[..end].iter().filter(|&&byte| byte == b'\n').count() as u64;
            self.at += end;
            if self.at_word_end() {
                return Some(());
            }
        }
    }

    fn at_word_end(&self) -> bool {
        self.bytes.get(self.at).is_none_or(u8::is_ascii_whitespace)
    }

    /// Passes over the next word if it is this one, and tells whether it is.
    pub fn skip_word(&mut self, word: &str) -> bool {
        let mut ahead = self.clone();
        let is_next = ahead.try_word() == Some(word.as_bytes());
        if is_next {
            *self = ahead;
        }
        is_next
    }

    /// Three coordinates.
    pub fn point(&mut self) -> Read<[f64; 3]> {
        Ok([
            self.double("the coordinate x")?,
            self.double("the coordinate y")?,
            self.double("the coordinate z")?,
        ])
    }

    /// The next `length` bytes.
    pub fn take(&mut self, length: usize, what: &str) -> Read<&'a [u8]> {
        if self.remaining() < length {
            let problem = format!(
                "the file ends after {} bytes, expected {length} bytes: {what}",
                self.remaining()
            );
            return Err(MeshError::at(Place::Byte(self.at as u64), problem));
        }
        let taken = &self.bytes[self.at..self.at + length];
        self.at += length;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self, what: &str) -> Read<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N, what)?);
        if self.encoding == Encoding::Big {
            array.reverse();
        }
        Ok(array)
    }

    /// A signed integer: in text, or of 32 bits.
    pub fn int(&mut self, what: &str) -> Read<i64> {
        match self.encoding {
            Encoding::Text => self.decimal(what),
            _ => Ok(i64::from(i32::from_le_bytes(self.array(what)?))),
        }
    }

    /// A signed integer: in text, or of 64 bits.
    pub fn long(&mut self, what: &str) -> Read<i64> {
        match self.encoding {
            Encoding::Text => self.decimal(what),
            _ => Ok(i64::from_le_bytes(self.array(what)?)),
        }
    }

    /// A finite double: in text, or of 64 bits.
    pub fn double(&mut self, what: &str) -> Read<f64> {
        let value = match self.encoding {
            Encoding::Text => return self.decimal_double(what),
            _ => f64::from_le_bytes(self.array(what)?),
        };
        self.finite(value, what)
    }

    /// A finite number of single precision: in text, or of 32 bits.
    pub fn single(&mut self, what: &str) -> Read<f64> {
        let value = match self.encoding {
            Encoding::Text => f64::from(self.decimal_double(what)? as f32),
            _ => f64::from(f32::from_le_bytes(self.array(what)?)),
        };
        self.finite(value, what)
    }

    fn finite(&self, value: f64, what: &str) -> Read<f64> {
        if value.is_finite() {
            Ok(value)
        } else {
            Err(self.error(format!("found {value}, expected {what}, a finite number")))
        }
    }

    /// The double nearest to a decimal text. Fortran's `1.5D-3` is 1.5e-3.
    fn decimal_double(&mut self, what: &str) -> Read<f64> {
        let word = self.word(what)?;
        match decimal_double(word) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => Err(self.unexpected(word, &format!("{what} in the range of doubles"))),
            None => Err(self.unexpected(word, &format!("{what}, a finite number"))),
        }
    }

    fn decimal(&mut self, what: &str) -> Read<i64> {
        if let Some(value) = self.short_natural() {
            return Ok(value);
        }
        let word = self.word(what)?;
        integer(word).ok_or_else(|| self.unexpected(word, &format!("{what}, an integer")))
    }

    /// A word of at most 18 digits, which is most numbers of a mesh file, in one pass;
    /// before any other word the cursor stays.
    fn short_natural(&mut self) -> Option<i64> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let (mut value, mut length) = (0, 0);
        while length < 18
            && let Some(digit @ b'0'..=b'9') = rest.get(length)
        {
            value = 10 * value + i64::from(digit - b'0');
            length += 1;
        }
        let is_word = length > 0 && rest.get(length).is_none_or(u8::is_ascii_whitespace);
        self.at += if is_word { length } else { 0 };
        is_word.then_some(value)
    }

    /// How many items follow, each of which takes at least `least` bytes: no more than the rest of
    /// the file contains.
    pub fn count(&mut self, value: i64, least: usize, what: &str) -> Read<usize> {
        let most = self.remaining() / least.max(1);
        match usize::try_from(value) {
            // The last item may lack the separator.
            Ok(count) if count <= most + 1 => Ok(count),
            _ => Err(self.error(format!(
                "found {value} as the number of {what}, but the {} bytes that are left \
                 contain at most {most}",
                self.remaining()
            ))),
        }
    }

    /// The fewest bytes of `numbers` integers: a digit and a space in text.
    pub fn least_bytes(&self, numbers: usize, width: usize) -> usize {
        match self.encoding {
            Encoding::Text => 2 * numbers,
            _ => width * numbers,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_numbers() {
        let mut source = Source::with_comments(b"12 -7 # nothing 5\n 0.1 1e400 nan 1x", b'#');
        assert_eq!(source.int("n"), Ok(12));
        assert_eq!(source.long("n"), Ok(-7));
        assert_eq!(source.double("x"), Ok(0.1));
        for expected in [
            "line 2: found \"1e400\", expected x in the range of doubles",
            "line 2: found \"nan\", expected x, a finite number",
            "line 2: found \"1x\", expected x, a finite number",
            "line 2: the file ends, expected x",
        ] {
            let error = source.double("x").expect_err("no number");
            assert_eq!(error.to_string(), expected);
        }
    }

    #[test]
    fn integers_of_any_length_are_read_alike() {
        let mut source =
            Source::new(b"007 999999999999999999 +12\r\n-0\t1234567890123456789 1.5 5");
        for expected in [7, 999_999_999_999_999_999, 12, 0] {
            assert_eq!(source.int("n"), Ok(expected));
        }
        for expected in [
            "line 2: found \"1234567890123456789\", expected n, an integer",
            "line 2: found \"1.5\", expected n, an integer",
        ] {
            let error = source.int("n").expect_err("no integer of 18 digits");
            assert_eq!(error.to_string(), expected);
        }
        assert_eq!(source.int("n"), Ok(5));
        assert!(source.int("n").is_err());
    }

    #[test]
    fn words_of_infinity_are_no_numbers() {
        for word in ["inf", "-INF", "+infinity", "NaN", "-nan", "", "+", "."] {
            assert!(Source::new(word.as_bytes()).double("x").is_err(), "{word}");
        }
        for (word, value) in [(".5", 0.5), ("+1.", 1.0), ("-2e-1", -0.2), ("1E3", 1000.0)] {
            assert_eq!(Source::new(word.as_bytes()).double("x"), Ok(value));
        }
    }

    #[test]
    fn binary_numbers_in_either_order() {
        let mut little = Source::new(&[1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0]);
        little.encoding = Encoding::Little;
        assert_eq!(little.int("n"), Ok(1));
        assert_eq!(little.double("x"), Ok(1.0));
        let error = little.int("n").expect_err("two bytes are left");
        assert_eq!(error.place, Place::Byte(12));
        let mut big = Source::new(&[0, 0, 0, 0, 0, 0, 1, 2]);
        big.encoding = Encoding::Big;
        assert_eq!(big.long("n"), Ok(258));
    }

    #[test]
    fn a_count_is_no_more_than_the_file_has_room_for() {
        let mut source = Source::new(b"1 2 3 4");
        assert_eq!(source.count(4, 2, "numbers"), Ok(4));
        assert!(source.count(5, 2, "numbers").is_err());
        assert!(source.count(-1, 2, "numbers").is_err());
        assert!(source.count(i64::MAX, 2, "numbers").is_err());
    }
}
