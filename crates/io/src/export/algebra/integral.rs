//! Numbers as lists of integers over a common denominator, for Lean.
//! The polynomial of the generator is monic, so sums and products of integral elements are integral.

use super::facts::{Class, Facts};
use super::list;
use acutile_core::tiling::{Corner, Tiling};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::{FloorLogBase2, Pow};
use malachite::{Integer, Rational};

const BRACKETS: [&str; 2] = ["[", "]"];

/// The values for the template.
pub fn values<const D: usize>(tiling: &Tiling<D>, facts: &Facts) -> Vec<(&'static str, String)> {
    let field = &tiling.frame.field;
    let degree = field.degree();
    let vertices: Vec<[Number; D]> = tiling.vertices.iter().collect();
    let denominator = Number::common_denominator(vertices.iter().flatten());
    let gram_denominator = Number::common_denominator(tiling.frame.gram.iter().flatten());
    let element = |x: &Number, factor: &Integer| element(x, factor, degree);
    let row =
        |row: &[Number], factor: &Integer| list(row.iter().map(|x| element(x, factor)), BRACKETS);
    let lengths = &gram_denominator * &denominator * &denominator;
    let class = |class: &Class| {
        let angles = list(class.angles.iter().map(usize::to_string), BRACKETS);
        format!("({}, {angles})", row(&class.squared_edges, &lengths))
    };
    let [low, high, bits] = interval(field.root());
    let below = &field.polynomial()[..degree];
    let simplices = tiling
        .simplices()
        .map(|corners| list(corners.iter().map(corner), BRACKETS));
    vec![
        (
            "POLYNOMIAL",
            list(below.iter().map(Integer::to_string), BRACKETS),
        ),
        ("LOW", low),
        ("HIGH", high),
        ("BITS", bits),
        ("GRAMDENOMINATOR", gram_denominator.to_string()),
        (
            "GRAM",
            list(
                tiling.frame.gram.iter().map(|r| row(r, &gram_denominator)),
                BRACKETS,
            ),
        ),
        ("DENOMINATOR", denominator.to_string()),
        (
            "VERTICES",
            list(vertices.iter().map(|v| row(v, &denominator)), BRACKETS),
        ),
        ("SIMPLICES", list(simplices, BRACKETS)),
        (
            "TOTAL",
            element(&facts.total, &(&denominator).pow(D as u64)),
        ),
        (
            "KINDS",
            list(facts.kinds.iter().map(usize::to_string), BRACKETS),
        ),
        ("CLASSES", list(facts.classes.iter().map(class), BRACKETS)),
    ]
}

/// The coefficients of x times the factor, which makes them integers; as many as the degree.
fn element(x: &Number, factor: &Integer, degree: usize) -> String {
    let factor = Rational::from(factor);
    let coefficients = x.coefficients().iter().map(|c| (c * &factor).to_string());
    let zeros = std::iter::repeat_with(|| "0".to_owned());
    list(coefficients.chain(zeros).take(degree), BRACKETS)
}

fn corner<const D: usize>(corner: &Corner<D>) -> String {
    let shift = list(corner.shift.iter().map(i32::to_string), BRACKETS);
    format!("({}, {shift})", corner.vertex)
}

/// Dyadic ends as integers over one power of 2, and its exponent.
fn interval((low, high): (Rational, Rational)) -> [String; 3] {
    let bits = [&low, &high].map(|x| x.denominator_ref().floor_log_base_2());
    let bits = bits[0].max(bits[1]);
    [
        (low << bits).to_string(),
        (high << bits).to_string(),
        bits.to_string(),
    ]
}
