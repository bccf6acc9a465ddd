//! The tiling of a certificate: the witness in the prover's numbers.
//!
//! It reads and does not judge: whether the certificate is right is the kernel's
//! business, and whoever shows this tiling as proved has asked it before.

use super::ImportError;
use acutile_core::tiling::{AnyTiling, Corner, Domain, Frame, Polytope, SHIFT_LIMIT, Tiling};
use acutile_exact::number::{Field, Number};
use acutile_format1::certificate::{self, Certificate, Claim, Place};
use malachite::{Integer, Rational};
use std::str::FromStr;

/// The tiling that a certificate describes.
///
/// # Errors
/// [`ImportError`] naming the entry that is not as docs/format.md says, or that is beyond the
/// prover's limits.
pub fn tiling_of_certificate(certificate: &Certificate) -> Result<AnyTiling, ImportError> {
    match certificate.claim.dimension {
        2 => tiling(certificate).map(AnyTiling::Plane),
        3 => tiling(certificate).map(AnyTiling::Space),
        other => Err(entry(
            "claim.dimension",
            format!("found {other}, expected 2 or 3"),
        )),
    }
}

fn entry(place: impl Into<String>, problem: impl std::fmt::Display) -> ImportError {
    ImportError::entry(place, problem)
}

fn tiling<const D: usize>(certificate: &Certificate) -> Result<Tiling<D>, ImportError> {
    let reader = Reader::of(&certificate.claim)?;
    let frame = reader.frame(&certificate.claim)?;
    let witness = &certificate.witness;
    let vertices = reader.rows("witness.vertices", &witness.vertices)?;
    let mut corners = Vec::with_capacity(witness.simplices.len() * (D + 1));
    for (s, simplex) in witness.simplices.iter().enumerate() {
        let place = format!("witness.simplices[{s}]");
        if simplex.len() != D + 1 {
            return Err(wrong_length(&place, simplex.len(), D + 1));
        }
        for corner in simplex {
            corners.push(read_corner(&place, corner, vertices.len(), frame.rank())?);
        }
    }
    Ok(Tiling {
        frame,
        vertices: vertices.into(),
        corners,
    })
}

fn wrong_length(place: &str, found: usize, expected: usize) -> ImportError {
    entry(place, format!("has {found} entries, expected {expected}"))
}

fn read_corner<const D: usize>(
    place: &str,
    Place(row): &Place,
    vertices: usize,
    rank: usize,
) -> Result<Corner<D>, ImportError> {
    let [vertex, shifts @ ..] = row.as_slice() else {
        return Err(wrong_length(place, 0, rank + 1));
    };
    if shifts.len() != rank {
        return Err(wrong_length(place, row.len(), rank + 1));
    }
    let vertex = u32::try_from(*vertex)
        .ok()
        .filter(|&v| (v as usize) < vertices)
        .ok_or_else(|| entry(place, format!("there is no vertex {vertex}")))?;
    let mut shift = [0; D];
    for (slot, &step) in shift.iter_mut().zip(shifts) {
        *slot = i32::try_from(step)
            .ok()
            .filter(|s| s.unsigned_abs() <= SHIFT_LIMIT.unsigned_abs())
            .ok_or_else(|| entry(place, format!("the shift {step} is too large")))?;
    }
    Ok(Corner { vertex, shift })
}

/// Reads numbers of one claim's field.
struct Reader {
    field: Field,
    /// The root that the claim calls a.
    generator: Number,
}

impl Reader {
    fn of(claim: &Claim) -> Result<Reader, ImportError> {
        let certificate::Field::Algebraic(algebraic) = &claim.field else {
            return Ok(Reader {
                field: Field::rationals(),
                generator: Number::zero(),
            });
        };
        let polynomial = algebraic
            .polynomial
            .iter()
            .map(|text| parse::<Integer>("claim.field.polynomial", text))
            .collect::<Result<Vec<_>, _>>()?;
        let end = |text: &str| parse::<Rational>("claim.field.root", text);
        let (low, high) = (end(&algebraic.root.0)?, end(&algebraic.root.1)?);
        let (field, generator) = Field::adjoin_root(&polynomial, low, high)
            .map_err(|error| entry("claim.field", error.to_string()))?;
        Ok(Reader { field, generator })
    }

    /// Σ c_i a^i, by Horner's rule.
    fn number(&self, place: &str, number: &certificate::Number) -> Result<Number, ImportError> {
        let mut sum = Number::zero();
        for coefficient in number.0.iter().rev() {
            let coefficient = Number::from(parse::<Rational>(place, coefficient)?);
            sum = &(&sum * &self.generator) + &coefficient;
        }
        Ok(sum)
    }

    fn list(&self, place: &str, row: &[certificate::Number]) -> Result<Vec<Number>, ImportError> {
        row.iter().map(|x| self.number(place, x)).collect()
    }

    fn rows<const D: usize>(
        &self,
        place: &str,
        rows: &[Vec<certificate::Number>],
    ) -> Result<Vec<[Number; D]>, ImportError> {
        let row = |row: &Vec<certificate::Number>| {
            self.list(place, row)?
                .try_into()
                .map_err(|row: Vec<Number>| wrong_length(place, row.len(), D))
        };
        rows.iter().map(row).collect()
    }

    fn frame<const D: usize>(&self, claim: &Claim) -> Result<Frame<D>, ImportError> {
        let gram = self.rows("claim.gram", &claim.gram)?;
        let polytope = |polytope: &certificate::Polytope| {
            let rows = polytope.vertices.iter();
            Ok::<_, ImportError>(Polytope {
                vertices: rows
                    .map(|row| self.list("claim.domain", row))
                    .collect::<Result<_, _>>()?,
                faces: polytope.faces.clone(),
            })
        };
        Ok(Frame {
            field: self.field.clone(),
            gram: gram
                .try_into()
                .map_err(|gram: Vec<_>| wrong_length("claim.gram", gram.len(), D))?,
            domain: match &claim.domain {
                certificate::Domain::Space => Domain::Space,
                certificate::Domain::Slab(p) => Domain::Slab(polytope(p)?),
                certificate::Domain::Prism(p) => Domain::Prism(polytope(p)?),
                certificate::Domain::Solid(p) => Domain::Solid(polytope(p)?),
                certificate::Domain::Region => Domain::Region,
            },
        })
    }
}

fn parse<T: FromStr>(place: &str, text: &str) -> Result<T, ImportError> {
    text.parse()
        .map_err(|_| entry(place, format!("found {text:?}, expected a number")))
}
