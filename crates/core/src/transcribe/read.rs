//! The tiling and the statements of a certificate, in the prover's numbers.
//!
//! It reads and does not judge: whoever shows the tiling as proved asks the kernel.

use crate::format::{self, Cosine, Fraction, cbor, cbor::CborError, read};
use crate::quality::{DihedralAngle, RadiusEdge};
use crate::statement::{Statement, summary};
use crate::tiling::{AnyTiling, Coordinates, Corner, Domain, Frame, Polytope, SHIFT_LIMIT, Tiling};
use acutile_exact::number::{Field, FieldError, Number};
use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Rational};
use std::fmt;

/// Why there is no tiling.
#[derive(Debug)]
pub enum ReadError {
    /// The bytes are not a certificate in CBOR.
    Cbor(CborError),
    /// The field is none, or beyond the prover's limits.
    Field(FieldError),
    /// A denominator is zero.
    Denominator,
    /// A corner of the simplex names no vertex, or is too far away.
    Corner(usize),
}

impl From<CborError> for ReadError {
    fn from(error: CborError) -> Self {
        ReadError::Cbor(error)
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            ReadError::Cbor(error) => write!(f, "{error}"),
            ReadError::Field(error) => write!(f, "the field: {error}"),
            ReadError::Denominator => write!(f, "a denominator is 0, expected a positive integer"),
            ReadError::Corner(simplex) => write!(
                f,
                "simplex {simplex}: a corner names no vertex, or is moved by more than \
                 {SHIFT_LIMIT} cells"
            ),
        }
    }
}

impl std::error::Error for ReadError {}

/// The tiling that a certificate in CBOR describes, and the statements of its claim.
///
/// # Errors
/// [`ReadError`].
pub fn of_certificate(cbor: &[u8]) -> Result<(AnyTiling, Vec<Statement>), ReadError> {
    let mut items = cbor::Items::new(cbor);
    let claim = read::head(&mut items)?;
    let numbers = Numbers::of(&claim.field)?;
    let statements = claim.statements.iter();
    let statements = statements
        .map(|statement| numbers.statement(statement))
        .collect::<Result<_, _>>()?;
    let tiling = match claim.dimension {
        2 => AnyTiling::Plane(tiling(&mut items, &claim, &numbers)?),
        _ => AnyTiling::Space(tiling(&mut items, &claim, &numbers)?),
    };
    items.end()?;
    Ok((tiling, statements))
}

/// A claim in words, one line, with the number of its simplices and of its boundary facets.
///
/// # Errors
/// [`ReadError`].
pub fn claim_in_words(
    claim: &format::Claim,
    simplices: usize,
    boundary: usize,
) -> Result<String, ReadError> {
    let numbers = Numbers::of(&claim.field)?;
    let statements = claim.statements.iter();
    let statements: Vec<Statement> = statements
        .map(|statement| numbers.statement(statement))
        .collect::<Result<_, _>>()?;
    Ok(match claim.dimension {
        2 => summary(
            &numbers.frame::<2>(claim)?,
            simplices,
            boundary,
            &statements,
        ),
        _ => summary(
            &numbers.frame::<3>(claim)?,
            simplices,
            boundary,
            &statements,
        ),
    })
}

/// Numbers of a certificate's field.
pub(crate) struct Numbers {
    pub field: Field,
    /// The powers of the root that the certificate calls a.
    powers: Vec<Number>,
}

impl Numbers {
    pub fn of(field: &format::Field) -> Result<Self, ReadError> {
        let one = Number::from(Rational::from(1));
        let format::Field::Algebraic(algebraic) = field else {
            return Ok(Numbers {
                field: Field::rationals(),
                powers: vec![one],
            });
        };
        if algebraic.denominator == 0 {
            return Err(ReadError::Denominator);
        }
        let end = |n: &Integer| Rational::from_integers_ref(n, &algebraic.denominator);
        let ends = (end(&algebraic.low), end(&algebraic.high));
        let (field, root) =
            Field::adjoin_root(&algebraic.polynomial, ends.0, ends.1).map_err(ReadError::Field)?;
        let degree = algebraic.polynomial.len() - 1;
        let powers = std::iter::successors(Some(one), |power| Some(power * &root));
        Ok(Numbers {
            field,
            powers: powers.take(degree).collect(),
        })
    }

    /// The number over a denominator that is not zero.
    pub fn number(&self, number: &format::Number, denominator: &Integer) -> Number {
        let coefficients = number.0.iter().zip(&self.powers);
        let terms = coefficients
            .filter(|(c, _)| **c != 0)
            .map(|(c, power)| power * Number::from(Rational::from_integers_ref(c, denominator)));
        terms.fold(Number::zero(), |sum, term| sum + term)
    }

    /// The number that a fraction is.
    pub fn fraction(&self, fraction: &Fraction) -> Result<Number, ReadError> {
        if fraction.denominator == 0 {
            return Err(ReadError::Denominator);
        }
        Ok(self.number(&fraction.numerator, &fraction.denominator))
    }

    fn angle(&self, cosine: &Cosine) -> Result<DihedralAngle, ReadError> {
        let square = self.fraction(&cosine.square)?;
        Ok(DihedralAngle {
            signed_square: if cosine.sign < 0 { -square } else { square },
        })
    }

