//! The goals of a search, in doubles: values of one simplex and their gradients.
//!
//! Let E be the matrix of the edges from corner 0 and P = E G E^T their inner products. Each value is a
//! function of P, and W is its gradient: dv = Σ W_kl dP_kl. Since dP = dE G E^T + E G dE^T + E dG E^T, the
//! gradient with respect to edge k is twice row k of W E G, and that with respect to G is E^T W E.

/// The value to improve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goal {
    /// The largest dihedral angle, as small as possible.
    MaxDihedral,
    /// The smallest dihedral angle, as large as possible.
    MinDihedral,
    /// The largest ratio of circumradius and shortest edge, as small as possible.
    RadiusEdge,
    /// Every dihedral angle less than a right angle.
    Acute,
}

/// A 3 x 3 matrix.
pub type Matrix = [[f64; 3]; 3];

/// A value that is to be small, and its gradient.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// Radians with a sign, or the logarithm of a ratio.
    pub value: f64,
    /// The gradient with respect to the four corners, in basis coordinates.
    pub corners: [[f64; 3]; 4],
    /// The gradient with respect to the Gram matrix.
    pub gram: Matrix,
}

impl Goal {
    /// The value that is less than this is good enough.
    pub fn enough(self) -> f64 {
        match self {
            // A margin for rounding.
            Goal::Acute => std::f64::consts::FRAC_PI_2 - 1e-4,
            _ => f64::NEG_INFINITY,
        }
    }

    /// The value in degrees, or the ratio.
    pub fn shown(self, value: f64) -> f64 {
        match self {
            Goal::MaxDihedral | Goal::Acute => value.to_degrees(),
            Goal::MinDihedral => -value.to_degrees(),
            Goal::RadiusEdge => value.exp(),
        }
    }

    /// The values of a simplex with these edges from corner 0; `None` if it is not positively oriented.
    pub fn values(self, edges: &Matrix, gram: &Matrix) -> Option<[f64; 6]> {
        let shape = Shape::of(edges, gram)?;
        Some(match self {
            Goal::RadiusEdge => {
                let radius = shape.squared_radius();
                EDGES.map(|(i, j)| (radius / shape.squared_edge(i, j)).ln() / 2.0)
            }
            Goal::MinDihedral => EDGES.map(|(i, j)| -shape.cosine(i, j).acos()),
            _ => EDGES.map(|(i, j)| shape.cosine(i, j).acos()),
        })
    }

    /// The k-th value with its gradient.
    pub fn term(self, edges: &Matrix, gram: &Matrix, k: usize) -> Option<Term> {
        let shape = Shape::of(edges, gram)?;
        let (i, j) = EDGES[k];
        let (value, w) = match self {
            Goal::RadiusEdge => shape.ratio_gradient(i, j),
            Goal::MinDihedral => {
                let (value, w) = shape.angle_gradient(i, j);
                (-value, scaled(&w, -1.0))
            }
            _ => shape.angle_gradient(i, j),
        };
        Some(term(value, &w, edges, gram))
    }
}

/// Pairs of facets, or of corners.
const EDGES: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

