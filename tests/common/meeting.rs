//! An oracle for whether two simplices meet elsewhere than in their common vertices. It uses linear
//! programming in exact fractions, and no method of the program.

use num_rational::Ratio;
use num_traits::{One, Signed, Zero};

pub type Point = [i64; 3];

/// Overflow panics.
type Fraction = Ratio<i128>;

/// Whether the convex hulls of `p` and `q` have a common point that, in the first hull, has weight on a
/// point outside of `common`.
///
/// Let the columns (p_i, 1, 0) and (-q_j, 0, 1) have the weights λ, μ >= 0 with the sum (0, 1, 1). The
/// greatest weight on the points that are not common occurs at a vertex of this polytope, that is with
/// linearly independent columns. All choices of columns are tried.
pub fn meet_elsewhere(p: &[Point], q: &[Point], common: &[Point]) -> bool {
    if (0..3).any(|k| are_apart(p, q, k)) {
        return false;
    }
    let first = p.iter().map(|x| [x[0], x[1], x[2], 1, 0]);
    let second = q.iter().map(|x| [-x[0], -x[1], -x[2], 0, 1]);
    let columns: Vec<[i64; 5]> = first.chain(second).collect();
    let others = (0..p.len()).filter(|&k| !common.contains(&p[k]));
    let others: u32 = others.map(|k| 1 << k).sum();
    (1u32..1 << columns.len())
        .filter(|set| set.count_ones() <= 5 && set & others != 0)
        .any(|set| {
            let chosen: Vec<usize> = (0..columns.len()).filter(|k| set >> k & 1 == 1).collect();
            let Some(weights) = solve(&chosen.iter().map(|&k| columns[k]).collect::<Vec<_>>())
            else {
                return false;
            };
            weights.iter().all(|w| !w.is_negative())
                && chosen
                    .iter()
                    .zip(&weights)
                    .any(|(&k, w)| others >> k & 1 == 1 && w.is_positive())
        })
}

/// Whether a plane across this axis has the first points on one side and the second ones on the other.
fn are_apart(p: &[Point], q: &[Point], axis: usize) -> bool {
    let greatest = |points: &[Point]| points.iter().map(|x| x[axis]).max();
    let least = |points: &[Point]| points.iter().map(|x| x[axis]).min();
    greatest(p) < least(q) || greatest(q) < least(p)
}

/// The weights with which independent columns give (0, 0, 0, 1, 1), by elimination.
fn solve(columns: &[[i64; 5]]) -> Option<Vec<Fraction>> {
    let fraction = |x: i64| Fraction::from_integer(i128::from(x));
    let n = columns.len();
    let mut rows: Vec<Vec<Fraction>> = (0..5)
        .map(|r| {
            let left = columns.iter().map(|column| fraction(column[r]));
            left.chain([fraction(i64::from(r >= 3))]).collect()
        })
        .collect();
    for k in 0..n {
        let pivot = (k..5).find(|&r| !rows[r][k].is_zero())?;
        rows.swap(k, pivot);
        let inverse = Fraction::one() / rows[k][k];
        for x in &mut rows[k] {
            *x *= inverse;
        }
        let row = rows[k].clone();
        for (r, other) in rows.iter_mut().enumerate() {
            if r != k && !other[k].is_zero() {
                let factor = other[k];
                for (x, y) in other.iter_mut().zip(&row) {
                    *x -= factor * y;
                }
            }
        }
    }
    let consistent = rows[n..].iter().all(|row| row[n].is_zero());
    consistent.then(|| rows[..n].iter().map(|row| row[n]).collect())
}