    /// A statement in the prover's numbers.
    pub fn statement(&self, statement: &format::Statement) -> Result<Statement, ReadError> {
        Ok(match statement {
            format::Statement::FaceToFaceTiling => Statement::FaceToFaceTiling,
            format::Statement::Acute => Statement::Acute,
            format::Statement::Nonobtuse => Statement::Nonobtuse,
            format::Statement::LargestAngle(relation, cosine) => {
                Statement::LargestAngle(*relation, self.angle(cosine)?)
            }
            format::Statement::SmallestAngle(relation, cosine) => {
                Statement::SmallestAngle(*relation, self.angle(cosine)?)
            }
            format::Statement::SquaredRatio(relation, square) => {
                let square = self.fraction(square)?;
                Statement::RadiusEdge(*relation, RadiusEdge { square })
            }
            format::Statement::UncrossedPlane(plane) => Statement::UncrossedPlane(plane.clone()),
            format::Statement::Delaunay => Statement::Delaunay,
            format::Statement::WeaklyDelaunay => Statement::WeaklyDelaunay,
            format::Statement::LocallyDelaunay => Statement::LocallyDelaunay,
            format::Statement::LocallyWeaklyDelaunay => Statement::LocallyWeaklyDelaunay,
            format::Statement::NotDelaunay => Statement::NotDelaunay,
            format::Statement::Tcp => Statement::Tcp,
        })
    }

    /// A domain; `value` makes a coordinate of a numerator and the denominator.
    pub fn domain<V, S>(
        &self,
        domain: &format::Domain<V>,
        value: impl Fn(&V, &Integer) -> S,
    ) -> Result<Domain<S>, ReadError> {
        let polytope = |polytope: &format::Polytope<V>| {
            if polytope.denominator == 0 {
                return Err(ReadError::Denominator);
            }
            let row = |row: &Vec<V>| {
                let numbers = row.iter().map(|x| value(x, &polytope.denominator));
                numbers.collect()
            };
            let face = |face: &Vec<u32>| face.iter().map(|v| *v as usize).collect();
            Ok(Polytope {
                vertices: polytope.vertices.iter().map(row).collect(),
                faces: polytope.faces.iter().map(face).collect(),
            })
        };
        Ok(match domain {
            format::Domain::Space => Domain::Space,
            format::Domain::Slab(slab) => Domain::Slab(polytope(slab)?),
            format::Domain::Prism(prism) => Domain::Prism(polytope(prism)?),
            format::Domain::Solid(solid) => Domain::Solid(polytope(solid)?),
            format::Domain::Region(rank) => Domain::Region(*rank),
        })
    }

    fn frame<const D: usize>(&self, claim: &format::Claim) -> Result<Frame<D>, ReadError> {
        let one = Integer::from(1);
        let entry = |i: usize, j: usize| {
            let (row, column) = (i.min(j), i.max(j));
            self.number(&claim.gram[row][column - row], &one)
        };
        Ok(Frame {
            field: self.field.clone(),
            gram: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
            domain: self.domain(&claim.domain, |x, unit| self.number(x, unit))?,
        })
    }
}

fn tiling<const D: usize>(
    items: &mut cbor::Items,
    claim: &format::Claim,
    numbers: &Numbers,
) -> Result<Tiling<D>, ReadError> {
    let frame = numbers.frame(claim)?;
    let vertices = coordinates(items, claim, numbers)?;
    // The boundary follows from the simplices.
    for _ in 0..items.array()? {
        items.array_of(D)?;
        for _ in 0..D {
            read::corner(items, claim.rank())?;
        }
    }
    let has_sixes = claim.statements.contains(&format::Statement::Tcp);
    let mut corners = Vec::new();
    for simplex in 0..items.array()? {
        items.array_of(D + 1 + usize::from(has_sixes))?;
        for _ in 0..=D {
            let corner = read::corner(items, claim.rank())?;
            corners.push(in_tiling(corner, vertices.len()).ok_or(ReadError::Corner(simplex))?);
        }
        if has_sixes {
            items.small()?;
        }
    }
    Ok(Tiling {
        frame,
        vertices,
        corners,
    })
}

pub(super) fn in_tiling<const D: usize>(
    corner: format::Corner,
    vertices: usize,
) -> Option<Corner<D>> {
    let is_near = corner
        .shift
        .iter()
        .all(|s| s.unsigned_abs() <= SHIFT_LIMIT as u32);
    (is_near && (corner.vertex as usize) < vertices).then(|| Corner {
        vertex: corner.vertex.into(),
        shift: std::array::from_fn(|k| corner.shift[k]),
    })
}

/// The vertices, as machine integers where they fit.
fn coordinates<const D: usize>(
    items: &mut cbor::Items,
    claim: &format::Claim,
    numbers: &Numbers,
) -> Result<Coordinates<D>, ReadError> {
    let denominator = items.integer()?;
    if denominator == Integer::ZERO {
        return Err(ReadError::Denominator);
    }
    let table = items.clone();
    if let Some(coordinates) = small_coordinates(items, claim, &denominator) {
        return Ok(coordinates);
    }
    *items = table;
    let degree = claim.field.degree();
    let mut points: Vec<[Number; D]> = Vec::new();
    for _ in 0..items.array()? {
        let row = read::numbers(items, D, degree)?;
        points.push(std::array::from_fn(|k| {
            numbers.number(&row[k], &denominator)
        }));
    }
    Ok(points.into())
}

/// `None` if something is not a machine integer, or no item at all.
fn small_coordinates<const D: usize>(
    items: &mut cbor::Items,
    claim: &format::Claim,
    denominator: &Integer,
) -> Option<Coordinates<D>> {
    if claim.field.degree() > 1 {
        return None;
    }
    let mut points = Vec::new();
    for _ in 0..items.array().ok()? {
        items.array_of(D).ok()?;
        let mut row = [0; D];
        for entry in &mut row {
            *entry = items.small().ok()?;
        }
        points.push(row);
    }
    Coordinates::from_integers(points, i64::try_from(denominator).ok()?)
}
