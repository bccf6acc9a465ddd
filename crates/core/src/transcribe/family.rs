//! From a family to its certificate, and back.
//!
//! The order of the simplices and vertices is that of the member in the middle of the box. A vertex
//! is moved to where it is in the first cell for that member.

use super::field::{Numerals, make_primitive};
use super::order::Order;
use super::read::{Numbers, ReadError, in_tiling};
use super::write::{Rows, in_format};
use crate::family::{AnyFamily, Family, FamilyProof, Parameter};
use crate::format::family::{self as data, FamilyClaim, Term, Tree, Value};
use crate::format::{self, Claim};
use crate::statement::{Statement, summary};
use crate::tiling::{Frame, Polytope};
use acutile_exact::geometry::RingElement;
use acutile_exact::polynomial::{End, Polynomial, Side};
use malachite::Integer;
use malachite::base::num::basic::traits::Zero;

/// The certificate in CBOR.
pub fn to_certificate<const D: usize>(family: &Family<D>, proof: &FamilyProof<D>) -> Vec<u8> {
    let numerals = numerals(family);
    let order = Order::of(&proof.member, &proof.proof.matching);
    let moved = |vertex: &crate::tiling::VertexId| -> [Polynomial; D] {
        let cell = order.cell(*vertex);
        let row = &family.vertices[vertex.index()];
        std::array::from_fn(|k| row[k].minus(&row[k].integer(i64::from(cell[k]))))
    };
    let vertices: Vec<[Polynomial; D]> = order.vertices.iter().map(moved).collect();
    let denominator = denominator(&numerals, vertices.iter().flatten());
    let row = |row: &[Polynomial; D]| {
        let values = row
            .iter()
            .map(|p| value(family, &numerals, p, &denominator));
        values.collect()
    };
    let vertices: Vec<Vec<Value>> = vertices.iter().map(row).collect();
    let claim = claim(family, &numerals, &proof.statements);
    let rows = Rows {
        tiling: &proof.member,
        order: &order,
    };
    let sixes = if proof.statements.contains(&Statement::Tcp) {
        proof.proof.parts(&proof.member).sixes
    } else {
        None
    };
    let mut bytes = Vec::new();
    // A Vec takes every byte.
    let _ = data::head(&mut bytes, &claim, &denominator, &vertices, &proof.tree)
        .and_then(|()| rows.simplices(sixes, &mut bytes));
    bytes
}

/// The smallest field of all numbers of a family.
fn numerals<const D: usize>(family: &Family<D>) -> Numerals {
    let terms = family.polynomials().flat_map(|p| p.terms());
    let sides = family.parameters.iter().map(|parameter| &parameter.side);
    let ends = sides.flat_map(|side| [&side.low.value, &side.high.value]);
    Numerals::of(&family.frame.field, terms.map(|(_, c)| c).chain(ends))
}

fn claim<const D: usize>(
    family: &Family<D>,
    numerals: &Numerals,
    statements: &[Statement],
) -> FamilyClaim {
    let end = |end: &End| data::End {
        is_open: end.is_open,
        value: numerals.fraction(&end.value),
    };
    let parameter = |Parameter { name, side }: &Parameter| data::Parameter {
        name: name.clone(),
        low: end(&side.low),
        high: end(&side.high),
    };
    let polytope = |polytope: &Polytope<Polynomial>| {
        let denominator = denominator(numerals, polytope.vertices.iter().flatten());
        let row = |row: &Vec<Polynomial>| {
            let values = row.iter().map(|p| value(family, numerals, p, &denominator));
            values.collect()
        };
        let face = |face: &Vec<usize>| face.iter().map(|v| *v as u32).collect();
        format::Polytope {
            vertices: polytope.vertices.iter().map(row).collect(),
            faces: polytope.faces.iter().map(face).collect(),
            denominator,
        }
    };
    FamilyClaim {
        parameters: family.parameters.iter().map(parameter).collect(),
        claim: Claim {
            dimension: D,
            field: numerals.field(),
            gram: gram(family, numerals),
            domain: in_format(&family.frame.domain, polytope),
            statements: statements.iter().map(|s| numerals.statement(s)).collect(),
        },
    }
}

/// The upper triangle of the primitive Gram matrix.
fn gram<const D: usize>(family: &Family<D>, numerals: &Numerals) -> Vec<Vec<Value>> {
    let gram = &family.frame.gram;
    let unit = denominator(numerals, gram.iter().flatten());
    let rows = gram.iter().enumerate().map(|(k, row)| {
        let entries = row[k..].iter().map(|p| value(family, numerals, p, &unit));
        entries.collect()
    });
    let mut rows: Vec<Vec<Value>> = rows.collect();
    let terms = rows.iter_mut().flatten().flat_map(|value| &mut value.0);
    make_primitive(terms.map(|term| &mut term.coefficient));
    rows
}

/// The least positive integer that clears these polynomials.
fn denominator<'p>(
    numerals: &Numerals,
    polynomials: impl Iterator<Item = &'p Polynomial>,
) -> Integer {
    numerals.denominator(polynomials.flat_map(|p| p.terms().iter().map(|(_, c)| c)))
}

