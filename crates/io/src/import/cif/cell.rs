//! The cell of a data block, as the Gram matrix of its basis.
//!
//! b_i · b_j = a_i a_j cos θ_ij. Lengths are decimals; the cosines of 60, 90 and 120
//! degrees are rational. Any other decimal angle has an irrational cosine (Niven): it is
//! rounded to 15 decimals, so that the field stays Q, and the caller is told. What is
//! proved is then proved of that lattice.

use super::block::Block;
use super::decimal::{Decimal, about};
use super::operation::{Rotation, metric_change};
use super::symmetry::Listed;
use super::token::at_line;
use crate::import::ImportError;
use acutile_exact::number::enclosure::cos_of_degrees;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Floor, Pow};

/// Decimals of a cosine that is not rational.
const COSINE_DECIMALS: i64 = 15;

/// The metric, and what was rounded for it.
pub struct Cell {
    pub gram: [[Rational; 3]; 3],
    /// Angle and cosine in words, for each that was rounded.
    pub rounded: Vec<String>,
    /// Whether a number had an uncertainty.
    pub uncertain: usize,
}

/// The cell of a block.
///
/// # Errors
/// A length or an angle is missing, or there is no such cell.
pub fn cell(block: &Block) -> Result<Cell, ImportError> {
    let mut uncertain = 0;
    let mut number = |tag: &str, greatest: Option<u8>| {
        let number = positive(block, tag, greatest)?;
        uncertain += usize::from(number.uncertain);
        Ok::<_, ImportError>(number.value)
    };
    let mut lengths = Vec::new();
    for axis in ["a", "b", "c"] {
        lengths.push(number(&format!("_cell_length_{axis}"), None)?);
    }
    let mut gram: [[Rational; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| &lengths[i] * &lengths[j]));
    let mut rounded = Vec::new();
    for (name, i, j) in [("alpha", 1, 2), ("beta", 0, 2), ("gamma", 0, 1)] {
        let angle = number(&format!("_cell_angle_{name}"), Some(180))?;
        let (cosine, words) = cosine(name, &angle);
        rounded.extend(words);
        gram[i][j] *= &cosine;
        gram[j][i] *= cosine;
    }
    check_positive(block, &gram)?;
    Ok(Cell {
        gram,
        rounded,
        uncertain,
    })
}

fn positive(block: &Block, tag: &str, limit: Option<u8>) -> Result<Decimal, ImportError> {
    let Some(value) = block.value(&[tag])? else {
        return Err(ImportError::entry(
            format!("data_{}", block.name),
            format!("{tag} is missing"),
        ));
    };
    let wrong = |problem: String| at_line(value.line, format!("{tag}: {problem}"));
    let number = Decimal::parse(value.text).map_err(wrong)?;
    if number.value <= 0 || limit.is_some_and(|limit| number.value >= limit) {
        let below = limit.map_or_else(String::new, |limit| format!(" and below {limit}"));
        return Err(wrong(format!(
            "found {}, expected more than 0{below}",
            value.text
        )));
    }
    Ok(number)
}

/// The cosine of an angle, rounded where it must be, and what to say of that.
fn cosine(name: &str, degrees: &Rational) -> (Rational, Option<String>) {
    let scale = Rational::from(10).pow(COSINE_DECIMALS);
    let width = (&scale * Rational::from(1_000_000)).pow(-1i64);
    let (low, high) = cos_of_degrees(degrees, &width);
    if low == high {
        return (low, None);
    }
    let half = Rational::from_signeds(1, 2);
    let units = ((low + high) * &half * &scale + half).floor();
    let value = Rational::from(&units) / scale;
    let sign = if value < 0 { "-" } else { "" };
    let digits = format!(
        "{:0>width$}",
        (&units).abs().to_string(),
        width = COSINE_DECIMALS as usize + 1
    );
    let (whole, decimals) = digits.split_at(digits.len() - COSINE_DECIMALS as usize);
    let words = format!("{name}: the cosine is taken to be {sign}{whole}.{decimals}");
    (value, Some(words))
}

/// The leading principal minors are positive; the first is a square.
fn check_positive(block: &Block, g: &[[Rational; 3]; 3]) -> Result<(), ImportError> {
    let minor = |i: usize, j: usize, k: usize, l: usize| &g[i][k] * &g[j][l] - &g[i][l] * &g[j][k];
    let second = minor(0, 1, 0, 1);
    let third =
        &g[0][0] * minor(1, 2, 1, 2) - &g[0][1] * minor(1, 2, 0, 2) + &g[0][2] * minor(1, 2, 0, 1);
    match second > 0 && third > 0 {
        true => Ok(()),
        false => {
            let place = format!("data_{}", block.name);
            Err(ImportError::entry(
                place,
                "there is no cell with these angles: its volume would not be positive",
            ))
        }
    }
}

/// Every operation is an isometry: Rᵀ G R = G.
///
/// With a rounded cosine the equality can fail by the rounding alone; then what differs is
/// returned, for the reader to be told.
///
/// # Errors
/// An operation that is none.
pub fn check_isometries(cell: &Cell, operations: &[Listed]) -> Result<Option<String>, ImportError> {
    let mut note = None;
    let mut seen: Vec<&Rotation> = Vec::new();
    for listed in operations {
        let rotation = &listed.operation.rotation;
        if seen.contains(&rotation) {
            continue;
        }
        seen.push(rotation);
        let Some((i, j, found)) = metric_change(rotation, &cell.gram) else {
            continue;
        };
        let problem = format!(
            "the symmetry operation {:?} does not fit the cell: it takes {} to {}",
            listed.text,
            products(i, j, &cell.gram[i][j]),
            about(&found, 10),
        );
        if cell.rounded.is_empty() || !is_near(&found, i, j, &cell.gram) {
            return Err(at_line(listed.line, problem));
        }
        note.get_or_insert(format!("line {}: {problem}, by rounding", listed.line));
    }
    Ok(note)
}

/// Decides only whether a difference is told or refused.
fn is_near(found: &Rational, i: usize, j: usize, gram: &[[Rational; 3]; 3]) -> bool {
    let scale = &gram[i][i] + &gram[j][j];
    (found - &gram[i][j]).abs() * Rational::from(1000) < scale
}

fn products(i: usize, j: usize, value: &Rational) -> String {
    let names = ["a", "b", "c"];
    format!("{}·{} = {}", names[i], names[j], about(value, 10))
}
