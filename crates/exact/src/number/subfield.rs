//! The smallest field that some numbers of a field generate.
//!
//! K = `Q[x]`/(p) is a vector space over Q. The numbers and 1 span a subspace; it is closed under
//! products by adding products until the dimension stays. A subspace of dimension m < n with the
//! powers 1, t, …, t^(m-1) of one element as a basis is Q(t). Where p is reducible the same holds
//! in the ring `Q[x]`/(p), so that the field may be larger than necessary, never too small.

use super::element::Number;
use super::error::FieldError;
use super::extension::split_square;
use super::field::Field;
use super::polynomial as poly;
use malachite::base::num::arithmetic::traits::{PowerOf2, Reciprocal};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};
use std::borrow::Borrow;

/// A field inside another one, with the way from numbers of the larger one to their coefficients.
#[derive(Clone, Debug)]
pub struct Subfield {
    /// The smaller field.
    pub field: Field,
    /// The powers of its generator as elements of the larger one; `None` if both are the same.
    powers: Option<Span>,
}

impl Subfield {
    /// The field that `numbers`, all of `field`, generate.
    pub fn of<N: Borrow<Number>>(field: &Field, numbers: impl IntoIterator<Item = N>) -> Subfield {
        let same = || Subfield {
            field: field.clone(),
            powers: None,
        };
        let n = field.degree();
        let mut span = Span::new(n);
        span.insert(&Number::from(Rational::ONE));
        for number in numbers {
            if span.len() == n {
                return same();
            }
            if !number.borrow().is_rational() {
                span.insert(number.borrow());
            }
        }
        span.close(field);
        match span.len() {
            1 => Subfield {
                field: Field::rationals(),
                powers: (n > 1).then_some(span),
            },
            m if m < n => smaller(field, &span).unwrap_or_else(same),
            _ => same(),
        }
    }

    /// The coefficients of a number in the powers of the smaller field's generator, as many as the degree
    /// of this field. `None` if the number is not in it.
    pub fn coefficients(&self, number: &Number) -> Option<Vec<Rational>> {
        match &self.powers {
            None => Some(padded(number, self.field.degree())),
            Some(powers) => powers.combination(number),
        }
    }

    /// Whether it is the larger field itself, with the same generator.
    pub fn is_whole(&self) -> bool {
        self.powers.is_none()
    }

    /// Whether a number lies in the field.
    pub fn contains(&self, number: &Number) -> bool {
        self.coefficients(number).is_some()
    }
}

fn padded(number: &Number, length: usize) -> Vec<Rational> {
    let mut coefficients = number.coefficients().to_vec();
    coefficients.resize(length.max(coefficients.len()), Rational::ZERO);
    coefficients
}

/// Independent elements of the larger field, in the order in which they came.
#[derive(Clone, Debug)]
struct Span {
    /// The degree of the larger field.
    degree: usize,
    elements: Vec<Number>,
    rows: Vec<Row>,
}

/// A vector with a leading 1, and the combination of elements that it is.
#[derive(Clone, Debug)]
struct Row {
    pivot: usize,
    vector: Vec<Rational>,
    combination: Vec<Rational>,
}

impl Span {
    fn new(degree: usize) -> Self {
        Span {
            degree,
            elements: Vec::new(),
            rows: Vec::new(),
        }
    }

    fn len(&self) -> usize {
        self.rows.len()
    }

    /// The rest of a number after subtracting a combination of the elements, and that one.
    fn reduced(&self, number: &Number) -> (Vec<Rational>, Vec<Rational>) {
        let mut rest = padded(number, self.degree);
        let mut combination = vec![Rational::ZERO; self.degree];
        for row in &self.rows {
            let factor = rest[row.pivot].clone();
            if factor != 0 {
                add_multiple(&mut rest, &row.vector, &-&factor);
                add_multiple(&mut combination, &row.combination, &factor);
            }
        }
        (rest, combination)
    }

    /// Adds an element, if it is independent of the others.
    fn insert(&mut self, number: &Number) -> bool {
        let (mut vector, combination) = self.reduced(number);
        let Some(pivot) = vector.iter().position(|x| *x != 0) else {
            return false;
        };
        let scale = (&vector[pivot]).reciprocal();
        let mut combination: Vec<Rational> = combination.iter().map(|x| -x).collect();
        combination[self.elements.len()] = Rational::ONE;
        for x in vector.iter_mut().chain(&mut combination) {
            *x *= &scale;
        }
        self.elements.push(number.clone());
        self.rows.push(Row {
            pivot,
            vector,
            combination,
        });
        true
    }

