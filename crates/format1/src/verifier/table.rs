//! The tables of a witness: rows that are read one after another, as often as needed.
//!
//! A table is held as its bytes in CBOR, or not held where it is a part of a file.
//! From JSON it is transcribed, row by row; to JSON it is written in the same way.

use super::Refusal;
use super::cbor::Lists;
use super::source::{Bytes, Source, Sum};
use crate::certificate::{Number, cbor};
use serde::de::{self, Deserialize, DeserializeOwned, Deserializer, SeqAccess, Visitor};
use serde::ser::{self, Serialize, SerializeSeq, Serializer};
use std::borrow::Cow;
use std::fmt;
use std::io::{self, Write};
use std::marker::PhantomData;

/// What a row is.
pub(super) trait Row: Default + Serialize {
    /// As JSON has it.
    type Json: DeserializeOwned;
    /// What it says of itself where JSON has something else.
    const NAME: &'static str;
    fn transcribe(row: &Self::Json, out: &mut Vec<u8>) -> io::Result<()>;
    fn read(&mut self, bytes: &mut Bytes) -> Result<(), Refusal>;
}

impl Row for Lists {
    type Json = Vec<Vec<i64>>;
    const NAME: &'static str = "rows of lists of integers";

    fn transcribe(row: &Self::Json, out: &mut Vec<u8>) -> io::Result<()> {
        cbor::lists(out, row)
    }

    fn read(&mut self, bytes: &mut Bytes) -> Result<(), Refusal> {
        bytes.lists(self)
    }
}

impl Row for Vec<Number> {
    type Json = Vec<Number>;
    const NAME: &'static str = "rows of numbers";

    fn transcribe(row: &Self::Json, out: &mut Vec<u8>) -> io::Result<()> {
        cbor::numbers(out, row)
    }

    fn read(&mut self, bytes: &mut Bytes) -> Result<(), Refusal> {
        *self = bytes.numbers()?;
        Ok(())
    }
}

pub(super) struct Table<'s, R> {
    /// The array of the rows.
    source: Source<'s>,
    rows: usize,
    sum: Option<Sum>,
    kind: PhantomData<R>,
}

impl<'s, R: Row> Table<'s, R> {
    pub(super) fn len(&self) -> usize {
        self.rows
    }

    /// Reads the table that begins here, to see that it is one; `name` is for refusals.
    pub(super) fn first(
        bytes: &mut Bytes,
        whole: &'s Source<'s>,
        name: &str,
    ) -> Result<Self, Refusal> {
        bytes.mark();
        let from = bytes.offset();
        let rows = bytes.array()?;
        let mut row = R::default();
        for index in 0..rows {
            row.read(bytes).map_err(|refusal| match refusal {
                Refusal::Cbor { offset, message } => Refusal::Cbor {
                    offset,
                    message: format!("{name}[{index}]: {message}"),
                },
                other => other,
            })?;
        }
        Ok(Table {
            source: whole.part(from, bytes.offset()),
            rows: rows as usize,
            sum: bytes.mark(),
            kind: PhantomData,
        })
    }

    /// Calls `visit` for each row, in order.
    pub(super) fn each(
        &self,
        mut visit: impl FnMut(usize, &R) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let mut rows = Rows::new(self);
        let found = rows.each(|index, row| visit(index, row));
        rows.finish(found)
    }

    /// Calls `visit` for each row with the same row of another table, which has as many.
    pub(super) fn each_beside<Q: Row>(
        &self,
        other: &Table<Q>,
        mut visit: impl FnMut(usize, &R, &Q) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let (mut rows, mut others) = (Rows::new(self), Rows::new(other));
        let found = rows.each(|index, row| match others.advance()? {
            Some(_) => visit(index, row, &others.row),
            None => Ok(()),
        });
        let found = rows.finish(found);
        others.finish(found)
    }

    /// Whether somebody else can change the rows between one pass and the next.
    pub(super) fn may_change(&self) -> bool {
        !self.source.is_ours()
    }
}

impl<R> Table<'_, R> {
    /// Writes the bytes as they are.
    pub(super) fn copy(&self, out: &mut impl Write) -> io::Result<()> {
        let mut bytes = Bytes::again(&self.source);
        loop {
            let piece = bytes.some(u64::MAX).map_err(io::Error::other)?;
            if piece.is_empty() {
                return bytes.check_sum(&self.sum).map_err(io::Error::other);
            }
            out.write_all(piece)?;
        }
    }
}

/// One pass over a table.
struct Rows<'t, R> {
    bytes: Bytes<'t>,
    sum: &'t Option<Sum>,
    count: usize,
    index: usize,
    row: R,
}

impl<'t, R: Row> Rows<'t, R> {
    fn new(table: &'t Table<R>) -> Self {
        Rows {
            bytes: Bytes::again(&table.source),
            sum: &table.sum,
            count: table.rows,
            index: 0,
            row: R::default(),
        }
    }

    /// Reads the next row, and tells its number.
    fn advance(&mut self) -> Result<Option<usize>, Refusal> {
        if self.bytes.offset() == 0 {
            self.bytes.array()?;
        }
        if self.index == self.count {
            return Ok(None);
        }
        self.row.read(&mut self.bytes)?;
        self.index += 1;
        Ok(Some(self.index - 1))
    }

    fn each(
        &mut self,
        mut visit: impl FnMut(usize, &R) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        while let Some(index) = self.advance()? {
            visit(index, &self.row)?;
        }
        Ok(())
    }

    /// What was found, if these were the rows of the first pass. So a refusal, too, is one of
    /// the bytes whose digest is told.
    fn finish(mut self, found: Result<(), Refusal>) -> Result<(), Refusal> {
        if found.is_err() && self.sum.is_some() {
            self.bytes.skip_rest()?;
        }
        self.bytes.check_sum(self.sum)?;
        found
    }
}

impl<R: Row> Serialize for Table<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut array = serializer.serialize_seq(Some(self.rows))?;
        let mut rows = Rows::new(self);
        while rows.advance().map_err(ser::Error::custom)?.is_some() {
            array.serialize_element(&rows.row)?;
        }
        rows.finish(Ok(())).map_err(ser::Error::custom)?;
        array.end()
    }
}

impl<'de, R: Row> Deserialize<'de> for Table<'_, R> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(Transcriber(PhantomData))
    }
}

struct Transcriber<'s, R>(PhantomData<Table<'s, R>>);

impl<'de, 's, R: Row> Visitor<'de> for Transcriber<'s, R> {
    type Value = Table<'s, R>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(R::NAME)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Self::Value, A::Error> {
        let (mut rows, mut body) = (0, Vec::new());
        while let Some(row) = array.next_element::<R::Json>()? {
            R::transcribe(&row, &mut body).map_err(de::Error::custom)?;
            rows += 1;
        }
        let mut bytes = Vec::with_capacity(body.len() + 9);
        cbor::array(&mut bytes, rows).map_err(de::Error::custom)?;
        bytes.append(&mut body);
        Ok(Table {
            source: Source::Memory(Cow::Owned(bytes)),
            rows,
            sum: None,
            kind: PhantomData,
        })
    }
}
