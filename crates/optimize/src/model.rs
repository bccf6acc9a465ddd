//! A tiling that depends on parameters, in doubles.

use crate::goal::{Goal, Matrix, filled};
use crate::moves::{Affine, ENTRIES, Moves};
use crate::program::Row;
use acutile_core::tiling::{SimplexId, Tiling};
use acutile_exact::number::Number;

/// The motions and the simplices in doubles.
pub struct Model {
    pub goal: Goal,
    vertices: Vec<Point<3>>,
    gram: Point<6>,
    simplices: Vec<[(usize, [f64; 3]); 4]>,
    /// A step of this size in a parameter moves its vertices by about an edge.
    pub scales: Vec<f64>,
    /// The part of `scales` that belongs to the Gram matrix.
    pub gram_parameters: usize,
}

/// constant + Σ parameter · vector
struct Point<const N: usize> {
    constant: [f64; N],
    terms: Vec<(usize, [f64; N])>,
}

/// The simplices and the parameters that a search works with.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Indices into the model's simplices.
    pub simplices: Vec<usize>,
    /// Parameters that may change.
    pub free: Vec<usize>,
}

impl<const N: usize> Point<N> {
    fn of(affine: &Affine<N>) -> Self {
        let double = |x: &[Number; N]| x.each_ref().map(Number::approximate);
        Point {
            constant: double(&affine.constant),
            terms: affine.terms.iter().map(|(k, v)| (*k, double(v))).collect(),
        }
    }

    fn at(&self, parameters: &[f64]) -> [f64; N] {
        let mut value = self.constant;
        for (parameter, vector) in &self.terms {
            for (x, v) in value.iter_mut().zip(vector) {
                *x += parameters[*parameter] * v;
            }
        }
        value
    }
}

impl Model {
    /// The model of a tiling whose other simplices are images of these.
    pub fn new(tiling: &Tiling<3>, moves: &Moves, simplices: &[SimplexId], goal: Goal) -> Self {
        let corners = |simplex: &SimplexId| {
            let corners = tiling.simplex(*simplex);
            std::array::from_fn(|k| (corners[k].vertex.index(), corners[k].shift.map(f64::from)))
        };
        let mut model = Model {
            goal,
            vertices: moves.vertices.iter().map(Point::of).collect(),
            gram: Point::of(&moves.gram),
            simplices: simplices.iter().map(corners).collect(),
            scales: Vec::new(),
            gram_parameters: moves.gram.terms.len(),
        };
        model.scales = model.scales_at(
            &moves
                .start
                .iter()
                .map(Number::approximate)
                .collect::<Vec<_>>(),
        );
        model
    }

    /// All simplices and parameters.
    pub fn everything(&self) -> Patch {
        Patch {
            simplices: (0..self.simplices.len()).collect(),
            free: (0..self.scales.len()).collect(),
        }
    }

    /// The vertices of a simplex.
    pub fn corners(&self, simplex: usize) -> [usize; 4] {
        self.simplices[simplex].map(|(vertex, _)| vertex)
    }

    /// The number of simplices.
    pub fn len(&self) -> usize {
        self.simplices.len()
    }

