//! The numbers of a document, or its polynomials in parameters: all are read into one field.

use super::ImportError;
use super::document::{Document, Domain, EndName, Generator, Lattice, ParameterEntry, Text};
use acutile_core::family::Parameter;
use acutile_exact::geometry::RingElement;
use acutile_exact::number::{Field, Number, ReadError, Reader};
use acutile_exact::polynomial::{self, End, Polynomial, Side};
use malachite::{Integer, Rational};
use std::str::FromStr;

/// Reads the numbers of one document into one field.
pub struct Numbers {
    reader: Reader,
    /// The names of the parameters.
    names: Vec<String>,
}

/// The kind of a document's entries: numbers, or polynomials in its parameters.
pub trait Entry: RingElement + PartialEq {
    /// The value of a text that was learnt.
    fn read(numbers: &Numbers, text: &str) -> Result<Self, ReadError>;
    /// 1/x, if it is an entry of the same kind.
    fn inverse(&self) -> Option<Self>;
    /// Whether it is 0.
    fn is_zero(&self) -> bool;
    /// In the words of a message.
    fn shown(&self, numbers: &Numbers) -> String;
}

impl Entry for Number {
    fn read(numbers: &Numbers, text: &str) -> Result<Self, ReadError> {
        numbers.reader.value(text)
    }

    fn inverse(&self) -> Option<Self> {
        Number::inverse(self)
    }

    fn is_zero(&self) -> bool {
        Number::is_zero(self)
    }

    fn shown(&self, _: &Numbers) -> String {
        self.to_string()
    }
}

impl Entry for Polynomial {
    fn read(numbers: &Numbers, text: &str) -> Result<Self, ReadError> {
        polynomial::text::read(&numbers.reader, text, &numbers.names)
    }

    fn inverse(&self) -> Option<Self> {
        Some(Polynomial::constant(self.to_constant()?.inverse()?))
    }

    fn is_zero(&self) -> bool {
        Polynomial::is_zero(self)
    }

    fn shown(&self, numbers: &Numbers) -> String {
        Polynomial::shown(self, &numbers.names)
    }
}

impl Numbers {
    /// Learns every number of the document, so that the field is final.
    pub fn of(document: &Document) -> Result<Self, ImportError> {
        let mut reader = Reader::new();
        for (name, generator) in &document.generators {
            add_generator(&mut reader, name, generator)?;
        }
        let names = document.parameters.0.iter().map(|(name, _)| name.clone());
        let mut numbers = Numbers {
            reader,
            names: names.collect(),
        };
        numbers.learn_parameters(document)?;
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
                polynomial::text::learn(&mut self.reader, &text, &self.names)
                    .map_err(|error| ImportError::Number { place: at(), error })?;
            }
        }
        Ok(())
    }

    /// The ends of the parameters' intervals, which are numbers.
    fn learn_parameters(&mut self, document: &Document) -> Result<(), ImportError> {
        for (name, entry) in &document.parameters.0 {
            if document.generators.contains_key(name) {
                let problem = "a generator has the same name; rename one of them";
                return Err(ImportError::entry(format!("parameters.{name}"), problem));
            }
            for (end, text) in ["low", "high"].iter().zip([entry.low, entry.high]) {
                let at = || format!("parameters.{name}.{end}");
                let text =
                    number_text(text).map_err(|problem| ImportError::entry(at(), problem))?;
                self.reader
                    .learn(&text)
                    .map_err(|error| ImportError::Number { place: at(), error })?;
            }
        }
        Ok(())
    }

    /// The parameters with their intervals.
    pub fn parameters(&self, document: &Document) -> Result<Vec<Parameter>, ImportError> {
        let end =
            |name: &str, end: EndName, text: Text, is_open: bool| -> Result<End, ImportError> {
                let word = match end {
                    EndName::Low => "low",
                    EndName::High => "high",
                };
                let at = || format!("parameters.{name}.{word}");
                let text =
                    number_text(text).map_err(|problem| ImportError::entry(at(), problem))?;
                let value = self.reader.value(&text);
                let value = value.map_err(|error| ImportError::Number { place: at(), error })?;
                Ok(End { value, is_open })
            };
        let parameter = |(name, entry): &(String, ParameterEntry)| {
            let is_open = |end: EndName| entry.open.contains(&end);
            Ok(Parameter {
                side: Side {
                    low: end(name, EndName::Low, entry.low, is_open(EndName::Low))?,
                    high: end(name, EndName::High, entry.high, is_open(EndName::High))?,
                },
                name: name.clone(),
            })
        };
        document.parameters.0.iter().map(parameter).collect()
    }

    /// D entries, in the final field.
    pub fn row<S: Entry, const D: usize>(
        &self,
        row: &[Text],
        place: impl Fn() -> String,
    ) -> Result<[S; D], ImportError> {
        let numbers: Vec<S> = self.list(row, D, place)?;
        Ok(std::array::from_fn(|k| numbers[k].clone()))
    }

    /// A row of this length.
    pub fn list<S: Entry>(
        &self,
        row: &[Text],
        length: usize,
        place: impl Fn() -> String,
    ) -> Result<Vec<S>, ImportError> {
        if row.len() != length {
            let problem = format!("has {} entries, expected {length}", row.len());
            return Err(ImportError::entry(place(), problem));
        }
        let value = |(j, text): (usize, &Text)| {
            let at = || format!("{}[{j}]", place());
            let text = number_text(*text).map_err(|problem| ImportError::entry(at(), problem))?;
            S::read(self, &text).map_err(|error| ImportError::Number { place: at(), error })
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
