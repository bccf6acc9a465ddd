//! Errors about fields and about the text of numbers, and their messages.

use super::limits::EXPONENT_LIMIT;
use super::limits::{
    BITS_LIMIT, DEGREE_LIMIT, DEPTH_LIMIT, DIGITS_LIMIT, ISOLATION_LIMIT, MINOR_BITS_LIMIT,
    POLYNOMIAL_BITS_LIMIT, TEXT_LIMIT,
};
use malachite::Rational;
use std::fmt;

/// Why there is no such field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FieldError {
    /// The polynomial is zero.
    ZeroPolynomial,
    /// The polynomial is a constant, which has no root.
    ConstantPolynomial,
    /// The degree is above [`DEGREE_LIMIT`].
    DegreeBeyondLimit(usize),
    /// A coefficient or an end of the interval has more than
    /// [`POLYNOMIAL_BITS_LIMIT`] bits: the number of bits.
    SizeBeyondLimit(u64),
    /// The lower end is above the upper end.
    EmptyInterval(Rational, Rational),
    /// The polynomial has no root in the interval.
    NoRoot(Rational, Rational),
    /// The polynomial has this many different roots in the interval.
    SeveralRoots(Rational, Rational, usize),
    /// Other roots are closer than 2^-[`ISOLATION_LIMIT`].
    RootsTooClose,
    /// The linear system for a generator is larger than
    /// `MINOR_BITS_LIMIT`: the bits of its minors, estimated.
    ExtensionBeyondLimit(u64),
    /// No small combination of two generators generates both.
    NoGenerator,
}

impl FieldError {
    /// Whether a stated limit is the reason, and not the input.
    pub fn is_limit(&self) -> bool {
        matches!(
            self,
            Self::DegreeBeyondLimit(_)
                | Self::SizeBeyondLimit(_)
                | Self::RootsTooClose
                | Self::ExtensionBeyondLimit(_)
                | Self::NoGenerator
        )
    }
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::ZeroPolynomial => write!(f, "the polynomial is zero"),
            Self::ConstantPolynomial => write!(f, "the polynomial is a constant"),
            Self::DegreeBeyondLimit(degree) => {
                write!(f, "degree {degree} is beyond the limit of {DEGREE_LIMIT}")
            }
            Self::SizeBeyondLimit(bits) => write!(
                f,
                "a number of {bits} bits in the polynomial or its interval is beyond the limit of {POLYNOMIAL_BITS_LIMIT}"
            ),
            Self::EmptyInterval(lo, hi) => {
                write!(
                    f,
                    "the interval from {lo} to {hi} is empty: its ends are in the wrong order"
                )
            }
            Self::NoRoot(lo, hi) => write!(f, "the polynomial has no root from {lo} to {hi}"),
            Self::SeveralRoots(lo, hi, count) => {
                write!(
                    f,
                    "the polynomial has {count} roots from {lo} to {hi}, and must have one"
                )
            }
            Self::ExtensionBeyondLimit(bits) => write!(
                f,
                "the field of all numbers so far is too large: a generator needs numbers of about \
                 {bits} bits, beyond the limit of {MINOR_BITS_LIMIT}"
            ),
            Self::RootsTooClose => {
                write!(
                    f,
                    "other roots are closer than 2^-{ISOLATION_LIMIT} to the root"
                )
            }
            Self::NoGenerator => write!(f, "no generator of the extended field was found"),
        }
    }
}

impl std::error::Error for FieldError {}

/// Why a text is no number, and the column, from 1, where that was seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadError {
    /// In characters from 1.
    pub column: usize,
    /// The kind of error.
    pub kind: ReadErrorKind,
}

/// An unknown name, and those that the document declares.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declared {
    /// The unknown name.
    pub unknown: String,
    /// The parameters of the document.
    pub parameters: Vec<String>,
    /// The generators of its field.
    pub generators: Vec<String>,
}

impl fmt::Display for Declared {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Declared { unknown, .. } = self;
        write!(
            f,
            "found '{unknown}', expected a number like 3/7 or sqrt(2)/4, or a declared name; {} and {}; to add a \
             parameter, write \"parameters\": {{\"{unknown}\": [0, 1]}} with its ends",
            listed("parameter", &self.parameters),
            listed("generator", &self.generators)
        )
    }
}

