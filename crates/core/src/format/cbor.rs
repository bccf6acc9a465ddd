//! Items of CBOR (RFC 8949) in the core deterministic encoding, section 4.2.1.
//!
//! Only integers, texts and arrays of definite length occur. Each head is as short as possible.
//! An integer beyond 64 bits is a byte string with tag 2 or 3 (section 3.4.3).

use malachite::base::num::basic::traits::One;
use malachite::base::num::conversion::traits::PowerOf2Digits;
use malachite::{Integer, Natural};
use std::fmt;
use std::io::{self, Write};

/// The first three bits of an item.
mod major {
    pub const NATURAL: u8 = 0;
    pub const NEGATIVE: u8 = 1;
    pub const BYTES: u8 = 2;
    pub const TEXT: u8 = 3;
    pub const ARRAY: u8 = 4;
    pub const TAG: u8 = 6;
}

/// The tag of an integer that is not negative.
const POSITIVE_BIG: u64 = 2;
/// The tag of -1 - n.
const NEGATIVE_BIG: u64 = 3;

/// Writes the head of an item: its kind, and its value or length.
fn head(out: &mut impl Write, kind: u8, argument: u64) -> io::Result<()> {
    let bytes = argument.to_be_bytes();
    let (info, length) = match argument {
        0..24 => return out.write_all(&[kind << 5 | bytes[7]]),
        24..0x100 => (24, 1),
        0x100..0x1_0000 => (25, 2),
        0x1_0000..0x1_0000_0000 => (26, 4),
        _ => (27, 8),
    };
    let mut item = [0; 9];
    item[0] = kind << 5 | info;
    item[1..=length].copy_from_slice(&bytes[8 - length..]);
    out.write_all(&item[..=length])
}

/// Writes the head of an array of `length` items.
///
/// # Errors
/// Where `out` cannot be written; so for the other functions.
pub fn array(out: &mut impl Write, length: usize) -> io::Result<()> {
    head(out, major::ARRAY, length as u64)
}

/// Writes an integer of 64 bits. -1 - n is the negative one with the argument n.
pub fn small(out: &mut impl Write, value: i64) -> io::Result<()> {
    if value < 0 {
        head(out, major::NEGATIVE, !value as u64)
    } else {
        head(out, major::NATURAL, value as u64)
    }
}

/// Writes any integer.
pub fn integer(out: &mut impl Write, value: &Integer) -> io::Result<()> {
    if let Ok(value) = i64::try_from(value) {
        return small(out, value);
    }
    let is_negative = *value < 0;
    let argument = if is_negative {
        value.unsigned_abs_ref() - Natural::ONE
    } else {
        value.unsigned_abs_ref().clone()
    };
    let (kind, tag) = if is_negative {
        (major::NEGATIVE, NEGATIVE_BIG)
    } else {
        (major::NATURAL, POSITIVE_BIG)
    };
    if let Ok(argument) = u64::try_from(&argument) {
        return head(out, kind, argument);
    }
    let bytes: Vec<u8> = argument.to_power_of_2_digits_desc(8);
    head(out, major::TAG, tag)?;
    head(out, major::BYTES, bytes.len() as u64)?;
    out.write_all(&bytes)
}

/// Writes a text.
pub fn text(out: &mut impl Write, text: &str) -> io::Result<()> {
    head(out, major::TEXT, text.len() as u64)?;
    out.write_all(text.as_bytes())
}

/// One item, an array without its elements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Item<'b> {
    /// An integer of 64 bits.
    Small(i64),
    /// Any other integer.
    Big(Integer),
    /// A text.
    Text(&'b str),
    /// The number of elements, which follow.
    Array(usize),
}

/// Why bytes are no certificate, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CborError {
    /// The offset of the byte.
    pub offset: usize,
    /// The rule that is broken.
    pub problem: &'static str,
}

impl fmt::Display for CborError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "byte {}: {}", self.offset, self.problem)
    }
}

impl std::error::Error for CborError {}

/// Reads items from bytes.
#[derive(Clone, Debug)]
pub struct Items<'b> {
    bytes: &'b [u8],
    offset: usize,
}

impl<'b> Items<'b> {
    /// From the beginning.
    pub fn new(bytes: &'b [u8]) -> Self {
        Items { bytes, offset: 0 }
    }

    /// The offset of the next byte.
    pub fn offset(&self) -> usize {
        self.offset
    }

    /// An error at the next byte.
    pub fn error(&self, problem: &'static str) -> CborError {
        CborError {
            offset: self.offset,
            problem,
        }
    }