    /// Adds products until all products of elements are in the span.
    fn close(&mut self, field: &Field) {
        let mut done = 0;
        while done < self.elements.len() && self.len() < field.degree() {
            for k in 0..=done {
                let product = &self.elements[done] * &self.elements[k];
                self.insert(&product);
            }
            done += 1;
        }
    }

    /// The coefficients in terms of the elements.
    fn combination(&self, number: &Number) -> Option<Vec<Rational>> {
        let (rest, mut combination) = self.reduced(number);
        combination.truncate(self.len());
        rest.iter().all(|x| *x == 0).then_some(combination)
    }
}

fn add_multiple(sum: &mut [Rational], vector: &[Rational], factor: &Rational) {
    for (x, y) in sum.iter_mut().zip(vector) {
        *x += factor * y;
    }
}

/// Combinations of the elements that are tried as generators.
const TRIES: i64 = 1000;

/// The subfield with this span; `None` if no generator is found.
fn smaller(field: &Field, span: &Span) -> Option<Subfield> {
    let m = span.len();
    (1..TRIES).find_map(|k| {
        let candidate = span.elements[1..]
            .iter()
            .rev()
            .fold(Number::zero(), |sum, x| sum * field.integer(k) + x);
        let candidate = simplified(field, candidate, m);
        let powers = powers_of(&candidate, field.degree(), m)?;
        let top = &powers.elements[m - 1] * &candidate;
        let relation = powers.combination(&top)?;
        with_generator(field, &candidate, &relation)
    })
}

/// 1, t, …, t^(m-1), if they are independent.
fn powers_of(t: &Number, degree: usize, m: usize) -> Option<Span> {
    let mut powers = Span::new(degree);
    let mut power = Number::from(Rational::ONE);
    for _ in 0..m {
        if !powers.insert(&power) {
            return None;
        }
        power = &power * t;
    }
    Some(powers)
}

/// For m = 2 the root of an integer without small square factors that generates the same field;
/// else the candidate itself.
fn simplified(field: &Field, candidate: Number, m: usize) -> Number {
    if m != 2 {
        return candidate;
    }
    let root = || {
        let powers = powers_of(&candidate, field.degree(), 2)?;
        let relation = powers.combination(&(&candidate * &candidate))?;
        // t² = c_1 t + c_0, and (2 t - c_1)² = c_1² + 4 c_0.
        let shifted = &candidate * field.integer(2) - Number::from(relation[1].clone());
        let square = &relation[1] * &relation[1] + Rational::from(4) * &relation[0];
        if square <= 0 {
            return None;
        }
        let numerator = square.numerator_ref();
        let (factor, _): (Natural, Natural) = split_square(numerator, square.denominator_ref());
        // With square = n/d and n d = s² f, (d/s) times the number is the root of f.
        let scale = Rational::from_naturals(square.denominator_ref().clone(), factor);
        Some((shifted * Number::from(scale)).abs())
    };
    root().unwrap_or(candidate)
}

/// Q(t) for an element with t^m = Σ relation_i t^i.
fn with_generator(field: &Field, t: &Number, relation: &[Rational]) -> Option<Subfield> {
    let mut polynomial: Vec<Rational> = relation.iter().map(|c| -c).collect();
    polynomial.push(Rational::ONE);
    let polynomial: Vec<Integer> = poly::primitive(&polynomial);
    let mut bits = 8i64;
    let (smaller, root) = loop {
        let (lo, hi) = t.enclosure(&Rational::power_of_2(-bits));
        match Field::adjoin_root(&polynomial, lo, hi) {
            Ok(found) => break found,
            Err(FieldError::SeveralRoots(..)) if bits < 2048 => bits *= 2,
            Err(_) => return None,
        }
    };
    if smaller.degree() != relation.len() {
        return None;
    }
    // The root is c times the generator of the smaller field, which thus is t/c.
    let scale = root.coefficients().get(1)?.reciprocal();
    let generator = t * Number::from(scale);
    let powers = powers_of(&generator, field.degree(), relation.len())?;
    Some(Subfield {
        field: smaller,
        powers: Some(powers),
    })
}
