//! The polytope P of a domain: its facets, its volume, and the facets in which a point lies.
//!
//! P is the convex hull of its vertices, in the last k coordinates. For a face f with the vertices
//! w_0, w_1, … let h_f(x) = det(w_1 - w_0, …, w_(k-1) - w_0, x - w_0) in these coordinates.
//! h_f(x) is n · (x - w_0), where n is the cross product of two vectors: those from w_0 for k = 3,
//! and basis vectors of the other coordinates in place of the missing ones.

use crate::claim::Polytope;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Ring, Sign, Vector};
use std::cmp::Ordering::{Equal, Less};
use std::collections::BTreeMap;

/// P in the numbers of one ring. The normals and offsets have x on the inner side of a face where n · x >= offset.
pub(crate) struct Facets<R: Ring> {
    ring: R,
    /// The vertices, in the last k of three or two coordinates.
    points: Vec<Vector<R>>,
    /// Basis vectors of coordinates that P does not have.
    spare: [Vector<R>; 2],
    planes: Vec<(Vector<R>, R::Element)>,
    /// k! vol P
    pub(crate) volume: R::Element,
    /// The denominator of the vertices of the tiling is this multiple of that of P.
    pub(crate) factor: R::Element,
}

impl<R: Ring> Facets<R> {
    /// Checks P1 to P3: the listed faces are the facets of P.
    pub(crate) fn new(polytope: &Polytope, dimension: usize, ring: &R) -> Checked<Self> {
        let missing = dimension.saturating_sub(polytope.dimension);
        let mut points = Vec::new();
        for vertex in &polytope.vertices {
            let mut point = Vector::<R>::default();
            for (slot, number) in point.iter_mut().skip(missing).zip(vertex) {
                *slot = ring.polynomial(number)?;
            }
            points.push(point);
        }
        let (one, zero) = (ring.integer(1)?, R::Element::default);
        let first = [one.clone(), zero(), zero()];
        let spare = if dimension == 3 { [first, [zero(), one, zero()]] } else { [[zero(), zero(), one], first] };
        let (planes, factor) = (Vec::new(), ring.integer(1)?);
        let mut facets = Facets { ring: ring.clone(), points, spare, planes, volume: zero(), factor };
        for (f, face) in polytope.faces.iter().enumerate() {
            facets.add(f, face)?;
        }
        check_closed(polytope)?;
        Ok(facets)
    }

    /// Checks I for a vertex. Returns the faces in which it lies.
    pub(crate) fn of_vertex(&self, point: &Vector<R>, vertex: u32) -> Checked<Vec<u32>> {
        let ring = &self.ring;
        let mut faces = Vec::new();
        for ((normal, offset), face) in self.planes.iter().zip(0..) {
            ring.work().add(4 * ring.price());
            let height = ring.minus(&ring.inner(normal, point)?, &ring.times(offset, &self.factor)?)?;
            let sign = ring.sign(&height);
            // Rule I: the vertex is in the domain.
            let is_inside = sign.is(|sign| sign != Less)?;
            ensure!(is_inside, VertexOutside, Place::Vertex(vertex), ring.value(&height));
            if sign == Sign::exactly(Equal) {
                faces.push(face);
            }
        }
        Ok(faces)
    }

    fn vector(&self, from: usize, to: usize) -> Checked<Vector<R>> {
        let point = |index| self.points.get(index).ok_or(Stop::LARGER);
        self.ring.difference(point(from)?, point(to)?)
    }

    /// The cross products for the triangles of a face from its first vertex; for k < 3 the one.
    fn normals(&self, face: &[usize]) -> Checked<Vec<Vector<R>>> {
        let [first, second] = &self.spare;
        match face {
            [_] => Ok(vec![self.ring.cross(first, second)?]),
            [p, q] => Ok(vec![self.ring.cross(first, &self.vector(*p, *q)?)?]),
            [origin, others @ ..] => {
                let pairs = others.iter().zip(others.iter().skip(1));
                let normal = |(&p, &q)| self.ring.cross(&self.vector(*origin, p)?, &self.vector(*origin, q)?);
                pairs.map(normal).collect()
            }
            [] => Err(Stop::LARGER),
        }
    }

