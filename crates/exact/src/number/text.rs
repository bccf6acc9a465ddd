//! Numbers as people write them, `(1+sqrt(5))/2`: text to syntax tree.
//!
//! It does not compute: names, divisors and roots are judged by
//! [`super::reader`]. The grammar, with blanks allowed between its words:
//!
//! ```text
//! sum     = ["-"] product { ("+" | "-") product }
//! product = power { ("*" | "/") power }
//! power   = atom [ "^" exponent ]
//! exponent = ["-"] digits | "(" ["-"] digits ")"
//! atom    = decimal | name | "sqrt" "(" sum ")" | "(" sum ")"
//! decimal = (digits ["." digits] | "." digits) [("e" | "E") ["+" | "-"] digits]
//! name    = letter { letter | digit | "_" }
//! ```
//!
//! Letters and digits are those of ASCII. A minus stands at the beginning of a
//! sum only, so that `--5` and `2*-3` are errors and `-2^2` is -(2^2).

use super::error::{ReadError, ReadErrorKind};
use super::limits::{DECIMAL_EXPONENT_LIMIT, DEPTH_LIMIT, DIGITS_LIMIT, POWER_LIMIT, TEXT_LIMIT};
use malachite::base::num::arithmetic::traits::Pow;
use malachite::{Natural, Rational};

/// The name of the square root, which no generator can have.
pub(super) const ROOT_NAME: &str = "sqrt";

/// A parsed text. Columns count characters from 1 and say where an operator or
/// a name stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    /// An integer or a decimal, exactly.
    Rational(Rational),
    /// A named generator.
    Name(String, usize),
    /// The summands, each with whether it is subtracted.
    Sum(Vec<(bool, Expression)>),
    /// The first factor, and the others with whether they divide and the column.
    Product(Box<Expression>, Vec<(bool, Expression, usize)>),
    /// A power with an integer exponent.
    Power(Box<Expression>, i64, usize),
    /// The square root that is not negative.
    Root(Box<Expression>, usize),
}

/// The syntax tree of `text`.
pub fn parse(text: &str) -> Result<Expression, ReadError> {
    let length = text.chars().count();
    if length > TEXT_LIMIT {
        return Err(ReadError {
            column: TEXT_LIMIT + 1,
            kind: ReadErrorKind::TooLong(length),
        });
    }
    let mut parser = Parser {
        text: text.chars().collect(),
        at: 0,
        depth: 0,
    };
    if parser.peek().is_none() {
        return Err(parser.error(ReadErrorKind::Empty));
    }
    let expression = parser.sum()?;
    match parser.peek() {
        None => Ok(expression),
        Some(_) => Err(parser.unexpected("an operator or the end")),
    }
}

struct Parser {
    text: Vec<char>,
    /// Index of the next character.
    at: usize,
    depth: usize,
}

impl Parser {
    /// The next character that is not blank.
    fn peek(&mut self) -> Option<char> {
        while self
            .text
            .get(self.at)
            .is_some_and(|c| matches!(c, ' ' | '\t' | '\n' | '\r'))
        {
            self.at += 1;
        }
        self.here()
    }

    /// The next character, blank or not.
    fn here(&self) -> Option<char> {
        self.text.get(self.at).copied()
    }

    /// Takes the next character if it is not blank and one of `wanted`.
    fn take(&mut self, wanted: &[char]) -> Option<char> {
        let found = self.peek().filter(|c| wanted.contains(c))?;
        self.at += 1;
        Some(found)
    }

    fn required(&mut self, wanted: char, name: &'static str) -> Result<(), ReadError> {
        self.take(&[wanted])
            .map(drop)
            .ok_or_else(|| self.unexpected(name))
    }

    fn error(&self, kind: ReadErrorKind) -> ReadError {
        ReadError {
            column: self.at + 1,
            kind,
        }
    }

    fn unexpected(&self, expected: &'static str) -> ReadError {
        let found = match self.here() {
            None => "the end".to_owned(),
            Some(c) if c.is_ascii_graphic() => format!("'{c}'"),
            Some(c) => format!("the character U+{:04X}", u32::from(c)),
        };
        self.error(ReadErrorKind::Unexpected(expected, found))
    }

    fn sum(&mut self) -> Result<Expression, ReadError> {
        let negative = self.take(&['-']).is_some();
        let first = self.product()?;
        if !negative && !matches!(self.peek(), Some('+' | '-')) {
            return Ok(first);
        }
        let mut summands = vec![(negative, first)];
        while let Some(operator) = self.take(&['+', '-']) {
            summands.push((operator == '-', self.product()?));
        }
        Ok(Expression::Sum(summands))
    }

