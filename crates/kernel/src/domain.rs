//! The polytope P of a domain, and the faces of P in which the vertices of the tiling lie.
//!
//! P is the convex hull of its vertices, in the last k coordinates. For a face f with the vertices
//! w_0, w_1, … let h_f(x) = det(w_1 - w_0, …, w_(k-1) - w_0, x - w_0) in these coordinates.
//! h_f(x) is n · (x - w_0), where n is the cross product of two vectors: those from w_0 for k = 3,
//! and basis vectors of the other coordinates in place of the missing ones.

use crate::claim::{Claim, Polytope};
use crate::int::Int;
use crate::limits::Work;
use crate::refusal::{Checked, Larger, Place, Stop, Value};
use crate::ring::{Element, Exact, Ring, Rings, Vector, each};
use crate::vertices::Vertices;
use num_bigint::BigInt;
use std::cmp::Ordering::{Equal, Greater, Less};
use std::collections::BTreeMap;

type Large<const N: usize> = Exact<BigInt, N>;

/// x is on the inner side of a face where n · x >= offset.
struct Plane<E> {
    normal: [E; 3],
    offset: E,
}

/// The faces of P in integers of one size, times the denominator of the vertices.
struct Planes<T, const N: usize> {
    ring: Exact<T, N>,
    planes: Vec<Plane<Element<T, N>>>,
}

/// A domain with faces, and the sets of faces in which the vertices lie.
pub(crate) struct Faces<const N: usize> {
    small: Option<Planes<i64, N>>,
    large: Planes<BigInt, N>,
    /// k! vol P, times the k-th power of the denominator of the vertices.
    pub(crate) volume: Element<BigInt, N>,
    /// The sets of faces that occur. The first one is empty.
    sets: Vec<Vec<u32>>,
    numbers: BTreeMap<Vec<u32>, u32>,
    /// The set of each vertex.
    of_vertex: Vec<u32>,
}

/// The vertices of P in the last k of three or two coordinates.
struct Frame<'p, const N: usize> {
    ring: &'p Large<N>,
    points: Vec<Vector<Large<N>>>,
    /// Basis vectors of coordinates that P does not have: the first is between them and those that
    /// P has.
    spare: [Vector<Large<N>>; 2],
}

impl<const N: usize> Faces<N> {
    /// Checks P1 to P3: the listed faces are the facets of P.
    pub(crate) fn new(
        claim: &Claim,
        polytope: &Polytope,
        rings: &Rings<N>,
        work: &Work,
    ) -> Checked<Faces<N>> {
        let undecided = |stop: Stop| stop.at_last(Place::Domain);
        let frame = Frame::new(claim, polytope, &rings.large).map_err(|l| undecided(l.into()))?;
        let mut planes = Vec::new();
        let mut volume = Element::default();
        for (f, face) in polytope.faces.iter().enumerate() {
            let (plane, pyramid) = frame.check_face(f, face).map_err(undecided)?;
            work.check(Place::Face(f))?;
            let sum = rings.large.plus(&volume, &pyramid);
            volume = sum.map_err(|l| undecided(l.into()))?;
            planes.push(plane);
        }
        check_closed(polytope)?;
        let ring = rings.large.clone();
        Ok(Faces {
            small: None,
            large: Planes { ring, planes },
            volume,
            sets: vec![Vec::new()],
            numbers: BTreeMap::from([(Vec::new(), 0)]),
            of_vertex: Vec::new(),
        })
    }

    /// The vertices have this denominator.
    pub(crate) fn set_denominator(
        &mut self,
        polytope: &Polytope,
        denominator: &BigInt,
        rings: &Rings<N>,
    ) -> Checked {
        // In a tiling every vertex of P is a corner, so its coordinates have this denominator.
        let factor = denominator / &polytope.denominator;
        let divides = &factor * &polytope.denominator == *denominator;
        ensure!(
            divides,
            DenominatorDomain,
            Place::Witness,
            polytope.denominator.clone()
        );
        let ring = &self.large.ring;
        let scaled = |value: &Element<BigInt, N>, times| -> Result<_, Larger> {
            (0..times).try_fold(value.clone(), |value, _| {
                ring.times(&value, &ring.element(std::slice::from_ref(&factor))?)
            })
        };
        let undecided = |Larger| Stop::Larger.at_last(Place::Domain);
        self.volume = scaled(&self.volume, polytope.dimension()).map_err(undecided)?;
        for plane in &mut self.large.planes {
            plane.offset = scaled(&plane.offset, 1).map_err(undecided)?;
        }
        let small = rings.small.as_ref().map(|ring| self.large.converted(ring));
        self.small = small.and_then(Result::ok);
        Ok(())
    }

