//! The numbers of one file, read into one field.
//!
//! First all texts are learnt: a square root that does not lie in the field so
//! far extends it. Then the field stands, and the same texts have values in it.

use super::element::Number;
use super::error::{FieldError, ReadError, ReadErrorKind};
use super::extension::{self, Extension};
use super::field::Field;
use super::limits::BITS_LIMIT;
use super::recognition::{self, Undecided};
use super::text::{self, Expression, ROOT_NAME};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Reads texts as elements of one field, which grows while it learns.
#[derive(Clone, Debug)]
pub struct Reader {
    field: Field,
    names: BTreeMap<String, Number>,
    /// Square roots by the coefficients of their squares.
    roots: BTreeMap<Vec<Rational>, Number>,
    /// Squares and roots that extended the field.
    steps: Vec<(Number, Number)>,
}

impl Default for Reader {
    fn default() -> Reader {
        Reader::new()
    }
}

/// The numbers that `texts` are, in one field that holds them all.
pub fn numbers(texts: &[&str]) -> Result<Vec<Number>, ReadError> {
    let mut reader = Reader::new();
    texts.iter().try_for_each(|text| reader.learn(text))?;
    texts.iter().map(|text| reader.value(text)).collect()
}

impl Reader {
    /// A reader whose field is Q.
    pub fn new() -> Reader {
        Reader {
            field: Field::rationals(),
            names: BTreeMap::new(),
            roots: BTreeMap::new(),
            steps: Vec::new(),
        }
    }

    /// The field so far.
    pub fn field(&self) -> Field {
        self.field.clone()
    }

    /// Names the only root of `polynomial` in [`lo`, `hi`] (see
    /// [`Field::adjoin_root`]), and extends the field by it. Names are made of
    /// ASCII letters, digits and `_`, and begin with a letter.
    pub fn generator(
        &mut self,
        name: &str,
        polynomial: &[Integer],
        lo: Rational,
        hi: Rational,
    ) -> Result<(), ReadError> {
        let error = |kind| ReadError { column: 1, kind };
        let fits = matches!(text::parse(name), Ok(Expression::Name(n, _)) if n == name);
        if !fits || name == ROOT_NAME {
            return Err(error(ReadErrorKind::NotAName(
                name.chars().take(40).collect(),
            )));
        }
        if self.names.contains_key(name) {
            return Err(error(ReadErrorKind::NameTaken(name.to_owned())));
        }
        let field_error = |e| error(ReadErrorKind::Field(Box::new(e)));
        let (other, b) = Field::adjoin_named_root(name, polynomial, lo, hi).map_err(field_error)?;
        let generator = self.join(&other).map_err(field_error)?;
        self.names
            .insert(name.to_owned(), extension::at(b.coefficients(), &generator));
        Ok(())
    }

    /// The names of the generators, sorted.
    pub fn generator_names(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }

    /// Extends the field, if needed, by the generator of `other`, and returns it.
    fn join(&mut self, other: &Field) -> Result<Number, FieldError> {
        if other.is_rationals() || self.field == *other {
            return Ok(other.generator());
        }
        if self.field.is_rationals() {
            self.field = other.clone();
            return Ok(other.generator());
        }
        if let Some(element) = recognition::generator(&self.field, other) {
            return Ok(element);
        }
        let (_, lower) = other
            .polynomial()
            .split_last()
            .ok_or(FieldError::ZeroPolynomial)?;
        let relation: Vec<Number> = lower
            .iter()
            .map(|c| Number::from(Rational::from(-c)))
            .collect();
        let enclose = |width: &Rational| other.generator().enclosure(width);
        let extension = extension::adjoin(&self.field, &relation, enclose)?;
        Ok(self.adopt(extension))
    }

    /// Moves everything into the larger field; returns the adjoined number.
    fn adopt(&mut self, extension: Extension) -> Number {
        self.names
            .values_mut()
            .for_each(|x| *x = extension.embed(x));
        let roots = std::mem::take(&mut self.roots);
        for (square, root) in roots {
            let square = extension.embed(&self.field.element(square));
            self.roots
                .insert(square.coefficients().to_vec(), extension.embed(&root));
        }
        for (square, root) in &mut self.steps {
            (*square, *root) = (extension.embed(square), extension.embed(root));
        }
        self.field = extension.field;
        extension.new
    }

    /// Parses `text` and extends the field until its value lies in it.
    pub fn learn(&mut self, text: &str) -> Result<(), ReadError> {
        self.learn_expression(&text::parse(text)?)
    }

    /// Extends the field until the value of `expression` lies in it.
    pub fn learn_expression(&mut self, expression: &Expression) -> Result<(), ReadError> {
        loop {
            let known = |d: &Number| Ok(self.roots.get(d.coefficients()).cloned());
            let (d, column) = match evaluate(expression, &self.names, &known) {
                Ok(_) => return Ok(()),
                Err(Stop::Error(error)) => return Err(error),
                Err(Stop::Root(d, column)) => (d, column),
            };
            self.learn_root(d)
                .map_err(|kind| ReadError { column, kind })?;
        }
    }

