//! Positions in double precision, to search by: where points are, and which spheres and
//! circles pass through them.
//!
//! Nothing here decides. A sphere or a circle is a guess, the search asks the exact
//! predicates where it matters, and [`super::certify`] checks the result.
//!
//! Let c* be the orthogonalised reduced basis. The Cartesian coordinate along c*_i, in units
//! of |c*_0|, is y = R d for coordinate differences d, where
//! R_ij = |c*_i| mu_ji / |c*_0| is upper triangular.

use crate::tiling::Corner;
use acutile_exact::geometry::linear::{cofactors, dot};
use acutile_exact::number::Number;

use super::DelaunayError;
use super::lattice::Orthogonal;

/// Beyond this ratio of lengths doubles are not trusted to stay in range.
const LENGTH_LIMIT: f64 = 1e40;

/// The least sine of an angle of a facet whose normal has many digits.
const SHARP: f64 = 1e-2;
/// The least size of such a facet, relative to the cell.
const RESOLVED: f64 = 1e-4;
/// The least determinant of a simplex whose circumsphere doubles know, relative to the
/// largest that edges of its size can have.
const SOLID: f64 = 1e-4;
/// The error of such a circumsphere is far less than this part of its radius.
const SLACK: f64 = 1e-5;
/// Points that coincide are computed to be closer than this, relative to the cell.
const RESOLUTION: f64 = 1e-9;

/// The points of a cell as doubles.
#[derive(Clone, Debug)]
pub struct Places<const D: usize> {
    /// Coordinates in the reduced basis, 0 to 1 up to rounding.
    pub fractions: Vec<[f64; D]>,
    /// R times the fractions.
    pub places: Vec<[f64; D]>,
    /// R: Cartesian coordinates of the basis vectors, in units of |c*_0|.
    pub basis: [[f64; D]; D],
    /// q_j: how much the j-th coordinate changes at most per unit of length.
    pub dual: [f64; D],
    /// The largest sum of a row of |R|: no point of the cell is farther from another in one
    /// Cartesian coordinate.
    extent: f64,
}

/// A ball, the centre relative to some corner.
#[derive(Clone, Copy, Debug)]
pub struct Sphere<const D: usize> {
    pub center: [f64; D],
    pub radius: f64,
    /// A point at computed distance beyond radius + slack is outside.
    pub slack: f64,
}

/// See [`Places::circle`].
#[derive(Clone, Copy, Debug)]
pub struct Circle<const D: usize> {
    /// Relative to the first corner of the facet.
    pub center: [f64; D],
    /// A unit vector to the side where (facet, p) is positive.
    pub normal: [f64; D],
    /// Whether centre and normal have many digits that are right.
    pub is_sharp: bool,
}

/// The edges of a simplex from its first corner, with its cofactors.
struct Shape<const D: usize> {
    edges: [[f64; D]; D],
    gradients: [[f64; D]; D],
    determinant: f64,
}

impl<const D: usize> Places<D> {
    /// Points in the reduced basis that `orthogonal` belongs to.
    pub fn new(
        fractions: Vec<[f64; D]>,
        orthogonal: &Orthogonal<D>,
    ) -> Result<Self, DelaunayError> {
        let basis = cartesian(orthogonal)?;
        let row_sum = |row: &[f64; D]| row.iter().map(|r| r.abs()).sum();
        let extent = basis.iter().map(row_sum).fold(0.0, f64::max);
        let places = fractions.iter().map(|x| upper_times(&basis, x)).collect();
        Ok(Places {
            dual: dual_lengths(&basis),
            extent,
            fractions,
            places,
            basis,
        })
    }

    /// The vector from `origin` to `p`.
    pub fn difference(&self, origin: &Corner<D>, p: &Corner<D>) -> [f64; D] {
        let [a, b] = [origin, p].map(|corner| &self.places[corner.vertex.index()]);
        let mut y: [f64; D] = std::array::from_fn(|k| b[k] - a[k]);
        if p.shift != origin.shift {
            let step = std::array::from_fn(|k| f64::from(p.shift[k] - origin.shift[k]));
            let moved = self.to_cartesian(&step);
            (0..D).for_each(|k| y[k] += moved[k]);
        }
        y
    }

    fn fractional_difference(&self, origin: &Corner<D>, p: &Corner<D>) -> [f64; D] {
        let [a, b] = [origin, p].map(|corner| &self.fractions[corner.vertex.index()]);
        std::array::from_fn(|k| (b[k] - a[k]) + f64::from(p.shift[k] - origin.shift[k]))
    }

    pub fn to_cartesian(&self, d: &[f64; D]) -> [f64; D] {
        upper_times(&self.basis, d)
    }

    /// R^-1 y
    pub fn to_fractional(&self, y: &[f64; D]) -> [f64; D] {
        back_substitute(&self.basis, y)
    }

    /// Points that coincide are computed to be closer than this.
    pub fn resolution(&self) -> f64 {
        RESOLUTION * self.extent
    }

