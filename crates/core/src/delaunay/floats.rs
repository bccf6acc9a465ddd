//! Coordinates in double precision with proved error bounds, the floating filter
//! of the predicates, and circumspheres with a proved uncertainty.
//!
//! Nothing here decides by itself: a filter returns a sign that it proves, or
//! `None`, and a sphere says how wrong it may be.
//!
//! **Positions.** Let c* be the orthogonalised reduced basis and y_i the Cartesian
//! coordinate along c*_i in units of |c*_0|: y = R d for coordinate differences d,
//! where R_ij = |c*_i| mu_ji / |c*_0| is upper triangular. For points with fractions f
//! and g and shift s the difference d = g - f + s is placed as (R g - R f) + R s, where
//! the first two products are kept. A fraction is a double within 2^-52 of the exact
//! one and at most 1, and entries of R have relative errors of at most 2^-50. Write
//! r = Σ_j |R_ij| and t = Σ_j |R_ij| |d_j|, so that Σ_j |R_ij| |s_j| <= r + t. Then the
//! fractions contribute 2^-51 r, the entries of R 2^-50 t, the roundings of the kept
//! products 2^-50 r (three to a term), those of R s 2^-51 (r + t), and the
//! last two sums 2^-53 (3 r + t): together less than 2^-48 (r + t), or
//!     |y computed - y exact| <= 2^-48 Σ_j |R_ij| (1 + |d_j|).
//! With q_j the length of row j of R^-1, |d_j| <= q_j |y| <= 2 q_j m for m the
//! largest entry of y. Hence every entry is right up to
//!     e(m) = tau + eta m,  tau = 2^-48 max_i Σ_j |R_ij|,
//!                          eta = 2^-46 max_i Σ_j |R_ij| q_j.
//!
//! **Polynomials** (D <= 3). Let m bound the entries of the edge vectors and e =
//! e(m); note eta >= 2^-47, so that rounding errors, multiples of 2^-53 m, are
//! below e/64. First order in e, the errors are at most: 4 m e for a cofactor (of
//! size 2 m²), 6 m e for a squared length (3 m²), 18 m² e for a determinant (6 m³),
//! 72 m³ e for w = Σ |e_k|² g_k (18 m⁴), 360 m⁴ e for the power d |x|² - w · x. The
//! rounding errors add less than a third to each, and terms of second order are
//! less than that as long as e < m / 1024. So 32 m² e and 1024 m⁴ e are safe
//! (in the plane the same numbers with one power of m less).

use crate::tiling::Corner;
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;

use super::DelaunayError;
use super::lattice::Orthogonal;

/// Beyond this ratio of lengths doubles are not trusted to stay in range.
const LENGTH_LIMIT: f64 = 1e40;

/// The least sine of an angle of a facet whose normal has many digits.
const SHARP: f64 = 1e-2;
/// The largest error of an edge of such a facet, relative to the longest.
const RESOLVED: f64 = 1e-12;

/// The points of a cell as doubles.
#[derive(Clone, Debug)]
pub struct Floats<const D: usize> {
    /// Coordinates in the reduced basis, 0 to 1 up to rounding.
    pub fractions: Vec<[f64; D]>,
    /// R times the fractions.
    pub places: Vec<[f64; D]>,
    /// R: Cartesian coordinates of the basis vectors, in units of |c*_0|.
    pub basis: [[f64; D]; D],
    /// q_j: how much the j-th coordinate changes at most per unit of length.
    pub dual: [f64; D],
    tau: f64,
    eta: f64,
}

/// A ball, the centre relative to some corner.
#[derive(Clone, Copy, Debug)]
pub struct Sphere<const D: usize> {
    pub center: [f64; D],
    pub radius: f64,
    /// A point at computed distance beyond radius + slack is outside.
    pub slack: f64,
}

/// See [`Floats::circle`].
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

impl<const D: usize> Floats<D> {
    /// Points in the reduced basis that `orthogonal` belongs to.
    pub fn new(
        fractions: Vec<[f64; D]>,
        orthogonal: &Orthogonal<D>,
    ) -> Result<Self, DelaunayError> {
        let basis = cartesian(orthogonal)?;
        let dual = dual_lengths(&basis);
        let row_sums = |weights: &[f64; D]| {
            basis
                .iter()
                .map(|row| {
                    row.iter()
                        .zip(weights)
                        .map(|(r, q)| r.abs() * q)
                        .sum::<f64>()
                })
                .fold(0.0, f64::max)
        };
        let places = fractions.iter().map(|x| upper_times(&basis, x)).collect();
        Ok(Floats {
            tau: 2f64.powi(-48) * row_sums(&[1.0; D]),
            eta: 2f64.powi(-46) * row_sums(&dual),
            fractions,
            places,
            basis,
            dual,
        })
    }

    /// The vector from `origin` to `p`, up to e(m) in each entry.
    pub fn difference(&self, origin: &Corner<D>, p: &Corner<D>) -> [f64; D] {
        let [a, b] = [origin, p].map(|corner| &self.places[corner.vertex as usize]);
        let mut y: [f64; D] = std::array::from_fn(|k| b[k] - a[k]);
        if p.shift != origin.shift {
            let step = std::array::from_fn(|k| f64::from(p.shift[k] - origin.shift[k]));
            let moved = self.to_cartesian(&step);
            (0..D).for_each(|k| y[k] += moved[k]);
        }
        y
    }

