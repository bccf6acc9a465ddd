//! Polynomial identities, proved by evaluation.
//!
//! Suppose that a polynomial of degree at most d_k in its k-th variable vanishes at all points of the grid
//! {0, …, d_1} x … x {0, …, d_n}. Then it is zero. As a polynomial in the last variable it has d_n + 1
//! roots at every point of the smaller grid. So its coefficients vanish there, and are zero by induction.
//! The degrees are bounds that one reads off the formula.

use acutile_exact::geometry::linear;

/// A vector with integer coordinates. The grids are so small that nothing overflows.
pub type Vector = [i128; 3];

/// Whether a polynomial with integer coefficients is zero, where `degrees` bounds its
/// degree in each variable.
pub fn is_zero(degrees: &[usize], polynomial: impl Fn(&[i128]) -> i128) -> bool {
    let mut point = vec![0; degrees.len()];
    loop {
        if polynomial(&point) != 0 {
            return false;
        }
        // The next point, the first coordinate fastest.
        let carry = (0..point.len()).find(|&k| point[k] < degrees[k] as i128);
        let Some(k) = carry else { return true };
        point[..k].fill(0);
        point[k] += 1;
    }
}

/// The vectors that a point of a grid holds one after the other.
pub fn vector(point: &[i128], index: usize) -> Vector {
    std::array::from_fn(|k| point[3 * index + k])
}

pub fn dot(x: Vector, y: Vector) -> i128 {
    linear::dot(&x, &y)
}

pub fn cross(x: Vector, y: Vector) -> Vector {
    linear::cross(&x, &y)
}

pub fn minus(x: Vector, y: Vector) -> Vector {
    linear::subtract(&x, &y)
}
