//! Items of CBOR, in the one encoding that each has: RFC 8949, section 4.2.1.
//!
//! No length is believed before the bytes are there, nothing longer than [`HELD`] is
//! held, and nesting is bounded. What is not the shortest form is refused.

use super::source::Bytes;
use super::{Refusal, document::excerpt};
use crate::certificate::{Number, cbor::major};
use serde::ser::{Serialize, SerializeSeq, Serializer};
use serde_json::{Map, Value};

/// The longest text, claim or row, in bytes. What is held of it may take 300 times as much.
pub(super) const HELD: u64 = 2 << 20;

/// An item without what it holds: an integer, or the length of a text, an array or a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Head {
    Natural(u64),
    /// -1 - n
    Negative(u64),
    Text(u64),
    Array(u64),
    Map(u64),
}

/// Lists of integers, one after another: a row of corners or of mates.
#[derive(Default)]
pub(super) struct Lists {
    entries: Vec<i64>,
    ends: Vec<usize>,
}

impl Lists {
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    pub(super) fn get(&self, index: usize) -> &[i64] {
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        &self.entries[start..self.ends[index]]
    }

    /// All entries, one after another.
    pub(super) fn entries(&self) -> &[i64] {
        &self.entries
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &[i64]> {
        (0..self.len()).map(|index| self.get(index))
    }
}

impl Serialize for Lists {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut array = serializer.serialize_seq(Some(self.len()))?;
        self.iter()
            .try_for_each(|list| array.serialize_element(list))?;
        array.end()
    }
}