    /// Checks that a face is a facet of P. Adds its plane, and to the volume k! times that of the
    /// pyramid over it whose apex is vertex 0 of P.
    fn add(&mut self, f: usize, face: &[usize]) -> Checked {
        let ring = &self.ring;
        let place = Place::Face(f);
        let mut normals = self.normals(face)?;
        let normal = normals.first().ok_or(Stop::LARGER)?;
        let origin = face.first().copied().ok_or(Stop::LARGER)?;
        // P1: h_f is zero at the vertices of f and has one strict sign at all others, of which there is one.
        let mut side = Equal;
        let mut corners = face.to_vec();
        corners.sort_unstable();
        for vertex in 0..self.points.len() {
            let height = ring.inner(normal, &self.vector(origin, vertex)?)?;
            let sign = ring.sign(&height).decided()?;
            let is_corner = corners.binary_search(&vertex).is_ok();
            if !is_corner && side == Equal {
                side = sign;
            }
            let is_right = if is_corner { sign == Equal } else { sign != Equal && sign == side };
            ensure!(is_right, FaceNotFacet, place, ring.value(&height));
        }
        ensure!(side != Equal, FaceNotFacet, place);
        ring.work().check(place)?;
        // P2, for k = 3: the vertices of a face stand in the order of a convex polygon. For all consecutive p, q and
        // every other t, and a vertex o that is not in f, det(q - p, t - p, o - p) is positive where the inner side is.
        // In the plane of f, (q - p) × (t - p) = λ n, so this says that λ is positive: p, q, t turn like w_0, w_1, w_2.
        let outside = (0..self.points.len()).find(|vertex| corners.binary_search(vertex).is_err());
        for [p, q] in cycle(face).filter(|_| face.len() > 2) {
            let apex = self.vector(p, outside.ok_or(Stop::LARGER)?)?;
            for &t in face.iter().filter(|&&t| t != p && t != q) {
                let turn = ring.inner(&ring.cross(&self.vector(p, q)?, &self.vector(p, t)?)?, &apex)?;
                let is_convex = ring.sign(&turn).is(|sign| sign == side)?;
                ensure!(is_convex, FaceNotConvex, place, ring.value(&turn));
            }
            ring.work().check(place)?;
        }
        let (apex, mut volume) = (self.vector(origin, 0)?, self.volume.clone());
        for normal in &mut normals {
            if side == Less {
                *normal = ring.difference(normal, &Default::default())?;
            }
            volume = ring.plus(&volume, &ring.inner(normal, &apex)?)?;
        }
        let normal = normals.swap_remove(0);
        let offset = ring.inner(&normal, self.points.get(origin).ok_or(Stop::LARGER)?)?;
        self.planes.push((normal, offset));
        self.volume = volume;
        Ok(())
    }
}

/// The pairs of items that follow one another, cyclically.
pub(crate) fn cycle<T: Copy>(items: &[T]) -> impl Iterator<Item = [T; 2]> {
    items.iter().zip(items.iter().cycle().skip(1)).map(|(one, other)| [*one, *other])
}

/// P3: every ridge of P that is in a face is in exactly two. The faces are distinct facets, and
/// facets are connected through ridges; so all facets of P are listed.
fn check_closed(polytope: &Polytope) -> Checked {
    let mut count: BTreeMap<Vec<usize>, (u64, usize)> = BTreeMap::new();
    for (f, face) in polytope.faces.iter().enumerate() {
        // For k = 1 the empty set, for k = 2 each vertex, for k = 3 each side.
        let ridges: Vec<Vec<usize>> = match face.as_slice() {
            [_] => vec![Vec::new()],
            [p, q] => vec![vec![*p], vec![*q]],
            face => cycle(face).map(|[p, q]| vec![p.min(q), p.max(q)]).collect(),
        };
        for ridge in ridges {
            count.entry(ridge).or_insert((0, f)).0 += 1;
        }
    }
    for (faces, f) in count.into_values() {
        ensure!(faces == 2, FacesNotClosed, Place::Face(f), faces);
    }
    Ok(())
}
