//! Certificates of the kind `patches` as plain data, and their CBOR.
//!
//! The numbers, the field, the statements and the rows are those of the kind `tiling`. As in the
//! other files of this module, nothing is computed or judged here.

use super::cbor::{CborError, Items, array, integer, small, text};
use super::read::{
    self, corner, expect, field as read_field, list, numbers as read_numbers,
    statement as read_statement,
};
use super::write::{corner as write_corner, field, numbers, row, statement};
use super::{CLAIM_FORMAT, Corner, FORMAT, Field, Number, Statement, VERSION};
use malachite::Integer;
use std::io::{self, Write};

/// The third member of a certificate and of a claim file.
pub const KIND: &str = "patches";

/// A claim about all tilings that a system of patches builds, and its patches.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// The claim alone defines the theorem.
    pub claim: Claim,
    /// One patch for each tile.
    pub witness: Vec<Patch>,
}

/// Over every mosaic of the tiles the patches build a tiling of space with the statements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// The field of all numbers.
    pub field: Field,
    /// The upper triangle of the 3 × 3 Gram matrix, by rows.
    pub gram: Vec<Vec<Number>>,
    /// The rank r of the lattice: 1 or 2.
    pub rank: usize,
    /// The tiles of the mosaics.
    pub tiles: Vec<Tile>,
    /// The statements about every tiling that the patches build.
    pub statements: Vec<Statement>,
}

/// A convex polygon (r = 1) or a segment (r = 2), with a class for each side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Positive; coordinates are numerators over it.
    pub denominator: Integer,
    /// 3 - r numerators each.
    pub vertices: Vec<Vec<Number>>,
    /// One integer for each side: its class.
    pub classes: Vec<i64>,
}

/// The tetrahedra and pyramids over a tile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Patch {
    /// Positive; coordinates are numerators over it.
    pub denominator: Integer,
    /// r numerators for each side.
    pub offsets: Vec<Vec<Number>>,
    /// 3 numerators for each vertex.
    pub vertices: Vec<Vec<Number>>,
    /// The pyramids on the sides.
    pub pyramids: Vec<Pyramid>,
    /// The tetrahedra, each by its corners.
    pub simplices: Vec<[Corner; 4]>,
}

/// An apex over a polygon in a side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pyramid {
    /// The apex.
    pub apex: Corner,
    /// The corners of the polygon in the side, in order.
    pub polygon: Vec<Corner>,
}

/// The certificate in CBOR.
pub fn to_bytes(certificate: &Certificate) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = certificate_to(&mut bytes, certificate);
    bytes
}

/// The claim file in CBOR.
pub fn claim_file(claim: &Claim) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = array(&mut bytes, 4)
        .and_then(|()| begin(&mut bytes, CLAIM_FORMAT))
        .and_then(|()| claim_to(&mut bytes, claim));
    bytes
}

fn begin(out: &mut impl Write, format: &str) -> io::Result<()> {
    text(out, format)?;
    small(out, VERSION as i64)?;
    text(out, KIND)
}

fn certificate_to(out: &mut impl Write, certificate: &Certificate) -> io::Result<()> {
    array(out, 5)?;
    begin(out, FORMAT)?;
    claim_to(out, &certificate.claim)?;
    let rank = certificate.claim.rank;
    each(out, &certificate.witness, |out, patch| {
        patch_to(out, patch, rank)
    })
}

/// Writes an array.
fn each<W: Write, T>(
    out: &mut W,
    items: &[T],
    mut write: impl FnMut(&mut W, &T) -> io::Result<()>,
) -> io::Result<()> {
    array(out, items.len())?;
    items.iter().try_for_each(|item| write(out, item))
}