impl Bytes<'_> {
    pub(super) fn wrong<T>(&self, message: &str) -> Result<T, Refusal> {
        Err(Refusal::Cbor {
            offset: self.offset(),
            message: excerpt(message),
        })
    }

    /// The last `back` bytes have another form.
    fn not_canonical<T>(&self, back: u64) -> Result<T, Refusal> {
        Err(Refusal::Canonical {
            offset: (self.offset() - back) as usize,
        })
    }

    fn byte(&mut self) -> Result<u8, Refusal> {
        match self.next()? {
            Some(byte) => Ok(byte),
            None => self.wrong("the bytes end here"),
        }
    }

    pub(super) fn head(&mut self) -> Result<Head, Refusal> {
        let first = self.byte()?;
        let kind = match first >> 5 {
            major::NATURAL => Head::Natural,
            major::NEGATIVE => Head::Negative,
            major::TEXT => Head::Text,
            major::ARRAY => Head::Array,
            major::MAP => Head::Map,
            _ => return self.wrong("neither an integer nor a text, an array or a map"),
        };
        self.argument(first & 31).map(kind)
    }

    /// The integer in the head, in its shortest form.
    fn argument(&mut self, info: u8) -> Result<u64, Refusal> {
        let length = match info {
            0..24 => return Ok(u64::from(info)),
            24..28 => 1 << (info - 24),
            31 => return self.not_canonical(1),
            _ => return self.wrong("a head that nothing has"),
        };
        let mut argument = 0;
        for _ in 0..length {
            argument = argument << 8 | u64::from(self.byte()?);
        }
        // What fits into half as many bytes, or into the first byte, is not written so.
        let least = match length {
            1 => 24,
            _ => 1 << (4 * length),
        };
        match argument < least {
            true => self.not_canonical(length + 1),
            false => Ok(argument),
        }
    }

    /// An array's length.
    pub(super) fn array(&mut self) -> Result<u64, Refusal> {
        match self.head()? {
            Head::Array(length) => Ok(length),
            _ => self.wrong("expected an array"),
        }
    }

    /// A map's length.
    pub(super) fn map(&mut self) -> Result<u64, Refusal> {
        match self.head()? {
            Head::Map(length) => Ok(length),
            _ => self.wrong("expected a map"),
        }
    }

    pub(super) fn natural(&mut self) -> Result<u64, Refusal> {
        match self.head()? {
            Head::Natural(value) => Ok(value),
            _ => self.wrong("expected a natural number"),
        }
    }

    fn integer(&mut self) -> Result<i64, Refusal> {
        let (value, is_negative) = match self.head()? {
            Head::Natural(value) => (value, false),
            Head::Negative(value) => (value, true),
            _ => return self.wrong("expected an integer"),
        };
        match i64::try_from(value) {
            Ok(value) if is_negative => Ok(!value),
            Ok(value) => Ok(value),
            Err(_) => self.wrong("an integer of more than 64 bits"),
        }
    }

    pub(super) fn text(&mut self) -> Result<String, Refusal> {
        match self.head()? {
            Head::Text(length) => self.text_of(length),
            _ => self.wrong("expected a text"),
        }
    }

    fn text_of(&mut self, length: u64) -> Result<String, Refusal> {
        if length > self.left() {
            return self.wrong("the bytes end within a text");
        }
        check_held(length)?;
        let mut text = Vec::with_capacity(length as usize);
        while (text.len() as u64) < length {
            let piece = self.some(length - text.len() as u64)?;
            text.extend_from_slice(piece);
        }
        String::from_utf8(text).or_else(|_| self.wrong("a text that is not UTF-8"))
    }

    /// A row of lists of integers, instead of the one that was there.
    pub(super) fn lists(&mut self, row: &mut Lists) -> Result<(), Refusal> {
        row.entries.clear();
        row.ends.clear();
        let start = self.offset();
        for _ in 0..self.array()? {
            for _ in 0..self.array()? {
                row.entries.push(self.integer()?);
                check_held(self.offset() - start)?;
            }
            row.ends.push(row.entries.len());
            check_held(self.offset() - start)?;
        }
        Ok(())
    }

    /// A row of numbers. A single coefficient stands alone, in no array.
    pub(super) fn numbers(&mut self) -> Result<Vec<Number>, Refusal> {
        let mut row = Vec::new();
        let start = self.offset();
        for _ in 0..self.array()? {
            row.push(Number(self.coefficients(start)?));
            check_held(self.offset() - start)?;
        }
        Ok(row)
    }

    fn coefficients(&mut self, start: u64) -> Result<Vec<String>, Refusal> {
        let length = match self.head()? {
            Head::Text(length) => return Ok(vec![self.text_of(length)?]),
            Head::Array(1) => return self.not_canonical(1),
            Head::Array(length) => length,
            _ => return self.wrong("expected a number: a text, or an array of texts"),
        };
        let mut coefficients = Vec::new();
        for _ in 0..length {
            coefficients.push(self.text()?);
            check_held(self.offset() - start)?;
        }
        Ok(coefficients)
    }

    /// Goes over the members of a map, `visit` over their values. The encoded keys rise.
    pub(super) fn members(
        &mut self,
        length: u64,
        mut visit: impl FnMut(&mut Self, &str) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let mut last: Option<String> = None;
        for _ in 0..length {
            let start = self.offset();
            let key = self.text()?;
            let back = self.offset() - start;
            match last
                .as_ref()
                .map(|last| (last.len(), last).cmp(&(key.len(), &key)))
            {
                Some(std::cmp::Ordering::Equal) => {
                    return self.wrong("a key that was there before");
                }
                Some(std::cmp::Ordering::Greater) => return self.not_canonical(back),
                _ => {}
            }
            visit(self, &key)?;
            last = Some(key);
        }
        Ok(())
    }

    /// Over an item of any kind, nested at most `depth` times.
    pub(super) fn skip(&mut self, depth: u8) -> Result<(), Refusal> {
        let Some(below) = depth.checked_sub(1) else {
            return self.wrong("nested too deeply");
        };
        match self.head()? {
            Head::Natural(_) | Head::Negative(_) => Ok(()),
            Head::Text(length) => self.text_of(length).map(drop),
            Head::Array(length) => (0..length).try_for_each(|_| self.skip(below)),
            Head::Map(length) => self.members(length, |bytes, _| bytes.skip(below)),
        }
    }

    /// The item as JSON. For small ones: it takes up to 300 times its bytes.
    pub(super) fn value(&mut self, depth: u8) -> Result<Value, Refusal> {
        let Some(below) = depth.checked_sub(1) else {
            return self.wrong("nested too deeply");
        };
        Ok(match self.head()? {
            Head::Natural(value) => value.into(),
            Head::Negative(value) => match i64::try_from(value) {
                Ok(value) => (!value).into(),
                Err(_) => return self.wrong("an integer of more than 64 bits"),
            },
            Head::Text(length) => self.text_of(length)?.into(),
            Head::Array(length) => {
                let mut items = Vec::new();
                for _ in 0..length {
                    items.push(self.value(below)?);
                }
                items.into()
            }
            Head::Map(length) => {
                let mut members = Map::new();
                self.members(length, |bytes, key| {
                    members.insert(key.to_owned(), bytes.value(below)?);
                    Ok(())
                })?;
                members.into()
            }
        })
    }
}

/// What is held at once is bounded, whatever the limit for the whole.
pub(super) fn check_held(found: u64) -> Result<(), Refusal> {
    match found <= HELD {
        true => Ok(()),
        false => Err(Refusal::TooManyBytes { found, limit: HELD }),
    }
}
