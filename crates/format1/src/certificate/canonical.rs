//! The one byte string of a certificate.
//!
//! JSON with the members in the order of the types, no space, a line break
//! around and within the outer three levels and none further in: a vertex, a
//! simplex and a row of mates are a line each. The text ends with a line break.

use super::Certificate;
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};
use std::io;

/// The canonical bytes of `certificate`.
pub fn to_bytes(certificate: &Certificate) -> Vec<u8> {
    let mut bytes = Vec::new();
    to_writer(&mut bytes, certificate)
        .expect("strings and integers always serialize, and a Vec takes every byte");
    bytes
}

/// The canonical bytes of whatever has the members of a [`Certificate`].
pub(crate) fn to_writer(out: &mut impl io::Write, data: &impl Serialize) -> serde_json::Result<()> {
    data.serialize(&mut Serializer::with_formatter(
        &mut *out,
        Lines { depth: 0 },
    ))?;
    out.write_all(b"\n").map_err(serde_json::Error::io)
}

/// Containers that begin at a depth below this have their members on lines of
/// their own: the certificate, its claim and witness, and their lists.
const DEPTH_OF_LINES: usize = 3;

struct Lines {
    depth: usize,
}

impl Lines {
    fn open<W: ?Sized + io::Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        writer.write_all(bracket)
    }

    fn close<W: ?Sized + io::Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth -= 1;
        if self.depth < DEPTH_OF_LINES {
            writer.write_all(b"\n")?;
        }
        writer.write_all(bracket)
    }

    fn member<W: ?Sized + io::Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        if !first {
            writer.write_all(b",")?;
        }
        if self.depth <= DEPTH_OF_LINES {
            writer.write_all(b"\n")?;
        }
        Ok(())
    }
}

impl Formatter for Lines {
    fn begin_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"[")
    }

    fn end_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"]")
    }

    fn begin_array_value<W: ?Sized + io::Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        self.member(writer, first)
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"{")
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"}")
    }

    fn begin_object_key<W: ?Sized + io::Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        self.member(writer, first)
    }
}
