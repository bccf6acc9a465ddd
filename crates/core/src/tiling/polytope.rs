//! Convex polytopes of dimension 1, 2 and 3: the cross-sections of slabs, prisms and
//! solids. Whether the data describe one is checked by [`crate::checker`].

use acutile_exact::geometry::{Scalar, Sign, linear};
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
    normal: [Number; 3],
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
        let offset = linear::dot(&normal, &in_space(points[0]));
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
        let apex = in_space(&self.vertices[0]);
        let edge = |vertex: usize| linear::subtract(&in_space(&self.vertices[vertex]), &apex);
        match self.dimension() {
            1 => {
                let [length, _, _] = edge(face[0]);
                length
            }
            2 => {
                let [_, _, area] = linear::cross(&edge(face[0]), &edge(face[1]));
                area
            }
            _ => (1..face.len().saturating_sub(1)).fold(Number::zero(), |sum, k| {
                sum + linear::determinant(&[edge(face[0]), edge(face[k]), edge(face[k + 1])])
            }),
        }
    }
}

impl Plane {
    /// Positive inside, zero on the plane, negative outside.
    pub fn value(&self, point: &[Number]) -> Number {
        &linear::dot(&self.normal, &in_space(point)) - &self.offset
    }

    fn turned(self) -> Self {
        Plane {
            normal: self.normal.map(|x| -x),
            offset: -self.offset,
        }
    }
}

/// A vector orthogonal to the differences of the first k points.
fn normal(points: &[&[Number]], dimension: usize) -> Option<[Number; 3]> {
    if points.len() < dimension {
        return None;
    }
    let first = in_space(points[0]);
    let edge = |k: usize| linear::subtract(&in_space(points[k]), &first);
    let unit = |axis: usize| -> [Number; 3] {
        std::array::from_fn(|k| first[0].integer(i64::from(k == axis)))
    };
    let normal = match dimension {
        1 => unit(0),
        2 => linear::cross(&unit(2), &edge(1)),
        _ => linear::cross(&edge(1), &edge(2)),
    };
    normal.iter().any(|x| !x.is_zero()).then_some(normal)
}

/// A point with up to three coordinates as one of space; the others are zero.
fn in_space(point: &[Number]) -> [Number; 3] {
    std::array::from_fn(|k| point.get(k).cloned().unwrap_or_else(Number::zero))
}