/// A polynomial times an integer that clears it.
fn value<const D: usize>(
    family: &Family<D>,
    numerals: &Numerals,
    p: &Polynomial,
    unit: &Integer,
) -> Value {
    let parameters = 0..family.parameters.len();
    let terms = p.terms().iter().map(|(monomial, c)| Term {
        coefficient: numerals.numerator(c, unit),
        // The exponents of a family are at most 15.
        exponents: parameters
            .clone()
            .map(|k| monomial.exponent(k) as u8)
            .collect(),
    });
    Value(terms.collect())
}

/// The family that a certificate in CBOR describes, the statements of its claim, and its tree.
///
/// # Errors
/// [`ReadError`].
pub fn of_certificate(cbor: &[u8]) -> Result<(AnyFamily, Vec<Statement>, Tree), ReadError> {
    let certificate = data::certificate(cbor)?;
    let numbers = Numbers::of(&certificate.claim.claim.field)?;
    let statements = certificate.claim.claim.statements.iter();
    let statements = statements.map(|statement| numbers.statement(statement));
    let family = match certificate.claim.claim.dimension {
        2 => AnyFamily::Plane(family(&certificate, &numbers)?),
        _ => AnyFamily::Space(family(&certificate, &numbers)?),
    };
    let statements = statements.collect::<Result<_, _>>()?;
    Ok((family, statements, certificate.witness.tree))
}

fn family<const D: usize>(
    certificate: &data::FamilyCertificate,
    numbers: &Numbers,
) -> Result<Family<D>, ReadError> {
    let data::FamilyCertificate { claim, witness } = certificate;
    if witness.denominator == Integer::ZERO {
        return Err(ReadError::Denominator);
    }
    let row = |row: &Vec<Value>| -> [Polynomial; D] {
        std::array::from_fn(|k| polynomial(numbers, &row[k], &witness.denominator))
    };
    let vertices: Vec<[Polynomial; D]> = witness.vertices.iter().map(row).collect();
    let corners = witness.simplices.iter().enumerate().map(|(index, corner)| {
        in_tiling(*corner, vertices.len()).ok_or(ReadError::Corner(index / (D + 1)))
    });
    Ok(Family {
        parameters: parameters(claim, numbers)?,
        frame: frame(claim, numbers)?,
        corners: corners.collect::<Result<_, _>>()?,
        vertices,
    })
}

fn parameters(claim: &FamilyClaim, numbers: &Numbers) -> Result<Vec<Parameter>, ReadError> {
    let end = |end: &data::End| -> Result<End, ReadError> {
        Ok(End {
            is_open: end.is_open,
            value: numbers.fraction(&end.value)?,
        })
    };
    let parameter = |parameter: &data::Parameter| {
        Ok(Parameter {
            name: parameter.name.clone(),
            side: Side {
                low: end(&parameter.low)?,
                high: end(&parameter.high)?,
            },
        })
    };
    claim.parameters.iter().map(parameter).collect()
}

fn frame<const D: usize>(
    FamilyClaim { claim, .. }: &FamilyClaim,
    numbers: &Numbers,
) -> Result<Frame<D, Polynomial>, ReadError> {
    let one = Integer::from(1);
    let entry = |i: usize, j: usize| {
        let (row, column) = (i.min(j), i.max(j));
        polynomial(numbers, &claim.gram[row][column - row], &one)
    };
    Ok(Frame {
        field: numbers.field.clone(),
        gram: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
        domain: numbers.domain(&claim.domain, |x, unit| polynomial(numbers, x, unit))?,
    })
}

fn polynomial(numbers: &Numbers, value: &Value, denominator: &Integer) -> Polynomial {
    let term = |term: &Term| {
        let coefficient = numbers.number(&term.coefficient, denominator);
        (term.exponents.clone(), coefficient)
    };
    Polynomial::from_terms(value.0.iter().map(term))
}

/// A claim in words, one line, with the number of its simplices.
///
/// # Errors
/// [`ReadError`].
pub fn claim_in_words(claim: &FamilyClaim, simplices: usize) -> Result<String, ReadError> {
    let numbers = Numbers::of(&claim.claim.field)?;
    let statements = claim.claim.statements.iter();
    let statements: Vec<Statement> = statements
        .map(|statement| numbers.statement(statement))
        .collect::<Result<_, _>>()?;
    let parameters = parameters(claim, &numbers)?;
    let sides = parameters
        .iter()
        .map(|p| format!("{} in {}", p.name, p.side));
    let sides: Vec<String> = sides.collect();
    let tiling = match claim.claim.dimension {
        2 => words::<2>(claim, &numbers, &parameters, simplices, &statements)?,
        _ => words::<3>(claim, &numbers, &parameters, simplices, &statements)?,
    };
    Ok(format!("for all {}: {tiling}", sides.join(", ")))
}

fn words<const D: usize>(
    claim: &FamilyClaim,
    numbers: &Numbers,
    parameters: &[Parameter],
    simplices: usize,
    statements: &[Statement],
) -> Result<String, ReadError> {
    let names: Vec<String> = parameters.iter().map(|p| p.name.clone()).collect();
    let frame: Frame<D, Polynomial> = frame(claim, numbers)?;
    let shown = |p: &Polynomial| p.shown(&names);
    let frame = Frame {
        gram: frame.gram.each_ref().map(|row| row.each_ref().map(shown)),
        domain: frame.domain.map(shown),
        field: frame.field,
    };
    Ok(summary(&frame, simplices, 0, statements))
}
