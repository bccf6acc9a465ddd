//! Certificates of the kind "family" as data. They have polynomials where a tiling has numbers, and a tree
//! that cuts the box of the parameters.

use super::cbor::{CborError, Item, Items, array, integer, small, text};
use super::read::{self, list};
use super::write::{self, Entry};
use super::{CLAIM_FORMAT, Claim, Corner, FAMILY, FORMAT, Fraction, Number, Statement};
use malachite::Integer;
use std::io::{self, Write};

/// A claim about all members of a family, and the witness for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FamilyCertificate {
    /// The claim alone defines the theorem.
    pub claim: FamilyClaim,
    /// The data from which the kernel checks it.
    pub witness: FamilyWitness,
}

/// For every point of the box the statements hold for the tiling with the values at that point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FamilyClaim {
    /// At least one.
    pub parameters: Vec<Parameter>,
    /// As for a single tiling. The Gram matrix has no common divisor of all coefficients.
    pub claim: Claim<Value>,
}

/// A parameter and its interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The name, which polynomials use by its position.
    pub name: String,
    /// The lower end.
    pub low: End,
    /// The upper end.
    pub high: End,
}

/// An end of an interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// Whether the interval leaves the end out.
    pub is_open: bool,
    /// The number at the end.
    pub value: Fraction,
}

/// A polynomial: its terms in ascending order of the exponents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Value(pub Vec<Term>);

/// A coefficient and one exponent for each parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// The coefficient.
    pub coefficient: Number,
    /// The exponents, in the order of the parameters.
    pub exponents: Vec<u8>,
}

/// How a box is cut.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tree {
    /// It is not.
    Leaf,
    /// In the middle of this side.
    Halves(usize, Box<[Tree; 2]>),
}

/// The simplices, and the tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FamilyWitness {
    /// Positive; coordinates are numerators over it.
    pub denominator: Integer,
    /// D numerators each.
    pub vertices: Vec<Vec<Value>>,
    /// The division of the box into leaves.
    pub tree: Tree,
    /// D + 1 corners for each simplex, one simplex after the other.
    pub simplices: Vec<Corner>,
    /// For each simplex the bits of the edges of valence 6, if TCP is claimed; else empty.
    pub sixes: Vec<u8>,
}

impl Entry for Value {
    fn write(&self, out: &mut impl Write) -> io::Result<()> {
        array(out, self.0.len())?;
        for Term {
            coefficient,
            exponents,
        } in &self.0
        {
            array(out, 1 + exponents.len())?;
            write::number(out, coefficient)?;
            exponents
                .iter()
                .try_for_each(|e| small(out, i64::from(*e)))?;
        }
        Ok(())
    }
}

/// Writes everything up to the table of simplices.
///
/// # Errors
/// Where `out` cannot be written; so for all writers.
pub fn head(
    out: &mut impl Write,
    claim: &FamilyClaim,
    denominator: &Integer,
    vertices: &[Vec<Value>],
    tree: &Tree,
) -> io::Result<()> {
    array(out, 5)?;
    write::begin(out, FORMAT, FAMILY)?;
    claim_to(out, claim)?;
    array(out, 5)?;
    integer(out, denominator)?;
    array(out, vertices.len())?;
    vertices
        .iter()
        .try_for_each(|row| write::numbers(out, row))?;
    // A family has no boundary facets, for it is no region.
    array(out, 0)?;
    tree_to(out, tree)
}

/// The certificate in CBOR.
pub fn to_bytes(certificate: &FamilyCertificate) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = certificate_to(&mut bytes, certificate);
    bytes
}

fn certificate_to(out: &mut impl Write, certificate: &FamilyCertificate) -> io::Result<()> {
    let FamilyCertificate { claim, witness } = certificate;
    head(
        out,
        claim,
        &witness.denominator,
        &witness.vertices,
        &witness.tree,
    )?;
    let corners = claim.claim.dimension + 1;
    array(out, witness.simplices.len() / corners)?;
    for (index, row) in witness.simplices.chunks_exact(corners).enumerate() {
        write::row(
            out,
            row,
            claim.claim.rank(),
            witness.sixes.get(index).copied(),
        )?;
    }
    Ok(())
}

/// The claim file in CBOR.
pub fn claim_file(claim: &FamilyClaim) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = array(&mut bytes, 4)
        .and_then(|()| write::begin(&mut bytes, CLAIM_FORMAT, FAMILY))
        .and_then(|()| claim_to(&mut bytes, claim));
    bytes
}

fn claim_to(
    out: &mut impl Write,
    FamilyClaim { parameters, claim }: &FamilyClaim,
) -> io::Result<()> {
    array(out, 6)?;
    small(out, claim.dimension as i64)?;
    write::field(out, &claim.field)?;
    array(out, parameters.len())?;
    for Parameter { name, low, high } in parameters {
        array(out, 3)?;
        text(out, name)?;
        end(out, low)?;
        end(out, high)?;
    }
    write::end_of_claim(out, claim)
}

