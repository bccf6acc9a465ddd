//! An oracle for whether two simplices meet elsewhere than in the hull of their common corners, by
//! linear programming in exact integers. It has nothing in common with the kernel.
#![allow(clippy::indexing_slicing)]

/// Whether some point of the hulls of p and q has, in p, weight on a corner that is not common.
///
/// Let the columns (p_i, 1, 0) and (-q_j, 0, 1) have weights that are not negative, with the sum
/// (0, 1, 1). The greatest weight on the corners that are not common is taken at a vertex of this
/// polytope, that is with independent columns. All choices of columns are tried.
pub(crate) fn meet_elsewhere(p: &[[i64; 3]], q: &[[i64; 3]], is_common: &[bool]) -> bool {
    let first = p.iter().map(|x| [x[0], x[1], x[2], 1, 0]);
    let second = q.iter().map(|x| [-x[0], -x[1], -x[2], 0, 1]);
    let columns: Vec<[i64; 5]> = first.chain(second).collect();
    let counts = |k: usize| k < p.len() && !is_common[k];
    let counting: u32 = (0..p.len()).filter(|&k| counts(k)).map(|k| 1 << k).sum();
    let mut sets = (1u32..1 << columns.len()).filter(|set| set.count_ones() <= 5 && set & counting != 0);
    sets.any(|set| {
        let chosen: Vec<usize> = (0..columns.len()).filter(|k| set >> k & 1 == 1).collect();
        let Some(signs) = solve(&chosen.iter().map(|&k| columns[k]).collect::<Vec<_>>()) else {
            return false;
        };
        signs.iter().all(|&sign| sign >= 0) && chosen.iter().zip(&signs).any(|(&k, &sign)| counts(k) && sign > 0)
    })
}

/// The signs of the weights with which independent columns give (0, 0, 0, 1, 1), by elimination
/// without fractions (Bareiss). Overflow panics.
fn solve(columns: &[[i64; 5]]) -> Option<Vec<i128>> {
    let n = columns.len();
    // The right side is behind the columns.
    let mut rows = [[0; 6]; 5];
    for (r, row) in rows.iter_mut().enumerate() {
        for (x, column) in row.iter_mut().zip(columns) {
            *x = i128::from(column[r]);
        }
        row[n] = i128::from(r >= 3);
    }
    let mut last = 1;
    for k in 0..n {
        let pivot = (k..5).find(|&r| rows[r][k] != 0)?;
        rows.swap(k, pivot);
        let row = rows[k];
        for (r, other) in rows.iter_mut().enumerate().filter(|(r, _)| *r != k) {
            let factor = other[k];
            for (x, y) in other.iter_mut().zip(&row).take(n + 1) {
                *x = (row[k] * *x - factor * y) / last;
            }
            // The diagonal keeps one value in all rows that are done.
            debug_assert!(r >= k || other[r] == row[k]);
        }
        last = row[k];
    }
    let is_consistent = rows[n..].iter().all(|row| row[n] == 0);
    is_consistent.then(|| rows[..n].iter().map(|row| row[n].signum() * last.signum()).collect())
}
