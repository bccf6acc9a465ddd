//! Small square matrices over the ring, of any size.
//!
//! Nothing is divided: determinants by expansion along the first row, which for
//! two and three dimensions is also the fastest way.

use super::ring::{Element, Ring};
use num_bigint::BigInt;
use num_traits::One;

/// Rows.
pub(super) type Matrix = Vec<Vec<Element>>;

/// det m
pub(super) fn determinant(ring: &Ring, m: &Matrix) -> Element {
    match m.as_slice() {
        [] => Element::integer(BigInt::one()),
        [r, s] => ring.sum([(false, &r[0], &s[1]), (true, &r[1], &s[0])]),
        _ => {
            let minors: Vec<Element> = (0..m.len())
                .map(|j| determinant(ring, &without(m, 0, j)))
                .collect();
            ring.sum(
                m[0].iter()
                    .zip(&minors)
                    .enumerate()
                    .map(|(j, (x, minor))| (is_odd(j), x, minor)),
            )
        }
    }
}

/// C_ij = (-1)^(i+j) det(m without row i and column j), so m C^T = det(m) I.
pub(super) fn cofactors(ring: &Ring, m: &Matrix) -> Matrix {
    let signed = |i: usize, j: usize| {
        let minor = determinant(ring, &without(m, i, j));
        if is_odd(i + j) {
            Element::default().minus(&minor)
        } else {
            minor
        }
    };
    (0..m.len())
        .map(|i| (0..m.len()).map(|j| signed(i, j)).collect())
        .collect()
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

fn without(m: &Matrix, row: usize, column: usize) -> Matrix {
    let keep = |skip: usize| (0..m.len()).filter(move |&k| k != skip);
    keep(row)
        .map(|i| keep(column).map(|j| m[i][j].clone()).collect())
        .collect()
}

fn is_odd(n: usize) -> bool {
    n % 2 == 1
}