fn end(out: &mut impl Write, end: &End) -> io::Result<()> {
    array(out, 2)?;
    text(out, if end.is_open { "open" } else { "closed" })?;
    write::fraction(out, &end.value)
}

fn tree_to(out: &mut impl Write, tree: &Tree) -> io::Result<()> {
    match tree {
        Tree::Leaf => array(out, 0),
        Tree::Halves(axis, halves) => {
            array(out, 3)?;
            small(out, *axis as i64)?;
            halves.iter().try_for_each(|half| tree_to(out, half))
        }
    }
}

/// The certificate in these bytes. It checks shapes and does not judge.
///
/// # Errors
/// [`CborError`] with the offset of the item that is not as docs/format.md says; so for all readers.
pub fn certificate(bytes: &[u8]) -> Result<FamilyCertificate, CborError> {
    let mut items = Items::new(bytes);
    items.array_of(5)?;
    read::begin(&mut items, FORMAT, FAMILY)?;
    let claim = claim(&mut items)?;
    let (dimension, rank) = (claim.claim.dimension, claim.claim.rank());
    let (degree, parameters) = (claim.claim.field.degree(), claim.parameters.len());
    items.array_of(5)?;
    let denominator = items.integer()?;
    let mut value = |items: &mut Items| value(items, degree, parameters);
    let vertices = list(&mut items, |items| {
        read::values(items, dimension, &mut value)
    })?;
    items.array_of(0)?;
    let tree = tree(&mut items, 0)?;
    let has_sixes = claim.claim.statements.contains(&Statement::Tcp);
    let (simplices, sixes) = read::rows(&mut items, rank, dimension + 1, has_sixes)?;
    items.end()?;
    Ok(FamilyCertificate {
        claim,
        witness: FamilyWitness {
            denominator,
            vertices,
            tree,
            simplices,
            sixes,
        },
    })
}

/// The claim in a claim file.
pub fn read_claim_file(bytes: &[u8]) -> Result<FamilyClaim, CborError> {
    let mut items = Items::new(bytes);
    items.array_of(4)?;
    read::begin(&mut items, CLAIM_FORMAT, FAMILY)?;
    let claim = claim(&mut items)?;
    items.end()?;
    Ok(claim)
}

fn claim(items: &mut Items) -> Result<FamilyClaim, CborError> {
    items.array_of(6)?;
    let (dimension, field) = (read::dimension(items)?, read::field(items)?);
    let degree = field.degree();
    let parameters = list(items, |items| parameter(items, degree))?;
    let count = parameters.len();
    let claim = read::end_of_claim(items, dimension, field, |items| value(items, degree, count))?;
    Ok(FamilyClaim { parameters, claim })
}

fn parameter(items: &mut Items, degree: usize) -> Result<Parameter, CborError> {
    items.array_of(3)?;
    Ok(Parameter {
        name: items.text()?.to_owned(),
        low: read_end(items, degree)?,
        high: read_end(items, degree)?,
    })
}

fn read_end(items: &mut Items, degree: usize) -> Result<End, CborError> {
    items.array_of(2)?;
    let error = items.error("expected \"closed\" or \"open\"");
    let is_open = match items.text()? {
        "open" => true,
        "closed" => false,
        _ => return Err(error),
    };
    Ok(End {
        is_open,
        value: read::fraction(items, degree)?,
    })
}

fn value(items: &mut Items, degree: usize, parameters: usize) -> Result<Value, CborError> {
    let exponent = |items: &mut Items| {
        let error = items.error("expected an exponent from 0 to 255");
        u8::try_from(items.small()?).map_err(|_| error)
    };
    list(items, |items| {
        items.array_of(1 + parameters)?;
        let coefficient = read::number(items, degree)?;
        let exponents = (0..parameters).map(|_| exponent(items));
        Ok(Term {
            coefficient,
            exponents: exponents.collect::<Result<_, _>>()?,
        })
    })
    .map(Value)
}

/// No tree is deeper.
const DEEPEST_TREE: usize = 64;

fn tree(items: &mut Items, depth: usize) -> Result<Tree, CborError> {
    let error = items.error("expected a tree of at most 64 levels");
    match items.next_item()? {
        Item::Array(0) => Ok(Tree::Leaf),
        Item::Array(3) if depth < DEEPEST_TREE => {
            let axis = usize::try_from(items.small()?).map_err(|_| error)?;
            let halves = [tree(items, depth + 1)?, tree(items, depth + 1)?];
            Ok(Tree::Halves(axis, Box::new(halves)))
        }
        _ => Err(error),
    }
}
