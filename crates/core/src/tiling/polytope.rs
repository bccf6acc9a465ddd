//! Convex polytopes of dimension 1, 2 and 3: the cross-sections of slabs, prisms and
//! solids. Whether the data describe one is checked by [`crate::checker`].

use acutile_exact::geometry::{RingElement, Sign};
use acutile_exact::number::Number;

/// A polytope by its vertices and its facets, as in a certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct Polytope {
    /// k coordinates each, k = 1, 2 or 3.
    pub vertices: Vec<Vec<Number>>,
    /// The facets by the indices of their vertices: one for k = 1, the two ends of a
    /// side for k = 2, the corners in cyclic order for k = 3.
    pub faces: Vec<Vec<usize>>,
}

/// The affine function n · x - c that vanishes on a face and is positive on the
/// side of the polytope.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    normal: Vec<Number>,
    offset: Number,
}

impl Polytope {
    /// The interval from `lower` to `upper`.
    pub fn interval(lower: Number, upper: Number) -> Self {
        Polytope {
            vertices: vec![vec![lower], vec![upper]],
            faces: vec![vec![0], vec![1]],
        }
    }

    /// The polygon with these corners in cyclic order.
    pub fn polygon(vertices: Vec<Vec<Number>>) -> Self {
        let n = vertices.len();
        Polytope {
            vertices,
            faces: (0..n).map(|i| vec![i, (i + 1) % n]).collect(),
        }
    }

    /// The dimension k.
    pub fn dimension(&self) -> usize {
        self.vertices.first().map_or(0, Vec::len)
    }

    /// The plane of a face through its first k vertices, turned so that the polytope's
    /// first vertex off the plane is on the positive side; `None` where these k
    /// vertices, or all vertices, lie in no plane or in one.
    pub fn plane(&self, face: usize) -> Option<Plane> {
        let points: Vec<&[Number]> = self.faces[face]
            .iter()
            .map(|&v| self.vertices[v].as_slice())
            .collect();
        let normal = normal(&points, self.dimension())?;
        let offset = dot(&normal, points[0]);
        let plane = Plane { normal, offset };
        let side = self
            .vertices
            .iter()
            .map(|v| plane.value(v).sign())
            .find(|s| s.is_ne())?;
        Some(if side == Sign::Greater {
            plane
        } else {
            plane.turned()
        })
    }

    /// k! times the volume, if this is a convex polytope: the cones over its faces from
    /// its first vertex, each face a fan of simplices from its first vertex.
    pub fn scaled_volume(&self) -> Number {
        let mut sum = Number::zero();
        for face in &self.faces {
            sum = &sum + &self.scaled_cone(face).abs();
        }
        sum
    }

    fn scaled_cone(&self, face: &[usize]) -> Number {
        let apex = &self.vertices[0];
        let edge = |vertex: usize| difference(&self.vertices[vertex], apex);
        match self.dimension() {
            1 => edge(face[0])[0].clone(),
            2 => determinant(&[edge(face[0]), edge(face[1])]),
            _ => (1..face.len().saturating_sub(1)).fold(Number::zero(), |sum, k| {
                &sum + &determinant(&[edge(face[0]), edge(face[k]), edge(face[k + 1])])
            }),
        }
    }
}

impl Plane {
    /// Positive inside, zero on the plane, negative outside.
    pub fn value(&self, point: &[Number]) -> Number {
        &dot(&self.normal, point) - &self.offset
    }

    fn turned(self) -> Self {
        let zero = Number::zero();
        Plane {
            normal: self.normal.iter().map(|x| &zero - x).collect(),
            offset: &zero - &self.offset,
        }
    }
}

/// A vector orthogonal to the differences of the first k points.
fn normal(points: &[&[Number]], dimension: usize) -> Option<Vec<Number>> {
    if points.len() < dimension {
        return None;
    }
    let normal = match dimension {
        1 => vec![points[0][0].integer(1)],
        2 => {
            let edge = difference(points[1], points[0]);
            vec![&Number::zero() - &edge[1], edge[0].clone()]
        }
        _ => cross(
            &difference(points[1], points[0]),
            &difference(points[2], points[0]),
        ),
    };
    normal.iter().any(|x| !x.is_zero()).then_some(normal)
}

fn cross(a: &[Number], b: &[Number]) -> Vec<Number> {
    (0..3)
        .map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            &(&a[i] * &b[j]) - &(&a[j] * &b[i])
        })
        .collect()
}

fn determinant(rows: &[Vec<Number>]) -> Number {
    match rows {
        [a, b] => &(&a[0] * &b[1]) - &(&a[1] * &b[0]),
        [a, b, c] => dot(a, &cross(b, c)),
        _ => Number::zero(),
    }
}

fn dot(a: &[Number], b: &[Number]) -> Number {
    a.iter()
        .zip(b)
        .fold(Number::zero(), |sum, (x, y)| &sum + &(x * y))
}

fn difference(a: &[Number], b: &[Number]) -> Vec<Number> {
    a.iter().zip(b).map(|(x, y)| x - y).collect()
}