    /// Checks I for a vertex, and notes the faces in which it lies.
    pub(crate) fn check_vertex(&mut self, vertices: &Vertices, vertex: u32) -> Checked {
        let small = self.small.as_ref().ok_or(Stop::Larger);
        let faces = match small.and_then(|planes| planes.faces(vertices, vertex)) {
            Err(Stop::Larger) => self.large.faces(vertices, vertex),
            found => found,
        };
        let faces = faces.map_err(|stop| stop.at_last(Place::Vertex(vertex)))?;
        let number = match self.numbers.get(&faces) {
            Some(&number) => number,
            None => {
                let number = u32::try_from(self.sets.len()).unwrap_or(u32::MAX);
                self.sets.push(faces.clone());
                self.numbers.insert(faces, number);
                number
            }
        };
        self.of_vertex.push(number);
        Ok(())
    }

    /// Whether vertices lie in one face.
    #[inline(always)]
    pub(crate) fn share(&self, vertices: [u32; 3]) -> bool {
        let set = |vertex: u32| {
            let vertex = usize::try_from(vertex).unwrap_or(usize::MAX);
            self.of_vertex.get(vertex).copied().unwrap_or(0)
        };
        let sets = vertices.map(set);
        !sets.contains(&0) && self.intersect(sets)
    }

    fn intersect(&self, sets: [u32; 3]) -> bool {
        let [a, b, c] = sets.map(|set| {
            let set = usize::try_from(set).unwrap_or(usize::MAX);
            self.sets.get(set).map_or(&[][..], Vec::as_slice)
        });
        self.large.ring.work().add(wide(a.len()) * 20);
        let has = |set: &[u32], face| set.binary_search(face).is_ok();
        a.iter().any(|face| has(b, face) && has(c, face))
    }
}

impl<T: Int, const N: usize> Planes<T, N> {
    fn converted<S: Int>(&self, ring: &Exact<S, N>) -> Result<Planes<S, N>, Larger> {
        let number = |x: &Element<T, N>| ring.element(&self.ring.coefficients(x));
        let mut planes = Vec::new();
        for plane in &self.planes {
            planes.push(Plane {
                normal: each(&plane.normal, number)?,
                offset: number(&plane.offset)?,
            });
        }
        let ring = ring.clone();
        Ok(Planes { ring, planes })
    }

    /// The faces in which a vertex lies.
    fn faces(&self, vertices: &Vertices, vertex: u32) -> Result<Vec<u32>, Stop> {
        let ring = &self.ring;
        let point = vertices.get(vertex)?;
        let mut faces = Vec::new();
        for (plane, face) in self.planes.iter().zip(0u32..) {
            let height = ring.minus(&ring.inner(&plane.normal, &point)?, &plane.offset)?;
            let sign = ring.sign(&height)?;
            // Rule I: the vertex is in the domain.
            let value = || Value::Quotient(ring.coefficients(&height), vec![1.into()]);
            ensure!(sign != Less, VertexOutside, Place::Vertex(vertex), value());
            if sign == Equal {
                faces.push(face);
            }
        }
        ring.work().add(3 * ring.price() * wide(self.planes.len()));
        Ok(faces)
    }
}

impl<'p, const N: usize> Frame<'p, N> {
    fn new(claim: &Claim, polytope: &Polytope, ring: &'p Large<N>) -> Result<Self, Larger> {
        let k = polytope.dimension();
        let missing = claim.dimension - k.min(claim.dimension);
        let mut points = Vec::new();
        for vertex in &polytope.vertices {
            let mut point: Vector<Large<N>> = Default::default();
            for (slot, number) in point.iter_mut().skip(missing).zip(vertex) {
                *slot = ring.element(number)?;
            }
            points.push(point);
        }
        let unit = |position: usize| -> Result<Vector<Large<N>>, Larger> {
            let mut unit: Vector<Large<N>> = Default::default();
            if let Some(slot) = unit.get_mut(position) {
                *slot = ring.element(&[BigInt::from(1)])?;
            }
            Ok(unit)
        };
        // Cyclic, so that the determinant with them is the one in the coordinates of P.
        let spare = if claim.dimension == 3 {
            [unit(0)?, unit(1)?]
        } else {
            [unit(2)?, unit(0)?]
        };
        Ok(Frame {
            ring,
            points,
            spare,
        })
    }

