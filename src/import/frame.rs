//! The metric part of a file: field, Gram matrix, and the change from Cartesian to
//! basis coordinates.

use super::ImportError;
use super::document::{Coordinates, Document, Generator, Lattice, Text};
use crate::geometry::linear;
use crate::number::{Number, Reader};
use crate::tiling::{Domain, Frame};
use malachite::Integer;
use malachite::Rational;
use std::str::FromStr;

/// Reads the numbers of one document into one field.
pub struct Numbers {
    reader: Reader,
}

impl Numbers {
    /// Learns every number of the document, so that the field is final.
    pub fn of(document: &Document) -> Result<Self, ImportError> {
        let mut reader = Reader::new();
        for (name, generator) in &document.generators {
            add_generator(&mut reader, name, generator)?;
        }
        let mut numbers = Numbers { reader };
        let (Lattice::Gram(matrix) | Lattice::Vectors(matrix)) = &document.lattice;
        numbers.learn("lattice", matrix)?;
        for (place, rows) in [
            ("vertices", &document.vertices),
            ("points", &document.points),
        ] {
            if let Some(rows) = rows {
                numbers.learn(place, rows)?;
            }
        }
        Ok(numbers)
    }

    fn learn(&mut self, place: &str, rows: &[Vec<Text>]) -> Result<(), ImportError> {
        for (i, row) in rows.iter().enumerate() {
            for (j, text) in row.iter().enumerate() {
                let at = || format!("{place}[{i}][{j}]");
                let text =
                    number_text(*text).map_err(|problem| ImportError::entry(at(), problem))?;
                self.reader
                    .learn(&text)
                    .map_err(|error| ImportError::entry(at(), error))?;
            }
        }
        Ok(())
    }

    /// D numbers, in the final field.
    pub fn row<const D: usize>(
        &self,
        row: &[Text],
        place: impl Fn() -> String,
    ) -> Result<[Number; D], ImportError> {
        if row.len() != D {
            let problem = format!("has {} entries, expected {D}", row.len());
            return Err(ImportError::entry(place(), problem));
        }
        let mut numbers = Vec::with_capacity(D);
        for (j, text) in row.iter().enumerate() {
            let at = || format!("{}[{j}]", place());
            let text = number_text(*text).map_err(|problem| ImportError::entry(at(), problem))?;
            numbers.push(
                self.reader
                    .value(&text)
                    .map_err(|e| ImportError::entry(at(), e))?,
            );
        }
        Ok(std::array::from_fn(|k| numbers[k].clone()))
    }
}

/// The text of a number: that of a JSON string, or a JSON number as it stands.
fn number_text(text: Text) -> Result<String, String> {
    let raw = text.0.get();
    match raw.as_bytes().first() {
        Some(b'"') => serde_json::from_str(raw).map_err(|error| error.to_string()),
        Some(b'-' | b'0'..=b'9') => Ok(raw.to_owned()),
        _ => Err(format!(
            "found {}, expected a number like 1, 0.25, \"1/3\" or \"sqrt(2)/2\"",
            raw.chars().take(20).collect::<String>()
        )),
    }
}

fn add_generator(
    reader: &mut Reader,
    name: &str,
    generator: &Generator,
) -> Result<(), ImportError> {
    let mut polynomial = Vec::new();
    for (k, text) in generator.polynomial.iter().enumerate() {
        let at = || format!("generators.{name}.polynomial[{k}]");
        let value = number_text(*text).map_err(|problem| ImportError::entry(at(), problem))?;
        polynomial.push(Integer::from_str(&value).map_err(|()| {
            ImportError::entry(at(), format!("found {value:?}, expected an integer"))
        })?);
    }
    let lower = rational(generator.root.0, || format!("generators.{name}.root[0]"))?;
    let upper = rational(generator.root.1, || format!("generators.{name}.root[1]"))?;
    reader
        .generator(name, &polynomial, lower, upper)
        .map_err(|error| ImportError::entry(format!("generators.{name}"), error))
}

