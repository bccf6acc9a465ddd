//! The lattice of all translations of a group, and reduced bases.

use crate::motion::{IDENTITY, Motion, Vector};
use crate::solve::{Matrix, dot, product, rational, times, transposed};
use malachite::base::num::arithmetic::traits::{Floor, Lcm};
use malachite::{Integer, Natural, Rational};

/// Steps of a reduction at most: more mean numbers beyond reason.
const STEP_LIMIT: usize = 10_000;

/// A basis, as rows, of the lattice that the unit vectors and some rational vectors generate.
pub fn basis(translations: &[Vector]) -> Option<Matrix> {
    let entries = translations.iter().flatten();
    let denominator = entries.fold(Natural::from(1u32), |lcm, x| lcm.lcm(x.denominator_ref()));
    let scale = Rational::from(&denominator);
    let scaled = |x: &Rational| Integer::try_from(x * &scale).ok();
    let mut rows: Vec<[Integer; 3]> = Vec::new();
    for k in 0..3 {
        rows.push(std::array::from_fn(|j| {
            if j == k {
                Integer::from(&denominator)
            } else {
                Integer::from(0)
            }
        }));
    }
    for translation in translations {
        let [x, y, z] = translation.each_ref().map(scaled);
        rows.push([x?, y?, z?]);
    }
    for column in 0..3 {
        eliminate(&mut rows, column);
    }
    let row = |k: usize| rows[k].each_ref().map(|x| Rational::from(x) / &scale);
    Some([row(0), row(1), row(2)])
}

/// Euclid's algorithm on a column of the rows from that number on.
fn eliminate(rows: &mut [[Integer; 3]], column: usize) {
    loop {
        let used = (column..rows.len()).filter(|&row| rows[row][column] != 0);
        let smallest = used.min_by_key(|&row| {
            let entry = &rows[row][column];
            if *entry < 0 { -entry } else { entry.clone() }
        });
        let Some(smallest) = smallest else {
            return;
        };
        rows.swap(column, smallest);
        let pivot = rows[column].clone();
        let mut is_done = true;
        for row in rows.iter_mut().skip(column + 1) {
            if row[column] == 0 {
                continue;
            }
            let quotient = Rational::from_integers_ref(&row[column], &pivot[column]).floor();
            for k in 0..3 {
                row[k] -= &quotient * &pivot[k];
            }
            is_done &= row[column] == 0;
        }
        if is_done {
            return;
        }
    }
}

/// The translations of a group.
pub fn translations(group: &[Motion]) -> Vec<Vector> {
    let pure = group.iter().filter(|motion| motion.rotation == IDENTITY);
    pure.map(|motion| motion.translation.clone()).collect()
}

/// The Gram matrix of basis vectors given as rows in another basis.
pub fn gram_of(basis: &Matrix, gram: &Matrix) -> Matrix {
    product(&product(basis, gram), &transposed(basis))
}

/// A reduced basis of the same lattice, as integral rows: no vector becomes shorter if sums or
/// differences of the others are added. `None` if there are too many steps.
pub fn reduced(gram: &Matrix) -> Option<Matrix> {
    let mut basis = rational(IDENTITY);
    for _ in 0..STEP_LIMIT {
        if !shorten(&mut basis, gram) {
            return Some(basis);
        }
    }
    None
}

fn shorten(basis: &mut Matrix, gram: &Matrix) -> bool {
    let norm = |x: &Vector| dot(x, &times(gram, x));
    for i in 0..3 {
        for j in (0..3).filter(|&j| j != i) {
            let quotient = dot(&basis[i], &times(gram, &basis[j])) / norm(&basis[j]);
            let nearest = Rational::from((quotient + Rational::from_signeds(1, 2)).floor());
            let candidate: Vector = std::array::from_fn(|k| &basis[i][k] - &nearest * &basis[j][k]);
            if norm(&candidate) < norm(&basis[i]) {
                basis[i] = candidate;
                return true;
            }
        }
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for (s, t) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let candidate: Vector = std::array::from_fn(|n| {
                &basis[i][n] + Rational::from(s) * &basis[j][n] + Rational::from(t) * &basis[k][n]
            });
            if norm(&candidate) < norm(&basis[i]) {
                basis[i] = candidate;
                return true;
            }
        }
    }
    false
}
