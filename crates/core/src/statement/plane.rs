//! Planes in words: linear equations in the coordinates, like `x2+x3=1/2`.

pub use crate::format::Plane;
use acutile_exact::number::parse_rational;
use malachite::base::num::arithmetic::traits::Gcd;
use malachite::{Integer, Rational};
use std::fmt;

const EXPECTED: &str =
    "expected an equation of a plane like x2+x3=1/2: integers times x1, x2, x3, and a fraction";

/// The plane of an equation, in lowest terms. It may have fewer coordinates than space.
pub(super) fn parse(text: &str) -> Result<Plane, String> {
    let wrong = || format!("found {text}, {EXPECTED}");
    let (left, right) = text.split_once('=').ok_or_else(wrong)?;
    let mut normal = [0i32; 3];
    for term in terms(left) {
        let (factor, coordinate) = term.split_once('x').ok_or_else(wrong)?;
        let axis = coordinate
            .parse()
            .ok()
            .filter(|axis| (1..=3).contains(axis));
        let factor = match factor {
            "" | "+" => 1,
            "-" => -1,
            factor => factor.parse().map_err(|_| wrong())?,
        };
        let entry: &mut i32 = &mut normal[axis.map_or(0, |axis: usize| axis - 1)];
        let sum = axis.and_then(|_| entry.checked_add(factor));
        *entry = sum
            .filter(|sum| sum.unsigned_abs() < Plane::MOST_ENTRY)
            .ok_or_else(wrong)?;
    }
    let offset = parse_rational(right).map_err(|_| wrong())?;
    let divisor = normal
        .iter()
        .fold(0, |gcd: u32, c| gcd.gcd(c.unsigned_abs())) as i32;
    let first = normal.iter().find(|c| **c != 0).ok_or_else(wrong)?;
    let divisor = divisor * first.signum();
    let offset = offset / Rational::from(divisor);
    Ok(Plane {
        normal: normal.map(|c| c / divisor).to_vec(),
        offset: numerator(&offset),
        denominator: Integer::from(offset.denominator_ref()),
    })
}

impl Plane {
    /// The right side of its equation.
    pub fn value(&self) -> Rational {
        Rational::from_integers_ref(&self.offset, &self.denominator)
    }
}

fn numerator(x: &Rational) -> Integer {
    Integer::from_sign_and_abs_ref(*x >= 0, x.numerator_ref())
}

/// The terms of a sum, each with its sign.
fn terms(sum: &str) -> Vec<&str> {
    let mut starts: Vec<usize> = vec![0];
    starts.extend(
        sum.char_indices()
            .skip(1)
            .filter(|(_, c)| "+-".contains(*c))
            .map(|(at, _)| at),
    );
    let ends = starts.iter().skip(1).copied().chain([sum.len()]);
    starts
        .iter()
        .zip(ends)
        .map(|(start, end)| &sum[*start..end])
        .collect()
}

/// `x2+x3=1/2`
impl fmt::Display for Plane {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut is_first = true;
        for (axis, c) in (1..).zip(&self.normal).filter(|(_, c)| **c != 0) {
            match (c, is_first) {
                (1, true) => write!(f, "x{axis}")?,
                (1, false) => write!(f, "+x{axis}")?,
                (-1, _) => write!(f, "-x{axis}")?,
                (c, true) => write!(f, "{c}x{axis}")?,
                (c, false) => write!(f, "{c:+}x{axis}")?,
            }
            is_first = false;
        }
        write!(f, "={}", self.offset)?;
        if self.denominator != 1 {
            write!(f, "/{}", self.denominator)?;
        }
        Ok(())
    }
}
