//! The words for what was verified. Trusted: they are what a person reads.
//!
//! The words for a refusal, which nobody takes for a proof, are in
//! [`super::render`].

use super::Verified;
use crate::certificate::{Claim, Domain, Field, Number, Statement};
use num_bigint::BigInt;
use std::fmt::{Display, Formatter, Result};

/// The claim in words, one line.
impl Display for Verified {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let claim = self.claim();
        let (simplex, how) = match claim.dimension {
            2 => ("triangle", "edge to edge"),
            _ => ("tetrahedron", "face to face"),
        };
        write_domain(f, claim)?;
        write!(
            f,
            " is tiled {how} by {}",
            counted(self.simplices(), simplex)
        )?;
        write_boundary(f, self)?;
        write_lattice(f, claim)?;
        write_field(f, claim)?;
        for statement in &claim.statements[1..] {
            write!(f, "; {}", Words(statement))?;
        }
        Ok(())
    }
}

/// What is tiled; x_1, …, x_D are coordinates in the basis.
fn write_domain(f: &mut Formatter, claim: &Claim) -> Result {
    let (name, polytope) = match (&claim.domain, claim.dimension) {
        (Domain::Space, 2) => return write!(f, "the plane"),
        (Domain::Space, _) => return write!(f, "three-space"),
        (Domain::Slab(polytope), 2) => ("strip", polytope),
        (Domain::Slab(polytope), _) => ("slab", polytope),
        (Domain::Prism(polytope), _) => ("prism", polytope),
        (Domain::Region, _) => return write!(f, "a bounded region of three-space"),
        (Domain::Solid(polytope), 2) => ("polygon", polytope),
        (Domain::Solid(polytope), _) => ("polyhedron", polytope),
    };
    let first = claim.domain.rank(claim.dimension) + 1;
    let coordinates = join((first..=claim.dimension).map(|i| format!("x_{i}")));
    let hull = join(polytope.vertices.iter().map(|vertex| Row(vertex)));
    write!(
        f,
        "the {name} of the points whose coordinates [{coordinates}] lie in the convex hull of {hull}"
    )
}

fn write_lattice(f: &mut Formatter, claim: &Claim) -> Result {
    f.write_str(match (&claim.domain, claim.domain.rank(claim.dimension)) {
        (Domain::Space, _) => " and their translates under the lattice whose basis has",
        (_, 0) => ", in the basis with",
        (_, 1) => {
            " and their translates by the integer multiples of the first vector of the basis with"
        }
        _ => " and their translates under the lattice of the first two vectors of the basis with",
    })?;
    write!(f, " the Gram matrix {}", Matrix(&claim.gram))
}

/// Of a region, whose boundary nothing else describes.
fn write_boundary(f: &mut Formatter, verified: &Verified) -> Result {
    if verified.claim().domain != Domain::Region {
        return Ok(());
    }
    write!(
        f,
        ", whose union it is, and its boundary by {} triangles, which meet in common vertices \
         and edges only",
        verified.boundary
    )
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
            Statement::DihedralBelow(q) => {
                write!(f, "all dihedral angles are below {} degrees", decimal(q))
            }
            Statement::DihedralAbove(q) => {
                write!(f, "all dihedral angles are above {} degrees", decimal(q))
            }
            Statement::RadiusEdgeBelow(q) => write!(
                f,
                "every circumradius is below {} times the shortest edge of its simplex",
                decimal(q)
            ),
            Statement::Delaunay => write!(f, "it is the Delaunay triangulation of its vertices"),
            Statement::WeaklyDelaunay => {
                write!(f, "it is a Delaunay triangulation of its vertices")
            }
            Statement::Tcp => write!(
                f,
                "it is tetrahedrally close packed: every edge is in 5 or 6 tetrahedra, \
                 and no triangle has two edges that are in 6"
            ),
        }
    }
}

/// A rational that is not negative, as a decimal where that is exact and of at
/// most 18 places: p/q = p (10^m / q) / 10^m.
fn decimal(text: &str) -> String {
    exact_decimal(text).unwrap_or_else(|| text.to_owned())
}

fn exact_decimal(text: &str) -> Option<String> {
    let (p, q) = text.split_once('/')?;
    let q: u64 = q.parse().ok()?;
    let places = (1..=18).find(|&m| 10u64.pow(m).is_multiple_of(q))?;
    let digits = p.parse::<BigInt>().ok()? * (10u64.pow(places) / q);
    let digits = format!("{digits:0>width$}", width = places as usize + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places as usize);
    Some(format!("{whole}.{fraction}"))
}

struct Row<'r>(&'r [Number]);

impl Display for Row<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        write!(f, "[{}]", join(self.0.iter()))
    }
}

struct Matrix<'m>(&'m [Vec<Number>]);

impl Display for Matrix<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        write!(f, "[{}]", join(self.0.iter().map(|row| Row(row))))
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

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn bounds_are_decimals_where_that_is_exact() {
        let cases = [
            ("7847/100", "78.47"),
            ("181/2", "90.5"),
            ("60", "60"),
            ("0", "0"),
            ("1/1000", "0.001"),
            ("1/8", "0.125"),
            ("77/3", "77/3"),
            ("1/100000000000000000000", "1/100000000000000000000"),
        ];
        for (text, expected) in cases {
            assert_eq!(decimal(text), expected);
        }
    }
}