    /// The parameters on which a vertex depends.
    pub fn parameters(&self, vertex: usize) -> impl Iterator<Item = usize> + '_ {
        self.vertices[vertex].terms.iter().map(|(k, _)| *k)
    }

    /// The parameters on which a simplex depends, sorted.
    pub fn parameters_of_simplex(&self, simplex: usize) -> Vec<usize> {
        let gram = self.gram.terms.iter().map(|(k, _)| *k);
        let corners = self.corners(simplex);
        let mut all: Vec<usize> = corners
            .iter()
            .flat_map(|v| self.parameters(*v))
            .chain(gram)
            .collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn gram_at(&self, parameters: &[f64]) -> Matrix {
        let entries = self.gram.at(parameters);
        let place = |i: usize, j: usize| ENTRIES.iter().position(|e| *e == (i.min(j), i.max(j)));
        filled(|i, j| place(i, j).map_or(0.0, |k| entries[k]))
    }

    fn edges(&self, simplex: usize, parameters: &[f64]) -> Matrix {
        let place = |k: usize| -> [f64; 3] {
            let (vertex, shift) = &self.simplices[simplex][k];
            let point = self.vertices[*vertex].at(parameters);
            std::array::from_fn(|i| point[i] + shift[i])
        };
        let first = place(0);
        let others = [place(1), place(2), place(3)];
        filled(|k, i| others[k][i] - first[i])
    }

    /// The six values of each simplex of a patch, with the simplex; `None` if one is not positively
    /// oriented.
    pub fn values(&self, patch: &Patch, parameters: &[f64]) -> Option<Vec<(usize, [f64; 6])>> {
        let gram = self.gram_at(parameters);
        patch
            .simplices
            .iter()
            .map(|&s| Some((s, self.goal.values(&self.edges(s, parameters), &gram)?)))
            .collect()
    }

    /// The largest value in a patch.
    pub fn worst(&self, patch: &Patch, parameters: &[f64]) -> Option<f64> {
        let values = self.values(patch, parameters)?;
        let all = values.iter().flat_map(|(_, values)| values);
        Some(all.copied().fold(f64::NEG_INFINITY, f64::max))
    }

    /// The linear conditions for steps in units of the scales, from the values that are at least `least`.
    /// Columns are places in the patch's list of free parameters.
    pub fn rows(&self, patch: &Patch, parameters: &[f64], least: f64) -> Option<Vec<Row>> {
        let gram = self.gram_at(parameters);
        let mut column = std::collections::HashMap::new();
        column.extend(patch.free.iter().copied().zip(0..));
        let mut rows = Vec::new();
        for (simplex, values) in self.values(patch, parameters)? {
            let edges = self.edges(simplex, parameters);
            for k in (0..6).filter(|k| values[*k] >= least) {
                let term = self.goal.term(&edges, &gram, k)?;
                let mut dense = vec![0.0; patch.free.len()];
                let mut add = |parameter: usize, slope: f64| {
                    if let Some(&column) = column.get(&parameter) {
                        let column: usize = column;
                        dense[column] += slope * self.scales[parameter];
                    }
                };
                for ((vertex, _), slope) in self.simplices[simplex].iter().zip(&term.corners) {
                    for (parameter, vector) in &self.vertices[*vertex].terms {
                        add(*parameter, (0..3).map(|i| slope[i] * vector[i]).sum());
                    }
                }
                for (parameter, vector) in &self.gram.terms {
                    let entries = ENTRIES.iter().zip(vector);
                    let slope = entries.map(|((i, j), v)| {
                        let twice = if i == j { 1.0 } else { 2.0 };
                        twice * term.gram[*i][*j] * v
                    });
                    add(*parameter, slope.sum());
                }
                let gradient = dense.into_iter().enumerate().filter(|(_, x)| *x != 0.0);
                rows.push(Row {
                    value: term.value,
                    gradient: gradient.collect(),
                });
            }
        }
        Some(rows)
    }

    /// For a parameter of a vertex: the mean edge divided by the length of its vector. For a parameter of
    /// the Gram matrix: the size of that matrix.
    fn scales_at(&self, start: &[f64]) -> Vec<f64> {
        let gram = self.gram_at(start);
        let length = |x: &[f64; 3]| {
            let square: f64 = (0..9)
                .map(|n| x[n / 3] * gram[n / 3][n % 3] * x[n % 3])
                .sum();
            square.max(0.0).sqrt()
        };
        let edges = (0..self.simplices.len()).flat_map(|s| self.edges(s, start));
        let (mut sum, mut count) = (0.0, 0.0f64);
        for edge in edges {
            sum += length(&edge);
            count += 1.0;
        }
        let mean = sum / count.max(1.0);
        let mut scales = vec![gram[0][0]; start.len()];
        for vertex in &self.vertices {
            for (parameter, vector) in &vertex.terms {
                scales[*parameter] = mean / length(vector).max(f64::MIN_POSITIVE);
            }
        }
        scales
    }
}
