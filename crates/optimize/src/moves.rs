//! The motions that a search allows, as affine functions of a few parameters.
//!
//! A vertex moves in the space that its stabiliser fixes, intersected with the planes of the boundary faces
//! that contain it. The other vertices of its orbit follow. The Gram matrix moves in the space of those
//! that the point group keeps, in the lattice's directions. All of this is linear and computed exactly, so
//! whatever the values of the parameters are, the symmetry and the boundary stay.
//!
//! A parameter is a coordinate of a vertex or an entry of the Gram matrix itself. So a parameter with a
//! small denominator gives short coordinates.

use crate::group::{Element, Group};
use acutile_core::checker::{Findings, check_domain};
use acutile_core::classify::Isometry;
use acutile_core::tiling::{Domain, Facet, Frame, Matching, Plane, Tiling, VertexId};
use acutile_exact::geometry::linear;
use acutile_exact::geometry::space::{Space, null_space};
use acutile_exact::number::Number;
use malachite::Rational;

/// constant + Σ parameter · vector
#[derive(Clone, Debug)]
pub struct Affine<const N: usize> {
    pub constant: [Number; N],
    pub terms: Vec<(usize, [Number; N])>,
}

/// A tiling that depends on parameters.
#[derive(Clone, Debug)]
pub struct Moves {
    /// The values of the start.
    pub start: Vec<Number>,
    /// The coordinates of each vertex.
    pub vertices: Vec<Affine<3>>,
    /// The Gram matrix, by the entries of `ENTRIES`.
    pub gram: Affine<6>,
}

/// Rows and columns of the entries of a symmetric matrix.
pub const ENTRIES: [(usize, usize); 6] = [(2, 2), (1, 2), (1, 1), (0, 2), (0, 1), (0, 0)];

/// The parts that may move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Freedom {
    /// Whether the Gram matrix may change.
    pub lattice: bool,
    /// Whether vertices in the boundary may move in its planes.
    pub boundary: bool,
}

impl Moves {
    /// The motions that keep a group, the combinatorics and the boundary.
    pub fn of(tiling: &Tiling<3>, matching: &Matching<3>, group: &Group, freedom: Freedom) -> Self {
        let normals = normals(tiling, matching);
        let mut start = Vec::new();
        let gram = gram(&tiling.frame, group, freedom.lattice, &mut start);
        let mut moves = Moves {
            start,
            vertices: Vec::new(),
            gram,
        };
        let mut vertices: Vec<Option<Affine<3>>> = vec![None; tiling.vertices.len()];
        for vertex in 0..vertices.len() {
            if vertices[vertex].is_some() {
                continue;
            }
            let is_fixed = !normals[vertex].is_empty() && !freedom.boundary;
            let first = if is_fixed {
                constant(tiling.vertices.vertex(VertexId::at(vertex)))
            } else {
                moves.orbit(tiling, vertex, group, &normals[vertex])
            };
            for element in &group.elements {
                let image = element.images[vertex];
                let slot = &mut vertices[image.vertex.index()];
                if slot.is_none() {
                    *slot = Some(moved(&first, element, image.shift));
                }
            }
        }
        // The identity is an element, so that each vertex is reached.
        moves.vertices = vertices.into_iter().flatten().collect();
        moves
    }

    /// The coordinates of the first vertex of an orbit, with new parameters.
    fn orbit(
        &mut self,
        tiling: &Tiling<3>,
        vertex: usize,
        group: &Group,
        normals: &[[Number; 3]],
    ) -> Affine<3> {
        let mut rows: Vec<Vec<Number>> = normals.iter().map(|n| n.to_vec()).collect();
        let one = Isometry::<3>::identity().linear;
        let fixes = |e: &&Element| e.images[vertex].vertex.index() == vertex;
        for element in group.elements.iter().filter(fixes) {
            for (row, unit) in element.isometry.linear.iter().zip(&one) {
                rows.push((0..3).map(|k| &row[k] - &unit[k]).collect());
            }
        }
        let point = tiling.vertices.vertex(VertexId::at(vertex));
        affine(point, &null_space(rows, 3), &mut self.start)
    }

    /// The number of parameters.
    pub fn len(&self) -> usize {
        self.start.len()
    }

    /// Whether nothing can move.
    pub fn is_empty(&self) -> bool {
        self.start.is_empty()
    }

    /// The tiling for these values of the parameters.
    pub fn tiling(&self, like: &Tiling<3>, parameters: &[Number]) -> Tiling<3> {
        let entries = self.gram.at(parameters);
        let mut gram = like.frame.gram.clone();
        for (entry, (i, j)) in entries.into_iter().zip(ENTRIES) {
            gram[i][j] = entry.clone();
            gram[j][i] = entry;
        }
        Tiling {
            frame: Frame {
                gram,
                ..like.frame.clone()
            },
            vertices: self.vertices.iter().map(|v| v.at(parameters)).collect(),
            corners: like.corners.clone(),
        }
    }
}

impl<const N: usize> Affine<N> {
    /// The value for these parameters.
    pub fn at(&self, parameters: &[Number]) -> [Number; N] {
        let mut value = self.constant.clone();
        for (parameter, vector) in &self.terms {
            for (x, v) in value.iter_mut().zip(vector) {
                *x = &*x + &(&parameters[*parameter] * v);
            }
        }
        value
    }
}

fn constant(point: [Number; 3]) -> Affine<3> {
    Affine {
        constant: point,
        terms: Vec::new(),
    }
}

