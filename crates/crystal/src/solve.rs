//! Matrices and linear equations over the rationals.

use crate::motion::Vector;
use malachite::Rational;

/// Rows.
pub type Matrix = [Vector; 3];

/// The zero vector.
pub fn zero() -> Vector {
    std::array::from_fn(|_| Rational::from(0))
}

/// M x
pub fn times(m: &Matrix, x: &Vector) -> Vector {
    std::array::from_fn(|i| dot(&m[i], x))
}

/// M N
pub fn product(m: &Matrix, n: &Matrix) -> Matrix {
    let n = transposed(n);
    std::array::from_fn(|i| std::array::from_fn(|j| dot(&m[i], &n[j])))
}

/// The transpose.
pub fn transposed(m: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i].clone()))
}

/// x · y
pub fn dot(x: &Vector, y: &Vector) -> Rational {
    let products = x.iter().zip(y).filter(|(x, _)| **x != 0);
    products.fold(Rational::from(0), |sum, (x, y)| sum + x * y)
}

/// An integral matrix as a rational one.
pub fn rational(m: [[i64; 3]; 3]) -> Matrix {
    m.map(|row| row.map(Rational::from))
}

/// The integral matrix, if it is one.
pub fn integral(m: &Matrix) -> Option<[[i64; 3]; 3]> {
    let mut entries = [[0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            entries[i][j] = i64::try_from(&m[i][j]).ok()?;
        }
    }
    Some(entries)
}

/// The inverse, if there is one.
pub fn inverse(m: &Matrix) -> Option<Matrix> {
    let column = |k: usize| {
        let rows = (0..3).map(|i| (m[i].clone(), Rational::from(u8::from(i == k))));
        solve(rows.collect(), true)
    };
    let columns = [column(0)?, column(1)?, column(2)?];
    Some(transposed(&columns))
}

/// A solution x of the equations a · x = b, or `None`. Unknowns that are free are zero, or there is
/// no answer if the solution must be unique.
pub fn solve(mut rows: Vec<(Vector, Rational)>, is_unique: bool) -> Option<Vector> {
    let mut pivots = Vec::new();
    let mut next = 0;
    for column in 0..3 {
        let Some(found) = (next..rows.len()).find(|&row| rows[row].0[column] != 0) else {
            continue;
        };
        rows.swap(next, found);
        let scale = rows[next].0[column].clone();
        let (pivot, value) = &rows[next];
        let pivot: Vector = std::array::from_fn(|k| &pivot[k] / &scale);
        let value = value / &scale;
        for (row, (a, b)) in rows.iter_mut().enumerate() {
            if row != next && a[column] != 0 {
                let factor = a[column].clone();
                (0..3).for_each(|k| a[k] -= &factor * &pivot[k]);
                *b -= &factor * &value;
            }
        }
        rows[next] = (pivot, value);
        pivots.push(column);
        next += 1;
    }
    let is_consistent = rows[next.min(rows.len())..].iter().all(|(_, b)| *b == 0);
    if !is_consistent || is_unique && pivots.len() < 3 {
        return None;
    }
    let mut x = zero();
    for (row, column) in pivots.into_iter().enumerate() {
        x[column] = rows[row].1.clone();
    }
    Some(x)
}
