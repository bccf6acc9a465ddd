//! The words for what was verified. Trusted: they are what a person reads.
//!
//! The words for a refusal, which nobody takes for a proof, are in
//! [`super::render`].

use super::Verified;
use crate::certificate::{Claim, Domain, Field, Number, Statement};
use std::fmt::{Display, Formatter, Result};

/// The claim in words, one line.
impl Display for Verified {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let claim = self.claim();
        let (simplex, tiled) = match claim.dimension {
            2 => ("triangle", "the plane is tiled edge to edge by"),
            _ => ("tetrahedron", "three-space is tiled face to face by"),
        };
        let Domain::Space = claim.domain;
        write!(
            f,
            "{tiled} {} and their translates",
            counted(self.simplices(), simplex)
        )?;
        write!(
            f,
            " under the lattice whose basis has the Gram matrix {}",
            Matrix(&claim.gram)
        )?;
        write_field(f, claim)?;
        for statement in &claim.statements[1..] {
            write!(f, "; {}", Words(statement))?;
        }
        Ok(())
    }
}

fn counted(count: usize, simplex: &str) -> String {
    match (count, simplex) {
        (1, _) => format!("1 {simplex}"),
        (_, "tetrahedron") => format!("{count} tetrahedra"),
        _ => format!("{count} {simplex}s"),
    }
}

fn write_field(f: &mut Formatter, claim: &Claim) -> Result {
    let Field::Algebraic(field) = &claim.field else {
        return Ok(());
    };
    write!(
        f,
        ", where a is the root of {}",
        Polynomial(&field.polynomial)
    )?;
    write!(f, " between {} and {}", field.root.0, field.root.1)
}

struct Words<'s>(&'s Statement);

impl Display for Words<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match self.0 {
            Statement::FaceToFaceTiling => write!(f, "a face-to-face tiling"),
            Statement::Acute => write!(f, "all dihedral angles are acute"),
            Statement::Nonobtuse => write!(f, "no dihedral angle is obtuse"),
            Statement::DihedralBelow(q) => write!(f, "all dihedral angles are below {q} degrees"),
            Statement::Delaunay => write!(f, "it is the Delaunay triangulation of its vertices"),
            Statement::WeaklyDelaunay => {
                write!(f, "it is a Delaunay triangulation of its vertices")
            }
        }
    }
}

struct Matrix<'m>(&'m [Vec<Number>]);

impl Display for Matrix<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let row = |row: &Vec<Number>| format!("[{}]", join(row.iter()));
        write!(f, "[{}]", join(self.0.iter().map(row)))
    }
}

fn join(items: impl Iterator<Item = impl Display>) -> String {
    items
        .map(|item| item.to_string())
        .collect::<Vec<_>>()
        .join(", ")
}

/// `1/2 + 1/2 a`, an expression in the generator a.
impl Display for Number {
    fn fmt(&self, f: &mut Formatter) -> Result {
        Polynomial(&self.0).fmt(f)
    }
}

/// Coefficients from the constant term up, written as a sum in a.
struct Polynomial<'c>(&'c [String]);

impl Display for Polynomial<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let power = |k: usize| match k {
            1 => "a".to_owned(),
            _ => format!("a^{k}"),
        };
        let mut first = true;
        for (k, coefficient) in self.0.iter().enumerate().filter(|(_, c)| *c != "0") {
            let size = coefficient.strip_prefix('-');
            let sign = match (size, first) {
                (Some(_), true) => "-",
                (Some(_), false) => " - ",
                (None, true) => "",
                (None, false) => " + ",
            };
            let size = size.unwrap_or(coefficient);
            match (k, size) {
                (0, _) => write!(f, "{sign}{size}")?,
                (_, "1") => write!(f, "{sign}{}", power(k))?,
                _ => write!(f, "{sign}{size} {}", power(k))?,
            }
            first = false;
        }
        if first { f.write_str("0") } else { Ok(()) }
    }
}
