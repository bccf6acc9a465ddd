//! Every operation must be an isometry of the cell: Rᵀ G R = G, exactly.
//!
//! Written numbers are rounded: a = 24.177 and b = 24.1765 are one length. If the operations fit
//! the cell within half a unit of each last digit, a cell that they fit exactly replaces it. First,
//! lengths that agree within their digits become equal. Then the mean of the metric under the
//! operations is taken. Otherwise the file is refused.

use super::cell::{Cell, Gram, gram};
use super::operation::Listed;
use super::operation::{Rotation, metric_change};
use super::token::at_line;
use crate::import::ImportError;
use crate::import::atoms::decimal::about;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Abs;

/// A bound for π / 180.
const RADIANS: (i64, i64) = (17_454, 1_000_000);

/// Makes the metric invariant under the operations; returns the changes in words.
///
/// # Errors
/// An operation that does not fit the cell within the written digits.
pub fn fit(cell: &mut Cell, operations: &[Listed]) -> Result<Vec<String>, ImportError> {
    let listed = different(operations);
    if is_invariant(&cell.gram, &listed) {
        return Ok(Vec::new());
    }
    let errors = errors(cell);
    for listed in &listed {
        check_within_digits(&cell.gram, &errors, listed)?;
    }
    let mut notes = equalise(cell, &listed);
    if !is_invariant(&cell.gram, &listed) {
        cell.gram = mean(&cell.gram, &listed);
        notes.push(
            "lengths and angles fit the operations within their digits only: the metric is replaced by its mean under the operations"
                .to_owned(),
        );
    }
    Ok(notes)
}

/// Whether operations fit the cell within its digits.
pub fn fits(cell: &Cell, operations: &[Listed]) -> bool {
    let errors = errors(cell);
    different(operations)
        .iter()
        .all(|listed| check_within_digits(&cell.gram, &errors, listed).is_ok())
}

/// The first operation with each rotation.
fn different(operations: &[Listed]) -> Vec<&Listed> {
    let mut list: Vec<&Listed> = Vec::new();
    for listed in operations {
        let rotation = &listed.operation.rotation;
        if list
            .iter()
            .all(|other| other.operation.rotation != *rotation)
        {
            list.push(listed);
        }
    }
    list
}

fn is_invariant(gram: &Gram, operations: &[&Listed]) -> bool {
    operations
        .iter()
        .all(|listed| metric_change(&listed.operation.rotation, gram).is_none())
}

/// The errors of the entries of G, to first order, if each number is off by half a unit of its
/// last digit.
fn errors(cell: &Cell) -> Gram {
    let half = Rational::from_signeds(1, 2);
    let radians = Rational::from_signeds(RADIANS.0, RADIANS.1);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let [a, b] = [i, j].map(|k| &cell.lengths[k]);
            let product_error = (&a.value * &b.unit + &b.value * &a.unit) * &half;
            if i == j {
                return product_error;
            }
            let angle = 3 - i - j;
            let cosine_error = &cell.angle_units[angle] * &half * &radians;
            product_error * (&cell.cosines[angle]).abs() + &a.value * &b.value * cosine_error
        })
    })
}

/// The change of each entry is less than the errors explain.
fn check_within_digits(gram: &Gram, errors: &Gram, listed: &Listed) -> Result<(), ImportError> {
    let rotation = &listed.operation.rotation;
    let changed = transformed(rotation, gram);
    let allowed = transformed(&rotation.map(|row| row.map(i64::abs)), errors);
    for i in 0..3 {
        for j in i..3 {
            let change = (&changed[i][j] - &gram[i][j]).abs();
            if change != 0 && change >= &allowed[i][j] + &errors[i][j] {
                let problem = format!(
                    "the symmetry operation {:?} does not fit the cell: it takes {} to {}",
                    listed.text,
                    products(i, j, &gram[i][j]),
                    about(&changed[i][j], 10),
                );
                return Err(at_line(listed.line, problem));
            }
        }
    }
    Ok(())
}

/// Rᵀ G R
fn transformed(r: &Rotation, gram: &Gram) -> Gram {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let mut sum = Rational::from(0);
            for k in 0..3 {
                for l in 0..3 {
                    let factor = r[k][i] * r[l][j];
                    if factor != 0 {
                        sum += &gram[k][l] * Rational::from(factor);
                    }
                }
            }
            sum
        })
    })
}

/// Gives axes that the operations mix the same length if their lengths agree within half a unit
/// each; the one with more digits is taken.
fn equalise(cell: &mut Cell, operations: &[&Listed]) -> Vec<String> {
    const NAMES: [&str; 3] = ["a", "b", "c"];
    let is_mixed = |i: usize, j: usize| {
        operations
            .iter()
            .any(|o| o.operation.rotation[j][i] != 0 || o.operation.rotation[i][j] != 0)
    };
    let mut notes = Vec::new();
    for (i, j) in [(0, 1), (0, 2), (1, 2), (0, 1)] {
        let [a, b] = [i, j].map(|k| &cell.lengths[k]);
        let twice = (&a.value - &b.value).abs() * Rational::from(2);
        if twice == 0 || twice >= &a.unit + &b.unit || !is_mixed(i, j) {
            continue;
        }
        let (rough, fine) = if a.unit > b.unit { (i, j) } else { (j, i) };
        notes.push(format!(
            "{} = {} is taken to be {} = {}, with which it agrees within its digits",
            NAMES[rough],
            about(&cell.lengths[rough].value, 10),
            NAMES[fine],
            about(&cell.lengths[fine].value, 10)
        ));
        cell.lengths[rough] = cell.lengths[fine].clone();
    }
    let [a, b, c] = &cell.lengths;
    cell.gram = gram([a, b, c], &cell.cosines);
    notes
}

/// The mean of Rᵀ G R over the point group, which every operation keeps.
fn mean(gram: &Gram, operations: &[&Listed]) -> Gram {
    let count = Rational::from(operations.len());
    let mut sum: Gram = std::array::from_fn(|_| std::array::from_fn(|_| Rational::from(0)));
    for listed in operations {
        let changed = transformed(&listed.operation.rotation, gram);
        for i in 0..3 {
            for j in 0..3 {
                sum[i][j] += &changed[i][j];
            }
        }
    }
    sum.map(|row| row.map(|entry| entry / &count))
}

fn products(i: usize, j: usize, value: &Rational) -> String {
    let names = ["a", "b", "c"];
    format!("{}·{} = {}", names[i], names[j], about(value, 10))
}