    fn product(&mut self) -> Result<Expression, ReadError> {
        let first = self.power()?;
        let mut factors = Vec::new();
        while let Some(operator) = self.take(&['*', '/']) {
            let column = self.at;
            factors.push((operator == '/', self.power()?, column));
        }
        Ok(if factors.is_empty() {
            first
        } else {
            Expression::Product(Box::new(first), factors)
        })
    }

    fn power(&mut self) -> Result<Expression, ReadError> {
        let base = self.atom()?;
        if self.take(&['^']).is_none() {
            return Ok(base);
        }
        let column = self.at;
        let open = self.take(&['(']).is_some();
        let exponent = self.exponent()?;
        if open {
            self.required(')', "')'")?;
        }
        Ok(Expression::Power(Box::new(base), exponent, column))
    }

    fn exponent(&mut self) -> Result<i64, ReadError> {
        let negative = self.take(&['-']).is_some();
        self.peek();
        self.bounded(negative, POWER_LIMIT, "an integer exponent")
    }

    fn atom(&mut self) -> Result<Expression, ReadError> {
        match self.peek() {
            Some('(') => {
                self.at += 1;
                self.nested()
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.decimal().map(Expression::Rational),
            Some(c) if c.is_ascii_alphabetic() => self.name(),
            _ => Err(self.unexpected("a number, a name or '('")),
        }
    }

    /// A sum and the parenthesis that closes it.
    fn nested(&mut self) -> Result<Expression, ReadError> {
        if self.depth == DEPTH_LIMIT {
            return Err(self.error(ReadErrorKind::TooDeep));
        }
        self.depth += 1;
        let inner = self.sum()?;
        self.depth -= 1;
        self.required(')', "an operator or ')'")?;
        Ok(inner)
    }

    fn name(&mut self) -> Result<Expression, ReadError> {
        let column = self.at + 1;
        let name = self.run(|c| c.is_ascii_alphanumeric() || c == '_');
        if name != ROOT_NAME {
            return Ok(Expression::Name(name, column));
        }
        self.required('(', "'(' after sqrt")?;
        Ok(Expression::Root(Box::new(self.nested()?), column))
    }

    /// The characters from here on that satisfy `belongs`.
    fn run(&mut self, belongs: impl Fn(char) -> bool) -> String {
        let rest = self.text[self.at..].iter().copied();
        let run: String = rest.take_while(|c| belongs(*c)).collect();
        self.at += run.chars().count();
        run
    }

    /// Digits, a fraction, an exponent: the digits d_1 … d_m with f of them
    /// after the point, and exponent e, are d_1…d_m 10^(e-f).
    fn decimal(&mut self) -> Result<Rational, ReadError> {
        let start = self.at;
        let mut digits = self.run(|c| c.is_ascii_digit());
        let mut exponent = 0;
        if self.here() == Some('.') {
            self.at += 1;
            let fraction = self.run(|c| c.is_ascii_digit());
            if fraction.is_empty() {
                return Err(self.unexpected("a digit after the point"));
            }
            exponent = -(fraction.len() as i64);
            digits += &fraction;
        }
        if digits.len() > DIGITS_LIMIT {
            let kind = ReadErrorKind::TooManyDigits(digits.len());
            return Err(ReadError {
                column: start + 1,
                kind,
            });
        }
        if matches!(self.here(), Some('e' | 'E')) {
            self.at += 1;
            let negative = self.here() == Some('-');
            self.at += usize::from(matches!(self.here(), Some('+' | '-')));
            exponent += self.bounded(
                negative,
                DECIMAL_EXPONENT_LIMIT,
                "the digits of an exponent",
            )?;
        }
        if self
            .here()
            .is_some_and(|c| c.is_ascii_alphabetic() || c == '_' || c == '.')
        {
            return Err(self.unexpected("an operator after the number"));
        }
        let digits: Natural = digits.parse().map_err(|()| self.unexpected("a digit"))?;
        Ok(Rational::from(digits) * Rational::from(10).pow(exponent))
    }

    /// An integer of absolute value at most `limit`, here; its sign is known.
    fn bounded(
        &mut self,
        negative: bool,
        limit: i64,
        name: &'static str,
    ) -> Result<i64, ReadError> {
        let start = self.at;
        let digits = self.run(|c| c.is_ascii_digit());
        if digits.is_empty() {
            return Err(self.unexpected(name));
        }
        // Digits that do not fit are beyond the limit, too.
        match digits.parse::<i64>() {
            Ok(value) if value <= limit => Ok(if negative { -value } else { value }),
            _ => {
                let kind = ReadErrorKind::ExponentBeyondLimit(limit);
                Err(ReadError {
                    column: start + 1,
                    kind,
                })
            }
        }
    }
}
