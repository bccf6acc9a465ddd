//! The polytope P of a domain, and the faces of P in which the vertices of the tiling lie.
//!
//! P is the convex hull of its vertices, in the last k coordinates. For a face f with the vertices
//! w_0, w_1, … let h_f(x) = det(w_1 - w_0, …, w_(k-1) - w_0, x - w_0) in these coordinates.
//! h_f(x) is n · (x - w_0), where n is the cross product of two vectors: those from w_0 for k = 3,
//! and basis vectors of the other coordinates in place of the missing ones.

use crate::claim::Polytope;
use crate::int::Int;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Element, Exact, Ring, Rings, Vector, each};
use crate::row::Corner;
use crate::vertices::Vertices;
use num_bigint::BigInt;
use std::cmp::Ordering::{Equal, Greater, Less};
use std::collections::BTreeMap;

type Large<const N: usize> = Exact<BigInt, N>;

/// The faces of P: x is on the inner side of one where n · x >= offset.
struct Planes<T, const N: usize> {
    ring: Exact<T, N>,
    /// n and the offset, times the denominator of the vertices of the tiling.
    planes: Vec<([Element<T, N>; 3], Element<T, N>)>,
}

/// A domain with faces.
pub(crate) struct Faces<const N: usize> {
    small: Option<Planes<i64, N>>,
    large: Planes<BigInt, N>,
    /// k! vol P, times the k-th power of the denominator of the vertices.
    pub(crate) volume: Element<BigInt, N>,
    /// The faces in which each vertex lies.
    of_vertex: Vec<Vec<u32>>,
}

impl<const N: usize> Faces<N> {
    /// Checks P1 to P3: the listed faces are the facets of P.
    pub(crate) fn new(polytope: &Polytope, dimension: usize, ring: &Large<N>) -> Checked<Self> {
        let frame = Frame::new(polytope, dimension, ring)?;
        let (mut planes, mut volume) = (Vec::new(), Element::default());
        for (f, face) in polytope.faces.iter().enumerate() {
            let (plane, pyramid) = frame.check_face(f, face)?;
            planes.push(plane);
            volume = ring.plus(&volume, &pyramid)?;
        }
        check_closed(polytope)?;
        let large = Planes { ring: ring.clone(), planes };
        Ok(Faces { small: None, large, volume, of_vertex: Vec::new() })
    }

    /// The vertices of the tiling have this denominator.
    pub(crate) fn set_denominator(&mut self, polytope: &Polytope, denominator: &BigInt, rings: &Rings<N>) -> Checked {
        // In a tiling every vertex of P is a corner, so its coordinates have this denominator.
        let factor = denominator / &polytope.denominator;
        let divides = &factor * &polytope.denominator == *denominator;
        ensure!(divides, DenominatorDomain, Place::Witness, polytope.denominator.clone());
        for c in &mut self.volume.0 {
            *c *= (0..polytope.dimension()).map(|_| &factor).product::<BigInt>();
        }
        for (_, offset) in &mut self.large.planes {
            offset.0.iter_mut().for_each(|c| *c *= &factor);
        }
        self.small = rings.small.as_ref().and_then(|ring| self.large.with_ring(ring).ok());
        Ok(())
    }

    /// Checks I for a vertex, and notes the faces in which it lies.
    pub(crate) fn check_vertex(&mut self, vertices: &Vertices, vertex: u32) -> Checked {
        let corner = Corner { vertex, shift: [0; 3] };
        let small = self.small.as_ref().ok_or(Stop::LARGER);
        let faces = match small.and_then(|planes| planes.faces(vertices, corner)) {
            Err(stop) if stop.is_larger() => self.large.faces(vertices, corner),
            found => found,
        };
        self.of_vertex.push(faces.map_err(|stop| stop.at(Place::Vertex(vertex)))?);
        Ok(())
    }

    /// Whether vertices lie in one face.
    pub(crate) fn share(&self, vertices: [u32; 3]) -> bool {
        let [a, b, c] = vertices.map(|vertex| {
            let vertex = usize::try_from(vertex).unwrap_or(usize::MAX);
            self.of_vertex.get(vertex).map_or(&[][..], Vec::as_slice)
        });
        self.large.ring.work().add(u64::try_from(a.len()).unwrap_or(u64::MAX) * 20);
        let has = |faces: &[u32], face| faces.binary_search(face).is_ok();
        a.iter().any(|face| has(b, face) && has(c, face))
    }
}

impl<T: Int, const N: usize> Planes<T, N> {
    fn with_ring<S: Int>(&self, ring: &Exact<S, N>) -> Checked<Planes<S, N>> {
        let number = |x: &Element<T, N>| ring.element(&self.ring.coefficients(x));
        let planes = self.planes.iter();
        let planes = planes.map(|(normal, offset)| Ok((each(normal, number)?, number(offset)?)));
        Ok(Planes { ring: ring.clone(), planes: planes.collect::<Checked<_>>()? })
    }

    /// The faces in which a vertex lies.
    fn faces(&self, vertices: &Vertices, corner: Corner) -> Checked<Vec<u32>> {
        let ring = &self.ring;
        let point = vertices.point(corner)?;
        let mut faces = Vec::new();
        for ((normal, offset), face) in self.planes.iter().zip(0..) {
            ring.work().add(3 * ring.price());
            let height = ring.minus(&ring.inner(normal, &point)?, offset)?;
            let sign = ring.sign(&height)?;
            // Rule I: the vertex is in the domain.
            let place = Place::Vertex(corner.vertex);
            ensure!(sign != Less, VertexOutside, place, ring.value(&height));
            if sign == Equal {
                faces.push(face);
            }
        }
        Ok(faces)
    }
}

