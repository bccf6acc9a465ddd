//! Short vectors of integer lattices: the algorithm of Lenstra, Lenstra and Lovász, exact, in de Weger's
//! form without fractions. See Cohen, A Course in Computational Algebraic Number Theory, algorithm 2.6.7.
//!
//! [`super::recognition`] finds candidates with it. What is found is checked
//! there, so that nothing depends on this file but what can be found.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{DivExact, DivRound, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::comparison::traits::PartialOrdAbs;
use malachite::base::rounding_modes::RoundingMode::Nearest;

/// A reduced basis of the lattice with the basis `rows`, which are independent
/// and of one length; the first vector of the result is short.
pub(super) fn reduce(rows: Vec<Vec<Integer>>) -> Vec<Vec<Integer>> {
    let n = rows.len();
    let mut state = Reduction {
        rows,
        d: vec![Integer::ONE; n + 1],
        lambda: vec![vec![Integer::ZERO; n]; n],
        known: 0,
    };
    let mut k = 0;
    while k < n {
        if k == state.known {
            state.orthogonalize(k);
        }
        if k > 0 {
            state.shorten(k, k - 1);
            if state.should_swap(k) {
                state.swap(k);
                k = (k - 1).max(1);
                continue;
            }
            (0..k - 1).rev().for_each(|l| state.shorten(k, l));
        }
        k += 1;
    }
    state.rows
}

/// With b_i* the Gram-Schmidt vectors and μ their coefficients:
/// d_i = |b_0*|² … |b_(i-1)*|² and λ_ij = d_(j+1) μ_ij are integers.
struct Reduction {
    rows: Vec<Vec<Integer>>,
    d: Vec<Integer>,
    lambda: Vec<Vec<Integer>>,
    /// The number of rows whose d and λ are known.
    known: usize,
}

impl Reduction {
    fn orthogonalize(&mut self, k: usize) {
        for j in 0..=k {
            let mut u: Integer = self.rows[k]
                .iter()
                .zip(&self.rows[j])
                .map(|(x, y)| x * y)
                .sum();
            for i in 0..j {
                let next = &self.d[i + 1] * u - &self.lambda[k][i] * &self.lambda[j][i];
                u = next.div_exact(&self.d[i]);
            }
            if j < k {
                self.lambda[k][j] = u;
            } else {
                self.d[k + 1] = u;
            }
        }
        self.known = k + 1;
    }

    /// Makes |μ_kl| at most 1/2 by subtracting a multiple of row l from row k.
    fn shorten(&mut self, k: usize, l: usize) {
        let twice = &self.lambda[k][l] << 1u64;
        if twice.le_abs(&self.d[l + 1]) {
            return;
        }
        let (factor, _) = (&self.lambda[k][l]).div_round(&self.d[l + 1], Nearest);
        let (head, tail) = self.rows.split_at_mut(k);
        for (x, y) in tail[0].iter_mut().zip(&head[l]) {
            *x -= &factor * y;
        }
        let (head, tail) = self.lambda.split_at_mut(k);
        tail[0][l] -= &factor * &self.d[l + 1];
        for (x, y) in tail[0].iter_mut().zip(&head[l][..l]) {
            *x -= &factor * y;
        }
    }

    /// Lovász: |b_k*|² < (3/4 - μ²) |b_(k-1)*|².
    fn should_swap(&self, k: usize) -> bool {
        let lambda = (&self.lambda[k][k - 1]).square();
        let left = (&self.d[k + 1] * &self.d[k - 1] + lambda) << 2u64;
        left < Integer::from(3) * (&self.d[k]).square()
    }

    fn swap(&mut self, k: usize) {
        self.rows.swap(k, k - 1);
        let (head, tail) = self.lambda.split_at_mut(k);
        head[k - 1][..k - 1].swap_with_slice(&mut tail[0][..k - 1]);
        let lambda = self.lambda[k][k - 1].clone();
        let product = &self.d[k - 1] * &self.d[k + 1] + (&lambda).square();
        let d = product.div_exact(&self.d[k]);
        for i in k + 1..self.known {
            let t = self.lambda[i][k].clone();
            let new = &self.d[k + 1] * &self.lambda[i][k - 1] - &lambda * &t;
            self.lambda[i][k] = new.div_exact(&self.d[k]);
            let other = &d * t + &lambda * &self.lambda[i][k];
            self.lambda[i][k - 1] = other.div_exact(&self.d[k + 1]);
        }
        self.d[k] = d;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(rows: &[[i64; 3]]) -> Vec<Vec<Integer>> {
        rows.iter()
            .map(|row| row.iter().map(|x| Integer::from(*x)).collect())
            .collect()
    }

    /// Every basis of Z³ is reduced to unit vectors.
    #[test]
    fn integer_lattice() {
        let reduced = reduce(rows(&[[1, 0, 0], [1000, 1, 0], [-70000, 333, 1]]));
        for row in reduced {
            assert_eq!(row.iter().map(Square::square).sum::<Integer>(), 1);
        }
    }

    /// 1·√2² - 2·1 = 0 is found from ten decimals of 1, √2, √2².
    #[test]
    fn relation() {
        let reduced = reduce(rows(&[
            [1, 0, 10_000_000_000],
            [0, 1, 14_142_135_623],
            [0, 0, 20_000_000_000],
        ]));
        assert_eq!(reduced.len(), 3);
        assert!(reduced[0].iter().map(Square::square).sum::<Integer>() < 10);
    }
}