    fn edges(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> [[f64; D]; D] {
        std::array::from_fn(|k| self.difference(&facet[0], facet.get(k + 1).unwrap_or(apex)))
    }

    /// The determinant of the fractional edges of a simplex.
    pub fn determinant(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> f64 {
        let edges = std::array::from_fn(|k| {
            self.fractional_difference(&facet[0], facet.get(k + 1).unwrap_or(apex))
        });
        Shape::new(edges).determinant
    }

    /// The circumsphere relative to the first corner, if the simplex is far from flat.
    pub fn circumsphere(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Option<Sphere<D>> {
        let shape = Shape::new(self.edges(facet, apex));
        let size = largest(&shape.edges).powi(D as i32);
        let center = shape.center();
        let radius = dot(&center, &center).sqrt();
        // False where something is not a number.
        (shape.determinant.abs() > SOLID * size).then_some(Sphere {
            center,
            radius,
            slack: SLACK * radius,
        })
    }

    /// A sphere from its centre in exact fractional coordinates relative to a corner.
    pub fn sphere_at(&self, center: &[Number; D]) -> Sphere<D> {
        let d = std::array::from_fn(|k| center[k].approximate());
        let center = self.to_cartesian(&d);
        let radius = dot(&center, &center).sqrt();
        Sphere {
            center,
            radius,
            slack: SLACK * radius + self.resolution(),
        }
    }

    /// The circle (in the plane, the two points) in which spheres through a facet meet.
    /// Only for guesses. With n a multiple of the normal, the sphere through the facet
    /// and its first corner + n has its centre above the one that is sought.
    pub fn circle(&self, facet: &[Corner<D>; D]) -> Circle<D> {
        let mut edges = self.edges(facet, &facet[0]);
        let normal = Shape::new(edges).gradients[D - 1];
        let length = dot(&normal, &normal).sqrt();
        let normal = normal.map(|x| x / length);
        let size = largest(&edges);
        edges[D - 1] = normal.map(|x| x * size);
        let center = Shape::new(edges).center();
        let height = dot(&center, &normal);
        Circle {
            center: std::array::from_fn(|k| center[k] - height * normal[k]),
            normal,
            is_sharp: length > SHARP * size.powi(D as i32 - 1) && size > RESOLVED * self.extent,
        }
    }
}

impl<const D: usize> Shape<D> {
    fn new(edges: [[f64; D]; D]) -> Self {
        let gradients = cofactors(&edges);
        Shape {
            edges,
            gradients,
            determinant: dot(&edges[0], &gradients[0]),
        }
    }

    /// w = Σ |e_k|² g_k
    fn weighted(&self) -> [f64; D] {
        let mut sum = [0.0; D];
        for (edge, gradient) in self.edges.iter().zip(&self.gradients) {
            let square = dot(edge, edge);
            (0..D).for_each(|k| sum[k] += square * gradient[k]);
        }
        sum
    }

    fn center(&self) -> [f64; D] {
        self.weighted().map(|x| x / (2.0 * self.determinant))
    }
}

fn largest<const D: usize>(vectors: &[[f64; D]]) -> f64 {
    vectors.iter().flatten().fold(0.0, |m, x| m.max(x.abs()))
}

/// R_ij = |c*_i| mu_ji / |c*_0|, from exact ratios.
fn cartesian<const D: usize>(orthogonal: &Orthogonal<D>) -> Result<[[f64; D]; D], DelaunayError> {
    let Orthogonal { mu, norms } = orthogonal;
    let mut basis = [[0.0; D]; D];
    for i in 0..D {
        let ratio = norms[i]
            .divide(&norms[0])
            .ok_or(DelaunayError::NotPositiveDefinite)?;
        let length = ratio.approximate().sqrt();
        if !(1.0 / LENGTH_LIMIT..LENGTH_LIMIT).contains(&length) {
            return Err(DelaunayError::TooElongated);
        }
        basis[i][i] = length;
        for j in i + 1..D {
            basis[i][j] = length * mu[j][i].approximate();
        }
    }
    Ok(basis)
}

fn upper_times<const D: usize>(upper: &[[f64; D]; D], x: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|i| (i..D).map(|j| upper[i][j] * x[j]).sum())
}

fn back_substitute<const D: usize>(upper: &[[f64; D]; D], y: &[f64; D]) -> [f64; D] {
    let mut x = [0.0; D];
    for i in (0..D).rev() {
        let known: f64 = (i + 1..D).map(|j| upper[i][j] * x[j]).sum();
        x[i] = (y[i] - known) / upper[i][i];
    }
    x
}

/// The lengths of the rows of R^-1, a little enlarged.
fn dual_lengths<const D: usize>(basis: &[[f64; D]; D]) -> [f64; D] {
    let mut squares = [0.0; D];
    for column in 0..D {
        let unit = std::array::from_fn(|k| f64::from(u8::from(k == column)));
        let x = back_substitute(basis, &unit);
        (0..D).for_each(|j| squares[j] += x[j] * x[j]);
    }
    squares.map(|square: f64| square.sqrt() * (1.0 + 1e-9))
}