fn rational(text: Text, place: impl Fn() -> String) -> Result<Rational, ImportError> {
    let value = number_text(text).map_err(|problem| ImportError::entry(place(), problem))?;
    let number = crate::number::numbers(&[&value]).map_err(|e| ImportError::entry(place(), e))?;
    match number[0].coefficients() {
        [] => Ok(Rational::from(0)),
        [rational] => Ok(rational.clone()),
        _ => Err(ImportError::entry(
            place(),
            format!("found {value:?}, expected a rational"),
        )),
    }
}

/// The frame of a document, and how its points are turned into basis coordinates.
pub fn read_frame<const D: usize>(
    document: &Document,
    numbers: &Numbers,
) -> Result<(Frame<D>, Change<D>), ImportError> {
    let (Lattice::Gram(rows) | Lattice::Vectors(rows)) = &document.lattice;
    if rows.len() != D {
        let problem = format!("has {} rows, expected {D}", rows.len());
        return Err(ImportError::entry("lattice", problem));
    }
    let mut matrix = Vec::with_capacity(D);
    for (i, row) in rows.iter().enumerate() {
        matrix.push(numbers.row::<D>(row, || format!("lattice[{i}]"))?);
    }
    let matrix: [[Number; D]; D] = std::array::from_fn(|i| matrix[i].clone());
    let domain = match document.domain {
        super::document::Domain::Space => Domain::Space,
    };
    let (gram, change) = match document.lattice {
        Lattice::Gram(_) => (checked_gram(matrix)?, Change::none(document.coordinates)?),
        Lattice::Vectors(_) => (
            gram_of(&matrix),
            Change::from_vectors(&matrix, document.coordinates)?,
        ),
    };
    let field = numbers.reader.field();
    Ok((
        Frame {
            field,
            gram,
            domain,
        },
        change,
    ))
}

fn checked_gram<const D: usize>(gram: [[Number; D]; D]) -> Result<[[Number; D]; D], ImportError> {
    for i in 0..D {
        for j in 0..i {
            if gram[i][j] != gram[j][i] {
                let problem = format!(
                    "the Gram matrix is not symmetric: entry [{i}][{j}] is {}, entry [{j}][{i}] is {}",
                    gram[i][j], gram[j][i]
                );
                return Err(ImportError::entry(format!("lattice[{i}][{j}]"), problem));
            }
        }
    }
    Ok(gram)
}

fn gram_of<const D: usize>(vectors: &[[Number; D]; D]) -> [[Number; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| linear::dot(&vectors[i], &vectors[j])))
}

/// The linear map from a file's coordinates to basis coordinates.
pub struct Change<const D: usize> {
    /// Row k gives basis coordinate k as a combination of Cartesian ones.
    inverse: Option<[[Number; D]; D]>,
}

impl<const D: usize> Change<D> {
    fn none(coordinates: Coordinates) -> Result<Self, ImportError> {
        match coordinates {
            Coordinates::Fractional => Ok(Change { inverse: None }),
            Coordinates::Cartesian => Err(ImportError::entry(
                "coordinates",
                "Cartesian coordinates need lattice vectors, a Gram matrix does not fix them",
            )),
        }
    }

    /// With basis vectors as rows of B, x = f B, so f_k = Σ_j x_j C_kj / det B for
    /// the cofactors C of B.
    fn from_vectors(
        vectors: &[[Number; D]; D],
        coordinates: Coordinates,
    ) -> Result<Self, ImportError> {
        let determinant = linear::determinant(vectors);
        let Some(scale) = determinant.inverse() else {
            let problem = "the lattice vectors are linearly dependent: their determinant is 0";
            return Err(ImportError::entry("lattice", problem));
        };
        Ok(Change {
            inverse: (coordinates == Coordinates::Cartesian).then(|| {
                linear::cofactors(vectors).map(|row| row.map(|cofactor| &cofactor * &scale))
            }),
        })
    }

    /// Basis coordinates of a point of the file.
    pub fn apply(&self, point: [Number; D]) -> [Number; D] {
        match &self.inverse {
            None => point,
            Some(inverse) => linear::apply(inverse, &point),
        }
    }
}
