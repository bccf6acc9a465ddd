//! The cell of a data block, as the Gram matrix of its basis.
//!
//! b_i · b_j = a_i a_j cos θ_ij. Lengths are decimals; the cosines of 60, 90 and 120
//! degrees are rational. Any other decimal angle has an irrational cosine (Niven). It is
//! rounded to 15 decimals, so that the field stays Q, and a note says so. The proof is
//! then about that lattice. A missing angle is 90 degrees, as the dictionary says.

use super::block::Block;
use super::token::at_line;
use crate::import::ImportError;
use crate::import::atoms::decimal::Decimal;
use acutile_exact::number::enclosure::cos_of_degrees;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Floor, Pow};

pub type Gram = [[Rational; 3]; 3];

/// Decimals of a cosine that is not rational.
const COSINE_DECIMALS: i64 = 15;

/// The metric, and how well its numbers are known.
pub struct Cell {
    pub gram: Gram,
    pub lengths: [Decimal; 3],
    /// cos α, cos β, cos γ
    pub cosines: [Rational; 3],
    /// For each angle with an uncertainty an interval that contains the cosines of all its values.
    pub cosine_ranges: [Option<(Rational, Rational)>; 3],
    /// One unit of the last written digit of each angle, in degrees.
    pub angle_units: [Rational; 3],
    /// Angle and cosine in words, for each that was rounded; angles that are missing.
    pub notes: Vec<String>,
    /// How many numbers had an uncertainty.
    pub uncertain: usize,
}

/// The cell of a block.
///
/// # Errors
/// A length is missing, or there is no such cell.
pub fn cell(block: &Block) -> Result<Cell, ImportError> {
    let mut notes = Vec::new();
    let mut lengths = Vec::new();
    for axis in ["a", "b", "c"] {
        let tag = format!("_cell_length_{axis}");
        let missing =
            || ImportError::entry(format!("data_{}", block.name), format!("{tag} is missing"));
        lengths.push(positive(block, &tag, None)?.ok_or_else(missing)?);
    }
    let mut cosines = [(); 3].map(|()| Rational::from(0));
    let mut angle_units = cosines.clone();
    let mut cosine_ranges = [None, None, None];
    let mut uncertain = 0;
    for (k, name) in ["alpha", "beta", "gamma"].into_iter().enumerate() {
        let Some(angle) = positive(block, &format!("_cell_angle_{name}"), Some(180))? else {
            notes.push(format!(
                "{name} is missing, so it is 90 degrees by the dictionary"
            ));
            continue;
        };
        let (cosine, words) = cosine(name, &angle.value);
        notes.extend(words);
        cosines[k] = cosine;
        cosine_ranges[k] = cosine_range(&angle);
        uncertain += usize::from(angle.uncertainty.is_some());
        angle_units[k] = angle.unit;
    }
    uncertain += lengths
        .iter()
        .filter(|length| length.uncertainty.is_some())
        .count();
    let gram = gram([&lengths[0], &lengths[1], &lengths[2]], &cosines);
    check_positive(block, &gram)?;
    Ok(Cell {
        gram,
        lengths: std::array::from_fn(|k| lengths[k].clone()),
        cosines,
        cosine_ranges,
        angle_units,
        notes,
        uncertain,
    })
}

/// b_i · b_j = a_i a_j cos θ_ij
pub fn gram(lengths: [&Decimal; 3], cosines: &[Rational; 3]) -> Gram {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let product = &lengths[i].value * &lengths[j].value;
            // The angle between b_i and b_j is named after the third axis.
            if i == j {
                product
            } else {
                product * &cosines[3 - i - j]
            }
        })
    })
}

fn positive(block: &Block, tag: &str, limit: Option<u8>) -> Result<Option<Decimal>, ImportError> {
    let Some(value) = block.value(&[tag])? else {
        return Ok(None);
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
    Ok(Some(number))
}

/// The cosines of an angle within its uncertainty, rounded outward; the cosine falls.
fn cosine_range(angle: &Decimal) -> Option<(Rational, Rational)> {
    let su = angle.uncertainty.as_ref().filter(|su| **su > 0)?;
    let width = Rational::from(10).pow(-COSINE_DECIMALS);
    let (least, most) = (&angle.value - su, &angle.value + su);
    // The cosine falls from 0 to 180 degrees only, and no angle of a cell is beyond.
    let low = if most < 180 {
        cos_of_degrees(&most, &width).0
    } else {
        Rational::from(-1)
    };
    let high = if least > 0 {
        cos_of_degrees(&least, &width).1
    } else {
        Rational::from(1)
    };
    Some((low, high))
}

/// The cosine of an angle, rounded where it must be, and the note about it.
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
    let words = format!(
        "{name}: the cosine is taken to be {sign}{whole}.{decimals} (15 decimals; what is proved is proved of that lattice)"
    );
    (value, Some(words))
}

/// The leading principal minors are positive; the first is a square.
fn check_positive(block: &Block, g: &[[Rational; 3]; 3]) -> Result<(), ImportError> {
    let minor = |i: usize, j: usize, k: usize, l: usize| &g[i][k] * &g[j][l] - &g[i][l] * &g[j][k];
    let second = minor(0, 1, 0, 1);
    let third =
        &g[0][0] * minor(1, 2, 1, 2) - &g[0][1] * minor(1, 2, 0, 2) + &g[0][2] * minor(1, 2, 0, 1);
    if second > 0 && third > 0 {
        return Ok(());
    }
    Err(ImportError::entry(
        format!("data_{}", block.name),
        "there is no cell with these angles: its volume would not be positive",
    ))
}
