//! Reads a certificate's CBOR into the data.
//!
//! It checks the grammar's shapes and lengths, so that the data can be written again. It does not
//! judge: whether a certificate is right, and canonical, is decided by the kernel.

use super::cbor::{CborError, Item, Items};
use super::{
    AlgebraicField, CLAIM_FORMAT, Certificate, Claim, Corner, Cosine, Domain, FORMAT, Field,
    Fraction, KIND, Number, Plane, Polytope, Relation, Statement, VERSION, Witness,
};
use malachite::Integer;

/// The certificate in these bytes.
///
/// # Errors
/// [`CborError`] with the offset of the item that is not as docs/format.md says; so for all
/// functions.
pub fn certificate(bytes: &[u8]) -> Result<Certificate, CborError> {
    let mut items = Items::new(bytes);
    let claim = head(&mut items)?;
    let degree = claim.field.degree();
    let denominator = items.integer()?;
    let vertices = list(&mut items, |items| numbers(items, claim.dimension, degree))?;
    let (boundary, _) = rows(&mut items, claim.rank(), claim.dimension, false)?;
    let has_sixes = claim.statements.contains(&Statement::Tcp);
    let (simplices, sixes) = rows(&mut items, claim.rank(), claim.dimension + 1, has_sixes)?;
    items.end()?;
    Ok(Certificate {
        claim,
        witness: Witness {
            denominator,
            vertices,
            boundary,
            simplices,
            sixes,
        },
    })
}

/// The claim of a certificate, up to the denominator of the witness.
pub fn head(items: &mut Items) -> Result<Claim, CborError> {
    items.array_of(5)?;
    begin(items, FORMAT, KIND)?;
    let claim = claim(items)?;
    items.array_of(4)?;
    Ok(claim)
}

/// The claim in a claim file.
pub fn claim_file(bytes: &[u8]) -> Result<Claim, CborError> {
    let mut items = Items::new(bytes);
    items.array_of(4)?;
    begin(&mut items, CLAIM_FORMAT, KIND)?;
    let claim = claim(&mut items)?;
    items.end()?;
    Ok(claim)
}

pub(super) fn begin(items: &mut Items, format: &str, kind: &str) -> Result<(), CborError> {
    expect(items, "the format is another", |items| {
        Ok(items.text()? == format)
    })?;
    expect(items, "the version is not 2", |items| {
        Ok(items.small()? == VERSION as i64)
    })?;
    expect(
        items,
        "the certificate is of another kind; verify, show and convert take every kind",
        |items| Ok(items.text()? == kind),
    )
}

/// Reads something that must be as `read` says; an error is at its beginning.
pub(super) fn expect(
    items: &mut Items,
    problem: &'static str,
    read: impl FnOnce(&mut Items) -> Result<bool, CborError>,
) -> Result<(), CborError> {
    let offset = items.offset();
    if read(items)? {
        Ok(())
    } else {
        Err(CborError { offset, problem })
    }
}

pub(super) fn list<T>(
    items: &mut Items,
    mut read: impl FnMut(&mut Items) -> Result<T, CborError>,
) -> Result<Vec<T>, CborError> {
    let length = items.array()?;
    // Every element takes at least a byte, so a length that lies ends with the bytes.
    let mut list = Vec::new();
    for _ in 0..length {
        list.push(read(items)?);
    }
    Ok(list)
}

fn claim(items: &mut Items) -> Result<Claim, CborError> {
    items.array_of(5)?;
    let (dimension, field) = (dimension(items)?, field(items)?);
    let degree = field.degree();
    end_of_claim(items, dimension, field, |items| number(items, degree))
}

pub(super) fn dimension(items: &mut Items) -> Result<usize, CborError> {
    let offset = items.offset();
    match items.small()? {
        2 => Ok(2),
        3 => Ok(3),
        _ => Err(CborError {
            offset,
            problem: "expected the dimension 2 or 3",
        }),
    }
}

