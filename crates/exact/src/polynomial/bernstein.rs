//! Signs of a polynomial that hold on a whole box.
//!
//! Substitute the box by [0, 1]^m. In the tensor Bernstein basis
//! B_i(u) = Π_k C(n_k, i_k) u_k^i_k (1 - u_k)^(n_k - i_k), where n_k is the degree in the k-th
//! parameter, every basis function is at least zero on the cube and positive inside. So
//! coefficients that are at least zero prove that the polynomial is. On a face of the cube, only
//! the coefficients with i_k = 0 or i_k = n_k on the fixed axes matter, and the polynomial is
//! positive inside of that face if one of them is positive.
//!
//! The coefficients here are those of the basis without the binomial factors, times a positive
//! number: they have the same signs. They are found axis by axis from
//! t = ((1 - u) l + u h) / d: a term a t^k becomes a ((1-u) l + u h)^k ((1-u) d + u d)^(n-k) / d^n.

use super::cuboid::Cuboid;
use super::{Coefficient, Polynomial};
use crate::geometry::Sign;

/// A polynomial with more coefficients than this is not decided.
pub const COEFFICIENT_LIMIT: usize = 1 << 20;

/// Whether the Bernstein coefficients prove that the polynomial is positive on the box. `None` if
/// there are too many, or if the box has other numbers than the polynomial.
pub fn is_positive<C: Coefficient>(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<bool> {
    let table = Table::of(p, cuboid)?;
    Some(table.none_negative() && table.positive_on_faces(cuboid))
}

/// Whether they prove that it is at least zero on the box.
pub fn is_nonnegative<C: Coefficient>(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<bool> {
    Some(Table::of(p, cuboid)?.none_negative())
}

/// The coefficients in the order of their indices, the last axis fastest, all times one positive
/// number and without the binomial factors.
pub fn coefficients<C: Coefficient>(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<Vec<C>> {
    Some(Table::of(p, cuboid)?.entries)
}

/// Coefficients by their indices on all axes, the last axis fastest.
struct Table<C> {
    /// The degree on each axis.
    degrees: Vec<usize>,
    entries: Vec<C>,
}

impl<C: Coefficient> Table<C> {
    fn of(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<Self> {
        let mut table = Table::dense(p, cuboid.sides.len())?;
        for (axis, side) in cuboid.sides.iter().enumerate() {
            if table.degrees[axis] > 0 {
                table.substitute(axis, &C::ends(side)?);
            }
        }
        Some(table)
    }

    /// The coefficients of the monomials.
    fn dense(p: &Polynomial<C>, parameters: usize) -> Option<Self> {
        let degrees: Vec<usize> = (0..parameters).map(|k| p.degree(k)).collect();
        let size = degrees
            .iter()
            .try_fold(1usize, |size, n| size.checked_mul(n + 1));
        let size = size.filter(|size| *size <= COEFFICIENT_LIMIT)?;
        let mut entries = vec![C::from_integer(0); size];
        for (monomial, c) in p.terms() {
            let indices = degrees.iter().enumerate();
            let index = indices.fold(0, |index, (k, n)| index * (n + 1) + monomial.exponent(k));
            entries[index] = c.clone();
        }
        Some(Table { degrees, entries })
    }

    /// The distance of neighbours on an axis.
    fn stride(&self, axis: usize) -> usize {
        self.degrees[axis + 1..].iter().map(|n| n + 1).product()
    }

    /// Replaces monomials on an axis by the Bernstein basis.
    fn substitute(&mut self, axis: usize, ends: &[C; 3]) {
        let (stride, length) = (self.stride(axis), self.degrees[axis] + 1);
        for block in self.entries.chunks_exact_mut(stride * length) {
            for offset in 0..stride {
                let places = (0..length).map(|k| offset + k * stride);
                let row: Vec<C> = places.clone().map(|place| block[place].clone()).collect();
                if row.iter().any(|c| c.sign().is_ne()) {
                    let changed = substituted(&row, ends);
                    places.zip(changed).for_each(|(place, c)| block[place] = c);
                }
            }
        }
    }

    fn none_negative(&self) -> bool {
        self.entries.iter().all(|c| c.sign() != Sign::Less)
    }

    /// Whether some coefficient is positive on each of the smallest faces that the box contains.
    fn positive_on_faces(&self, cuboid: &Cuboid) -> bool {
        let choices = self.degrees.iter().zip(&cuboid.sides).map(|(n, side)| {
            let ends = [(side.low.is_open, 0), (side.high.is_open, *n)];
            let closed = ends.iter().filter(|(is_open, _)| !is_open);
            let mut fixed: Vec<Option<usize>> = closed.map(|(_, index)| Some(*index)).collect();
            fixed.dedup();
            match *n {
                0 => vec![None],
                _ if fixed.is_empty() => vec![None],
                _ => fixed,
            }
        });
        let faces = choices.fold(vec![Vec::new()], |faces, choice| {
            let with = |face: &Vec<Option<usize>>| {
                let face = face.clone();
                choice
                    .iter()
                    .map(move |fixed| [&face[..], &[*fixed]].concat())
                    .collect::<Vec<_>>()
            };
            faces.iter().flat_map(with).collect::<Vec<_>>()
        });
        let positive = self.positive_indices();
        faces.iter().all(|face| {
            let is_on = |index: &Vec<usize>| {
                face.iter()
                    .zip(index)
                    .all(|(fixed, i)| fixed.is_none_or(|f| f == *i))
            };
            positive.iter().any(is_on)
        })
    }

    fn positive_indices(&self) -> Vec<Vec<usize>> {
        let positive = self
            .entries
            .iter()
            .enumerate()
            .filter(|(_, c)| c.sign() == Sign::Greater);
        let indices = |(mut place, _): (usize, &C)| {
            let mut index = vec![0; self.degrees.len()];
            for (slot, n) in index.iter_mut().zip(&self.degrees).rev() {
                *slot = place % (n + 1);
                place /= n + 1;
            }
            index
        };
        positive.map(indices).collect()
    }
}

/// The coefficients of u^i (1 - u)^(n - i), by Horner's rule: after k steps the row stands for a
/// form of degree k in u and 1 - u.
fn substituted<C: Coefficient>(row: &[C], [low, high, unit]: &[C; 3]) -> Vec<C> {
    let mut form: Vec<C> = Vec::with_capacity(row.len());
    // ((1-u) d + u d)^k
    let mut power = vec![low.integer(1)];
    for c in row.iter().rev() {
        form = times_linear(&form, low, high);
        if form.is_empty() {
            form.push(c.clone());
        } else {
            power = times_linear(&power, unit, unit);
            for (sum, p) in form.iter_mut().zip(&power) {
                *sum = sum.plus(&c.times(p));
            }
        }
    }
    form
}

/// A form times (1 - u) l + u h.
fn times_linear<C: Coefficient>(form: &[C], low: &C, high: &C) -> Vec<C> {
    let Some(last) = form.last() else {
        return Vec::new();
    };
    let mut product = Vec::with_capacity(form.len() + 1);
    product.push(form[0].times(low));
    for pair in form.windows(2) {
        product.push(pair[0].times(high).plus(&pair[1].times(low)));
    }
    product.push(last.times(high));
    product
}
