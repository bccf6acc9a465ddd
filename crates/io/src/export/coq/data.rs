//! The witness of a certificate as a term of type `cert`: integers, denominators cleared.

use super::NotATheorem;
use super::numbers::{BigRational, Table, common_denominator, scaled, table};
use acutile_format1::certificate::{Certificate, Mate, Place, Polytope};
use num_bigint::BigInt;
use num_traits::Zero;
use std::fmt::Write;

/// The definitions of the vertices, the simplices and the certificate `c`.
pub(super) fn data(certificate: &Certificate, algebraic: bool) -> Result<String, NotATheorem> {
    let (claim, witness) = (&certificate.claim, &certificate.witness);
    let rank = claim.domain.rank(3);
    let vertices = rows_of(&table(&witness.vertices)?, 3)?;
    let polytope = polytope(claim.domain.polytope(), 3 - rank)?;
    let gram = rows_of(&table(&claim.gram)?, 3)?;
    if gram.len() != 3 || witness.mates.len() != witness.simplices.len() {
        return Err(NotATheorem::Malformed(
            "the Gram matrix, or the mates".to_owned(),
        ));
    }
    let den = common_denominator([&vertices, &polytope]);
    let gram_den = common_denominator([&gram]);
    let ring = if algebraic { "list Z" } else { "Z" };
    let points = |table: &Table| -> Vec<String> {
        table.iter().map(|x| point(x, &den, algebraic)).collect()
    };
    let rows = witness.simplices.iter().zip(&witness.mates);
    let simplices: Vec<String> = rows
        .map(|(s, m)| simplex(s, m, rank))
        .collect::<Result<_, _>>()?;
    let entry = |(i, j): (usize, usize)| scaled(&gram[i][j], &gram_den, algebraic);
    let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(entry);
    let constructor = if algebraic {
        "nfcert fl e0 es"
    } else {
        "zcert"
    };
    Ok(format!(
        "(* {den} times the coordinates of the vertices, in the basis. *)\n\
         Definition verts : list (v3 ({ring})) := [\n  {}].\n\n\
         (* Four corners (vertex, lattice vector), four mates (simplex, facet, lattice vector). *)\n\
         Definition tets : list ctet := [\n  {}].\n\n\
         (* Rank {rank}; {den} times the vertices of the polytope, its faces. *)\n\
         Definition c : cert ({ring}) :=\n  {constructor} {den} verts tets {gram_den} (KG _ {}) {rank}%nat\n  \
         [{}]\n  [{}].\n",
        points(&vertices).join(";\n  "),
        simplices.join(";\n  "),
        entries.join(" "),
        points(&polytope).join("; "),
        faces(claim.domain.polytope()).join("; "),
    ))
}

/// The table, if every row has the length.
pub(super) fn rows_of(table: &Table, length: usize) -> Result<Table, NotATheorem> {
    match table.iter().all(|row| row.len() == length) {
        true => Ok(table.clone()),
        false => Err(NotATheorem::Malformed("the length of a row".to_owned())),
    }
}

/// The vertices of the polytope, zeros filled in for the directions of the lattice.
fn polytope(polytope: Option<&Polytope>, k: usize) -> Result<Table, NotATheorem> {
    let Some(polytope) = polytope else {
        return Ok(Vec::new());
    };
    let zero = || vec![BigRational::zero()];
    let mut rows = rows_of(&table(&polytope.vertices)?, k)?;
    for row in &mut rows {
        row.splice(0..0, std::iter::repeat_with(zero).take(3 - k));
    }
    Ok(rows)
}

pub(super) fn faces(polytope: Option<&Polytope>) -> Vec<String> {
    let face = |face: &Vec<usize>| {
        let indices: Vec<String> = face.iter().map(|i| format!("{i}%N")).collect();
        format!("[{}]", indices.join(";"))
    };
    polytope.map_or_else(Vec::new, |p| p.faces.iter().map(face).collect())
}

fn point(x: &[Vec<BigRational>], den: &BigInt, algebraic: bool) -> String {
    let coordinates: Vec<String> = x.iter().map(|c| scaled(c, den, algebraic)).collect();
    format!("V3 _ {}", coordinates.join(" "))
}

/// The vertex and the lattice vector, zeros filled in.
pub(super) fn corner_of(place: &Place, rank: usize) -> Result<(i64, [i64; 3]), NotATheorem> {
    match place.0.split_first() {
        Some((&v, shift)) if shift.len() == rank => {
            let mut full = [0; 3];
            full[..rank].copy_from_slice(shift);
            Ok((v, full))
        }
        _ => Err(NotATheorem::Malformed("a corner".to_owned())),
    }
}

fn simplex(corners: &[Place], mates: &[Mate], rank: usize) -> Result<String, NotATheorem> {
    let wrong = || NotATheorem::Malformed("a simplex or its mates".to_owned());
    if corners.len() != 4 || mates.len() != 4 {
        return Err(wrong());
    }
    let mut text = "CT".to_owned();
    for corner in corners {
        let (v, [x, y, z]) = corner_of(corner, rank)?;
        let _ = write!(text, " ({v}%N,({x},{y},{z}))");
    }
    for Mate(mate) in mates {
        if rank < 3 && mate.len() == 1 {
            text += " None";
            continue;
        }
        let (&t, rest) = mate.split_first().ok_or_else(wrong)?;
        let (j, [x, y, z]) = corner_of(&Place(rest.to_vec()), rank)?;
        let _ = write!(text, " (Some ({t}%N,{j}%N,({x},{y},{z})))");
    }
    Ok(text)
}
