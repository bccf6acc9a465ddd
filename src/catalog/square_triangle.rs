//! Section 4.1: from an edge-to-edge tiling of the plane by squares and equilateral
//! triangles to a TCP structure.
//!
//! The paper marks black and white dots on the plane tiling, side 4, and puts points at
//! heights 4k - 1 over black dots, 4k + 1 over white ones, 4k and 4k + 2 over vertices.
//! *The rule of the colours.* All edges have directions that are multiples of 30 degrees
//! from one of them; call an edge black if the multiple is even. Then the edges
//! of a triangle (60 degrees apart) have one colour, neighbouring edges of a square (90)
//! differ, and nothing depends on the cell that was chosen. The dots: the middle of
//! an edge in its colour; the centre of a triangle in the other colour than its edges;
//! in a square, for each side, its middle moved inwards by 1, in the other colour than
//! the side.
//!
//! Vertices are exact: with z a 12th root of unity (z^4 = z² - 1) the vector
//! (a, b, c, d) is a + b z + c z² + d z³.

use super::CatalogError;
use super::recipe::{common_field, quotient};
use crate::delaunay::{Ties, triangulate};
use crate::number::{Field, Number};
use crate::tiling::{Frame, PointSet, Tiling};
use malachite::{Integer, Rational};
use std::collections::HashMap;

/// a + b z + c z² + d z³
pub type Cyclotomic = [i64; 4];

/// z^k
const POWERS: [Cyclotomic; 12] = [
    [1, 0, 0, 0],
    [0, 1, 0, 0],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
    [-1, 0, 1, 0],
    [0, -1, 0, 1],
    [-1, 0, 0, 0],
    [0, -1, 0, 0],
    [0, 0, -1, 0],
    [0, 0, 0, -1],
    [1, 0, -1, 0],
    [0, 1, 0, -1],
];

/// A periodic tiling of the plane by unit squares and triangles: a basis of the lattice and one
/// vertex of each orbit. Its edges are all pairs of vertices at distance 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaneTiling {
    /// Two lattice vectors.
    pub lattice: [Cyclotomic; 2],
    /// The vertices of a cell.
    pub vertices: Vec<Cyclotomic>,
}

fn plane(lattice: [Cyclotomic; 2], vertices: &[Cyclotomic]) -> PlaneTiling {
    PlaneTiling {
        lattice,
        vertices: vertices.to_vec(),
    }
}

/// 3^6: triangles only, which gives Z.
pub fn triangles() -> PlaneTiling {
    plane([POWERS[0], POWERS[2]], &[[0; 4]])
}

/// 4^4: squares only, which gives A15.
pub fn squares() -> PlaneTiling {
    plane([POWERS[0], POWERS[3]], &[[0; 4]])
}

/// 3^3.4^2: a row of squares, a row of triangles; gives H.
pub fn rows() -> PlaneTiling {
    plane([POWERS[0], [0, 0, 1, 1]], &[[0; 4], POWERS[3]])
}

/// 3^2.4.3.4: every vertex belongs to a square with sides 1 and z³; gives sigma.
pub fn snub() -> PlaneTiling {
    plane(
        [[1, 1, 0, 0], [-1, 0, 1, 1]],
        &[[0; 4], POWERS[0], POWERS[3], [1, 0, 0, 1]],
    )
}

/// 3.4.6.4 with each hexagon cut into six triangles. The lattice vectors have the length
/// 1 + sqrt 3, and sqrt 3 = 2 z - z³.
pub fn rhombitrihexagonal() -> PlaneTiling {
    let length = [1, 2, 0, -1];
    let mut vertices = vec![[0; 4]];
    vertices.extend([1, 3, 5, 7, 9, 11].map(|k| POWERS[k]));
    PlaneTiling {
        lattice: [length, times(length, POWERS[2])],
        vertices,
    }
}

impl PlaneTiling {
    /// Stampfli's inflation by the factor 2 + sqrt 3: around each vertex c of the
    /// enlarged tiling a dodecagonal wheel, c, c + z^k, c + z^k + z^(k±1) for even k.
    pub fn inflated(&self) -> PlaneTiling {
        let factor = [2, 2, 0, -1];
        let lattice = self.lattice.map(|x| times(x, factor));
        let mut inflated = PlaneTiling {
            lattice,
            vertices: Vec::new(),
        };
        let mut known = HashMap::new();
        for &vertex in &self.vertices {
            for x in wheel(times(vertex, factor)) {
                if known.insert(inflated.residue(x), ()).is_none() {
                    inflated.vertices.push(x);
                }
            }
        }
        inflated
    }

    /// The representative of x modulo the lattice: two coordinates in which the lattice
    /// vectors are independent determine the multiples to subtract.
    fn residue(&self, x: Cyclotomic) -> Cyclotomic {
        let [a, b] = &self.lattice;
        let minor = |x: &Cyclotomic, y: &Cyclotomic, i: usize, j: usize| x[i] * y[j] - x[j] * y[i];
        let pairs = (0..4).flat_map(|j| (0..j).map(move |i| (i, j)));
        let Some((i, j)) = pairs.into_iter().find(|&(i, j)| minor(a, b, i, j) != 0) else {
            return x;
        };
        let d = minor(a, b, i, j);
        let s = (minor(&x, b, i, j) * d.signum()).div_euclid(d.abs());
        let t = (minor(a, &x, i, j) * d.signum()).div_euclid(d.abs());
        std::array::from_fn(|k| x[k] - s * a[k] - t * b[k])
    }

