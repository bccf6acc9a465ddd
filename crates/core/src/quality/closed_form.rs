//! Short names of square roots and of angles, recognised exactly.
//!
//! An angle is given by the signed square of its cosine, s = ±cos² t. By the formula cos² t = (1 + cos
//! 2t)/2, s is an integer combination of square roots for the multiples of 15, 18 and 22.5 degrees. Each is
//! recognised by the polynomial that s is a root of.

use acutile_exact::number::{Number, radical};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedSqrt;

/// √square as a text.
pub fn root(square: &Number) -> Option<String> {
    square.to_rational().map(radical::root)
}

/// √square where it is rational.
pub fn rational_root(square: &Number) -> Option<Rational> {
    square.to_rational()?.checked_sqrt()
}

/// The angle with this signed square of the cosine, as a text. It is in degrees for a known multiple, else
/// an arc cosine if the square is rational.
pub fn angle(signed_square: &Number) -> Option<String> {
    if let Some(degrees) = whole_degrees(signed_square) {
        return Some(degrees_text(&degrees));
    }
    let sign = if signed_square.sign().is_lt() {
        "-"
    } else {
        ""
    };
    let root = root(&signed_square.abs())?;
    Some(format!("arccos({sign}{root})"))
}

fn degrees_text(degrees: &Rational) -> String {
    if *degrees.denominator_ref() == 1u32 {
        degrees.to_string()
    } else {
        super::decimal::rounded_down(degrees, 1)
    }
}

/// A known angle below 90 degrees. It has twice the degrees, the coefficients of a polynomial with root
/// cos² t (constant first), and whether this is the smaller of two roots.
type Known = (i64, [i64; 3], bool);

const KNOWN: [Known; 13] = [
    (60, [-3, 4, 0], false),
    (90, [-1, 2, 0], false),
    (120, [-1, 4, 0], false),
    (30, [1, -16, 16], false),
    (150, [1, -16, 16], true),
    (72, [1, -12, 16], false),
    (144, [1, -12, 16], true),
    (36, [5, -20, 16], false),
    (108, [5, -20, 16], true),
    (45, [1, -8, 8], false),
    (135, [1, -8, 8], true),
    // Angles whose cosines are 1 and 0.
    (0, [-1, 1, 0], false),
    (180, [0, 1, 0], false),
];

/// The angle in degrees if it is a multiple of 15, 18 or 22.5 degrees, or an odd multiple of 9 degrees. The
/// square of the cosine must have a degree of at most two.
pub fn whole_degrees(signed_square: &Number) -> Option<Rational> {
    let square = signed_square.abs();
    let acute = known_degrees(&square).or_else(|| odd_multiple_of_nine(&square))?;
    Some(if signed_square.sign().is_lt() {
        Rational::from(180) - acute
    } else {
        acute
    })
}

/// 9, 27, 63 or 81 for the square of its cosine. With c = cos 2t = 2 cos² t - 1 these are the
/// angles for which 2t is 18, 54, 126 or 162 degrees, where cos 10t = 0 and c ≠ 0:
/// 16 c⁴ - 20 c² + 5 = 0.
fn odd_multiple_of_nine(square: &Number) -> Option<Rational> {
    let integer = |n: i64| Number::from(Rational::from(n));
    let c = &(square * &integer(2)) - &integer(1);
    let cc = &c * &c;
    let value = &(&(&cc * &integer(16)) - &integer(20)) * &cc + integer(5);
    if !value.is_zero() {
        return None;
    }
    // cos² 18° and cos² 54° add up to 5/4.
    let is_steep = cc > Number::from(Rational::from_signeds(5, 8));
    Some(Rational::from(match (c.sign().is_gt(), is_steep) {
        (true, true) => 9,
        (true, false) => 27,
        (false, false) => 63,
        (false, true) => 81,
    }))
}

fn known_degrees(square: &Number) -> Option<Rational> {
    let is_known = |(_, polynomial, smaller): &&Known| {
        let value = polynomial.iter().rev().fold(Number::zero(), |value, c| {
            value * square + Number::from(Rational::from(*c))
        });
        // The two roots of a quadratic here add up to 3/4, 1 or 5/4.
        let half_sum = Rational::from_signeds(-polynomial[1], 2 * polynomial[2].max(1));
        let is_right_root = polynomial[2] == 0 || (*square < Number::from(half_sum)) == *smaller;
        is_right_root && value.is_zero()
    };
    let (twice, ..) = KNOWN.iter().find(is_known)?;
    Some(Rational::from_signeds(*twice, 2))
}
