//! The metric part of a file: Gram matrix, domain, and the change from Cartesian to
//! basis coordinates.

use super::ImportError;
use super::document::{Coordinates, Document, Lattice};
use super::domain::read_domain;
use super::numbers::{Entry, Numbers};
use acutile_core::tiling::{Domain, Frame, Polytope};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;

/// The frame of a document, and how its points are turned into basis coordinates.
pub fn read_frame<S: Entry, const D: usize>(
    document: &Document,
    numbers: &Numbers,
) -> Result<(Frame<D, S>, Change<D, S>), ImportError> {
    let domain = read_domain::<S, D>(document, numbers)?;
    let Some(lattice) = &document.lattice else {
        return identity(numbers, domain);
    };
    let (Lattice::Gram(rows) | Lattice::Vectors(rows)) = lattice;
    if rows.len() != D {
        let problem = format!("has {} rows, expected {D}", rows.len());
        return Err(ImportError::entry("lattice", problem));
    }
    let mut matrix = Vec::with_capacity(D);
    for (i, row) in rows.iter().enumerate() {
        matrix.push(numbers.row::<S, D>(row, || format!("lattice[{i}]"))?);
    }
    let matrix: [[S; D]; D] = std::array::from_fn(|i| matrix[i].clone());
    let (gram, change) = match lattice {
        Lattice::Gram(_) => (
            checked_gram(matrix, numbers)?,
            Change::none(document.coordinates)?,
        ),
        Lattice::Vectors(_) => (
            gram_of(&matrix),
            Change::from_vectors(&matrix, document.coordinates)?,
        ),
    };
    let field = numbers.field();
    let domain = change.apply_to(domain);
    Ok((
        Frame {
            field,
            gram,
            domain,
        },
        change,
    ))
}

/// Without a lattice a solid or a region lives in Cartesian coordinates.
fn identity<S: Entry, const D: usize>(
    numbers: &Numbers,
    domain: Domain<S>,
) -> Result<(Frame<D, S>, Change<D, S>), ImportError> {
    match &domain {
        Domain::Solid(_) | Domain::Region(0) => {}
        _ => {
            let problem = "is missing; only a solid and a region of rank 0 need none";
            return Err(ImportError::entry("lattice", problem));
        }
    }
    let field = numbers.field();
    let one = S::read(numbers, "1").map_err(|error| ImportError::Number {
        place: "lattice".to_owned(),
        error,
    })?;
    let gram = std::array::from_fn(|i| std::array::from_fn(|j| one.integer(i64::from(i == j))));
    Ok((
        Frame {
            field,
            gram,
            domain,
        },
        Change { inverse: None },
    ))
}

fn checked_gram<S: Entry, const D: usize>(
    gram: [[S; D]; D],
    numbers: &Numbers,
) -> Result<[[S; D]; D], ImportError> {
    for i in 0..D {
        for j in 0..i {
            if gram[i][j] != gram[j][i] {
                let problem = format!(
                    "the Gram matrix is not symmetric: entry [{i}][{j}] is {}, entry [{j}][{i}] is {}",
                    gram[i][j].shown(numbers),
                    gram[j][i].shown(numbers)
                );
                return Err(ImportError::entry(format!("lattice[{i}][{j}]"), problem));
            }
        }
    }
    Ok(gram)
}

fn gram_of<S: Entry, const D: usize>(vectors: &[[S; D]; D]) -> [[S; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| linear::dot(&vectors[i], &vectors[j])))
}

/// The linear map from a file's coordinates to basis coordinates.
pub struct Change<const D: usize, S = Number> {
    /// Row k gives basis coordinate k as a combination of Cartesian ones.
    inverse: Option<[[S; D]; D]>,
}

impl<S: Entry, const D: usize> Change<D, S> {
    fn none(coordinates: Coordinates) -> Result<Self, ImportError> {
        match coordinates {
            Coordinates::Fractional => Ok(Change { inverse: None }),
            Coordinates::Cartesian => Err(ImportError::entry(
                "coordinates",
                "Cartesian coordinates need lattice vectors, a Gram matrix does not fix them",
            )),
        }
    }

    /// With basis vectors as rows of B, x = f B. So f_k = Σ_j x_j C_kj / det B for
    /// the cofactors C of B.
    fn from_vectors(vectors: &[[S; D]; D], coordinates: Coordinates) -> Result<Self, ImportError> {
        if coordinates == Coordinates::Fractional {
            return Ok(Change { inverse: None });
        }
        let determinant = linear::determinant(vectors);
        let Some(scale) = determinant.inverse() else {
            let problem = if determinant.is_zero() {
                "the lattice vectors are linearly dependent: their determinant is 0"
            } else {
                "the determinant of the lattice vectors depends on parameters; give \
                     fractional coordinates"
            };
            return Err(ImportError::entry("lattice", problem));
        };
        let cofactors = linear::cofactors(vectors);
        let inverse = cofactors.map(|row| row.map(|cofactor| cofactor.times(&scale)));
        Ok(Change {
            inverse: Some(inverse),
        })
    }

    /// The vertices of a solid are points of the file; the heights of a slab and the
    /// corners of a prism are basis coordinates.
    fn apply_to(&self, domain: Domain<S>) -> Domain<S> {
        match domain {
            Domain::Solid(polytope) => {
                let change = |vertex: &Vec<S>| {
                    self.apply(std::array::from_fn(|k| vertex[k].clone()))
                        .to_vec()
                };
                let vertices = polytope.vertices.iter().map(change).collect();
                Domain::Solid(Polytope {
                    vertices,
                    faces: polytope.faces,
                })
            }
            other => other,
        }
    }

    /// Basis coordinates of a point of the file.
    pub fn apply(&self, point: [S; D]) -> [S; D] {
        match &self.inverse {
            None => point,
            Some(inverse) => linear::apply(inverse, &point),
        }
    }
}
