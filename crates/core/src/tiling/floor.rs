//! The cell of the lattice in which a coordinate lies.

use acutile_exact::number::Number;
use malachite::Rational;

/// The largest integer that is not more than x, or 0 if it is beyond 2^30; a double proposes,
/// exact comparisons decide.
pub fn floor(x: &Number) -> i32 {
    let integer = |n: i32| Number::from(Rational::from(n));
    let guess = x.approximate().floor();
    if guess.is_nan() || guess.abs() >= f64::from(1 << 30) {
        return 0;
    }
    let mut floor = guess as i32;
    while *x < integer(floor) {
        floor -= 1;
    }
    while *x >= integer(floor + 1) {
        floor += 1;
    }
    floor
}
