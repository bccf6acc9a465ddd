//! Writes the data of a certificate in CBOR, in one pass and row by row.
//!
//! The lengths of the witness's tables come first, so a table is written as its rows are
//! computed. Nothing is checked here.

use super::cbor::{array, integer, small, text};
use super::{
    AlgebraicField, CLAIM_FORMAT, Certificate, Claim, Corner, Cosine, Domain, FORMAT, Field,
    Fraction, KIND, Number, Polytope, Relation, Statement, VERSION,
};
use malachite::Integer;
use std::io::{self, Write};

/// The certificate in CBOR.
pub fn to_bytes(certificate: &Certificate) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = certificate_to(&mut bytes, certificate);
    bytes
}

/// The claim file in CBOR: [format, version, kind, claim].
pub fn claim_file(claim: &Claim) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = array(&mut bytes, 4)
        .and_then(|()| begin(&mut bytes, CLAIM_FORMAT, KIND))
        .and_then(|()| claim_to(&mut bytes, claim));
    bytes
}

/// Writes the certificate.
///
/// # Errors
/// Where `out` cannot be written; so for all functions.
pub fn certificate_to(out: &mut impl Write, certificate: &Certificate) -> io::Result<()> {
    let Certificate { claim, witness } = certificate;
    let d = claim.dimension;
    head(out, claim)?;
    integer(out, &witness.denominator)?;
    array(out, witness.vertices.len())?;
    for vertex in &witness.vertices {
        numbers(out, vertex)?;
    }
    array(out, witness.boundary.len() / d)?;
    for facet in witness.boundary.chunks_exact(d) {
        row(out, facet, claim.rank(), None)?;
    }
    array(out, witness.simplices.len() / (d + 1))?;
    for (index, simplex) in witness.simplices.chunks_exact(d + 1).enumerate() {
        row(
            out,
            simplex,
            claim.rank(),
            witness.sixes.get(index).copied(),
        )?;
    }
    Ok(())
}

/// Everything up to the witness's first member: the denominator, the tables of vertices, boundary
/// facets and simplices follow.
pub fn head(out: &mut impl Write, claim: &Claim) -> io::Result<()> {
    array(out, 5)?;
    begin(out, FORMAT, KIND)?;
    claim_to(out, claim)?;
    array(out, 4)
}

pub(super) fn begin(out: &mut impl Write, format: &str, kind: &str) -> io::Result<()> {
    text(out, format)?;
    small(out, VERSION as i64)?;
    text(out, kind)
}

/// The values in the place of a number.
pub trait Entry {
    /// Writes it.
    ///
    /// # Errors
    /// Where `out` cannot be written.
    fn write(&self, out: &mut impl Write) -> io::Result<()>;
}

impl Entry for Number {
    fn write(&self, out: &mut impl Write) -> io::Result<()> {
        number(out, self)
    }
}

/// Writes a row of numbers: the coordinates of a vertex.
pub fn numbers(out: &mut impl Write, row: &[impl Entry]) -> io::Result<()> {
    array(out, row.len())?;
    row.iter().try_for_each(|x| x.write(out))
}

/// Writes a facet, or a simplex with its hint.
#[inline]
pub fn row(
    out: &mut impl Write,
    corners: &[Corner],
    rank: usize,
    sixes: Option<u8>,
) -> io::Result<()> {
    array(out, corners.len() + usize::from(sixes.is_some()))?;
    corners.iter().try_for_each(|c| corner(out, c, rank))?;
    match sixes {
        Some(sixes) => small(out, i64::from(sixes)),
        None => Ok(()),
    }
}

/// Writes a corner.
#[inline]
pub fn corner(out: &mut impl Write, corner: &Corner, rank: usize) -> io::Result<()> {
    let Corner { vertex, shift } = corner;
    if *shift == [0; 3] {
        return small(out, i64::from(*vertex));
    }
    array(out, 1 + rank)?;
    small(out, i64::from(*vertex))?;
    shift[..rank]
        .iter()
        .try_for_each(|step| small(out, i64::from(*step)))
}

/// Writes a claim.
pub fn claim_to(out: &mut impl Write, claim: &Claim) -> io::Result<()> {
    array(out, 5)?;
    small(out, claim.dimension as i64)?;
    field(out, &claim.field)?;
    end_of_claim(out, claim)
}