/// The Gram matrix, the domain and the statements; `read` reads the value in the place of a
/// number.
pub(super) fn end_of_claim<V>(
    items: &mut Items,
    dimension: usize,
    field: Field,
    mut read: impl FnMut(&mut Items) -> Result<V, CborError>,
) -> Result<Claim<V>, CborError> {
    let degree = field.degree();
    items.array_of(dimension)?;
    let gram = (0..dimension)
        .map(|row| values(items, dimension - row, &mut read))
        .collect::<Result<_, _>>()?;
    Ok(Claim {
        dimension,
        gram,
        domain: domain(items, dimension, &mut read)?,
        statements: list(items, |items| statement(items, degree))?,
        field,
    })
}

pub(super) fn field(items: &mut Items) -> Result<Field, CborError> {
    let offset = items.offset();
    let wrong = |problem| CborError { offset, problem };
    match items.next_item()? {
        Item::Text("Q") => return Ok(Field::Rationals),
        Item::Array(2) => {}
        _ => return Err(wrong("expected \"Q\", or a polynomial and a root")),
    }
    let polynomial = list(items, |items| items.integer())?;
    if polynomial.len() < 3 {
        return Err(wrong("the degree is less than two"));
    }
    items.array_of(3)?;
    Ok(Field::Algebraic(AlgebraicField {
        polynomial,
        low: items.integer()?,
        high: items.integer()?,
        denominator: items.integer()?,
    }))
}

/// A row of `length` numbers.
pub fn numbers(items: &mut Items, length: usize, degree: usize) -> Result<Vec<Number>, CborError> {
    values(items, length, &mut |items| number(items, degree))
}

/// A row of this length.
pub(super) fn values<V>(
    items: &mut Items,
    length: usize,
    read: &mut impl FnMut(&mut Items) -> Result<V, CborError>,
) -> Result<Vec<V>, CborError> {
    items.array_of(length)?;
    (0..length).map(|_| read(items)).collect()
}

pub(super) fn number(items: &mut Items, degree: usize) -> Result<Number, CborError> {
    if degree == 1 {
        return Ok(Number(vec![items.integer()?]));
    }
    items.array_of(degree)?;
    let coefficients: Result<Vec<Integer>, _> = (0..degree).map(|_| items.integer()).collect();
    Ok(Number(coefficients?))
}

pub(super) fn fraction(items: &mut Items, degree: usize) -> Result<Fraction, CborError> {
    items.array_of(2)?;
    Ok(Fraction {
        numerator: number(items, degree)?,
        denominator: items.integer()?,
    })
}

fn domain<V>(
    items: &mut Items,
    dimension: usize,
    read: &mut impl FnMut(&mut Items) -> Result<V, CborError>,
) -> Result<Domain<V>, CborError> {
    let offset = items.offset();
    let wrong = |problem| CborError { offset, problem };
    match items.next_item()? {
        Item::Text("space") => return Ok(Domain::Space),
        Item::Array(2) => {}
        _ => return Err(wrong("expected a domain")),
    }
    match items.text()? {
        "slab" => Ok(Domain::Slab(polytope(items, 1, read)?)),
        "prism" if dimension == 3 => Ok(Domain::Prism(polytope(items, 2, read)?)),
        "solid" => Ok(Domain::Solid(polytope(items, dimension, read)?)),
        "region" => match usize::try_from(items.small()?) {
            Ok(rank) if rank <= dimension => Ok(Domain::Region(rank)),
            _ => Err(wrong("the rank is not between 0 and the dimension")),
        },
        _ => Err(wrong("the domain is not known in this dimension")),
    }
}

fn polytope<V>(
    items: &mut Items,
    k: usize,
    read: &mut impl FnMut(&mut Items) -> Result<V, CborError>,
) -> Result<Polytope<V>, CborError> {
    items.array_of(3)?;
    Ok(Polytope {
        denominator: items.integer()?,
        vertices: list(items, |items| values(items, k, read))?,
        faces: list(items, |items| list(items, index))?,
    })
}

fn index(items: &mut Items) -> Result<u32, CborError> {
    let offset = items.offset();
    u32::try_from(items.small()?).map_err(|_| CborError {
        offset,
        problem: "expected an index",
    })
}

