//! CBOR (RFC 8949) in its core deterministic encoding, as far as certificates use it: integers of
//! any size, texts and arrays.
//!
//! The bytes are read once, in pieces. The digest is of exactly the bytes that were read.

use crate::limits::{Limits, Work};
use crate::refusal::{Checked, Place, Value};
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
const LONGEST: u64 = 1 << 16;

/// An integer of 64 bits, or else a larger one.
pub type Integer = Result<i64, BigInt>;

pub struct Cbor<'r> {
    input: &'r mut dyn Read,
    /// The bytes of this piece.
    piece: Vec<u8>,
    next: usize,
    /// Bytes before this piece.
    before: u64,
    pub(crate) limits: Limits,
    digest: Sha256,
    pub(crate) work: Rc<Work>,
}

fn wide(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}

impl<'r> Cbor<'r> {
    pub(crate) fn new(input: &'r mut dyn Read, limits: &Limits, work: &Rc<Work>) -> Cbor<'r> {
        let (limits, work) = (limits.clone(), work.clone());
        Cbor { input, piece: Vec::new(), next: 0, before: 0, limits, digest: Sha256::new(), work }
    }

    pub fn place(&self) -> Place {
        Place::Byte(self.before.saturating_add(wide(self.next)))
    }

    /// The next byte, which stays; nothing at the end.
    fn peek(&mut self) -> Checked<Option<u8>> {
        if self.next >= self.piece.len() {
            self.read_piece()?;
        }
        Ok(self.piece.get(self.next).copied())
    }

    #[cold]
    #[inline(never)]
    fn read_piece(&mut self) -> Checked {
        self.before = self.before.saturating_add(wide(self.piece.len()));
        self.next = 0;
        self.piece.resize(PIECE, 0);
        let length = loop {
            match self.input.read(&mut self.piece) {
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                length => break length.ok(),
            }
        };
        self.piece.truncate(some!(length, Unreadable, self.place()));
        let read = self.before.saturating_add(wide(self.piece.len()));
        let is_within = read <= self.limits.bytes;
        ensure!(is_within, TooManyBytes, self.place(), Value::Limit("bytes", None));
        self.work.set_bytes(read);
        self.digest.update(&self.piece);
        Ok(())
    }

    #[inline(always)]
    fn take(&mut self) -> Checked<u8> {
        let byte = match self.piece.get(self.next) {
            Some(byte) => Some(*byte),
            None => self.peek()?,
        };
        self.next += 1;
        Ok(some!(byte, Cbor, self.place()))
    }

    /// The kind of an item, and its value or length in the shortest form.
    fn head(&mut self) -> Checked<(u8, u64)> {
        let first = self.take()?;
        self.rest_of_head(first)
    }

    #[inline(always)]
    fn rest_of_head(&mut self, first: u8) -> Checked<(u8, u64)> {
        let info = first & 31;
        if info < 24 {
            return Ok((first >> 5, u64::from(info)));
        }
        ensure!(info < 28, Cbor, self.place());
        let length = 1 << (info - 24);
        let mut value = 0;
        for _ in 0..length {
            value = value << 8 | u64::from(self.take()?);
        }
        // A value that fits in half as many bytes, or in the first byte, is not canonical.
        let least = if length == 1 { 24 } else { 1 << (4 * length) };
        ensure!(value >= least, Canonical, self.place());
        Ok((first >> 5, value))
    }

    #[inline(always)]
    pub fn integer(&mut self) -> Checked<Integer> {
        let first = self.take()?;
        let kind = first >> 5;
        ensure!(matches!(kind, NATURAL | NEGATIVE | TAG), Cbor, self.place());
        let (_, value) = self.rest_of_head(first)?;
        match i64::try_from(value) {
            Ok(value) if kind != TAG => Ok(Ok(if kind == NATURAL { value } else { !value })),
            _ if kind == NATURAL => Ok(Err(value.into())),
            _ if kind == NEGATIVE => Ok(Err(!BigInt::from(value))),
            _ => self.big_integer(value),
        }
    }

    /// Tag 2, or 3 for negative ones: the bytes of n, or of -1 - n, more than eight.
    #[cold]
    #[inline(never)]
    fn big_integer(&mut self, tag: u64) -> Checked<Integer> {
        let (kind, length) = self.head()?;
        ensure!(matches!(tag, 2 | 3) && kind == BYTES, Cbor, self.place());
        let first = self.peek()?.unwrap_or(1);
        ensure!(length > 8 && first > 0, Canonical, self.place());
        let bits = length.saturating_mul(8) - u64::from(first.leading_zeros());
        let is_within = bits <= self.limits.bits;
        ensure!(is_within, TooManyDigits, self.place(), Value::Limit("bits", Some(bits)));
        let mut bytes = Vec::new();
        for _ in 0..length {
            bytes.push(self.take()?);
        }
        let value = BigInt::from_bytes_be(Sign::Plus, &bytes);
        Ok(Err(if tag == 3 { !value } else { value }))
    }

    /// An integer that fits 64 bits, or else the nearest one that does.
    pub fn small(&mut self) -> Checked<i64> {
        let nearest = |value| if value < BigInt::ZERO { i64::MIN } else { i64::MAX };
        Ok(self.integer()?.unwrap_or_else(nearest))
    }

    pub fn big(&mut self) -> Checked<BigInt> {
        Ok(self.integer()?.map_or_else(|large| large, BigInt::from))
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
    pub fn is_array(&mut self) -> Checked<bool> {
        Ok(self.peek()?.is_some_and(|byte| byte >> 5 == ARRAY))
    }

    pub fn array(&mut self) -> Checked<u64> {
        let (kind, length) = self.head()?;
        ensure!(kind == ARRAY, Cbor, self.place());
        Ok(length)
    }

    /// A record or an array of known length.
    pub fn array_of(&mut self, length: usize) -> Checked<u64> {
        let found = self.array()?;
        ensure!(found == wide(length), Cbor, self.place(), found);
        Ok(found)
    }

    /// No byte is left. Returns the number of bytes and their digest.
    pub fn finish(mut self) -> Checked<(u64, [u8; 32])> {
        ensure!(self.peek()?.is_none(), Cbor, self.place());
        Ok((self.before, self.digest.finalize().into()))
    }
}
