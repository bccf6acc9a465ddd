//! A reduced basis of a lattice, exactly: the algorithm of Lenstra, Lenstra and
//! Lovász (Math. Ann. 261, 1982) with a Gram matrix as only input.
//!
//! In a reduced basis the coordinates of a ball are not much longer than its radius, however skewed the given basis was.

use super::DelaunayError;
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;
use malachite::Rational;

/// No entry of a change of basis is larger, so that products cannot overflow.
const ENTRY_LIMIT: i64 = 1 << 28;

/// A reduced basis c of the lattice with the basis b.
#[derive(Clone, Debug)]
pub struct Reduced<const D: usize> {
    /// c_i = Σ rows_ij b_j; the determinant is 1.
    pub rows: [[i64; D]; D],
    /// The inverse matrix: b_i = Σ inverse_ij c_j.
    pub inverse: [[i64; D]; D],
    /// Inner products of the c_i.
    pub gram: [[Number; D]; D],
}

/// c_i = c*_i + Σ_{j<i} mu_ij c*_j with c* orthogonal.
pub struct Orthogonal<const D: usize> {
    /// mu_ij for j < i.
    pub mu: [[Number; D]; D],
    /// |c*_i|², all positive.
    pub norms: [Number; D],
}

impl<const D: usize> Orthogonal<D> {
    /// The Gram-Schmidt process on a Gram matrix. `None` if the matrix is not positive definite: the
    /// product of the first k norms is the k-th leading minor.
    pub fn of(gram: &[[Number; D]; D]) -> Option<Self> {
        let mut mu: [[Number; D]; D] = zeros();
        let mut r: [[Number; D]; D] = zeros();
        for i in 0..D {
            for j in 0..=i {
                let known = (0..j).fold(gram[i][j].clone(), |x, k| x - &(&mu[j][k] * &r[i][k]));
                if j < i {
                    mu[i][j] = known.divide(&r[j][j])?;
                } else if known.sign() != Sign::Greater {
                    return None;
                }
                r[i][j] = known;
            }
        }
        let norms = std::array::from_fn(|i| r[i][i].clone());
        Some(Orthogonal { mu, norms })
    }
}

fn zeros<const D: usize>() -> [[Number; D]; D] {
    std::array::from_fn(|_| std::array::from_fn(|_| Number::zero()))
}

/// A reduced basis of the lattice with this Gram matrix.
pub fn reduce<const D: usize>(gram: &[[Number; D]; D]) -> Result<Reduced<D>, DelaunayError> {
    if (0..D).any(|i| (0..i).any(|j| gram[i][j] != gram[j][i])) {
        return Err(DelaunayError::NotSymmetric);
    }
    let identity = std::array::from_fn(|i| std::array::from_fn(|j| i64::from(i == j)));
    let mut basis = Reduced {
        rows: identity,
        inverse: identity,
        gram: gram.clone(),
    };
    let mut k = 1;
    let mut even = true;
    basis.orthogonal()?;
    while k < D {
        for j in (0..k).rev() {
            basis.shorten(k, j)?;
        }
        if basis.is_ordered(k)? {
            k += 1;
        } else {
            basis.swap(k);
            even = !even;
            k = (k - 1).max(1);
        }
    }
    if !even {
        basis.negate(D - 1);
    }
    Ok(basis)
}

impl<const D: usize> Reduced<D> {
    fn orthogonal(&self) -> Result<Orthogonal<D>, DelaunayError> {
        Orthogonal::of(&self.gram).ok_or(DelaunayError::NotPositiveDefinite)
    }

    /// Subtracts multiples of c_j from c_k until |mu_kj| is about 1/2 or less. A
    /// double gives all but the last 2^-52 of a multiple, so it is soon done; without
    /// the margin, 1/2 and -1/2 would follow each other for ever.
    fn shorten(&mut self, k: usize, j: usize) -> Result<(), DelaunayError> {
        loop {
            let mu = self.orthogonal()?.mu[k][j].approximate();
            if mu.abs() < 0.51 {
                return Ok(());
            }
            let multiple = mu.round();
            if multiple.is_nan() || multiple.abs() > ENTRY_LIMIT as f64 {
                return Err(DelaunayError::TooSkewed);
            }
            self.subtract(k, j, multiple as i64)?;
        }
    }

    /// c_k := c_k - m c_j
    fn subtract(&mut self, k: usize, j: usize, m: i64) -> Result<(), DelaunayError> {
        let factor = Number::from(Rational::from(m));
        for i in 0..D {
            self.rows[k][i] -= m * self.rows[j][i];
            self.inverse[i][j] += m * self.inverse[i][k];
            self.gram[k][i] = &self.gram[k][i] - &(&factor * &self.gram[j][i]);
        }
        for row in &mut self.gram {
            row[k] = &row[k] - &(&factor * &row[j]);
        }
        let entries = self.rows.iter().chain(&self.inverse).flatten();
        if entries.into_iter().any(|entry| entry.abs() > ENTRY_LIMIT) {
            return Err(DelaunayError::TooSkewed);
        }
        Ok(())
    }

    /// Lovász' condition with the factor 99/100.
    fn is_ordered(&self, k: usize) -> Result<bool, DelaunayError> {
        let Orthogonal { mu, norms } = self.orthogonal()?;
        let mu = &mu[k][k - 1];
        let factor = Number::from(Rational::from_unsigneds(99u8, 100u8)) - &(mu * mu);
        Ok(norms[k] >= &factor * &norms[k - 1])
    }

    fn swap(&mut self, k: usize) {
        self.rows.swap(k, k - 1);
        self.gram.swap(k, k - 1);
        for i in 0..D {
            self.inverse[i].swap(k, k - 1);
            self.gram[i].swap(k, k - 1);
        }
    }

    fn negate(&mut self, k: usize) {
        for i in 0..D {
            self.rows[k][i] = -self.rows[k][i];
            self.inverse[i][k] = -self.inverse[i][k];
            if i != k {
                self.gram[k][i] = -&self.gram[k][i];
                self.gram[i][k] = -&self.gram[i][k];
            }
        }
    }

    /// Coordinates in the reduced basis of a vector given in the basis b.
    pub fn coordinates(&self, x: &[Number; D]) -> [Number; D] {
        std::array::from_fn(|i| {
            (0..D).fold(Number::zero(), |sum, j| {
                sum + &(&x[j] * &Number::from(Rational::from(self.inverse[j][i])))
            })
        })
    }

    /// Coordinates in the basis b of a vector given in the reduced one.
    pub fn vector(&self, x: &[Number; D]) -> [Number; D] {
        std::array::from_fn(|j| {
            (0..D).fold(Number::zero(), |sum, i| {
                sum + &(&x[i] * &Number::from(Rational::from(self.rows[i][j])))
            })
        })
    }

    /// Coordinates in the basis b of a lattice vector given in the reduced one.
    pub fn original(&self, shift: [i64; D]) -> [i64; D] {
        std::array::from_fn(|j| (0..D).map(|i| shift[i] * self.rows[i][j]).sum())
    }
}
