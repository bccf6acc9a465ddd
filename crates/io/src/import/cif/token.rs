//! The words of CIF 1.1: `data_` headers, `loop_`, tags and values, with their lines.
//!
//! The syntax is that of S. R. Hall, J. D. Westbrook, Specification of the
//! Crystallographic Information File, International Tables G (2005), chapter 2.2. A
//! value is a word, a text in quotes, or the lines between two lines that begin with `;`.
//! A quote ends a text only before white space. A value that begins with a bracket is reserved
//! there, but programs write it, so it is read. A file that begins with `#\#CIF_2.0` has the lists,
//! tables and triple quotes of CIF 2.0 (H. J. Bernstein et al., J. Appl. Cryst. 49 (2016) 277), and
//! its quotes end at the next quote.

use crate::import::ImportError;
use crate::import::words::short;

/// A value as it stands in the file.
#[derive(Clone, Copy, Debug)]
pub struct Value<'t> {
    /// Without its quotes.
    pub text: &'t str,
    /// Of the file, from 1.
    pub line: u32,
    /// Whether it had quotes: `'?'` is a question mark, `?` is nothing known.
    pub quoted: bool,
}

impl Value<'_> {
    /// `?` (unknown) and `.` (not applicable).
    pub fn is_missing(&self) -> bool {
        !self.quoted && matches!(self.text, "?" | ".")
    }
}

/// A word of the file.
#[derive(Clone, Copy, Debug)]
pub enum Token<'t> {
    /// `data_NAME`, the name.
    Data(&'t str),
    /// `loop_`
    Loop,
    /// `_tag`, as it is written.
    Tag(&'t str),
    Value(Value<'t>),
}

/// The error of a line.
pub fn at_line(line: u32, problem: impl std::fmt::Display) -> ImportError {
    ImportError::entry(format!("line {line}"), problem)
}

/// Goes through a text, word by word.
pub struct Tokens<'t> {
    text: &'t str,
    /// The byte to be read next.
    at: usize,
    /// Its line.
    line: u32,
    /// CIF 2.0
    is_second: bool,
}

impl<'t> Tokens<'t> {
    /// The words of a text.
    pub fn of(text: &'t str) -> Self {
        Tokens {
            text,
            at: 0,
            line: 1,
            is_second: text.starts_with("#\\#CIF_2.0"),
        }
    }

    /// The next word and its line; `None` at the end.
    ///
    /// # Errors
    /// An unfinished text, or a word that CIF 1.1 reserves.
    pub fn next(&mut self) -> Result<Option<(Token<'t>, u32)>, ImportError> {
        self.skip_blanks();
        let line = self.line;
        let token = match self.byte(0) {
            None => return Ok(None),
            Some(b';') if self.is_line_start() => self.text_field()?,
            Some(quote @ (b'\'' | b'"')) if self.is_triple(quote) => self.triple_quoted(quote)?,
            Some(quote @ (b'\'' | b'"')) => self.quoted(quote)?,
            Some(b'[' | b'{') if self.is_second => self.collection()?,
            Some(_) => self.word()?,
        };
        Ok(Some((token, line)))
    }

    fn byte(&self, ahead: usize) -> Option<u8> {
        self.text.as_bytes().get(self.at + ahead).copied()
    }

    fn is_line_start(&self) -> bool {
        self.at == 0 || matches!(self.text.as_bytes()[self.at - 1], b'\n' | b'\r')
    }

    /// One byte further; `\n`, `\r\n` and `\r` end a line.
    fn step(&mut self) {
        match self.byte(0) {
            Some(b'\n') => self.line += 1,
            Some(b'\r') if self.byte(1) != Some(b'\n') => self.line += 1,
            _ => {}
        }
        self.at += 1;
    }

    fn skip_blanks(&mut self) {
        loop {
            match self.byte(0) {
                Some(byte) if is_blank(byte) => self.step(),
                Some(b'#') => self.skip_line(),
                _ => return,
            }
        }
    }

    fn skip_line(&mut self) {
        while self.byte(0).is_some_and(|byte| !is_line_end(byte)) {
            self.at += 1;
        }
    }

    /// From `;` at the beginning of a line to the next one there.
    fn text_field(&mut self) -> Result<Token<'t>, ImportError> {
        let (start, line) = (self.at + 1, self.line);
        self.at += 1;
        loop {
            match self.byte(0) {
                None => {
                    let problem = "the text that begins here with ';' has no end: a line that \
                                   begins with ';' is missing";
                    return Err(at_line(line, problem));
                }
                Some(b';') if self.is_line_start() => break,
                Some(_) => self.step(),
            }
        }
        let text = self.text[start..self.at].trim_end_matches(['\n', '\r']);
        self.at += 1;
        Ok(quoted_value(text, line))
    }

    /// A quote ends at the same quote before white space, on its line.
    fn quoted(&mut self, quote: u8) -> Result<Token<'t>, ImportError> {
        let start = self.at + 1;
        self.at = start;
        loop {
            match self.byte(0) {
                Some(byte)
                    if byte == quote && (self.is_second || self.byte(1).is_none_or(is_blank)) =>
                {
                    break;
                }
                Some(byte) if !is_line_end(byte) => self.at += 1,
                _ => {
                    let problem = format!(
                        "the quote {0} has no end: {0} before a blank, on this line",
                        char::from(quote)
                    );
                    return Err(at_line(self.line, problem));
                }
            }
        }
        let text = &self.text[start..self.at];
        self.at += 1;
        Ok(quoted_value(text, self.line))
    }

    fn is_triple(&self, quote: u8) -> bool {
        self.is_second && [1, 2].iter().all(|&k| self.byte(k) == Some(quote))
    }

    /// From three quotes to the next three.
    fn triple_quoted(&mut self, quote: u8) -> Result<Token<'t>, ImportError> {
        let (start, line) = (self.at + 3, self.line);
        self.at = start;
        while self.byte(0).is_some() && !(self.byte(0) == Some(quote) && self.is_triple(quote)) {
            self.step();
        }
        if self.byte(0).is_none() {
            return Err(at_line(line, "the text in three quotes has no end"));
        }
        let text = &self.text[start..self.at];
        self.at += 3;
        Ok(quoted_value(text, line))
    }

    /// A list or table as one value: to the bracket that closes it. Quoted texts in it may have
    /// brackets.
    fn collection(&mut self) -> Result<Token<'t>, ImportError> {
        let (start, line) = (self.at, self.line);
        let mut depth = 0u32;
        loop {
            match self.byte(0) {
                None => return Err(at_line(line, "the list or table has no end")),
                Some(b'[' | b'{') => depth += 1,
                Some(b']' | b'}') => depth -= 1,
                Some(quote @ (b'\'' | b'"')) => {
                    if self.is_triple(quote) {
                        self.triple_quoted(quote)?
                    } else {
                        self.quoted(quote)?
                    };
                    continue;
                }
                Some(_) => {}
            }
            self.step();
            if depth == 0 {
                break;
            }
        }
        Ok(quoted_value(&self.text[start..self.at], line))
    }

    fn word(&mut self) -> Result<Token<'t>, ImportError> {
        let start = self.at;
        while self.byte(0).is_some_and(|byte| !is_blank(byte)) {
            self.at += 1;
        }
        let text = &self.text[start..self.at];
        let line = self.line;
        if text.starts_with('_') {
            return Ok(Token::Tag(text));
        }
        if let Some(name) = strip_prefix(text, "data_") {
            return Ok(Token::Data(name));
        }
        if text.eq_ignore_ascii_case("loop_") {
            return Ok(Token::Loop);
        }
        let reserved = strip_prefix(text, "save_").is_some()
            || ["global_", "stop_"]
                .iter()
                .any(|word| text.eq_ignore_ascii_case(word))
            || text.starts_with('$');
        if reserved {
            Err(at_line(
                line,
                format!("found {}, which has no place in a CIF of data", short(text)),
            ))
        } else {
            Ok(Token::Value(Value {
                text,
                line,
                quoted: false,
            }))
        }
    }
}