    /// The directions k, sorted, of the edges at each vertex.
    fn edges(&self) -> Vec<Vec<usize>> {
        let known: HashMap<_, _> = self
            .vertices
            .iter()
            .map(|&v| (self.residue(v), ()))
            .collect();
        let is_edge =
            |v: &Cyclotomic, k: usize| known.contains_key(&self.residue(sum(*v, POWERS[k])));
        self.vertices
            .iter()
            .map(|v| (0..12).filter(|&k| is_edge(v, k)).collect())
            .collect()
    }

    /// The corners of the tiles: (vertex, direction of the first side, angle/30).
    fn tile_corners(&self) -> Result<Vec<(usize, usize, usize)>, CatalogError> {
        let mut corners = Vec::new();
        for (vertex, directions) in self.edges().iter().enumerate() {
            for (i, &k) in directions.iter().enumerate() {
                let next = directions[(i + 1) % directions.len()];
                let angle = (next + 11 - k) % 12 + 1;
                if angle != 2 && angle != 3 {
                    return Err(CatalogError::NotSquareTriangle {
                        vertex,
                        angle: 30 * angle,
                    });
                }
                corners.push((vertex, k, angle));
            }
        }
        Ok(corners)
    }

    /// The points of the structure over one cell: 12 times the place in the plane, and
    /// the height.
    fn points(&self) -> Result<Vec<(Cyclotomic, i64)>, CatalogError> {
        let dot = |black: bool| if black { -1 } else { 1 };
        let mut points = Vec::new();
        for &vertex in &self.vertices {
            points.extend([(scaled(vertex, 12), 0), (scaled(vertex, 12), 2)]);
        }
        for (vertex, k, angle) in self.tile_corners()? {
            let (corner, black) = (scaled(self.vertices[vertex], 12), k % 2 == 0);
            let middle = sum(corner, scaled(POWERS[k], 6));
            // An edge has two ends, a triangle three corners: one of them has a small k. A
            // square has a corner for each side.
            if k < 6 {
                points.push((middle, dot(black)));
            }
            if angle == 3 {
                points.push((sum(middle, scaled(POWERS[(k + 3) % 12], 3)), dot(!black)));
            } else if k < 4 {
                let center = sum(scaled(POWERS[k], 4), scaled(POWERS[k + 2], 4));
                points.push((sum(corner, center), dot(!black)));
            }
        }
        Ok(points)
    }

    /// The structure over the plane tiling: side 4, and period 4 in height.
    pub fn structure(&self) -> Result<Tiling<3>, CatalogError> {
        Ok(triangulate(&self.point_set()?, Ties::Refuse)?)
    }

    /// The vertices of the structure.
    pub fn point_set(&self) -> Result<PointSet<3>, CatalogError> {
        let root = square_root_of_3()?;
        let [a, b] = self.lattice.map(|x| cartesian(x, &root));
        let integer = |x: i64| Number::from(Rational::from(x));
        let area = cross(&a, &b);
        let mut points = Vec::new();
        for (place, height) in self.points()? {
            let x = cartesian(place, &root);
            let scale = &area * &integer(12);
            let s = quotient(&cross(&x, &b), &scale)?;
            let t = quotient(&cross(&a, &x), &scale)?;
            points.push([s, t, Number::from(Rational::from_signeds(height, 4))]);
        }
        let inner = |x: &[Number; 2], y: &[Number; 2]| {
            &integer(16) * &(&(&x[0] * &y[0]) + &(&x[1] * &y[1]))
        };
        let ab = inner(&a, &b);
        let zero = Number::zero;
        let gram = [
            [inner(&a, &a), ab.clone(), zero()],
            [ab, inner(&b, &b), zero()],
            [zero(), zero(), integer(16)],
        ];
        let field = common_field(gram.iter().chain(&points).flatten());
        Ok(PointSet {
            frame: Frame::space(field, gram),
            points,
        })
    }
}

fn wheel(c: Cyclotomic) -> Vec<Cyclotomic> {
    let mut points = vec![c];
    for k in [0, 2, 4, 6, 8, 10] {
        let spoke = sum(c, POWERS[k]);
        points.extend([
            spoke,
            sum(spoke, POWERS[k + 1]),
            sum(spoke, POWERS[(k + 11) % 12]),
        ]);
    }
    points
}

fn sum(x: Cyclotomic, y: Cyclotomic) -> Cyclotomic {
    std::array::from_fn(|k| x[k] + y[k])
}

fn scaled(x: Cyclotomic, factor: i64) -> Cyclotomic {
    x.map(|entry| entry * factor)
}

fn times(x: Cyclotomic, y: Cyclotomic) -> Cyclotomic {
    let mut product = [0; 4];
    for (i, a) in x.iter().enumerate() {
        for (j, b) in y.iter().enumerate() {
            product = sum(product, scaled(POWERS[i + j], a * b));
        }
    }
    product
}

fn square_root_of_3() -> Result<Number, CatalogError> {
    let polynomial = [-3, 0, 1].map(Integer::from);
    let (_, root) = Field::adjoin_root(&polynomial, Rational::from(1), Rational::from(2))?;
    Ok(root)
}

/// z = (sqrt 3 + i)/2, z² = (1 + i sqrt 3)/2, z³ = i.
fn cartesian(x: Cyclotomic, root: &Number) -> [Number; 2] {
    let [a, b, c, d] = x.map(|entry| Number::from(Rational::from(entry)));
    let half = Number::from(Rational::from_signeds(1, 2));
    let real = &a + &(&half * &(&(&b * root) + &c));
    let imaginary = &d + &(&half * &(&b + &(&c * root)));
    [real, imaginary]
}

fn cross(x: &[Number; 2], y: &[Number; 2]) -> Number {
    &(&x[0] * &y[1]) - &(&x[1] * &y[0])
}