/// The Gram matrix, the domain and the statements.
pub(super) fn end_of_claim(out: &mut impl Write, claim: &Claim<impl Entry>) -> io::Result<()> {
    array(out, claim.gram.len())?;
    for row in &claim.gram {
        numbers(out, row)?;
    }
    domain(out, &claim.domain)?;
    array(out, claim.statements.len())?;
    claim.statements.iter().try_for_each(|s| statement(out, s))
}

pub(super) fn field(out: &mut impl Write, field: &Field) -> io::Result<()> {
    let Field::Algebraic(AlgebraicField {
        polynomial,
        low,
        high,
        denominator,
    }) = field
    else {
        return text(out, "Q");
    };
    array(out, 2)?;
    integers(out, polynomial)?;
    array(out, 3)?;
    [low, high, denominator]
        .into_iter()
        .try_for_each(|n| integer(out, n))
}

fn integers(out: &mut impl Write, list: &[Integer]) -> io::Result<()> {
    array(out, list.len())?;
    list.iter().try_for_each(|n| integer(out, n))
}

pub(super) fn number(out: &mut impl Write, Number(coefficients): &Number) -> io::Result<()> {
    match coefficients.as_slice() {
        [rational] => integer(out, rational),
        list => integers(out, list),
    }
}

fn domain(out: &mut impl Write, domain: &Domain<impl Entry>) -> io::Result<()> {
    let (name, polytope) = match domain {
        Domain::Space => return text(out, "space"),
        Domain::Region(rank) => {
            array(out, 2)?;
            text(out, "region")?;
            return small(out, *rank as i64);
        }
        Domain::Slab(polytope) => ("slab", polytope),
        Domain::Prism(polytope) => ("prism", polytope),
        Domain::Solid(polytope) => ("solid", polytope),
    };
    array(out, 2)?;
    text(out, name)?;
    let Polytope {
        denominator,
        vertices,
        faces,
    } = polytope;
    array(out, 3)?;
    integer(out, denominator)?;
    array(out, vertices.len())?;
    vertices
        .iter()
        .try_for_each(|vertex| numbers(out, vertex))?;
    array(out, faces.len())?;
    for face in faces {
        array(out, face.len())?;
        face.iter().try_for_each(|v| small(out, i64::from(*v)))?;
    }
    Ok(())
}

pub(super) fn statement(out: &mut impl Write, statement: &Statement) -> io::Result<()> {
    match statement {
        Statement::LargestAngle(relation, cosine) | Statement::SmallestAngle(relation, cosine) => {
            array(out, 4)?;
            text(out, statement.name())?;
            text(out, relation.text())?;
            let Cosine { sign, square } = cosine;
            small(out, i64::from(*sign))?;
            fraction(out, square)
        }
        Statement::SquaredRatio(relation, ratio) => {
            array(out, 3)?;
            text(out, statement.name())?;
            text(out, Relation::text(*relation))?;
            fraction(out, ratio)
        }
        Statement::UncrossedPlane(plane) => {
            array(out, 3)?;
            text(out, statement.name())?;
            array(out, plane.normal.len())?;
            let mut entries = plane.normal.iter();
            entries.try_for_each(|c| small(out, i64::from(*c)))?;
            array(out, 2)?;
            integer(out, &plane.offset)?;
            integer(out, &plane.denominator)
        }
        _ => text(out, statement.name()),
    }
}

pub(super) fn fraction(out: &mut impl Write, fraction: &Fraction) -> io::Result<()> {
    array(out, 2)?;
    number(out, &fraction.numerator)?;
    integer(out, &fraction.denominator)
}

impl Statement {
    /// The text in a certificate, or the first of its texts.
    pub fn name(&self) -> &'static str {
        match self {
            Statement::FaceToFaceTiling => "face-to-face tiling",
            Statement::Acute => "acute",
            Statement::Nonobtuse => "nonobtuse",
            Statement::LargestAngle(..) => "largest dihedral angle",
            Statement::SmallestAngle(..) => "smallest dihedral angle",
            Statement::SquaredRatio(..) => "squared radius-edge ratio",
            Statement::UncrossedPlane(..) => "uncrossed plane",
            Statement::Delaunay => "Delaunay",
            Statement::WeaklyDelaunay => "weakly Delaunay",
            Statement::LocallyDelaunay => "locally Delaunay",
            Statement::LocallyWeaklyDelaunay => "locally weakly Delaunay",
            Statement::NotDelaunay => "not Delaunay",
            Statement::Tcp => "TCP",
        }
    }
}
