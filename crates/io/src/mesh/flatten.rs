//! A tiling as a mesh: one cell of it, in Cartesian coordinates.

use super::lattice::Basis;
use super::numbering::Numbering;
use super::{Mesh, MeshError, Periodic};
use acutile_core::tiling::{Corner, Tiling, VertexId};
use acutile_exact::number::Number;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedSqrt;
use malachite::base::num::basic::traits::{One, Zero};
use std::collections::{BTreeMap, HashMap};

/// A mesh, and what rounding did to it.
pub struct Flat {
    /// A node for each corner that differs from the others as a vertex or by its shift.
    pub mesh: Mesh,
    /// How many coordinates are no doubles.
    pub rounded: usize,
    /// No coordinate was moved by more.
    pub largest_move: f64,
    /// The lattice vectors, each coordinate exact where it has a name, else rounded.
    pub lattice: Vec<[f64; 3]>,
}

/// The mesh of a tiling. Without a basis the first basis vector points along the x axis and the
/// second lies in the plane of x and y.
///
/// # Errors
/// Where the Gram matrix is no metric.
pub fn flatten<const D: usize>(
    tiling: &Tiling<D>,
    basis: Option<&Basis>,
) -> Result<Flat, MeshError> {
    let mut cartesian = Cartesian::new(tiling, basis)?;
    let mut indices: HashMap<Corner<D>, u32> = HashMap::new();
    let mut corners: Vec<Corner<D>> = Vec::new();
    let mut points = Vec::with_capacity(tiling.corners.len());
    for corner in &tiling.corners {
        points.push(*indices.entry(*corner).or_insert_with(|| {
            corners.push(*corner);
            corners.len() as u32 - 1
        }));
    }
    let mut mesh = Mesh::default();
    if D == 2 {
        mesh.triangles = points.as_chunks::<3>().0.to_vec();
    } else {
        mesh.tetrahedra = points.as_chunks::<4>().0.to_vec();
    }
    mesh.points = corners
        .iter()
        .map(|c| cartesian.point(&tiling.position(c)))
        .collect();
    mesh.nodes = Numbering::consecutive(1, mesh.points.len());
    mesh.elements = Numbering::consecutive(1, mesh.cell_count());
    let (rounded, largest_move) = (cartesian.rounded, cartesian.largest_move);
    let unit = |k: usize| -> [Number; D] {
        std::array::from_fn(|j| tiling.frame.field.integer(i64::from(j == k)))
    };
    let lattice: Vec<[f64; 3]> = (0..tiling.frame.rank())
        .map(|k| cartesian.point(&unit(k)))
        .collect();
    mesh.periodic = links(&corners, &lattice);
    Ok(Flat {
        mesh,
        rounded,
        largest_move,
        lattice,
    })
}

/// A link for each lattice vector between a node and the first node of the same vertex.
fn links<const D: usize>(corners: &[Corner<D>], lattice: &[[f64; 3]]) -> Vec<Periodic> {
    let mut originals: HashMap<VertexId, (u32, Corner<D>)> = HashMap::new();
    for (index, corner) in (0u32..).zip(corners) {
        let size = |c: &Corner<D>| (c.shift.map(i32::abs).iter().sum::<i32>(), c.shift);
        let first = originals.entry(corner.vertex).or_insert((index, *corner));
        if size(corner) < size(&first.1) {
            *first = (index, *corner);
        }
    }
    let mut links: BTreeMap<[i32; D], Vec<(u32, u32)>> = BTreeMap::new();
    for (index, corner) in (0u32..).zip(corners) {
        let (original, first) = originals[&corner.vertex];
        let step = acutile_core::tiling::difference(corner.shift, first.shift);
        if step != [0; D] {
            links.entry(step).or_default().push((index, original));
        }
    }
    let links = (1..)
        .zip(links)
        .map(|(number, (step, nodes)): (i64, (_, _))| Periodic {
            dimension: D as i64 - 1,
            entities: (2 * number, 2 * number - 1),
            affine: Some(translation(step, lattice)),
            nodes,
        });
    links.collect()
}

fn translation<const D: usize>(step: [i32; D], lattice: &[[f64; 3]]) -> [f64; 16] {
    let mut matrix = [0.0; 16];
    for i in 0..4 {
        matrix[5 * i] = 1.0;
    }
    for j in 0..3 {
        let terms = lattice
            .iter()
            .zip(step)
            .map(|(vector, n)| f64::from(n) * vector[j]);
        matrix[4 * j + 3] = terms.sum();
    }
    matrix
}