    fn learn_root(&mut self, d: Number) -> Result<(), ReadErrorKind> {
        let found = recognition::square_root(&self.field, &d, &self.steps)
            .map_err(|Undecided| ReadErrorKind::RootUndecided(shown(&d)))?;
        let (square, root) = match found {
            Some(root) => (d, root),
            None => {
                let extension = extension::adjoin_square_root(&self.field, &d)
                    .map_err(|e| ReadErrorKind::Field(Box::new(e)))?;
                let square = extension.embed(&d);
                let root = self.adopt(extension);
                self.steps.push((square.clone(), root.clone()));
                (square, root)
            }
        };
        self.roots.insert(square.coefficients().to_vec(), root);
        Ok(())
    }

    /// The number that `text` is. A square root that does not lie in the field,
    /// for want of learning, is an error.
    pub fn value(&self, text: &str) -> Result<Number, ReadError> {
        self.value_of(&text::parse(text)?)
    }

    /// The number that an expression is, as [`Reader::value`].
    pub fn value_of(&self, expression: &Expression) -> Result<Number, ReadError> {
        let find = |d: &Number| match self.roots.get(d.coefficients()) {
            Some(root) => Ok(Some(root.clone())),
            None => recognition::square_root(&self.field, d, &self.steps)
                .map_err(|Undecided| ReadErrorKind::RootUndecided(shown(d))),
        };
        evaluate(expression, &self.names, &find).map_err(|stop| match stop {
            Stop::Error(error) => error,
            Stop::Root(d, column) => ReadError {
                column,
                kind: ReadErrorKind::RootNotInField(shown(&d)),
            },
        })
    }
}

/// Why an evaluation ends early: an error, or a square root that is not known,
/// of a positive number at a column.
enum Stop {
    Error(ReadError),
    Root(Number, usize),
}

fn stop(column: usize, kind: ReadErrorKind) -> Stop {
    Stop::Error(ReadError { column, kind })
}

type Names = BTreeMap<String, Number>;
type Find<'a> = &'a dyn Fn(&Number) -> Result<Option<Number>, ReadErrorKind>;

fn evaluate(expression: &Expression, names: &Names, find: Find) -> Result<Number, Stop> {
    match expression {
        Expression::Rational(value) => Ok(Number::from(value.clone())),
        Expression::Name(name, column) => names.get(name).cloned().ok_or_else(|| {
            let unknown = if names.is_empty() {
                ReadErrorKind::NoNames
            } else {
                ReadErrorKind::UnknownName
            };
            stop(*column, unknown(name.clone()))
        }),
        Expression::Sum(summands) => summands.iter().try_fold(Number::zero(), |sum, (minus, x)| {
            let x = evaluate(x, names, find)?;
            limited(if *minus { sum - x } else { sum + x }, 1)
        }),
        Expression::Product(first, factors) => {
            let first = evaluate(first, names, find)?;
            factors
                .iter()
                .try_fold(first, |product, (divides, x, column)| {
                    let x = evaluate(x, names, find)?;
                    let x = if *divides { inverse(&x, *column)? } else { x };
                    limited(product * x, *column)
                })
        }
        Expression::Power(base, exponent, column) => {
            let base = evaluate(base, names, find)?;
            let base = if *exponent < 0 {
                inverse(&base, *column)?
            } else {
                base
            };
            power(&base, exponent.unsigned_abs(), *column)
        }
        Expression::Root(radicand, column) => root(evaluate(radicand, names, find)?, *column, find),
    }
}

fn inverse(x: &Number, column: usize) -> Result<Number, Stop> {
    x.inverse()
        .ok_or_else(|| stop(column, ReadErrorKind::DivisionByZero))
}

/// x^e by squaring, e >= 0.
fn power(x: &Number, e: u64, column: usize) -> Result<Number, Stop> {
    if e == 0 {
        return Ok(Number::from(Rational::from(1)));
    }
    let half = power(x, e / 2, column)?;
    let square = limited(&half * &half, column)?;
    if e.is_multiple_of(2) {
        Ok(square)
    } else {
        limited(square * x, column)
    }
}

fn root(d: Number, column: usize, find: Find) -> Result<Number, Stop> {
    match d.sign() {
        Ordering::Equal => return Ok(Number::zero()),
        Ordering::Less => return Err(stop(column, ReadErrorKind::RootOfNegative(shown(&d)))),
        Ordering::Greater => {}
    }
    match find(&d) {
        Ok(Some(root)) => Ok(root),
        Ok(None) => Err(Stop::Root(d, column)),
        Err(kind) => Err(stop(column, kind)),
    }
}

fn limited(x: Number, column: usize) -> Result<Number, Stop> {
    if bits(&x) > BITS_LIMIT {
        return Err(stop(column, ReadErrorKind::ValueTooLarge));
    }
    Ok(x)
}

fn bits(x: &Number) -> u64 {
    let size = |c: &Rational| {
        c.numerator_ref().significant_bits() + c.denominator_ref().significant_bits()
    };
    x.coefficients().iter().map(size).sum()
}

/// The number for a message: exactly if that is short.
fn shown(x: &Number) -> String {
    match (bits(x), x.approximate()) {
        (..=256, _) => x.to_string(),
        (_, near) if near.is_finite() => format!("about {near:e}"),
        (bits, _) => format!("a number of {bits} bits"),
    }
}

/// The rational number that `text` is; it may be any expression, without roots
/// of numbers that are no squares.
pub fn parse_rational(text: &str) -> Result<Rational, ReadError> {
    // In Q every element has one coefficient.
    Reader::new()
        .value(text)
        .map(|x| x.coefficients()[0].clone())
}
