//! All motions that keep a point set with a lattice and kinds of points, exactly.
//!
//! First come the translations: one takes a point of the rarest kind to another one. They generate the
//! whole lattice of the set. Every motion keeps that lattice. So in a reduced basis its rotation is
//! integral and keeps the Gram matrix. It takes each basis vector to a lattice vector of the same length.
//! Such vectors have coefficients of at most 2 in size there.

use crate::lattice::{basis, gram_of, reduced};
use crate::motion::{Motion, Rotation, Vector, fractional, rotated};
use crate::solve::{Matrix, inverse, product, times, transposed};
use malachite::Rational;
use std::collections::HashMap;

/// Larger sets are declined: the search is quadratic in the rarest kind.
pub const POINT_LIMIT: usize = 5_000;

/// The symmetry of a point set in a reduced basis of its lattice.
#[derive(Clone, Debug)]
pub struct Symmetry {
    /// The change of coordinates: x in the new basis is `change` times x in the old one.
    pub change: Matrix,
    /// In the new basis.
    pub gram: Matrix,
    /// Modulo the lattice, whose translations are all integral now.
    pub group: Vec<Motion>,
}

/// The symmetry of points with kinds in a cell, or `None` beyond the limits.
pub fn symmetry(gram: &Matrix, points: &[Vector], kinds: &[usize]) -> Option<Symmetry> {
    if points.is_empty() || points.len() > POINT_LIMIT || points.len() != kinds.len() {
        return None;
    }
    let set = PointSet::new(points, kinds);
    let translations: Vec<Vector> = set
        .motions(&crate::motion::IDENTITY)
        .into_iter()
        .map(|motion| motion.translation)
        .collect();
    let primitive = basis(&translations)?;
    let short = reduced(&gram_of(&primitive, gram))?;
    let rows = product(&short, &primitive);
    let change = inverse(&transposed(&rows))?;
    let gram = gram_of(&rows, gram);
    let moved: Vec<Vector> = points.iter().map(|point| times(&change, point)).collect();
    let set = PointSet::new(&moved, kinds);
    let group = rotations(&gram)
        .iter()
        .flat_map(|rotation| set.motions(rotation))
        .collect();
    Some(Symmetry {
        change,
        gram,
        group,
    })
}

/// Points modulo the lattice with their kinds.
struct PointSet {
    kinds: HashMap<Vector, usize>,
    /// The points of the rarest kind.
    rare: Vec<Vector>,
}

impl PointSet {
    fn new(points: &[Vector], kinds: &[usize]) -> PointSet {
        let reduced = points.iter().map(|point| point.clone().map(fractional));
        let kinds: HashMap<Vector, usize> = reduced.zip(kinds.iter().copied()).collect();
        let mut counts: HashMap<usize, usize> = HashMap::new();
        kinds
            .values()
            .for_each(|kind| *counts.entry(*kind).or_insert(0) += 1);
        let rarest = counts.iter().map(|(kind, count)| (count, kind)).min();
        let rarest = rarest.map(|(_, kind)| *kind);
        let mut rare: Vec<Vector> = kinds
            .iter()
            .filter(|(_, kind)| Some(**kind) == rarest)
            .map(|(point, _)| point.clone())
            .collect();
        rare.sort();
        PointSet { kinds, rare }
    }

    /// The motions with this rotation that keep the set.
    fn motions(&self, rotation: &Rotation) -> Vec<Motion> {
        let Some(first) = self.rare.first() else {
            return Vec::new();
        };
        let turned = rotated(rotation, first);
        let to = |image: &Vector| {
            Motion {
                rotation: *rotation,
                translation: std::array::from_fn(|k| &image[k] - &turned[k]),
            }
            .reduced()
        };
        self.rare
            .iter()
            .map(to)
            .filter(|motion| self.is_kept_by(motion))
            .collect()
    }

    fn is_kept_by(&self, motion: &Motion) -> bool {
        self.kinds
            .iter()
            .all(|(point, kind)| self.kinds.get(&motion.apply(point).map(fractional)) == Some(kind))
    }
}

/// The integral matrices R with Rᵀ G R = G, for a reduced Gram matrix.
fn rotations(gram: &Matrix) -> Vec<Rotation> {
    let range = -2..=2i64;
    let mut images: [Vec<[i64; 3]>; 3] = Default::default();
    for x in range.clone() {
        for y in range.clone() {
            for z in range.clone() {
                let vector = [x, y, z];
                let norm = inner(gram, &vector, &vector);
                (0..3)
                    .filter(|&k| norm == gram[k][k])
                    .for_each(|k| images[k].push(vector));
            }
        }
    }
    let mut rotations = Vec::new();
    for a in &images[0] {
        for b in images[1].iter().filter(|b| inner(gram, a, b) == gram[0][1]) {
            for c in &images[2] {
                if inner(gram, a, c) == gram[0][2] && inner(gram, b, c) == gram[1][2] {
                    rotations.push(std::array::from_fn(|i| [a[i], b[i], c[i]]));
                }
            }
        }
    }
    rotations
}

fn inner(gram: &Matrix, x: &[i64; 3], y: &[i64; 3]) -> Rational {
    let mut sum = Rational::from(0);
    for i in 0..3 {
        for j in 0..3 {
            if x[i] * y[j] != 0 {
                sum += &gram[i][j] * Rational::from(x[i] * y[j]);
            }
        }
    }
    sum
}