/// Turns basis coordinates into Cartesian ones: y_j = Σ_i f_i B_ij. Either B is given, or
/// B_ij = L_ij √D_j. Here G = L D Lᵀ, L is unit lower triangular, and D is diagonal.
struct Cartesian {
    rows: [[Number; 3]; 3],
    /// D_j where √D_j is no rational, else nothing.
    squares: [Option<Number>; 3],
    rounded: usize,
    largest_move: f64,
}

impl Cartesian {
    fn new<const D: usize>(tiling: &Tiling<D>, basis: Option<&Basis>) -> Result<Self, MeshError> {
        // In the plane the third basis vector is the normal of length 1.
        let entry = |i: usize, j: usize| match tiling.frame.gram.get(i).and_then(|row| row.get(j)) {
            Some(entry) => entry.clone(),
            None => tiling.frame.field.integer(i64::from(i == j)),
        };
        let gram = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        let (rows, squares) = match basis {
            Some(basis) => (basis.vectors.clone(), [const { None }; 3]),
            None => factored(&gram).ok_or_else(|| {
                MeshError::of_file(
                    "the Gram matrix is not positive definite, so nothing is a mesh of this tiling; \
                     certify says more",
                )
            })?,
        };
        Ok(Cartesian {
            rows,
            squares,
            rounded: 0,
            largest_move: 0.0,
        })
    }

    fn point<const D: usize>(&mut self, fractions: &[Number; D]) -> [f64; 3] {
        std::array::from_fn(|j| {
            let sum = (0..D).fold(Number::zero(), |sum, i| {
                &sum + &(&fractions[i] * &self.rows[i][j])
            });
            match &self.squares[j] {
                Some(square) if !sum.is_zero() => {
                    let value = &(&sum * &sum) * square;
                    self.root(&value, sum.sign().is_lt())
                }
                _ => self.double(&sum),
            }
        })
    }

    fn double(&mut self, value: &Number) -> f64 {
        let double = value.approximate();
        let exact = Rational::try_from(double).unwrap_or(Rational::ZERO);
        let step = value - &Number::from(exact);
        if !step.is_zero() {
            self.note(step.approximate().abs());
        }
        double
    }

    /// √value or -√value, for a value that is not 0.
    fn root(&mut self, value: &Number, is_negative: bool) -> f64 {
        let root = value.to_rational().and_then(|value| value.checked_sqrt());
        let root = match root {
            Some(root) => {
                return self.double(&Number::from(if is_negative { -root } else { root }));
            }
            None => value.enclosure_of_root(&(Rational::ONE >> 120u32)).0,
        };
        let double = Number::from(root.clone()).approximate();
        let exact = Rational::try_from(double).unwrap_or(Rational::ZERO);
        // The enclosure's width is nothing against the unit in the last place.
        self.note(Number::from(root - exact).approximate().abs());
        if is_negative { -double } else { double }
    }

    fn note(&mut self, step: f64) {
        self.rounded += 1;
        self.largest_move = self.largest_move.max(step);
    }
}

/// The rows and the squares of [`Cartesian`].
type Factors = ([[Number; 3]; 3], [Option<Number>; 3]);

/// L with its columns multiplied by √D_j where that is rational, and the other D_j; `None` if the
/// matrix is not positive definite.
fn factored(gram: &[[Number; 3]; 3]) -> Option<Factors> {
    let mut lower: [[Number; 3]; 3] =
        std::array::from_fn(|_| std::array::from_fn(|_| Number::zero()));
    let mut squares: [Number; 3] = std::array::from_fn(|_| Number::zero());
    for j in 0..3 {
        let known = |i: usize, lower: &[[Number; 3]; 3], squares: &[Number; 3]| {
            (0..j).fold(gram[i][j].clone(), |rest, k| {
                &rest - &(&(&lower[i][k] * &lower[j][k]) * &squares[k])
            })
        };
        squares[j] = known(j, &lower, &squares);
        if squares[j].sign().is_le() {
            return None;
        }
        for i in j..3 {
            let entry = known(i, &lower, &squares);
            lower[i][j] = entry.divide(&squares[j])?;
        }
    }
    let mut irrational = [const { None }; 3];
    for j in 0..3 {
        match squares[j]
            .to_rational()
            .and_then(|square| square.checked_sqrt())
        {
            Some(root) => {
                let root = Number::from(root);
                lower.iter_mut().for_each(|row| row[j] = &row[j] * &root);
            }
            None => irrational[j] = Some(squares[j].clone()),
        }
    }
    Some((lower, irrational))
}
