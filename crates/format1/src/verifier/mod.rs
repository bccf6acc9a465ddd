//! The trusted kernel: it re-checks a certificate from its bytes alone.
//!
//! It shares the description of the data ([`crate::certificate`]) with the
//! prover, and no arithmetic and no judgement. The order of reading:
//!
//! | file | what it establishes |
//! |---|---|
//! | `source`, `cbor` | bytes in memory or in a file; items of CBOR, each in its one encoding |
//! | `document`, `table` | the bytes are a certificate of a known version, in the one notation it has; its tables, row by row |
//! | `shape` | lengths, ranges and order: every index points at something |
//! | `number`, `integer` | rationals from text; integers of any length |
//! | `ring`, `root` | the field; sums, products and signs in it |
//! | `tiling`, `corners` | all numbers of the certificate as elements of one ring; its simplices, in order |
//! | `domain` | the domain's polytope, and that the tiling keeps to its boundary |
//! | `mates` | the facets are paired, each pair one facet seen from two sides |
//! | `region`, `extent`, `apart` | the boundary of a region does not meet itself, and nothing is outside of it |
//! | `simplex` | what several statements ask of one simplex |
//! | `geometry` | metric, orientation, volume, and the claimed statements |
//! | `angle`, `radius`, `tcp` | the statements that need more than a sign of a product |
//! | `words` | the claim in words |
//! | `refusal`, `render` | what can be wrong, and the words for it |
//!
//! Whatever goes wrong is a [`Refusal`]. There is no panic, no clock, no thread,
//! no floating point, and no loop that the [`Limits`] do not bound.

mod angle;
mod apart;
mod cbor;
mod corners;
mod document;
mod domain;
mod extent;
mod geometry;
mod integer;
mod limits;
mod mates;
mod matrix;
mod number;
mod radius;
mod refusal;
mod region;
mod render;
mod ring;
mod root;
#[cfg(test)]
mod sabotage;
mod shape;
mod simplex;
mod source;
mod table;
mod tcp;
mod tiling;
mod words;

use crate::certificate::Claim;
use crate::certificate::cbor::is_cbor;
use document::{Document, read_cbor, read_json};
use source::Source;
use std::borrow::Cow;
use std::fs::File;
use std::io;

pub use limits::Limits;
pub use refusal::{Kind, Refusal};

/// A claim that has been checked. Only [`verify`] makes one; its `Display` says
/// the claim in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verified {
    claim: Claim,
    vertices: usize,
    simplices: usize,
    boundary: usize,
    sha256: String,
}

impl Verified {
    /// What is proved.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// Vertices, up to lattice translations.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// Simplices, up to lattice translations.
    pub fn simplices(&self) -> usize {
        self.simplices
    }

    /// Facets in the boundary of the domain, up to lattice translations.
    pub fn boundary(&self) -> usize {
        self.boundary
    }

    /// SHA-256 of the certificate's bytes: 64 hexadecimal digits.
    pub fn sha256(&self) -> &str {
        &self.sha256
    }
}

/// Checks everything that the certificate in `bytes` claims, in JSON or in CBOR.
///
/// Pure. The first check that fails gives the refusal.
pub fn verify(bytes: &[u8], limits: &Limits) -> Result<Verified, Refusal> {
    verify_by(bytes, limits, shape::CHECKS, geometry::CHECKS)
}

/// [`verify`] for a certificate in CBOR that is a regular file. It is read once for each check, in
/// pieces; what is held grows with the vertices, and with the facets that wait for their mates.
pub fn verify_file(file: &File, limits: &Limits) -> Result<Verified, Refusal> {
    let source = Source::of_file(file)?;
    let document = read_cbor(&source, limits)?;
    check(&document, limits, shape::CHECKS, geometry::CHECKS)
}

/// [`verify`], with its checks as a parameter so that the tests can show what
/// would be accepted without each of them.
fn verify_by(
    bytes: &[u8],
    limits: &Limits,
    shape: &[(&str, shape::Check)],
    geometry: &[(&str, geometry::Check)],
) -> Result<Verified, Refusal> {
    if !is_cbor(bytes) {
        return check(&read_json(bytes, limits)?, limits, shape, geometry);
    }
    let source = Source::Memory(Cow::Borrowed(bytes));
    check(&read_cbor(&source, limits)?, limits, shape, geometry)
}

fn check(
    document: &Document,
    limits: &Limits,
    shape: &[(&str, shape::Check)],
    geometry: &[(&str, geometry::Check)],
) -> Result<Verified, Refusal> {
    for (_, check) in shape {
        check(document, limits)?;
    }
    let tiling = tiling::Tiling::new(document, limits)?;
    geometry::check(&tiling, geometry)?;
    verified(document)
}

fn verified(document: &Document) -> Result<Verified, Refusal> {
    let mut boundary = 0;
    document.witness.mates.each(|_, row| {
        boundary += row.iter().filter(|entry| mates::is_boundary(entry)).count();
        Ok(())
    })?;
    let digits = document.sha256.iter().map(|byte| format!("{byte:02x}"));
    Ok(Verified {
        claim: document.claim.clone(),
        vertices: document.witness.vertices.len(),
        simplices: document.witness.simplices.len(),
        boundary,
        sha256: digits.collect(),
    })
}

/// A certificate in JSON, from either encoding. That it is one is checked, and nothing of
/// what it says.
///
/// # Errors
/// Not a certificate, or too large.
pub fn to_json(bytes: &[u8], limits: &Limits) -> Result<Vec<u8>, Refusal> {
    transcribed(bytes, limits, |document, out| document.write_json(out))
}

/// A certificate in CBOR, as [`to_json`] gives it in JSON.
///
/// # Errors
/// Not a certificate, or too large.
pub fn to_cbor(bytes: &[u8], limits: &Limits) -> Result<Vec<u8>, Refusal> {
    transcribed(bytes, limits, |document, out| document.write_cbor(out))
}

fn transcribed(
    bytes: &[u8],
    limits: &Limits,
    write: impl Fn(&Document, &mut Vec<u8>) -> io::Result<()>,
) -> Result<Vec<u8>, Refusal> {
    let mut out = Vec::new();
    let source = Source::Memory(Cow::Borrowed(bytes));
    let document = match is_cbor(bytes) {
        true => read_cbor(&source, limits)?,
        false => read_json(bytes, limits)?,
    };
    let message = |error: io::Error| error.to_string();
    match write(&document, &mut out).map_err(message) {
        Ok(()) => Ok(out),
        // Nothing that is in memory changes, and a vector takes all bytes.
        Err(message) => Err(Refusal::Changed { message }),
    }
}