    fn fractional_difference(&self, origin: &Corner<D>, p: &Corner<D>) -> [f64; D] {
        let [a, b] = [origin, p].map(|corner| &self.fractions[corner.vertex as usize]);
        std::array::from_fn(|k| (b[k] - a[k]) + f64::from(p.shift[k] - origin.shift[k]))
    }

    pub fn to_cartesian(&self, d: &[f64; D]) -> [f64; D] {
        upper_times(&self.basis, d)
    }

    /// R^-1 y
    pub fn to_fractional(&self, y: &[f64; D]) -> [f64; D] {
        back_substitute(&self.basis, y)
    }

    /// Points at one place are computed to be closer than this.
    pub fn resolution(&self) -> f64 {
        8.0 * self.tau
    }

    fn error(&self, m: f64) -> f64 {
        self.tau + self.eta * m
    }

    fn edges(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> [[f64; D]; D] {
        std::array::from_fn(|k| self.difference(&facet[0], facet.get(k + 1).unwrap_or(apex)))
    }

    /// The determinant of the fractional edges of a simplex, and their largest entry.
    pub fn determinant(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> (f64, f64) {
        let edges = std::array::from_fn(|k| {
            self.fractional_difference(&facet[0], facet.get(k + 1).unwrap_or(apex))
        });
        (Shape::new(edges).determinant, largest(&edges))
    }

    /// The sign of the orientation of (facet, apex), if the doubles prove it.
    pub fn orientation(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Option<Sign> {
        let edges = self.edges(facet, apex);
        let m = largest(&edges);
        let e = self.error(m);
        let determinant = Shape::new(edges).determinant;
        proved(determinant, 32.0 * m.powi(D as i32 - 1) * e, e, m)
    }

    /// The sphere through the corners of a positively oriented simplex.
    pub fn sphere(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> FloatSphere<'_, D> {
        let shape = Shape::new(self.edges(facet, apex));
        FloatSphere {
            floats: self,
            origin: facet[0],
            determinant: shape.determinant,
            weighted: shape.weighted(),
            size: largest(&shape.edges),
        }
    }

    /// The circumsphere relative to the first corner, if it is well determined.
    ///
    /// Its centre is w/(2d). The errors of w and d divide through to
    /// (|δw| + 2 |c| |δd|) / (2 (|d| - |δd|)) for an entry; the same again bounds
    /// the error of the radius |c|, and 2 e that of a point compared with it.
    pub fn circumsphere(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Option<Sphere<D>> {
        let shape = Shape::new(self.edges(facet, apex));
        let m = largest(&shape.edges);
        let e = self.error(m);
        let center = shape.center();
        let radius = dot(&center, &center).sqrt();
        let determinant_error = 32.0 * m.powi(D as i32 - 1) * e;
        let weighted_error = 128.0 * m.powi(D as i32) * e;
        let room = 2.0 * (shape.determinant.abs() - determinant_error);
        let entry = (weighted_error + 2.0 * radius * determinant_error) / room;
        let slack = 4.0 * (entry + self.error(2.0 * radius));
        // False where something is not a number.
        (room > 0.0 && slack < 1e-6 * radius).then_some(Sphere {
            center,
            radius,
            slack,
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
            slack: 8.0 * self.error(2.0 * radius),
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
            is_sharp: length > SHARP * size.powi(D as i32 - 1)
                && self.error(size) < RESOLVED * size,
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

/// The polynomial of a sphere, see [`Floats::sphere`].
pub struct FloatSphere<'a, const D: usize> {
    floats: &'a Floats<D>,
    origin: Corner<D>,
    determinant: f64,
    weighted: [f64; D],
    size: f64,
}

impl<const D: usize> FloatSphere<'_, D> {
    /// Whether p is outside (`Greater`) or inside (`Less`), if the doubles prove it.
    pub fn side(&self, p: &Corner<D>) -> Option<Sign> {
        let x = self.floats.difference(&self.origin, p);
        let m = self.size.max(largest(&[x]));
        let e = self.floats.error(m);
        let power = self.determinant * dot(&x, &x) - dot(&self.weighted, &x);
        proved(power, 1024.0 * m.powi(D as i32 + 1) * e, e, m)
    }
}

/// The sign of `value` if it is larger than its error bound (false for NaN).
fn proved(value: f64, bound: f64, e: f64, m: f64) -> Option<Sign> {
    if !(value.abs() > bound && e < m / 1024.0) {
        return None;
    }
    Some(if value > 0.0 {
        Sign::Greater
    } else {
        Sign::Less
    })
}

/// The inner product.
pub fn dot<const D: usize>(x: &[f64; D], y: &[f64; D]) -> f64 {
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

fn largest<const D: usize>(vectors: &[[f64; D]]) -> f64 {
    vectors.iter().flatten().fold(0.0, |m, x| m.max(x.abs()))
}

/// The cofactors of a matrix with two or three rows.
fn cofactors<const D: usize>(m: &[[f64; D]; D]) -> [[f64; D]; D] {
    if D == 2 {
        return std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if i == j {
                    m[1 - i][1 - j]
                } else {
                    -m[1 - i][1 - j]
                }
            })
        });
    }
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (a, b, c, d) = ((i + 1) % D, (i + 2) % D, (j + 1) % D, (j + 2) % D);
            m[a][c] * m[b][d] - m[a][d] * m[b][c]
        })
    })
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
