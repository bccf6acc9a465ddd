//! The witness of a certificate about the plane as a term of type `cert2`.
//!
//! `PlaneChecker.v` wants the corners of a triangle in the order of their names, and whether
//! this order is positive.

use super::data::{faces, gram, polytope};
use super::error::{NotATheorem, require};
use super::numbers::{element, ring};
use super::pairing::{Mate, mates, rows};
use acutile_core::format::{Certificate, Corner, Field, Number};

/// The definitions of the vertices, the triangles and the certificate `c`.
pub(super) fn data(certificate: &Certificate) -> Result<String, NotATheorem> {
    let (claim, witness) = (&certificate.claim, &certificate.witness);
    let (field, den) = (&claim.field, &witness.denominator);
    let [g11, g12, g22] = gram(certificate)?;
    let rows = rows(witness, 2)?;
    let sorted: Vec<Vec<Corner>> = rows.iter().map(|row| sorted(row)).collect();
    let orders = rows.iter().zip(&sorted).zip(mates(&sorted));
    let triangles: Vec<String> = orders
        .map(|((row, sorted), mates)| triangle(sorted, &mates, *row == sorted.as_slice()))
        .collect();
    Ok(format!(
        "(* {den} times the coordinates of the vertices, in the basis. *)\n\
         Definition verts : list ({ring} * {ring}) := [\n  {}].\n\n\
         (* Three corners (vertex, lattice vector), three mates (triangle, edge, lattice vector), orientation. *)\n\
         Definition tris : list ctri := [\n  {}].\n\n\
         (* Rank {rank}; {den} times the vertices of the polytope, its faces. *)\n\
         Definition c : cert2 ({ring}) :=\n  Cert2 _ {den} verts tris ({g11}, {g22}, {g12}) {rank}%nat\n  \
         [{}]\n  [{}].\n",
        points(&witness.vertices, field)?.join(";\n  "),
        triangles.join(";\n  "),
        points(&polytope(certificate)?, field)?.join("; "),
        faces(claim.domain.polytope()).join("; "),
        ring = ring(field),
        rank = claim.rank(),
    ))
}

fn points(points: &[Vec<Number>], field: &Field) -> Result<Vec<String>, NotATheorem> {
    points.iter().map(|x| point(x, field)).collect()
}

fn point(x: &[Number], field: &Field) -> Result<String, NotATheorem> {
    require(x.len() == 2, "the length of a row")?;
    Ok(format!(
        "({}, {})",
        element(&x[0], field)?,
        element(&x[1], field)?
    ))
}

fn sorted(row: &[Corner]) -> Vec<Corner> {
    let mut corners = row.to_vec();
    corners.sort_unstable();
    corners
}

/// In a row the determinant is positive, so the ascending order is even if the row has it.
fn triangle(corners: &[Corner], mates: &[Option<Mate>], is_even: bool) -> String {
    let corner = |c: &Corner| format!("({}%N,({},{}))", c.vertex, c.shift[0], c.shift[1]);
    let corners: Vec<String> = corners.iter().map(corner).collect();
    let mates: Vec<String> = mates.iter().map(mate).collect();
    format!("CTri {} {} {is_even}", corners.join(" "), mates.join(" "))
}

fn mate(mate: &Option<Mate>) -> String {
    match mate {
        None => "None".to_owned(),
        Some(Mate {
            simplex,
            facet,
            shift: [x, y, _],
        }) => {
            format!("(Some ({simplex}%N,{facet}%N,({x},{y})))")
        }
    }
}
