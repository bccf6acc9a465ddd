//! Convex polytopes of dimension 1, 2 and 3: the cross-sections of slabs, prisms and
//! solids. Whether the data describe one is checked by [`crate::checker`].

use acutile_exact::geometry::{RingElement, Sign, linear};
use acutile_exact::number::Number;

/// A polytope by its vertices and its facets, as in a certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct Polytope<S = Number> {
    /// k coordinates each, k = 1, 2 or 3.
    pub vertices: Vec<Vec<S>>,
    /// The facets by the indices of their vertices: one for k = 1, the two ends of a
    /// side for k = 2, the corners in cyclic order for k = 3.
    pub faces: Vec<Vec<usize>>,
}

/// The affine function n · x - c that vanishes on a face and is positive on the
/// side of the polytope.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane<S = Number> {
    normal: [S; 3],
    offset: S,
}

impl<S> Polytope<S> {
    /// The interval from `lower` to `upper`.
    pub fn interval(lower: S, upper: S) -> Self {
        Polytope {
            vertices: vec![vec![lower], vec![upper]],
            faces: vec![vec![0], vec![1]],
        }
    }

    /// The polygon with these corners in cyclic order.
    pub fn polygon(vertices: Vec<Vec<S>>) -> Self {
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

    /// The polytope with other numbers as coordinates.
    pub fn map<T>(&self, map: impl Fn(&S) -> T) -> Polytope<T> {
        let rows = self.vertices.iter();
        Polytope {
            vertices: rows.map(|row| row.iter().map(&map).collect()).collect(),
            faces: self.faces.clone(),
        }
    }
}

impl<S: RingElement> Polytope<S> {
    /// The plane of a face through its first k vertices, turned to one side or the other; `None`
    /// if it has fewer.
    pub fn unturned_plane(&self, face: usize) -> Option<Plane<S>> {
        let points: Vec<&[S]> = self.faces[face]
            .iter()
            .map(|&v| self.vertices[v].as_slice())
            .collect();
        let normal = normal(&points, self.dimension())?;
        let offset = linear::dot(&normal, &in_space(points[0]));
        Some(Plane { normal, offset })
    }

    /// k! times the volume of the cone over a face from the first vertex, with either sign. The
    /// face is a fan of simplices from its first vertex.
    pub fn scaled_cone(&self, face: usize) -> S {
        let face = &self.faces[face];
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
            _ => {
                let fan = (1..face.len().saturating_sub(1)).map(|k| {
                    linear::determinant(&[edge(face[0]), edge(face[k]), edge(face[k + 1])])
                });
                let zero = apex[0].integer(0);
                fan.fold(zero, |sum, volume| sum.plus(&volume))
            }
        }
    }
}

impl Polytope {
    /// The plane of a face. Its positive side has the polytope's first vertex that is not in the plane.
    /// `None` if the face's first k vertices span no plane, or if all vertices lie in one plane.
    pub fn plane(&self, face: usize) -> Option<Plane> {
        let plane = self.unturned_plane(face)?;
        if plane.normal.iter().all(Number::is_zero) {
            return None;
        }
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

    /// k! times the volume, if this is a convex polytope: the cones over its faces from its first
    /// vertex.
    pub fn scaled_volume(&self) -> Number {
        let cones = (0..self.faces.len()).map(|face| self.scaled_cone(face).abs());
        cones.fold(Number::zero(), |sum, cone| &sum + &cone)
    }
}

impl<S> Plane<S> {
    /// The coefficients of the affine function, for up to three coordinates; the others are zero.
    pub fn normal(&self) -> &[S; 3] {
        &self.normal
    }

    /// The value that n · x has on the plane.
    pub fn offset(&self) -> &S {
        &self.offset
    }
}

impl<S: RingElement> Plane<S> {
    /// Positive inside, zero on the plane, negative outside.
    pub fn value(&self, point: &[S]) -> S {
        linear::dot(&self.normal, &in_space(point)).minus(&self.offset)
    }

    /// The same plane with the other side inside.
    pub fn turned(self) -> Self {
        let zero = self.offset.integer(0);
        Plane {
            normal: self.normal.map(|x| zero.minus(&x)),
            offset: zero.minus(&self.offset),
        }
    }
}

/// A vector orthogonal to the differences of the first k points.
fn normal<S: RingElement>(points: &[&[S]], dimension: usize) -> Option<[S; 3]> {
    if points.len() < dimension {
        return None;
    }
    let first = in_space(points[0]);
    let edge = |k: usize| linear::subtract(&in_space(points[k]), &first);
    let unit =
        |axis: usize| -> [S; 3] { std::array::from_fn(|k| first[0].integer(i64::from(k == axis))) };
    Some(match dimension {
        1 => unit(0),
        2 => linear::cross(&unit(2), &edge(1)),
        _ => linear::cross(&edge(1), &edge(2)),
    })
}

/// A point with up to three coordinates as one of space; the others are zero.
fn in_space<S: RingElement>(point: &[S]) -> [S; 3] {
    std::array::from_fn(|k| match point.get(k) {
        Some(x) => x.clone(),
        None => point[0].integer(0),
    })
}
