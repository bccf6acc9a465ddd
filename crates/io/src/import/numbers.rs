//! The numbers of a document: all of them are read into one field.

use super::ImportError;
use super::document::{Document, Domain, Generator, Lattice, Text};
use acutile_exact::number::{Field, Number, Reader};
use malachite::{Integer, Rational};
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
        if let Some(Lattice::Gram(matrix) | Lattice::Vectors(matrix)) = &document.lattice {
            numbers.learn("lattice", matrix)?;
        }
        match &document.domain {
            Domain::Space | Domain::Region(_) => {}
            Domain::Slab(heights) => numbers.learn("domain.slab", std::slice::from_ref(heights))?,
            Domain::Prism(polytope) => {
                numbers.learn("domain.prism.vertices", &polytope.vertices)?
            }
            Domain::Solid(polytope) => {
                numbers.learn("domain.solid.vertices", &polytope.vertices)?
            }
        }
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

    /// The field in which all numbers live.
    pub fn field(&self) -> Field {
        self.reader.field()
    }

    fn learn(&mut self, place: &str, rows: &[Vec<Text>]) -> Result<(), ImportError> {
        for (i, row) in rows.iter().enumerate() {
            for (j, text) in row.iter().enumerate() {
                let at = || format!("{place}[{i}][{j}]");
                let text =
                    number_text(*text).map_err(|problem| ImportError::entry(at(), problem))?;
                self.reader
                    .learn(&text)
                    .map_err(|error| ImportError::Number { place: at(), error })?;
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
        let numbers = self.list(row, D, place)?;
        Ok(std::array::from_fn(|k| numbers[k].clone()))
    }

    /// A row of this length.
    pub fn list(
        &self,
        row: &[Text],
        length: usize,
        place: impl Fn() -> String,
    ) -> Result<Vec<Number>, ImportError> {
        if row.len() != length {
            let problem = format!("has {} entries, expected {length}", row.len());
            return Err(ImportError::entry(place(), problem));
        }
        let value = |(j, text): (usize, &Text)| {
            let at = || format!("{}[{j}]", place());
            let text = number_text(*text).map_err(|problem| ImportError::entry(at(), problem))?;
            self.reader
                .value(&text)
                .map_err(|error| ImportError::Number { place: at(), error })
        };
        row.iter().enumerate().map(value).collect()
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
        .map_err(|error| ImportError::Number {
            place: format!("generators.{name}"),
            error,
        })
}

fn rational(text: Text, place: impl Fn() -> String) -> Result<Rational, ImportError> {
    let value = number_text(text).map_err(|problem| ImportError::entry(place(), problem))?;
    let number =
        acutile_exact::number::numbers(&[&value]).map_err(|error| ImportError::Number {
            place: place(),
            error,
        })?;
    match number[0].coefficients() {
        [] => Ok(Rational::from(0)),
        [rational] => Ok(rational.clone()),
        _ => Err(ImportError::entry(
            place(),
            format!("found {value:?}, expected a rational"),
        )),
    }
}
