//! The other encoding: the same data in CBOR (RFC 8949).
//!
//! Core deterministic encoding (section 4.2.1): definite lengths, each as short as
//! can be, the members of a map in the order of their encoded keys. Of CBOR only
//! integers, text, arrays and maps with text keys occur, for in JSON nothing else
//! does. So a certificate has one byte string here, too. What is written goes out as
//! it comes; no table is held. Reading is the kernel's business.

use super::{Claim, FORMAT, Number, VERSION};
use serde_json::Value;
use std::io::{self, Write};

/// The first three bits of an item: what it is.
pub(crate) mod major {
    pub const NATURAL: u8 = 0;
    pub const NEGATIVE: u8 = 1;
    pub const TEXT: u8 = 3;
    pub const ARRAY: u8 = 4;
    pub const MAP: u8 = 5;
}

/// Whether bytes that begin like this are CBOR and not JSON: a certificate is a map,
/// whose first byte no text in UTF-8 begins with.
pub fn is_cbor(bytes: &[u8]) -> bool {
    bytes.first().is_some_and(|byte| byte >> 5 == major::MAP)
}

/// The head of an item: its kind, and its value or length, as short as can be.
fn head(out: &mut impl Write, kind: u8, argument: u64) -> io::Result<()> {
    let bytes = argument.to_be_bytes();
    let (info, length) = match argument {
        0..24 => return out.write_all(&[kind << 5 | bytes[7]]),
        24..0x100 => (24, 1),
        0x100..0x1_0000 => (25, 2),
        0x1_0000..0x1_0000_0000 => (26, 4),
        _ => (27, 8),
    };
    out.write_all(&[kind << 5 | info])?;
    out.write_all(&bytes[8 - length..])
}

/// The head of an array of `length` items.
pub fn array(out: &mut impl Write, length: usize) -> io::Result<()> {
    head(out, major::ARRAY, length as u64)
}

/// An integer; -1 - n is the negative one with the argument n.
pub fn integer(out: &mut impl Write, value: i64) -> io::Result<()> {
    match value < 0 {
        false => head(out, major::NATURAL, value.unsigned_abs()),
        true => head(out, major::NEGATIVE, !value as u64),
    }
}

fn text(out: &mut impl Write, text: &str) -> io::Result<()> {
    head(out, major::TEXT, text.len() as u64)?;
    out.write_all(text.as_bytes())
}

/// A row of numbers: the coordinates of a vertex.
pub fn numbers(out: &mut impl Write, row: &[Number]) -> io::Result<()> {
    array(out, row.len())?;
    row.iter().try_for_each(|Number(coefficients)| {
        if let [rational] = coefficients.as_slice() {
            return text(out, rational);
        }
        array(out, coefficients.len())?;
        coefficients.iter().try_for_each(|c| text(out, c))
    })
}

/// A row of lists of integers: the corners of a simplex, or its mates.
pub fn lists<L: AsRef<[i64]>>(out: &mut impl Write, row: &[L]) -> io::Result<()> {
    array(out, row.len())?;
    row.iter().try_for_each(|list| {
        let list = list.as_ref();
        array(out, list.len())?;
        list.iter().try_for_each(|&entry| integer(out, entry))
    })
}

/// Any JSON of which there is an encoding here: no fractions, `null`, `true`, `false`.
pub fn value(out: &mut impl Write, json: &Value) -> io::Result<()> {
    match json {
        Value::String(string) => text(out, string),
        Value::Array(items) => {
            array(out, items.len())?;
            items.iter().try_for_each(|item| value(out, item))
        }
        Value::Object(members) => {
            head(out, major::MAP, members.len() as u64)?;
            let mut members: Vec<_> = members.iter().collect();
            members.sort_by_key(|(key, _)| (key.len(), *key));
            members.into_iter().try_for_each(|(key, member)| {
                text(out, key)?;
                value(out, member)
            })
        }
        Value::Number(number) => match (number.as_u64(), number.as_i64()) {
            (Some(natural), _) => head(out, major::NATURAL, natural),
            (_, Some(negative)) => integer(out, negative),
            _ => Err(io::ErrorKind::InvalidData.into()),
        },
        Value::Null | Value::Bool(_) => Err(io::ErrorKind::InvalidData.into()),
    }
}

/// The claim alone.
pub fn claim(out: &mut impl Write, claim: &Claim) -> io::Result<()> {
    value(out, &serde_json::to_value(claim)?)
}

/// Writes one table of the witness: the head of its array, and its rows.
pub type WriteTable<'t, W> = &'t mut dyn FnMut(&mut W) -> io::Result<()>;

/// The tables of a witness, each written when its turn comes.
pub struct Tables<'t, W> {
    /// Rows by [`lists`].
    pub mates: WriteTable<'t, W>,
    /// Rows by [`numbers`].
    pub vertices: WriteTable<'t, W>,
    /// Rows by [`lists`].
    pub simplices: WriteTable<'t, W>,
}

/// A whole certificate.
///
/// # Errors
/// Where `out` cannot be written.
pub fn certificate<W: Write>(out: &mut W, of: &Claim, tables: Tables<W>) -> io::Result<()> {
    head(out, major::MAP, 4)?;
    text(out, "claim")?;
    claim(out, of)?;
    text(out, "format")?;
    text(out, FORMAT)?;
    text(out, "version")?;
    head(out, major::NATURAL, VERSION)?;
    text(out, "witness")?;
    head(out, major::MAP, 3)?;
    text(out, "mates")?;
    (tables.mates)(out)?;
    text(out, "vertices")?;
    (tables.vertices)(out)?;
    text(out, "simplices")?;
    (tables.simplices)(out)
}