    fn vector(&self, from: usize, to: usize) -> Result<Vector<Large<N>>, Larger> {
        let from = self.points.get(from).ok_or(Larger)?;
        self.ring
            .difference(from, self.points.get(to).ok_or(Larger)?)
    }

    /// The cross products of the triangles of a face from its first vertex.
    fn normals(&self, face: &[usize]) -> Result<Vec<Vector<Large<N>>>, Larger> {
        let [first, second] = &self.spare;
        let one = match face {
            [_] => self.ring.cross(first, second)?,
            [p, q] => self.ring.cross(first, &self.vector(*p, *q)?)?,
            _ => {
                let origin = face.first().copied().ok_or(Larger)?;
                let pairs = face.iter().skip(1).zip(face.iter().skip(2));
                let triangles = pairs.map(|(&p, &q)| {
                    let (p, q) = (self.vector(origin, p)?, self.vector(origin, q)?);
                    self.ring.cross(&p, &q)
                });
                return triangles.collect();
            }
        };
        Ok(vec![one])
    }

    /// Checks that a face is a facet of P. Returns its plane, with the inner side positive, and
    /// k! times the volume of the pyramid over it whose apex is vertex 0 of P.
    #[allow(clippy::type_complexity)]
    fn check_face(
        &self,
        f: usize,
        face: &[usize],
    ) -> Result<(Plane<Element<BigInt, N>>, Element<BigInt, N>), Stop> {
        let ring = self.ring;
        let normals = self.normals(face)?;
        let normal = normals.first().ok_or(Larger)?;
        let origin = face.first().copied().ok_or(Larger)?;
        let mut is_corner = vec![false; self.points.len()];
        for &corner in face {
            *is_corner.get_mut(corner).ok_or(Larger)? = true;
        }
        // P1: h_f is zero at the vertices of f and has one strict sign at all others, of which
        // there is one.
        let mut side = Equal;
        for (vertex, is_corner) in is_corner.into_iter().enumerate() {
            let height = ring.inner(normal, &self.vector(origin, vertex)?)?;
            let sign = ring.sign(&height)?;
            if !is_corner && side == Equal {
                side = sign;
            }
            let is_right = sign == if is_corner { Equal } else { side };
            let is_right = is_right && (is_corner || sign != Equal);
            let value = || Value::Quotient(ring.coefficients(&height), vec![1.into()]);
            ensure!(is_right, FaceNotFacet, Place::Face(f), value());
        }
        ensure!(side != Equal, FaceNotFacet, Place::Face(f));
        self.check_polygon(f, face, normal)?;
        let zero: Vector<Large<N>> = Default::default();
        let inward = |normal: &Vector<Large<N>>| {
            if side == Greater {
                Ok(normal.clone())
            } else {
                ring.difference(normal, &zero)
            }
        };
        let apex = self.vector(origin, 0)?;
        let mut pyramid = Element::default();
        for normal in &normals {
            pyramid = ring.plus(&pyramid, &ring.inner(&inward(normal)?, &apex)?)?;
        }
        let normal = inward(normal)?;
        let offset = ring.inner(&normal, self.points.get(origin).ok_or(Larger)?)?;
        Ok((Plane { normal, offset }, pyramid))
    }

    /// P2, for k = 3: the vertices of a face stand in the order of a convex polygon. For all
    /// consecutive p, q and every other t, the turn det(q - p, t - p, n) is positive. In the plane
    /// of f, (q - p) × (t - p) = λ n, and λ is positive where p, q, t turn like w_0, w_1, w_2.
    fn check_polygon(
        &self,
        f: usize,
        face: &[usize],
        normal: &Vector<Large<N>>,
    ) -> Result<(), Stop> {
        for (&p, &q) in sides(face).filter(|_| face.len() > 2) {
            for &t in face.iter().filter(|&&t| t != p && t != q) {
                let (q, t) = (self.vector(p, q)?, self.vector(p, t)?);
                let turn = self.ring.inner(&self.ring.cross(&q, &t)?, normal)?;
                let is_convex = self.ring.sign(&turn)? == Greater;
                let value = || Value::Quotient(self.ring.coefficients(&turn), vec![1.into()]);
                ensure!(is_convex, FaceNotConvex, Place::Face(f), value());
            }
            self.ring.work().check(Place::Face(f))?;
        }
        Ok(())
    }
}

/// The pairs of vertices that follow one another, cyclically.
fn sides(face: &[usize]) -> impl Iterator<Item = (&usize, &usize)> {
    face.iter().zip(face.iter().cycle().skip(1))
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
            face => sides(face)
                .map(|(&p, &q)| vec![p.min(q), p.max(q)])
                .collect(),
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

fn wide(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}
