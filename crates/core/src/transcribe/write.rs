//! The certificate of a tiling, row by row.

use super::field::{Numerals, Written};
use super::order::Order;
use crate::format::{self, Claim, cbor};
use crate::statement::Statement;
use crate::tiling::coordinates::{Form, decompose};
use crate::tiling::{Corner, Domain, Facet, Matching, Polytope, Tiling, difference};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::{Gcd, Pow};
use malachite::{Integer, Rational};
use std::io::{self, Write};

/// The parts of a certificate.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'t, const D: usize> {
    /// The tiling; its simplices become rows.
    pub tiling: &'t Tiling<D>,
    /// The matching of its facets; facets without a mate are in the boundary.
    pub matching: &'t Matching<D>,
    /// In the order of a claim.
    pub statements: &'t [Statement],
    /// For each simplex the edges of valence 6, if TCP is among the statements.
    pub sixes: Option<&'t [u8]>,
}

/// The certificate in CBOR.
pub fn to_certificate<const D: usize>(parts: Parts<D>) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = write(parts, &mut bytes);
    bytes
}

/// Writes the certificate in CBOR; no table of it is kept.
///
/// # Errors
/// Where `out` cannot be written.
pub fn write<const D: usize>(parts: Parts<D>, out: &mut impl Write) -> io::Result<()> {
    let Parts {
        tiling, matching, ..
    } = parts;
    let written = Written::of(tiling);
    format::write::head(out, &claim_of(parts, &written))?;
    let order = Order::of(tiling, matching);
    let rows = Rows {
        tiling,
        order: &order,
    };
    rows.vertices(&written.numerals, out)?;
    rows.boundary(matching, out)?;
    rows.simplices(parts.sixes, out)
}

/// The claim of a tiling.
pub fn claim<const D: usize>(parts: Parts<D>) -> Claim {
    claim_of(parts, &Written::of(parts.tiling))
}

fn claim_of<const D: usize>(parts: Parts<D>, written: &Written<D>) -> Claim {
    let statements = parts.statements.iter();
    Claim {
        dimension: D,
        field: written.numerals.field(),
        gram: written.gram(),
        domain: domain(&parts.tiling.frame.domain, &written.numerals),
        statements: statements.map(|s| written.numerals.statement(s)).collect(),
    }
}

fn domain(domain: &Domain, written: &Numerals) -> format::Domain {
    in_format(domain, |polytope: &Polytope| {
        let denominator = written.denominator(polytope.vertices.iter().flatten());
        let row = |row: &Vec<Number>| {
            let numerators = row.iter().map(|x| written.numerator(x, &denominator));
            numerators.collect()
        };
        let face = |face: &Vec<usize>| face.iter().map(|v| *v as u32).collect();
        format::Polytope {
            vertices: polytope.vertices.iter().map(row).collect(),
            faces: polytope.faces.iter().map(face).collect(),
            denominator,
        }
    })
}

/// A domain with its polytope as a certificate has it.
pub(super) fn in_format<S, V>(
    domain: &Domain<S>,
    polytope: impl Fn(&Polytope<S>) -> format::Polytope<V>,
) -> format::Domain<V> {
    match domain {
        Domain::Space => format::Domain::Space,
        Domain::Slab(slab) => format::Domain::Slab(polytope(slab)),
        Domain::Prism(prism) => format::Domain::Prism(polytope(prism)),
        Domain::Solid(solid) => format::Domain::Solid(polytope(solid)),
        Domain::Region(rank) => format::Domain::Region(*rank),
    }
}

/// The tables of a witness.
pub(super) struct Rows<'t, const D: usize> {
    pub tiling: &'t Tiling<D>,
    pub order: &'t Order<D>,
}

