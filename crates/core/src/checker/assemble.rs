//! Writes a proved tiling as a certificate.

use super::domain::Boundary;
use crate::tiling::{self, Corner, Facet, Frame, Matching, Mate, Tiling};
use acutile_exact::number;
use acutile_format1::certificate::{
    self, AlgebraicField, Certificate, Claim, Domain, FORMAT, Field, Number, Place, Polytope,
    Statement, VERSION, Witness, cbor,
};
use malachite::{Integer, Rational};
use std::io::{self, Write};

/// The certificate of a tiling whose facets all have mates.
pub fn certificate<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    boundary: &Boundary,
    statements: Vec<Statement>,
) -> Certificate {
    let simplices = tiling.simplices();
    Certificate {
        format: FORMAT.to_owned(),
        version: VERSION,
        claim: claim(&tiling.frame, statements),
        witness: Witness {
            vertices: tiling
                .vertices
                .iter()
                .map(|vertex| numbers(&vertex))
                .collect(),
            simplices: simplices
                .map(|corners| places(corners, tiling.frame.rank()))
                .collect(),
            mates: (0..tiling.len())
                .map(|simplex| mates(tiling, matching, boundary, simplex))
                .collect(),
        },
    }
}

/// Writes the same certificate in CBOR, row by row.
pub fn write_cbor<const D: usize, W: Write>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    boundary: &Boundary,
    statements: Vec<Statement>,
    out: &mut W,
) -> io::Result<()> {
    let mut corners = tiling.simplices();
    let tables = cbor::Tables {
        mates: &mut |out: &mut W| {
            cbor::array(out, tiling.len())?;
            (0..tiling.len()).try_for_each(|simplex| {
                cbor::lists(out, &mates(tiling, matching, boundary, simplex))
            })
        },
        vertices: &mut |out| {
            cbor::array(out, tiling.vertices.len())?;
            let mut rows = tiling.vertices.iter();
            rows.try_for_each(|vertex| cbor::numbers(out, &numbers(&vertex)))
        },
        simplices: &mut |out| {
            cbor::array(out, tiling.len())?;
            corners.try_for_each(|row| cbor::lists(out, &places(row, tiling.frame.rank())))
        },
    };
    cbor::certificate(out, &claim(&tiling.frame, statements), tables)
}

fn claim<const D: usize>(frame: &Frame<D>, statements: Vec<Statement>) -> Claim {
    Claim {
        dimension: D,
        field: field(&frame.field),
        gram: frame.gram.iter().map(|row| numbers(row)).collect(),
        domain: domain(&frame.domain),
        statements,
    }
}

fn domain(domain: &tiling::Domain) -> Domain {
    match domain {
        tiling::Domain::Space => Domain::Space,
        tiling::Domain::Slab(polytope) => Domain::Slab(polytope_data(polytope)),
        tiling::Domain::Prism(polytope) => Domain::Prism(polytope_data(polytope)),
        tiling::Domain::Solid(polytope) => Domain::Solid(polytope_data(polytope)),
        tiling::Domain::Region => Domain::Region,
    }
}

fn polytope_data(polytope: &tiling::Polytope) -> Polytope {
    Polytope {
        vertices: polytope
            .vertices
            .iter()
            .map(|vertex| numbers(vertex))
            .collect(),
        faces: polytope.faces.clone(),
    }
}

fn numbers(numbers: &[number::Number]) -> Vec<Number> {
    numbers.iter().map(number).collect()
}

/// The number as a certificate writes it.
pub fn number(number: &number::Number) -> Number {
    let coefficients = number.coefficients();
    Number(coefficients.iter().map(Rational::to_string).collect())
}

/// The field as a certificate writes it.
pub fn field(field: &number::Field) -> Field {
    if field.is_rationals() {
        return Field::Rationals;
    }
    let (lo, hi) = field.root();
    Field::Algebraic(AlgebraicField {
        polynomial: field.polynomial().iter().map(Integer::to_string).collect(),
        root: (lo.to_string(), hi.to_string()),
    })
}

fn places<const D: usize>(corners: &[Corner<D>], rank: usize) -> Vec<Place> {
    corners
        .iter()
        .map(|corner| Place(row(&[corner.vertex], &corner.shift[..rank])))
        .collect()
}

/// The row of a simplex.
fn mates<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    boundary: &Boundary,
    simplex: usize,
) -> Vec<certificate::Mate> {
    let entry_of = |opposite: usize| {
        if let Some(mate) = matching.mate(tiling, simplex, opposite) {
            return mate_row(&mate, tiling.frame.rank());
        }
        let facet = Facet {
            simplex: simplex as u32,
            opposite: opposite as u8,
        };
        let face = boundary.get(&facet);
        certificate::Mate(face.iter().map(|face| **face as i64).collect())
    };
    (0..=D).map(entry_of).collect()
}

fn mate_row<const D: usize>(mate: &Mate<D>, rank: usize) -> certificate::Mate {
    let Facet { simplex, opposite } = mate.facet;
    certificate::Mate(row(&[simplex, u32::from(opposite)], &mate.shift[..rank]))
}

fn row(indices: &[u32], shift: &[i32]) -> Vec<i64> {
    indices
        .iter()
        .map(|&k| i64::from(k))
        .chain(shift.iter().map(|&s| i64::from(s)))
        .collect()
}
