//! Null spaces of exact matrices.

use crate::number::Number;
use malachite::Rational;

/// The solutions d of `rows` d = 0 for `columns` unknowns.
#[derive(Clone, Debug)]
pub struct Space {
    /// The unknowns that may be chosen freely. Basis vector k is 1 at free unknown k and 0 at the others.
    pub free: Vec<usize>,
    /// One vector for each free unknown.
    pub basis: Vec<Vec<Number>>,
}

/// The null space of a matrix. Unknowns are eliminated from the first on, so that the last ones are free.
pub fn null_space(mut rows: Vec<Vec<Number>>, columns: usize) -> Space {
    let pivots = reduce(&mut rows, columns);
    let free: Vec<usize> = (0..columns).filter(|c| !pivots.contains(c)).collect();
    let vector = |&free: &usize| {
        let mut vector = vec![Number::zero(); columns];
        vector[free] = Number::from(Rational::from(1));
        for (row, &pivot) in pivots.iter().enumerate() {
            vector[pivot] = -rows[row][free].clone();
        }
        vector
    };
    Space {
        basis: free.iter().map(vector).collect(),
        free,
    }
}

/// The rank of a matrix.
pub fn rank(mut rows: Vec<Vec<Number>>, columns: usize) -> usize {
    reduce(&mut rows, columns).len()
}

/// Brings the rows into reduced echelon form, and returns the columns of the pivots: that of row k is
/// entry k. Rows after these are zero.
fn reduce(rows: &mut [Vec<Number>], columns: usize) -> Vec<usize> {
    let mut pivots = Vec::new();
    for column in 0..columns {
        let top = pivots.len();
        let Some(found) = (top..rows.len()).find(|&row| !rows[row][column].is_zero()) else {
            continue;
        };
        rows.swap(top, found);
        // The entry is not zero.
        let Some(inverse) = rows[top][column].inverse() else {
            continue;
        };
        for entry in &mut rows[top] {
            *entry = &*entry * &inverse;
        }
        let pivot = rows[top].clone();
        for (row, entries) in rows.iter_mut().enumerate() {
            let factor = entries[column].clone();
            if row == top || factor.is_zero() {
                continue;
            }
            for (entry, above) in entries.iter_mut().zip(&pivot) {
                if !above.is_zero() {
                    *entry = &*entry - &(&factor * above);
                }
            }
        }
        pivots.push(column);
    }
    pivots
}