fn claim_to(out: &mut impl Write, claim: &Claim) -> io::Result<()> {
    array(out, 5)?;
    field(out, &claim.field)?;
    each(out, &claim.gram, |out, row| numbers(out, row))?;
    small(out, claim.rank as i64)?;
    each(out, &claim.tiles, |out, tile| {
        array(out, 3)?;
        integer(out, &tile.denominator)?;
        each(out, &tile.vertices, |out, vertex| numbers(out, vertex))?;
        each(out, &tile.classes, |out, class| small(out, *class))
    })?;
    each(out, &claim.statements, |out, s| statement(out, s))
}

fn patch_to(out: &mut impl Write, patch: &Patch, rank: usize) -> io::Result<()> {
    array(out, 5)?;
    integer(out, &patch.denominator)?;
    each(out, &patch.offsets, |out, offset| numbers(out, offset))?;
    each(out, &patch.vertices, |out, vertex| numbers(out, vertex))?;
    each(out, &patch.pyramids, |out, Pyramid { apex, polygon }| {
        array(out, 2)?;
        write_corner(out, apex, rank)?;
        each(out, polygon, |out, corner| write_corner(out, corner, rank))
    })?;
    each(out, &patch.simplices, |out, corners| {
        row(out, corners, rank, None)
    })
}

/// The certificate in these bytes.
///
/// # Errors
/// [`CborError`] with the offset of the item that is not as docs/format.md says.
pub fn certificate(bytes: &[u8]) -> Result<Certificate, CborError> {
    let mut items = Items::new(bytes);
    items.array_of(5)?;
    read::begin(&mut items, FORMAT, KIND)?;
    let claim = claim(&mut items)?;
    let (rank, degree) = (claim.rank, claim.field.degree());
    let witness = list(&mut items, |items| patch(items, rank, degree))?;
    items.end()?;
    Ok(Certificate { claim, witness })
}

/// The claim in a claim file.
///
/// # Errors
/// As [`certificate`].
pub fn claim_of_file(bytes: &[u8]) -> Result<Claim, CborError> {
    let mut items = Items::new(bytes);
    items.array_of(4)?;
    read::begin(&mut items, CLAIM_FORMAT, KIND)?;
    let claim = claim(&mut items)?;
    items.end()?;
    Ok(claim)
}

fn claim(items: &mut Items) -> Result<Claim, CborError> {
    items.array_of(5)?;
    let field = read_field(items)?;
    let degree = field.degree();
    items.array_of(3)?;
    let gram = (0..3).map(|row| read_numbers(items, 3 - row, degree));
    let gram = gram.collect::<Result<_, _>>()?;
    let mut rank = 0;
    expect(items, "the rank is not 1 or 2", |items| {
        let found = usize::try_from(items.small()?);
        rank = found.unwrap_or_default();
        Ok(matches!(rank, 1 | 2))
    })?;
    Ok(Claim {
        gram,
        rank,
        tiles: list(items, |items| tile(items, rank, degree))?,
        statements: list(items, |items| read_statement(items, degree))?,
        field,
    })
}

fn tile(items: &mut Items, rank: usize, degree: usize) -> Result<Tile, CborError> {
    items.array_of(3)?;
    Ok(Tile {
        denominator: items.integer()?,
        vertices: list(items, |items| read_numbers(items, 3 - rank, degree))?,
        classes: list(items, |items| items.small())?,
    })
}

fn patch(items: &mut Items, rank: usize, degree: usize) -> Result<Patch, CborError> {
    items.array_of(5)?;
    Ok(Patch {
        denominator: items.integer()?,
        offsets: list(items, |items| read_numbers(items, rank, degree))?,
        vertices: list(items, |items| read_numbers(items, 3, degree))?,
        pyramids: list(items, |items| {
            items.array_of(2)?;
            Ok(Pyramid {
                apex: corner(items, rank)?,
                polygon: list(items, |items| corner(items, rank))?,
            })
        })?,
        simplices: list(items, |items| {
            items.array_of(4)?;
            let mut row = [Corner {
                vertex: 0,
                shift: [0; 3],
            }; 4];
            for slot in &mut row {
                *slot = corner(items, rank)?;
            }
            Ok(row)
        })?,
    })
}