impl<const D: usize> Rows<'_, D> {
    /// The denominator and the vertices.
    fn vertices(&self, written: &Numerals, out: &mut impl Write) -> io::Result<()> {
        match self.tiling.vertices.form() {
            Form::Integers {
                numerators,
                denominator,
            } => self.integers(numerators, *denominator, written, out),
            Form::Doubles(points) => self.doubles(points, written, out),
            Form::Numbers(points) => self.numbers(points, written, out),
        }
    }

    /// Numerators over a denominator: all of them divided by their common divisor.
    fn integers(
        &self,
        numerators: &[[i64; D]],
        denominator: i64,
        written: &Numerals,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let mut entries = numerators.iter().flatten();
        let divisor = entries.try_fold(denominator.unsigned_abs(), |gcd, n| {
            let gcd = gcd.gcd(n.unsigned_abs());
            if gcd == 1 { Err(gcd) } else { Ok(gcd) }
        });
        // Not negative, for the denominator is below 2^62.
        let divisor = divisor.unwrap_or_else(|one| one) as i64;
        cbor::small(out, denominator / divisor)?;
        cbor::array(out, numerators.len())?;
        for vertex in &self.order.vertices {
            let cell = self.order.cell(*vertex);
            let row = &numerators[vertex.index()];
            self.row(out, written, |out, k| {
                // Reduced to the first cell, a numerator is less than the denominator.
                let moved = i128::from(row[k]) - i128::from(cell[k]) * i128::from(denominator);
                let value = moved / i128::from(divisor);
                match i64::try_from(value) {
                    Ok(value) => cbor::small(out, value),
                    Err(_) => cbor::integer(out, &Integer::from(value)),
                }
            })?;
        }
        Ok(())
    }

    /// Doubles are multiples of one power of two.
    fn doubles(
        &self,
        points: &[[f64; D]],
        written: &Numerals,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let exponents = points.iter().flatten().map(|x| decompose(*x).1);
        let least = exponents.min().unwrap_or(0).min(0);
        let unit = Integer::from(2).pow(u64::from(least.unsigned_abs()));
        cbor::integer(out, &unit)?;
        cbor::array(out, points.len())?;
        for vertex in &self.order.vertices {
            let cell = self.order.cell(*vertex);
            let row = &points[vertex.index()];
            self.row(out, written, |out, k| {
                let (mantissa, exponent) = decompose(row[k]);
                let shift = u64::try_from(exponent - least).unwrap_or(0);
                let value = Integer::from(mantissa) << shift;
                cbor::integer(out, &(value - Integer::from(cell[k]) * &unit))
            })?;
        }
        Ok(())
    }

    fn numbers(
        &self,
        points: &[[Number; D]],
        written: &Numerals,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let unit = written.denominator(points.iter().flatten());
        cbor::integer(out, &unit)?;
        cbor::array(out, points.len())?;
        for vertex in &self.order.vertices {
            let cell = self.order.cell(*vertex);
            let row = &points[vertex.index()];
            let moved = std::array::from_fn::<_, D, _>(|k| {
                let number = &row[k] - Number::from(Rational::from(cell[k]));
                written.numerator(&number, &unit)
            });
            format::write::numbers(out, &moved)?;
        }
        Ok(())
    }

    /// A vertex with rational coordinates; over a larger field they are constant terms.
    fn row<W: Write>(
        &self,
        out: &mut W,
        written: &Numerals,
        integer: impl Fn(&mut W, usize) -> io::Result<()>,
    ) -> io::Result<()> {
        cbor::array(out, D)?;
        for k in 0..D {
            if written.degree() > 1 {
                cbor::array(out, written.degree())?;
            }
            integer(out, k)?;
            for _ in 1..written.degree() {
                cbor::small(out, 0)?;
            }
        }
        Ok(())
    }

    /// A corner with the number of its vertex, from the first cell.
    #[inline]
    fn corner(&self, corner: &Corner<D>) -> Corner<D> {
        Corner {
            vertex: self.order.numbers[corner.vertex.index()].into(),
            shift: corner.moved(self.order.cell(corner.vertex)).shift,
        }
    }

    /// The facets without a mate, sorted by their corners; only of a region.
    fn boundary(&self, matching: &Matching<D>, out: &mut impl Write) -> io::Result<()> {
        let mut facets: Vec<([Corner<D>; D], bool)> = Vec::new();
        if self.tiling.frame.domain.is_region() {
            let alone = matching.mismatches.iter().filter(|m| m.uses.len() == 1);
            facets.extend(alone.map(|m| self.facet(m.uses[0].0)));
        }
        facets.sort_unstable();
        cbor::array(out, facets.len())?;
        let rank = self.tiling.frame.rank();
        facets.into_iter().try_for_each(|(mut corners, is_odd)| {
            if is_odd {
                // In the plane another corner comes first.
                corners.swap(D - 2, D - 1);
                corners = seen_from_first(corners);
            }
            format::write::row(out, &corners.map(corner_in_format), rank, None)
        })
    }

    /// The sorted corners of a facet, relative to the first. Also whether the last two must be exchanged,
    /// so that the opposite corner and these corners are positively oriented.
    fn facet(&self, facet: Facet) -> ([Corner<D>; D], bool) {
        let simplex = self.tiling.simplex(facet.simplex);
        let opposite = usize::from(facet.opposite);
        let mut corners: [Corner<D>; D] =
            std::array::from_fn(|k| self.corner(&simplex[k + usize::from(k >= opposite)]));
        // (c_i, the others in order) has the orientation of the simplex times (-1)^i.
        let is_odd = sort(&mut corners) ^ (opposite % 2 == 1);
        (seen_from_first(corners), is_odd)
    }

    /// The simplices with their hints.
    pub fn simplices(&self, sixes: Option<&[u8]>, out: &mut impl Write) -> io::Result<()> {
        cbor::array(out, self.tiling.len())?;
        let rank = self.tiling.frame.rank();
        for simplex in &self.order.rows {
            let corners = self.tiling.simplex(*simplex);
            let hint = sixes.map(|sixes| sixes[simplex.index()]);
            match corners {
                [a, b, c] => self.simplex([a, b, c], hint, rank, out)?,
                [a, b, c, d] => self.simplex([a, b, c, d], hint, rank, out)?,
                _ => return Err(io::ErrorKind::InvalidInput.into()),
            }
        }
        Ok(())
    }

    /// Sorted corners, the last two exchanged so that the orientation is that of the tiling,
    /// which is positive.
    fn simplex<const N: usize>(
        &self,
        corners: [&Corner<D>; N],
        sixes: Option<u8>,
        rank: usize,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let mut places: [(Corner<D>, usize); N] =
            std::array::from_fn(|k| (self.corner(corners[k]), k));
        let is_odd = sort(&mut places);
        let sixes = sixes.map(|bits| permuted(bits, &places.map(|(_, k)| k)));
        let mut corners = seen_from_first(places.map(|(corner, _)| corner));
        if is_odd {
            corners.swap(N - 2, N - 1);
        }
        format::write::row(out, &corners.map(corner_in_format), rank, sixes)
    }
}

