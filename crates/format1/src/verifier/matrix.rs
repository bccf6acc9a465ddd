//! Square matrices of one, two or three rows over the ring: no others occur.
//!
//! Nothing is divided: determinants by expansion along the first row, which for
//! two and three dimensions is also the fastest way.

use super::integer::Integer;
use super::ring::{Element, Ring};

/// Rows.
pub(super) type Matrix = Vec<Vec<Element>>;

/// det m
pub(super) fn determinant(ring: &Ring, m: &Matrix) -> Element {
    match m.as_slice() {
        [r] => r[0].clone(),
        [r, s] => ring.sum([(false, &r[0], &s[1]), (true, &r[1], &s[0])]),
        [r, s, t] => ring.dot(r, &cross(ring, s, t)),
        _ => Element::default(),
    }
}

/// C_ij = (-1)^(i+j) det(m without row i and column j), so m C^T = det(m) I.
pub(super) fn cofactors(ring: &Ring, m: &Matrix) -> Matrix {
    let negative = |x: &Element| Element::default().minus(x);
    match m.as_slice() {
        [_] => vec![vec![Element::integer(Integer::ONE)]],
        [r, s] => vec![
            vec![s[1].clone(), negative(&s[0])],
            vec![negative(&r[1]), r[0].clone()],
        ],
        [r, s, t] => vec![cross(ring, s, t), cross(ring, t, r), cross(ring, r, s)],
        _ => Matrix::new(),
    }
}

/// m x
pub(super) fn apply(ring: &Ring, m: &Matrix, x: &[Element]) -> Vec<Element> {
    m.iter().map(|row| ring.dot(row, x)).collect()
}

/// x × y in three coordinates: the functional z -> det(x, y, z).
pub(super) fn cross(ring: &Ring, x: &[Element], y: &[Element]) -> Vec<Element> {
    let entry = |i: usize, j: usize| ring.sum([(false, &x[i], &y[j]), (true, &x[j], &y[i])]);
    vec![entry(1, 2), entry(2, 0), entry(0, 1)]
}

/// The first k rows and columns.
pub(super) fn leading(m: &Matrix, k: usize) -> Matrix {
    m[..k].iter().map(|row| row[..k].to_vec()).collect()
}