/// The vertices of P in the last k of three or two coordinates.
struct Frame<'p, const N: usize> {
    ring: &'p Large<N>,
    points: Vec<Vector<Large<N>>>,
    /// Basis vectors of coordinates that P does not have.
    spare: [Vector<Large<N>>; 2],
}

type Plane<const N: usize> = (Vector<Large<N>>, Element<BigInt, N>);

impl<'p, const N: usize> Frame<'p, N> {
    fn new(polytope: &Polytope, dimension: usize, ring: &'p Large<N>) -> Checked<Self> {
        let missing = dimension.saturating_sub(polytope.dimension());
        let mut points = Vec::new();
        for vertex in &polytope.vertices {
            let mut point: Vector<Large<N>> = Default::default();
            for (slot, number) in point.iter_mut().skip(missing).zip(vertex) {
                *slot = ring.element(number)?;
            }
            points.push(point);
        }
        let (one, zero) = (ring.integer(1)?, Element::default());
        let first = [one.clone(), zero.clone(), zero.clone()];
        let spare =
            if dimension == 3 { [first, [zero.clone(), one, zero]] } else { [[zero.clone(), zero, one], first] };
        Ok(Frame { ring, points, spare })
    }

    fn vector(&self, from: usize, to: usize) -> Checked<Vector<Large<N>>> {
        let point = |index| self.points.get(index).ok_or(Stop::LARGER);
        self.ring.difference(point(from)?, point(to)?)
    }

    /// The cross products for the triangles of a face from its first vertex; for k < 3 the one.
    fn normals(&self, face: &[usize]) -> Checked<Vec<Vector<Large<N>>>> {
        let [first, second] = &self.spare;
        match face {
            [_] => Ok(vec![self.ring.cross(first, second)?]),
            [p, q] => Ok(vec![self.ring.cross(first, &self.vector(*p, *q)?)?]),
            [origin, others @ ..] => {
                let pairs = others.iter().zip(others.iter().skip(1));
                let normals = pairs.map(|(&p, &q)| {
                    let (p, q) = (self.vector(*origin, p)?, self.vector(*origin, q)?);
                    self.ring.cross(&p, &q)
                });
                normals.collect()
            }
            [] => Err(Stop::LARGER),
        }
    }

    /// Checks that a face is a facet of P. Returns its plane, with the inner side positive, and
    /// k! times the volume of the pyramid over it whose apex is vertex 0 of P.
    fn check_face(&self, f: usize, face: &[usize]) -> Checked<(Plane<N>, Element<BigInt, N>)> {
        let ring = self.ring;
        let mut normals = self.normals(face)?;
        let normal = normals.first().ok_or(Stop::LARGER)?;
        let origin = face.first().copied().ok_or(Stop::LARGER)?;
        // P1: h_f is zero at the vertices of f and has one strict sign at all others, of which
        // there is one.
        let mut side = Equal;
        let mut corners = face.to_vec();
        corners.sort_unstable();
        for vertex in 0..self.points.len() {
            let height = ring.inner(normal, &self.vector(origin, vertex)?)?;
            let sign = ring.sign(&height)?;
            let is_corner = corners.binary_search(&vertex).is_ok();
            if !is_corner && side == Equal {
                side = sign;
            }
            let is_right = if is_corner { sign == Equal } else { sign != Equal && sign == side };
            ensure!(is_right, FaceNotFacet, Place::Face(f), ring.value(&height));
        }
        ensure!(side != Equal, FaceNotFacet, Place::Face(f));
        ring.work().check(Place::Face(f))?;
        self.check_polygon(f, face, normal)?;
        if side == Less {
            for normal in &mut normals {
                *normal = ring.difference(normal, &Default::default())?;
            }
        }
        let (apex, mut pyramid) = (self.vector(origin, 0)?, Element::default());
        for normal in &normals {
            pyramid = ring.plus(&pyramid, &ring.inner(normal, &apex)?)?;
        }
        let normal = normals.swap_remove(0);
        let offset = ring.inner(&normal, self.points.get(origin).ok_or(Stop::LARGER)?)?;
        Ok(((normal, offset), pyramid))
    }

    /// P2, for k = 3: the vertices of a face stand in the order of a convex polygon. For all
    /// consecutive p, q and every other t, the turn det(q - p, t - p, n) is positive. In the plane
    /// of f, (q - p) × (t - p) = λ n, and λ is positive where p, q, t turn like w_0, w_1, w_2.
    fn check_polygon(&self, f: usize, face: &[usize], normal: &Vector<Large<N>>) -> Checked {
        for (p, q) in sides(face).filter(|_| face.len() > 2) {
            for &t in face.iter().filter(|&&t| t != p && t != q) {
                let (q, t) = (self.vector(p, q)?, self.vector(p, t)?);
                let turn = self.ring.inner(&self.ring.cross(&q, &t)?, normal)?;
                let is_convex = self.ring.sign(&turn)? == Greater;
                ensure!(is_convex, FaceNotConvex, Place::Face(f), self.ring.value(&turn));
            }
            self.ring.work().check(Place::Face(f))?;
        }
        Ok(())
    }
}

/// The pairs of vertices that follow one another, cyclically.
fn sides(face: &[usize]) -> impl Iterator<Item = (usize, usize)> {
    face.iter().copied().zip(face.iter().copied().cycle().skip(1))
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
            face => sides(face).map(|(p, q)| vec![p.min(q), p.max(q)]).collect(),
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