    /// The next item.
    ///
    /// # Errors
    /// If the bytes end, are not deterministic, or are of another kind.
    #[inline]
    pub fn next_item(&mut self) -> Result<Item<'b>, CborError> {
        let start = self.offset;
        let at_start = |problem| CborError {
            offset: start,
            problem,
        };
        let (kind, argument) = self.head()?;
        Ok(match kind {
            major::NATURAL => match i64::try_from(argument) {
                Ok(value) => Item::Small(value),
                Err(_) => Item::Big(Integer::from(argument)),
            },
            major::NEGATIVE => match i64::try_from(argument) {
                Ok(value) => Item::Small(!value),
                Err(_) => Item::Big(-Integer::from(argument) - Integer::ONE),
            },
            major::TEXT => {
                let bytes = self.take(argument)?;
                let is_printable = bytes.iter().all(|byte| (0x20..0x7f).contains(byte));
                match std::str::from_utf8(bytes) {
                    Ok(text) if is_printable => Item::Text(text),
                    _ => return Err(at_start("expected a text of printable ASCII")),
                }
            }
            major::ARRAY => match usize::try_from(argument) {
                Ok(length) => Item::Array(length),
                Err(_) => return Err(at_start("the array is too long")),
            },
            major::TAG => Item::Big(
                self.big(argument)
                    .map_err(|e| CborError { offset: start, ..e })?,
            ),
            _ => return Err(at_start("expected an integer, a text or an array")),
        })
    }

    fn head(&mut self) -> Result<(u8, u64), CborError> {
        let start = self.offset;
        let initial = self.take(1)?[0];
        let (kind, info) = (initial >> 5, initial & 31);
        let length = match info {
            0..24 => return Ok((kind, info.into())),
            24..28 => 1usize << (info - 24),
            _ => {
                return Err(CborError {
                    offset: start,
                    problem: "expected a definite length",
                });
            }
        };
        let bytes = self.take(length as u64)?;
        let argument = bytes.iter().fold(0, |n, byte| n << 8 | u64::from(*byte));
        let least = if length == 1 {
            24
        } else {
            1 << (8 * (length / 2))
        };
        if argument < least {
            return Err(CborError {
                offset: start,
                problem: "the head is not as short as possible",
            });
        }
        Ok((kind, argument))
    }

    fn take(&mut self, length: u64) -> Result<&'b [u8], CborError> {
        let end = usize::try_from(length)
            .ok()
            .and_then(|length| self.offset.checked_add(length));
        let taken = end.and_then(|end| self.bytes.get(self.offset..end));
        let taken = taken.ok_or(CborError {
            offset: self.bytes.len(),
            problem: "the file ends, expected the rest of a certificate",
        })?;
        self.offset += taken.len();
        Ok(taken)
    }

    /// The integer after the head of a tag.
    fn big(&mut self, tag: u64) -> Result<Integer, CborError> {
        if tag != POSITIVE_BIG && tag != NEGATIVE_BIG {
            return Err(self.error("the tag is not 2 or 3"));
        }
        let (kind, length) = self.head()?;
        if kind != major::BYTES {
            return Err(self.error("expected a byte string after the tag"));
        }
        let bytes = self.take(length)?;
        if bytes.len() < 9 || bytes[0] == 0 {
            return Err(self.error("the integer is not as short as possible"));
        }
        let digits = bytes.iter().copied();
        let size = Natural::from_power_of_2_digits_desc(8, digits)
            .ok_or_else(|| self.error("the integer is not readable"))?;
        let value = Integer::from(size);
        Ok(if tag == POSITIVE_BIG {
            value
        } else {
            -value - Integer::ONE
        })
    }

    /// An array's length.
    ///
    /// # Errors
    /// As [`Items::next_item`], and if the item is of another kind; so for the others.
    pub fn array(&mut self) -> Result<usize, CborError> {
        let at = self.offset;
        match self.next_item()? {
            Item::Array(length) => Ok(length),
            _ => Err(CborError {
                offset: at,
                problem: "expected an array",
            }),
        }
    }

    /// The head of an array of this length.
    pub fn array_of(&mut self, expected: usize) -> Result<(), CborError> {
        let at = self.offset;
        if self.array()? == expected {
            Ok(())
        } else {
            Err(CborError {
                offset: at,
                problem: "the array has a wrong length",
            })
        }
    }

    /// A text.
    pub fn text(&mut self) -> Result<&'b str, CborError> {
        let at = self.offset;
        match self.next_item()? {
            Item::Text(text) => Ok(text),
            _ => Err(CborError {
                offset: at,
                problem: "expected a text",
            }),
        }
    }

    /// An integer of 64 bits.
    #[inline]
    pub fn small(&mut self) -> Result<i64, CborError> {
        let at = self.offset;
        match self.next_item()? {
            Item::Small(value) => Ok(value),
            _ => Err(CborError {
                offset: at,
                problem: "expected an integer of 64 bits",
            }),
        }
    }

    /// Any integer.
    pub fn integer(&mut self) -> Result<Integer, CborError> {
        let at = self.offset;
        match self.next_item()? {
            Item::Small(value) => Ok(Integer::from(value)),
            Item::Big(value) => Ok(value),
            _ => Err(CborError {
                offset: at,
                problem: "expected an integer",
            }),
        }
    }

    /// Checks that no byte is left.
    ///
    /// # Errors
    /// If one is.
    pub fn end(&self) -> Result<(), CborError> {
        if self.offset == self.bytes.len() {
            Ok(())
        } else {
            Err(self.error("bytes follow the certificate"))
        }
    }
}
