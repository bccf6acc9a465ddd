//! The witness of a certificate about space as a term of type `cert`.

use super::error::{NotATheorem, require};
use super::numbers::{element, factor, ring, times, zero};
use super::pairing::{Mate, mates, rows};
use acutile_core::format::{Certificate, Corner, Field, Number, Polytope};
use malachite::Integer;
use std::fmt::Write;

/// The definitions of the vertices, the simplices and the certificate `c`.
pub(super) fn data(certificate: &Certificate) -> Result<String, NotATheorem> {
    let (claim, witness) = (&certificate.claim, &certificate.witness);
    let (field, den) = (&claim.field, &witness.denominator);
    let [g11, g12, g13, g22, g23, g33] = gram(certificate)?;
    let constructor = match field {
        Field::Rationals => "zcert",
        Field::Algebraic(_) => "nfcert fl e0 es",
    };
    let rows = rows(witness, 3)?;
    let pairs = rows.iter().zip(mates(&rows));
    let simplices: Vec<String> = pairs.map(|(row, mates)| simplex(row, &mates)).collect();
    Ok(format!(
        "(* {den} times the coordinates of the vertices, in the basis. *)\n\
         Definition verts : list (v3 ({})) := [\n  {}].\n\n\
         (* Four corners (vertex, lattice vector), four mates (simplex, facet, lattice vector). *)\n\
         Definition tets : list ctet := [\n  {}].\n\n\
         (* Rank {rank}; {den} times the vertices of the polytope, its faces. *)\n\
         Definition c : cert ({}) :=\n  {constructor} {den} verts tets (KG _ {g11} {g22} {g33} {g12} {g13} {g23}) {rank}%nat\n  \
         [{}]\n  [{}].\n",
        ring(field),
        points(&witness.vertices, field)?.join(";\n  "),
        simplices.join(";\n  "),
        ring(field),
        points(&polytope(certificate)?, field)?.join("; "),
        faces(claim.domain.polytope()).join("; "),
        rank = claim.rank(),
    ))
}

/// The N entries of the upper triangle, by rows.
pub(super) fn gram<const N: usize>(certificate: &Certificate) -> Result<[String; N], NotATheorem> {
    let claim = &certificate.claim;
    let lengths = claim.gram.iter().map(Vec::len);
    let is_triangle = lengths.eq((1..=claim.dimension).rev());
    require(is_triangle, "the shape of the Gram matrix")?;
    let entries = claim.gram.iter().flatten();
    let terms: Result<Vec<String>, _> = entries.map(|entry| element(entry, &claim.field)).collect();
    let wrong = NotATheorem::Malformed("the shape of the Gram matrix");
    terms?.try_into().map_err(|_| wrong)
}

/// The vertices of the polytope over the witness's denominator, as points of dimension D: with
/// zeros for the directions of the lattice.
pub(super) fn polytope(certificate: &Certificate) -> Result<Vec<Vec<Number>>, NotATheorem> {
    let (claim, witness) = (&certificate.claim, &certificate.witness);
    let Some(polytope) = claim.domain.polytope() else {
        return Ok(Vec::new());
    };
    let factor = factor(&witness.denominator, &polytope.denominator)?;
    padded(
        polytope,
        &factor,
        claim.rank(),
        &claim.field,
        claim.dimension,
    )
}

/// The vertices of the polytope times a factor, with `rank` zeros in front.
pub(super) fn padded(
    polytope: &Polytope,
    factor: &Integer,
    rank: usize,
    field: &Field,
    dimension: usize,
) -> Result<Vec<Vec<Number>>, NotATheorem> {
    let mut points = Vec::with_capacity(polytope.vertices.len());
    for vertex in &polytope.vertices {
        require(rank + vertex.len() == dimension, "the length of a row")?;
        let zeros = std::iter::repeat_n(zero(field), rank);
        points.push(
            zeros
                .chain(vertex.iter().map(|x| times(x, factor)))
                .collect(),
        );
    }
    Ok(points)
}

pub(super) fn faces(polytope: Option<&Polytope>) -> Vec<String> {
    let face = |face: &Vec<u32>| {
        let indices: Vec<String> = face.iter().map(|i| format!("{i}%N")).collect();
        format!("[{}]", indices.join(";"))
    };
    polytope.map_or_else(Vec::new, |p| p.faces.iter().map(face).collect())
}

fn points(points: &[Vec<Number>], field: &Field) -> Result<Vec<String>, NotATheorem> {
    points.iter().map(|x| point(x, field)).collect()
}

fn point(x: &[Number], field: &Field) -> Result<String, NotATheorem> {
    require(x.len() == 3, "the length of a row")?;
    let coordinates: Result<Vec<String>, _> = x.iter().map(|x| element(x, field)).collect();
    Ok(format!("V3 _ {}", coordinates?.join(" ")))
}

fn simplex(corners: &[Corner], mates: &[Option<Mate>]) -> String {
    let mut text = "CT".to_owned();
    for Corner {
        vertex,
        shift: [x, y, z],
    } in corners
    {
        // A String takes every text.
        let _ = write!(text, " ({vertex}%N,({x},{y},{z}))");
    }
    for mate in mates {
        let _ = match mate {
            None => write!(text, " None"),
            Some(Mate {
                simplex,
                facet,
                shift: [x, y, z],
            }) => {
                write!(text, " (Some ({simplex}%N,{facet}%N,({x},{y},{z})))")
            }
        };
    }
    text
}
