//! The witness of a plane certificate as a term of type `cert2`.
//!
//! PlaneChecker.v wants the corners of a triangle in the order of their names, and to be
//! told whether that order is positive; the mates follow.

use super::NotATheorem;
use super::data::{corner_of, faces, rows_of};
use super::numbers::{BigRational, Table, common_denominator, scaled, table};
use acutile_format1::certificate::{Certificate, Mate, Place};
use num_bigint::BigInt;

type Corner = (i64, [i64; 3]);

/// A triangle: its corners in order, and where each of its corners went.
struct Sorted {
    corners: [Corner; 3],
    position: [usize; 3],
}

/// The definitions of the vertices, the triangles and the certificate `c`.
pub(super) fn data(certificate: &Certificate, algebraic: bool) -> Result<String, NotATheorem> {
    let (claim, witness) = (&certificate.claim, &certificate.witness);
    let rank = claim.domain.rank(2);
    let vertices = rows_of(&table(&witness.vertices)?, 2)?;
    let polytope = match claim.domain.polytope() {
        Some(polytope) => padded(&rows_of(&table(&polytope.vertices)?, 2 - rank)?),
        None => Vec::new(),
    };
    let gram = rows_of(&table(&claim.gram)?, 2)?;
    if gram.len() != 2 || witness.mates.len() != witness.simplices.len() {
        return Err(NotATheorem::Malformed(
            "the Gram matrix, or the mates".to_owned(),
        ));
    }
    let den = common_denominator([&vertices, &polytope]);
    let gram_den = common_denominator([&gram]);
    let ring = if algebraic { "list Z" } else { "Z" };
    let number = |c: &[BigRational], m: &BigInt| scaled(c, m, algebraic);
    let points = |table: &Table| -> Vec<String> {
        let point = |x: &Vec<Vec<_>>| format!("({}, {})", number(&x[0], &den), number(&x[1], &den));
        table.iter().map(point).collect()
    };
    let sorted: Vec<Sorted> = witness
        .simplices
        .iter()
        .map(|corners| sorted(corners, rank))
        .collect::<Result<_, _>>()?;
    let triangles: Vec<String> = (sorted.iter().zip(&witness.mates))
        .map(|(triangle, mates)| term(triangle, mates, &sorted, rank))
        .collect::<Result<_, _>>()?;
    let entries = [(0, 0), (1, 1), (0, 1)].map(|(i, j)| number(&gram[i][j], &gram_den));
    Ok(format!(
        "(* {den} times the coordinates of the vertices, in the basis. *)\n\
         Definition verts : list ({ring} * {ring}) := [\n  {}].\n\n\
         (* Three corners (vertex, lattice vector), three mates (triangle, edge, lattice vector), orientation. *)\n\
         Definition tris : list ctri := [\n  {}].\n\n\
         (* Rank {rank}; {den} times the vertices of the polytope, its faces. *)\n\
         Definition c : cert2 ({ring}) :=\n  Cert2 _ {den} verts tris {gram_den} ({}) {rank}%nat\n  \
         [{}]\n  [{}].\n",
        points(&vertices).join(";\n  "),
        triangles.join(";\n  "),
        entries.join(", "),
        points(&polytope).join("; "),
        faces(claim.domain.polytope()).join("; "),
    ))
}

/// A zero before the coordinate of a strip's sides.
fn padded(polytope: &Table) -> Table {
    let zero = || vec![BigRational::from_integer(0.into())];
    let pad = |row: &Vec<Vec<BigRational>>| match row.len() {
        1 => vec![zero(), row[0].clone()],
        _ => row.clone(),
    };
    polytope.iter().map(pad).collect()
}

fn sorted(corners: &[Place], rank: usize) -> Result<Sorted, NotATheorem> {
    let wrong = || NotATheorem::Malformed("a simplex".to_owned());
    let all: Vec<Corner> = corners
        .iter()
        .map(|corner| corner_of(corner, rank))
        .collect::<Result<_, _>>()?;
    let mut order = [0, 1, 2];
    if all.len() != 3 {
        return Err(wrong());
    }
    order.sort_by_key(|&i| all[i]);
    let mut position = [0; 3];
    for (place, &i) in order.iter().enumerate() {
        position[i] = place;
    }
    let corners = order.map(|i| all[i]);
    Ok(Sorted { corners, position })
}

/// Whether sorting was an even permutation.
fn is_even(position: [usize; 3]) -> bool {
    let [a, b, c] = position;
    let inversions = usize::from(a > b) + usize::from(a > c) + usize::from(b > c);
    inversions % 2 == 0
}

fn term(
    triangle: &Sorted,
    mates: &[Mate],
    all: &[Sorted],
    rank: usize,
) -> Result<String, NotATheorem> {
    let mut walls = [const { String::new() }; 3];
    if mates.len() != 3 {
        return Err(NotATheorem::Malformed("the mates of a simplex".to_owned()));
    }
    for (mate, &place) in mates.iter().zip(&triangle.position) {
        walls[place] = mate_term(mate, all, rank)?;
    }
    let corners = triangle
        .corners
        .map(|(v, [x, y, _])| format!("({v}%N,({x},{y}))"));
    let even = is_even(triangle.position);
    Ok(format!(
        "CTri {} {} {even}",
        corners.join(" "),
        walls.join(" ")
    ))
}

fn mate_term(Mate(mate): &Mate, all: &[Sorted], rank: usize) -> Result<String, NotATheorem> {
    let wrong = || NotATheorem::Malformed("a mate".to_owned());
    let (&t, rest) = mate.split_first().ok_or_else(wrong)?;
    if rank < 2 && rest.is_empty() {
        return Ok("None".to_owned());
    }
    let (j, [x, y, _]) = corner_of(&Place(rest.to_vec()), rank)?;
    let index = |i: i64| usize::try_from(i).map_err(|_| wrong());
    let other = all.get(index(t)?).ok_or_else(wrong)?;
    let place = other.position.get(index(j)?).ok_or_else(wrong)?;
    Ok(format!("(Some ({t}%N,{place}%N,({x},{y})))"))
}