pub(super) fn statement(items: &mut Items, degree: usize) -> Result<Statement, CborError> {
    let offset = items.offset();
    let unknown = CborError {
        offset,
        problem: "the statement is not known",
    };
    let length = match items.next_item()? {
        Item::Text(name) => {
            let found = PLAIN.iter().find(|statement| statement.name() == name);
            return found.cloned().ok_or(unknown);
        }
        Item::Array(length) => length,
        _ => return Err(unknown),
    };
    match (items.text()?, length) {
        ("largest dihedral angle", 4) => Ok(Statement::LargestAngle(
            relation(items)?,
            cosine(items, degree)?,
        )),
        ("smallest dihedral angle", 4) => Ok(Statement::SmallestAngle(
            relation(items)?,
            cosine(items, degree)?,
        )),
        ("squared radius-edge ratio", 3) => Ok(Statement::SquaredRatio(
            relation(items)?,
            fraction(items, degree)?,
        )),
        ("uncrossed plane", 3) => Ok(Statement::UncrossedPlane(plane(items)?)),
        _ => Err(unknown),
    }
}

fn plane(items: &mut Items) -> Result<Plane, CborError> {
    let offset = items.offset();
    let normal = list(items, |items| {
        i32::try_from(items.small()?).map_err(|_| CborError {
            offset,
            problem: "an entry of a normal is too large",
        })
    })?;
    items.array_of(2)?;
    Ok(Plane {
        normal,
        offset: items.integer()?,
        denominator: items.integer()?,
    })
}

/// The statements that are a text alone.
const PLAIN: [Statement; 9] = [
    Statement::FaceToFaceTiling,
    Statement::Acute,
    Statement::Nonobtuse,
    Statement::Delaunay,
    Statement::WeaklyDelaunay,
    Statement::LocallyDelaunay,
    Statement::LocallyWeaklyDelaunay,
    Statement::NotDelaunay,
    Statement::Tcp,
];

fn relation(items: &mut Items) -> Result<Relation, CborError> {
    let offset = items.offset();
    let text = items.text()?;
    let found = Relation::ALL
        .into_iter()
        .find(|relation| relation.text() == text);
    found.ok_or(CborError {
        offset,
        problem: "the relation is not known",
    })
}

fn cosine(items: &mut Items, degree: usize) -> Result<Cosine, CborError> {
    let offset = items.offset();
    let sign = match items.small()? {
        -1 => -1,
        0 => 0,
        1 => 1,
        _ => {
            return Err(CborError {
                offset,
                problem: "the sign is not -1, 0 or 1",
            });
        }
    };
    Ok(Cosine {
        sign,
        square: fraction(items, degree)?,
    })
}

/// The rows of a table: corners, and hints if there are any.
pub(super) fn rows(
    items: &mut Items,
    rank: usize,
    corners: usize,
    has_sixes: bool,
) -> Result<(Vec<Corner>, Vec<u8>), CborError> {
    let length = items.array()?;
    let (mut table, mut sixes) = (Vec::new(), Vec::new());
    for _ in 0..length {
        items.array_of(corners + usize::from(has_sixes))?;
        for _ in 0..corners {
            table.push(corner(items, rank)?);
        }
        if has_sixes {
            let offset = items.offset();
            sixes.push(u8::try_from(items.small()?).map_err(|_| CborError {
                offset,
                problem: "expected six bits",
            })?);
        }
    }
    Ok((table, sixes))
}

/// A corner of a facet or of a simplex.
#[inline]
pub fn corner(items: &mut Items, rank: usize) -> Result<Corner, CborError> {
    let offset = items.offset();
    let wrong = |problem| CborError { offset, problem };
    let vertex = match items.next_item()? {
        Item::Small(vertex) => vertex,
        Item::Array(length) if length == rank + 1 => {
            let vertex = items.small()?;
            let mut corner = Corner {
                vertex: u32::try_from(vertex).map_err(|_| wrong("expected a vertex"))?,
                shift: [0; 3],
            };
            for slot in &mut corner.shift[..rank] {
                let step = items.small()?;
                *slot = i32::try_from(step).map_err(|_| wrong("the shift is too large"))?;
            }
            return Ok(corner);
        }
        _ => return Err(wrong("expected a corner")),
    };
    Ok(Corner {
        vertex: u32::try_from(vertex).map_err(|_| wrong("expected a vertex"))?,
        shift: [0; 3],
    })
}