/// `the parameters are s and t`
fn listed(noun: &str, names: &[String]) -> String {
    match names {
        [] => format!("there is no {noun}"),
        [name] => format!("the {noun} is {name}"),
        [first @ .., last] => format!("the {noun}s are {} and {last}", first.join(", ")),
    }
}

/// The kinds of errors about a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadErrorKind {
    /// Nothing but blanks.
    Empty,
    /// More characters than [`TEXT_LIMIT`].
    TooLong(usize),
    /// The expected text, and the found one.
    Unexpected(&'static str, String),
    /// Nested deeper than [`DEPTH_LIMIT`].
    TooDeep,
    /// More digits than [`DIGITS_LIMIT`].
    TooManyDigits(usize),
    /// An exponent beyond the limit given.
    ExponentBeyondLimit(i64),
    /// A name that no generator has.
    UnknownName(String),
    /// This name stands where no generators are defined.
    NoNames(String),
    /// A document declares neither a parameter nor a generator of this name.
    NotDeclared(Declared),
    /// This cannot name a generator.
    NotAName(String),
    /// Another generator has this name.
    NameTaken(String),
    /// The divisor, or the base of a negative power, is 0.
    DivisionByZero,
    /// The square root of this negative number.
    RootOfNegative(String),
    /// This square root does not lie in the field.
    RootNotInField(String),
    /// Whether this square root lies in the field was not found out within the limits.
    RootUndecided(String),
    /// A value has more bits than [`BITS_LIMIT`].
    ValueTooLarge,
    /// This parameter stands in a divisor, under a root or in a negative power.
    NotAPolynomial(String),
    /// The polynomial has this degree in a parameter.
    DegreeTooHigh(usize),
    /// There is no such field.
    Field(Box<FieldError>),
}

impl ReadError {
    /// Whether a stated limit is the reason, and not the text.
    pub fn is_limit(&self) -> bool {
        match &self.kind {
            ReadErrorKind::TooLong(_)
            | ReadErrorKind::TooDeep
            | ReadErrorKind::TooManyDigits(_)
            | ReadErrorKind::ExponentBeyondLimit(_)
            | ReadErrorKind::RootUndecided(_)
            | ReadErrorKind::ValueTooLarge => true,
            ReadErrorKind::Field(error) => error.is_limit(),
            _ => false,
        }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        use ReadErrorKind::*;
        write!(f, "column {}: ", self.column)?;
        match &self.kind {
            Empty => write!(f, "expected a number, found nothing"),
            TooLong(n) => write!(f, "{n} characters are more than the limit of {TEXT_LIMIT}"),
            Unexpected(expected, found) => write!(f, "expected {expected}, found {found}"),
            TooDeep => write!(
                f,
                "parentheses are nested deeper than the limit of {DEPTH_LIMIT}"
            ),
            TooManyDigits(n) => write!(f, "{n} digits are more than the limit of {DIGITS_LIMIT}"),
            ExponentBeyondLimit(limit) => {
                write!(f, "the exponent is beyond the limit of {limit}")
            }
            UnknownName(name) => write!(f, "no generator is named '{name}'"),
            NoNames(name) => write!(f, "found '{name}', expected a number like 3/7 or sqrt(2)/4"),
            NotDeclared(declared) => write!(f, "{declared}"),
            NotAName(name) => write!(f, "'{}' cannot name a generator", name.escape_default()),
            NameTaken(name) => write!(f, "another generator is named '{name}'"),
            DivisionByZero => write!(f, "division by zero"),
            RootOfNegative(x) => write!(f, "the square root of the negative number {x}"),
            RootNotInField(x) => write!(f, "the square root of {x} does not lie in the field"),
            RootUndecided(x) => write!(
                f,
                "whether the square root of {x} lies in the field is beyond the limits of the search"
            ),
            ValueTooLarge => {
                write!(f, "a value has more bits than the limit of {}", BITS_LIMIT)
            }
            NotAPolynomial(name) => write!(
                f,
                "expected a polynomial in the parameters; '{name}' stands in a divisor, under a \
                 root or in a negative power"
            ),
            DegreeTooHigh(degree) => write!(
                f,
                "polynomial of too high degree: {degree} in one parameter, expected at most {EXPONENT_LIMIT}"
            ),
            Field(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for ReadError {}
