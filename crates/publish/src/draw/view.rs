//! From where a figure is seen: an exact direction, and a projection in doubles.
//!
//! The direction to the eye, a rational vector in basis coordinates, decides visibility. Only places on the
//! paper are doubles.

use super::DrawError;
use super::polygon::Point;
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;

/// An orthographic view.
#[derive(Clone, Debug)]
pub struct View {
    /// The direction to the eye, in basis coordinates.
    pub eye: Point,
    /// The basis vectors in Cartesian coordinates.
    vectors: [[f64; 3]; 3],
    /// The same on the screen: to the right, up, to the eye.
    basis: [[f64; 3]; 3],
}

/// Entries of the direction are multiples of the largest one divided by this number.
const STEPS: f64 = 4096.0;

impl View {
    /// The view of a basis with this Gram matrix from `direction`. In Cartesian coordinates the first basis
    /// vector lies along x, the second in the plane of x and y, and the third above it.
    ///
    /// # Errors
    /// If the matrix is not positive definite, the direction is 0, or lengths are beyond doubles.
    pub fn new(gram: &[[Number; 3]; 3], direction: [f64; 3]) -> Result<View, DrawError> {
        let vectors = cholesky(gram).ok_or(DrawError::NotPositiveDefinite)?;
        let entries = coordinates(&vectors, direction);
        if !entries.iter().all(|x| x.is_finite()) {
            return Err(DrawError::NoDirection);
        }
        let largest = entries.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let steps = entries.map(|x| (x / largest * STEPS).round());
        if !steps.iter().any(|x| x.abs() > 0.0) {
            return Err(DrawError::NoDirection);
        }
        let eye = steps.map(|x| Number::from(Rational::from(x as i64)));
        let toward = unit(combination(&vectors, steps));
        let vertical = if toward[0].hypot(toward[1]) > 1e-3 {
            [0.0, 0.0, 1.0]
        } else {
            [0.0, 1.0, 0.0]
        };
        let right = unit(linear::cross(&vertical, &toward));
        let up = linear::cross(&toward, &right);
        let basis = vectors.map(|b| {
            [
                linear::dot(&b, &right),
                linear::dot(&b, &up),
                linear::dot(&b, &toward),
            ]
        });
        if basis.iter().flatten().all(|x| x.is_finite()) {
            Ok(View {
                eye,
                vectors,
                basis,
            })
        } else {
            Err(DrawError::TooLarge)
        }
    }

    /// The place on the screen: to the right and up, in units of length.
    pub fn place(&self, point: &Point) -> [f64; 2] {
        let [x, y, _] = self.on_screen(point);
        [x, y]
    }

    /// Cartesian coordinates: the first basis vector along x, the second in the plane of x and y.
    pub fn cartesian(&self, point: &Point) -> [f64; 3] {
        combination(&self.vectors, point.each_ref().map(Number::approximate))
    }

    /// How much light a triangle gets, 0 to 1; the light comes from the upper left, from
    /// behind the eye.
    pub fn light(&self, corners: &[Point]) -> f64 {
        let [a, b, c] = [0, 1, 2].map(|k| self.on_screen(&corners[k]));
        let edge = |p: [f64; 3]| std::array::from_fn(|k| p[k] - a[k]);
        let normal = unit(linear::cross(&edge(b), &edge(c)));
        let toward = if normal[2] < 0.0 { -1.0 } else { 1.0 };
        (toward * linear::dot(&normal, &[-0.48, 0.6, 0.64])).max(0.0)
    }

    fn on_screen(&self, point: &Point) -> [f64; 3] {
        combination(&self.basis, point.each_ref().map(Number::approximate))
    }
}

/// The rows of the lower triangular L with L L^T = G.
fn cholesky(gram: &[[Number; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    let mut rows = [[0.0f64; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            let rest = gram[i][j].approximate() - linear::dot(&rows[i], &rows[j]);
            rows[i][j] = if i != j {
                rest / rows[j][j]
            } else if rest > 0.0 && rest.is_finite() {
                rest.sqrt()
            } else {
                return None;
            };
        }
    }
    Some(rows)
}

/// The c with Σ c_i b_i = x, for a triangular basis.
fn coordinates(vectors: &[[f64; 3]; 3], x: [f64; 3]) -> [f64; 3] {
    let mut c = [0.0; 3];
    for k in (0..3).rev() {
        let others: f64 = (k + 1..3).map(|i| c[i] * vectors[i][k]).sum();
        c[k] = (x[k] - others) / vectors[k][k];
    }
    c
}

fn combination(vectors: &[[f64; 3]; 3], c: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| (0..3).map(|i| c[i] * vectors[i][k]).sum())
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = linear::dot(&a, &a).sqrt();
    a.map(|x| x / length)
}