/// The barycentric covectors in the basis of the edges.
const COVECTORS: [[f64; 3]; 4] = [
    [-1.0, -1.0, -1.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
];

/// The inner products of the edges, and the inverse.
struct Shape {
    products: Matrix,
    inverse: Matrix,
}

impl Shape {
    fn of(edges: &Matrix, gram: &Matrix) -> Option<Self> {
        if determinant(edges) <= 0.0 {
            return None;
        }
        let products = product(&product(edges, gram), &transposed(edges));
        let determinant = determinant(&products);
        if determinant <= 0.0 || determinant.is_nan() {
            return None;
        }
        let cofactors = acutile_exact::geometry::linear::cofactors(&products);
        Some(Shape {
            inverse: scaled(&cofactors, 1.0 / determinant),
            products,
        })
    }

    /// The covector of facet i as a vector.
    fn normal(&self, i: usize) -> [f64; 3] {
        apply(&self.inverse, &COVECTORS[i])
    }

    fn cosine(&self, i: usize, j: usize) -> f64 {
        let (a, b) = (self.normal(i), self.normal(j));
        let square = dot(&COVECTORS[i], &a) * dot(&COVECTORS[j], &b);
        (-dot(&COVECTORS[i], &b) / square.sqrt()).clamp(-1.0, 1.0)
    }

    /// With q_i the normals and c the cosine, c = -Q_ij / √(Q_ii Q_jj) and dQ_ij = -q_i^T dP q_j.
    fn angle_gradient(&self, i: usize, j: usize) -> (f64, Matrix) {
        let (a, b) = (self.normal(i), self.normal(j));
        let (aa, bb) = (dot(&COVECTORS[i], &a), dot(&COVECTORS[j], &b));
        let root = (aa * bb).sqrt();
        let c = (-dot(&COVECTORS[i], &b) / root).clamp(-1.0, 1.0);
        let sine = (1.0 - c * c).sqrt();
        let w = filled(|k, l| {
            let mixed = (a[k] * b[l] + a[l] * b[k]) / (2.0 * root);
            let own = c / 2.0 * (a[k] * a[l] / aa + b[k] * b[l] / bb);
            -(mixed + own) / sine
        });
        (c.acos(), w)
    }

    /// y with R² = l · y / 4 for the squared edges l from corner 0.
    fn centre(&self) -> [f64; 3] {
        apply(
            &self.inverse,
            &[
                self.products[0][0],
                self.products[1][1],
                self.products[2][2],
            ],
        )
    }

    fn squared_radius(&self) -> f64 {
        let y = self.centre();
        (0..3).map(|k| self.products[k][k] * y[k]).sum::<f64>() / 4.0
    }

    fn squared_edge(&self, i: usize, j: usize) -> f64 {
        let w = edge(i, j);
        dot(&w, &apply(&self.products, &w))
    }

    /// The logarithm of R over the edge from corner i to corner j.
    fn ratio_gradient(&self, i: usize, j: usize) -> (f64, Matrix) {
        let y = self.centre();
        let w = edge(i, j);
        let (radius, square) = (self.squared_radius(), self.squared_edge(i, j));
        let gradient = filled(|k, l| {
            let diagonal = if k == l { 2.0 * y[k] } else { 0.0 };
            let of_radius = (diagonal - y[k] * y[l]) / 4.0;
            (of_radius / radius - w[k] * w[l] / square) / 2.0
        });
        ((radius / square).ln() / 2.0, gradient)
    }
}

/// The edge from corner i to corner j in the basis of the edges from corner 0.
fn edge(i: usize, j: usize) -> [f64; 3] {
    let unit = |corner: usize, k: usize| if corner == k + 1 { 1.0 } else { 0.0 };
    std::array::from_fn(|k| unit(j, k) - unit(i, k))
}

fn term(value: f64, w: &Matrix, edges: &Matrix, gram: &Matrix) -> Term {
    let image = product(w, edges);
    let rows = scaled(&product(&image, gram), 2.0);
    let first = std::array::from_fn(|k| -(rows[0][k] + rows[1][k] + rows[2][k]));
    Term {
        value,
        corners: [first, rows[0], rows[1], rows[2]],
        gram: product(&transposed(edges), &image),
    }
}

/// The matrix with these entries.
pub fn filled(entry: impl Fn(usize, usize) -> f64) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    filled(|i, j| (0..3).map(|k| a[i][k] * b[k][j]).sum())
}

fn transposed(a: &Matrix) -> Matrix {
    filled(|i, j| a[j][i])
}

fn scaled(a: &Matrix, factor: f64) -> Matrix {
    filled(|i, j| a[i][j] * factor)
}

/// The determinant of a matrix.
pub fn determinant(a: &Matrix) -> f64 {
    acutile_exact::geometry::linear::determinant(a)
}

fn apply(a: &Matrix, x: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| dot(&a[i], x))
}

fn dot(x: &[f64; 3], y: &[f64; 3]) -> f64 {
    x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXAMPLE: Matrix = [[1.0, 0.1, 0.2], [0.3, 0.9, -0.1], [0.2, 0.4, 1.1]];
    const GRAM: Matrix = [[1.0, 0.2, 0.0], [0.2, 1.5, 0.1], [0.0, 0.1, 0.8]];

    /// Every gradient agrees with central differences.
    #[test]
    fn gradients_are_differences() {
        let step = 1e-6;
        for goal in [Goal::MaxDihedral, Goal::MinDihedral, Goal::RadiusEdge] {
            for k in 0..6 {
                let term = goal.term(&EXAMPLE, &GRAM, k).unwrap();
                let value = |edges: &Matrix, gram: &Matrix| goal.values(edges, gram).unwrap()[k];
                assert!((term.value - value(&EXAMPLE, &GRAM)).abs() < 1e-12);
                for (i, j) in (0..9).map(|n| (n / 3, n % 3)) {
                    let moved = |sign: f64| {
                        let mut edges = EXAMPLE;
                        edges[i][j] += sign * step;
                        value(&edges, &GRAM)
                    };
                    let difference = (moved(1.0) - moved(-1.0)) / (2.0 * step);
                    assert!((difference - term.corners[i + 1][j]).abs() < 1e-7);
                    let stretched = |sign: f64| {
                        let mut gram = GRAM;
                        gram[i][j] += sign * step / 2.0;
                        gram[j][i] += sign * step / 2.0;
                        value(&EXAMPLE, &gram)
                    };
                    let difference = (stretched(1.0) - stretched(-1.0)) / (2.0 * step);
                    assert!((difference - (term.gram[i][j] + term.gram[j][i]) / 2.0).abs() < 1e-7);
                }
            }
        }
    }

    /// The regular tetrahedron has angles arccos(1/3) and ratio √6/4.
    #[test]
    fn a_regular_tetrahedron() {
        let edges = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let gram = [[1.0, 0.5, 0.5], [0.5, 1.0, 0.5], [0.5, 0.5, 1.0]];
        for value in Goal::MaxDihedral.values(&edges, &gram).unwrap() {
            assert!((value.cos() - 1.0 / 3.0).abs() < 1e-12);
        }
        for value in Goal::RadiusEdge.values(&edges, &gram).unwrap() {
            assert!((value.exp() - 6f64.sqrt() / 4.0).abs() < 1e-12);
        }
    }
}
