//! CBOR (RFC 8949) in its core deterministic encoding, as far as certificates use it: integers of
//! any size, texts and arrays.
//!
//! The bytes are read once, in pieces. The digest is of exactly the bytes that were read.

use crate::limits::{Limits, Work};
use crate::refusal::{Checked, Limit, Place, Value};
use num_bigint::{BigInt, Sign};
use sha2::{Digest, Sha256};
use std::io::{ErrorKind, Read};
use std::rc::Rc;

const NATURAL: u8 = 0;
const NEGATIVE: u8 = 1;
const BYTES: u8 = 2;
const TEXT: u8 = 3;
const ARRAY: u8 = 4;
const TAG: u8 = 6;

const PIECE: usize = 1 << 16;
/// The longest text. All texts of the grammar are shorter.
const LONGEST: u64 = 64;

/// An integer as it is encoded.
#[derive(Clone)]
pub enum Integer {
    Small(i64),
    Large(BigInt),
}

impl From<Integer> for BigInt {
    fn from(integer: Integer) -> BigInt {
        match integer {
            Integer::Small(value) => value.into(),
            Integer::Large(value) => value,
        }
    }
}

pub struct Cbor<'r> {
    input: &'r mut dyn Read,
    /// The bytes of this piece.
    piece: Vec<u8>,
    next: usize,
    /// Bytes before this piece.
    before: u64,
    limit: u64,
    bits: u64,
    digest: Sha256,
    work: Rc<Work>,
}