fn quoted_value(text: &str, line: u32) -> Token<'_> {
    Token::Value(Value {
        text,
        line,
        quoted: true,
    })
}

/// The rest of `text` after a keyword, which may have capital letters.
pub fn strip_prefix<'t>(text: &'t str, keyword: &str) -> Option<&'t str> {
    let head = text.get(..keyword.len())?;
    head.eq_ignore_ascii_case(keyword)
        .then(|| &text[keyword.len()..])
}

fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

fn is_blank(byte: u8) -> bool {
    is_line_end(byte) || matches!(byte, b' ' | b'\t')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Result<Vec<String>, String> {
        let mut tokens = Tokens::of(text);
        let mut words = Vec::new();
        while let Some((token, line)) = tokens.next().map_err(|error| error.to_string())? {
            words.push(match token {
                Token::Data(name) => format!("{line} data {name}"),
                Token::Loop => format!("{line} loop"),
                Token::Tag(tag) => format!("{line} {tag}"),
                Token::Value(v) => format!("{line} {:?} {}", v.text, v.quoted),
            });
        }
        Ok(words)
    }

    /// Examples of the specification, paragraphs 7 to 17, and of the ways to end a line.
    #[test]
    fn the_syntax() {
        for (text, expected) in [
            (
                "#\\#CIF_1.1\nDATA_a # b\n_C.d 1",
                vec!["2 data a", "3 _C.d", "3 \"1\" false"],
            ),
            (
                "'a dog's life' \"b\" 'c'd'",
                vec!["1 \"a dog's life\" true", "1 \"b\" true", "1 \"c'd\" true"],
            ),
            (
                "_t\n;a\n b;\n; x",
                vec!["1 _t", "2 \"a\\n b;\" true", "4 \"x\" false"],
            ),
            (
                "a\r\nb\rc\n\rd ;e a#b",
                vec![
                    "1 \"a\" false",
                    "2 \"b\" false",
                    "3 \"c\" false",
                    "5 \"d\" false",
                    "5 \";e\" false",
                    "5 \"a#b\" false",
                ],
            ),
            (
                "Loop_ '' ? '.'",
                vec!["1 loop", "1 \"\" true", "1 \"?\" false", "1 \".\" true"],
            ),
            (
                "\u{e9} data_\u{e9}",
                vec!["1 \"\u{e9}\" false", "1 data \u{e9}"],
            ),
        ] {
            assert_eq!(words(text).expect("words"), expected, "{text:?}");
        }
    }

    #[test]
    fn texts_without_an_end_and_reserved_words() {
        for (text, message) in [
            (
                "a\n;b\nc",
                "line 2: the text that begins here with ';' has no end: a line that begins with ';' is missing",
            ),
            (
                "\n'b\n'",
                "line 2: the quote ' has no end: ' before a blank, on this line",
            ),
            (
                "save_x",
                "line 1: found \"save_x\", which has no place in a CIF of data",
            ),
            (
                "STOP_",
                "line 1: found \"STOP_\", which has no place in a CIF of data",
            ),
            (
                "$frame",
                "line 1: found \"$frame\", which has no place in a CIF of data",
            ),
        ] {
            assert_eq!(words(text).expect_err(text), message);
        }
    }
}