/// The edges of a tetrahedron by its corners, in the order of the hint's bits.
const EDGES: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

/// The bits of the edges of the sorted corners, `order` giving their places before.
fn permuted(bits: u8, order: &[usize]) -> u8 {
    let bit = |i: usize, j: usize| {
        let ends = (order[i].min(order[j]), order[i].max(order[j]));
        let edge = EDGES.iter().position(|edge| *edge == ends).unwrap_or(0);
        bits >> edge & 1
    };
    let edges = EDGES.iter().enumerate();
    edges.fold(0, |sum, (edge, (i, j))| sum | bit(*i, *j) << edge)
}

/// Sorts a few entries; whether the permutation was odd.
#[inline]
fn sort<T: Copy + Ord, const N: usize>(entries: &mut [T; N]) -> bool {
    let mut is_odd = false;
    for end in 1..N {
        let mut k = end;
        while k > 0 && entries[k] < entries[k - 1] {
            entries.swap(k, k - 1);
            is_odd = !is_odd;
            k -= 1;
        }
    }
    is_odd
}

fn seen_from_first<const N: usize, const D: usize>(corners: [Corner<D>; N]) -> [Corner<D>; N] {
    let origin = corners[0].shift;
    corners.map(|corner| Corner {
        vertex: corner.vertex,
        shift: difference(corner.shift, origin),
    })
}

fn corner_in_format<const D: usize>(corner: Corner<D>) -> format::Corner {
    let mut shift = [0; 3];
    shift[..D].copy_from_slice(&corner.shift);
    format::Corner {
        vertex: corner.vertex.number(),
        shift,
    }
}