impl Cbor<'_> {
    pub(crate) fn new<'r>(input: &'r mut dyn Read, limits: &Limits, work: &Rc<Work>) -> Cbor<'r> {
        Cbor {
            input,
            piece: Vec::new(),
            next: 0,
            before: 0,
            limit: limits.bytes,
            bits: limits.bits,
            digest: Sha256::new(),
            work: work.clone(),
        }
    }

    pub fn place(&self) -> Place {
        let next = u64::try_from(self.next).unwrap_or(u64::MAX);
        Place::Byte(self.before.saturating_add(next))
    }

    /// The next byte, which stays; nothing at the end.
    #[inline(always)]
    fn peek(&mut self) -> Checked<Option<u8>> {
        match self.piece.get(self.next) {
            Some(&byte) => Ok(Some(byte)),
            None => self.peek_at_next(),
        }
    }

    #[cold]
    #[inline(never)]
    fn peek_at_next(&mut self) -> Checked<Option<u8>> {
        let length = u64::try_from(self.piece.len()).unwrap_or(u64::MAX);
        self.before = self.before.saturating_add(length);
        self.next = 0;
        self.piece.resize(PIECE, 0);
        let length = loop {
            match self.input.read(&mut self.piece) {
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                length => break length,
            }
        };
        ensure!(length.is_ok(), Unreadable, self.place());
        self.piece.truncate(length.unwrap_or(0));
        let length = u64::try_from(self.piece.len()).unwrap_or(u64::MAX);
        let read = self.before.saturating_add(length);
        let exceeds = Value::Exceeds(Limit::Bytes, None);
        ensure!(read <= self.limit, TooManyBytes, self.place(), exceeds);
        self.work.set_bytes(read);
        self.digest.update(&self.piece);
        Ok(self.piece.first().copied())
    }

    #[inline(always)]
    fn take(&mut self) -> Checked<u8> {
        let byte = self.peek()?;
        ensure!(byte.is_some(), Cbor, self.place());
        self.next += 1;
        Ok(byte.unwrap_or(0))
    }

    /// The kind of an item, and its value or length in the shortest form.
    #[inline(always)]
    fn head(&mut self) -> Checked<(u8, u64)> {
        let first = self.take()?;
        match first & 31 {
            info @ 0..24 => Ok((first >> 5, u64::from(info))),
            info => Ok((first >> 5, self.long_head(info)?)),
        }
    }

    fn long_head(&mut self, info: u8) -> Checked<u64> {
        ensure!((24..28).contains(&info), Cbor, self.place());
        let length = 1 << (info - 24);
        let mut value = 0;
        for _ in 0..length {
            value = value << 8 | u64::from(self.take()?);
        }
        // A value that fits in half as many bytes, or in the first byte, is not canonical.
        let least = if length == 1 { 24 } else { 1 << (4 * length) };
        ensure!(value >= least, Canonical, self.place());
        Ok(value)
    }

    #[inline(always)]
    pub fn integer(&mut self) -> Checked<Integer> {
        match self.take()? {
            first @ 0..24 => Ok(Integer::Small(i64::from(first))),
            first @ 32..56 => Ok(Integer::Small(31 - i64::from(first))),
            first => self.long_integer(first),
        }
    }

    fn long_integer(&mut self, first: u8) -> Checked<Integer> {
        let is_integer = matches!(first >> 5, NATURAL | NEGATIVE | TAG);
        ensure!(is_integer, Cbor, self.place());
        if first >> 5 == TAG {
            return self.big_integer(first);
        }
        let value = self.long_head(first & 31)?;
        Ok(match (first >> 5, i64::try_from(value)) {
            (NATURAL, Ok(value)) => Integer::Small(value),
            (_, Ok(value)) => Integer::Small(!value),
            (NATURAL, Err(_)) => Integer::Large(value.into()),
            (_, Err(_)) => Integer::Large(!BigInt::from(value)),
        })
    }

    /// Tag 2, or 3 for negative ones: the bytes of n, or of -1 - n, more than eight.
    fn big_integer(&mut self, tag: u8) -> Checked<Integer> {
        ensure!(matches!(tag & 31, 2 | 3), Cbor, self.place());
        let (kind, length) = self.head()?;
        ensure!(kind == BYTES, Cbor, self.place());
        let first = self.peek()?.unwrap_or(0);
        ensure!(length > 8 && first > 0, Canonical, self.place());
        let bits = length.saturating_mul(8) - u64::from(first.leading_zeros());
        let exceeds = Value::Exceeds(Limit::Bits, Some(bits));
        ensure!(bits <= self.bits, TooManyDigits, self.place(), exceeds);
        let mut bytes = Vec::new();
        for _ in 0..length {
            bytes.push(self.take()?);
        }
        let value = BigInt::from_bytes_be(Sign::Plus, &bytes);
        let is_negative = tag & 31 == 3;
        Ok(Integer::Large(if is_negative { !value } else { value }))
    }

    /// An integer that fits 64 bits, or else the nearest one that does.
    #[inline(always)]
    pub fn small(&mut self) -> Checked<i64> {
        match self.integer()? {
            Integer::Small(value) => Ok(value),
            Integer::Large(value) if value.sign() == Sign::Minus => Ok(i64::MIN),
            Integer::Large(_) => Ok(i64::MAX),
        }
    }

    pub fn big(&mut self) -> Checked<BigInt> {
        self.integer().map(BigInt::from)
    }

    pub fn text(&mut self) -> Checked<String> {
        let (kind, length) = self.head()?;
        ensure!(kind == TEXT && length <= LONGEST, Cbor, self.place());
        let mut text = String::new();
        for _ in 0..length {
            let byte = self.take()?;
            ensure!((b' '..=b'~').contains(&byte), Cbor, self.place());
            text.push(char::from(byte));
        }
        Ok(text)
    }

    /// Whether the next item is an array.
    #[inline(always)]
    pub fn is_array(&mut self) -> Checked<bool> {
        Ok(self.peek()?.is_some_and(|byte| byte >> 5 == ARRAY))
    }

    #[inline(always)]
    pub fn array(&mut self) -> Checked<u64> {
        let (kind, length) = self.head()?;
        ensure!(kind == ARRAY, Cbor, self.place());
        Ok(length)
    }

    /// A record or an array of known length.
    #[inline(always)]
    pub fn array_of(&mut self, length: u64) -> Checked {
        let found = self.array()?;
        ensure!(found == length, Cbor, self.place(), found);
        Ok(())
    }

    /// An array of known length, read by a function of the index.
    pub fn array_with<V>(
        &mut self,
        length: u64,
        mut read: impl FnMut(&mut Self, u64) -> Checked<V>,
    ) -> Checked<Vec<V>> {
        self.array_of(length)?;
        (0..length).map(|i| read(self, i)).collect()
    }

    /// An array of any length.
    pub fn list<V>(
        &mut self,
        mut read: impl FnMut(&mut Self, u64) -> Checked<V>,
    ) -> Checked<Vec<V>> {
        let length = self.array()?;
        let mut values = Vec::new();
        for i in 0..length {
            values.push(read(self, i)?);
        }
        Ok(values)
    }

    /// No byte is left. Returns the number of bytes and their digest.
    pub fn finish(mut self) -> Checked<(u64, [u8; 32])> {
        ensure!(self.peek()?.is_none(), Cbor, self.place());
        Ok((self.before, self.digest.finalize().into()))
    }
}