/// `point` plus the vectors of a space. The parameters, which are appended to `start`, are the free
/// coordinates of the point.
fn affine<const N: usize>(point: [Number; N], space: &Space, start: &mut Vec<Number>) -> Affine<N> {
    let mut constant = point.clone();
    let mut terms = Vec::new();
    for (&free, vector) in space.free.iter().zip(&space.basis) {
        let value = &point[free];
        for (x, v) in constant.iter_mut().zip(vector) {
            *x = &*x - &(value * v);
        }
        let vector = std::array::from_fn(|k| vector[k].clone());
        terms.push((start.len(), vector));
        start.push(value.clone());
    }
    Affine { constant, terms }
}

/// The image of a moving vertex under an isometry, back by a lattice vector.
fn moved(first: &Affine<3>, element: &Element, shift: [i32; 3]) -> Affine<3> {
    let image = element.isometry.image(&first.constant);
    let terms = first.terms.iter();
    Affine {
        constant: std::array::from_fn(|k| &image[k] - &Number::from(Rational::from(shift[k]))),
        terms: terms
            .map(|(k, v)| (*k, linear::apply(&element.isometry.linear, v)))
            .collect(),
    }
}

/// The Gram matrices that the group keeps. The scale of all of space is no parameter.
fn gram(frame: &Frame<3>, group: &Group, is_free: bool, start: &mut Vec<Number>) -> Affine<6> {
    let entries = ENTRIES.map(|(i, j)| frame.gram[i][j].clone());
    let rank = match frame.domain {
        Domain::Region(_) => 0,
        _ => frame.rank(),
    };
    if !is_free || rank == 0 {
        return Affine {
            constant: entries,
            terms: Vec::new(),
        };
    }
    let unit = |k: usize| {
        (0..6)
            .map(|l| Number::from(Rational::from(u8::from(k == l))))
            .collect()
    };
    let mut rows: Vec<Vec<Number>> = Vec::new();
    for (k, (i, j)) in ENTRIES.into_iter().enumerate() {
        let is_scale = rank == 3 && (i, j) == (0, 0);
        if i.max(j) >= rank || is_scale {
            rows.push(unit(k));
        }
    }
    // The scale is kept by keeping the first entry, so the rows above are part of the equations for the
    // differences of Gram matrices.
    for element in &group.elements {
        rows.extend(differences(&element.isometry.linear));
    }
    affine(entries, &null_space(rows, 6), start)
}

/// The six equations M^T G M = G in the entries of G.
fn differences(linear: &[[Number; 3]; 3]) -> Vec<Vec<Number>> {
    let coefficient = |(i, j): (usize, usize), (k, l): (usize, usize)| {
        let term = |k: usize, l: usize| &linear[k][i] * &linear[l][j];
        let image = if k == l {
            term(k, l)
        } else {
            term(k, l) + term(l, k)
        };
        let same = Number::from(Rational::from(u8::from((i, j) == (k, l))));
        image - same
    };
    ENTRIES
        .into_iter()
        .map(|row| {
            ENTRIES
                .into_iter()
                .map(|column| coefficient(row, column))
                .collect()
        })
        .collect()
}

/// For each vertex the covectors that its motions must vanish on. They are normals of the faces of the
/// domain that contain it. In a region they are normals of the boundary facets at it.
fn normals(tiling: &Tiling<3>, matching: &Matching<3>) -> Vec<Vec<[Number; 3]>> {
    let mut normals = vec![Vec::new(); tiling.vertices.len()];
    if tiling.frame.domain.is_region() {
        for facet in tiling.facets().filter(|f| matching.neighbour(*f).is_none()) {
            let (corners, normal) = facet_normal(tiling, facet);
            for vertex in corners {
                let list: &mut Vec<[Number; 3]> = &mut normals[vertex.index()];
                if !list.contains(&normal) {
                    list.push(normal.clone());
                }
            }
        }
        return normals;
    }
    // Data that describe no polytope were refused.
    let planes = check_domain(tiling, &mut Findings::new(0));
    let rank = tiling.frame.rank();
    for plane in planes {
        let normal = covector(&plane, rank);
        for (vertex, point) in tiling.vertices.iter().enumerate() {
            if plane.value(tiling.frame.cross_section(&point)).is_zero() {
                normals[vertex].push(normal.clone());
            }
        }
    }
    normals
}

/// The covector of a plane, which is about the last coordinates.
fn covector(plane: &Plane, rank: usize) -> [Number; 3] {
    std::array::from_fn(|k| match k.checked_sub(rank) {
        Some(k) => plane.normal()[k].clone(),
        None => Number::zero(),
    })
}

/// The vertices of a facet, and a covector that vanishes on it, scaled so that equal planes give equal
/// covectors.
fn facet_normal(tiling: &Tiling<3>, facet: Facet) -> (Vec<VertexId>, [Number; 3]) {
    let corners: Vec<_> = tiling
        .simplex(facet.simplex)
        .iter()
        .enumerate()
        .filter(|(k, _)| *k != usize::from(facet.opposite))
        .map(|(_, corner)| corner)
        .collect();
    let points: Vec<[Number; 3]> = corners.iter().map(|c| tiling.position(c)).collect();
    let edge = |k: usize| linear::subtract(&points[k], &points[0]);
    let normal = linear::cross(&edge(1), &edge(2));
    let scale = normal.iter().find_map(Number::inverse);
    let normal = match scale {
        Some(scale) => normal.map(|x| &x * &scale),
        None => normal,
    };
    (corners.iter().map(|c| c.vertex).collect(), normal)
}
