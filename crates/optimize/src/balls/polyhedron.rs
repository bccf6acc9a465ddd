//! A polyhedron for a set that is removed from the 600-cell, with the remaining cells in it.
//!
//! Where the polyhedron is given, its corners are those of the set in all ways that differ. Otherwise
//! the corners are projected stereographically from the middle of the set. Each face gets the plane that is nearest
//! to its corners, rounded. Three planes meet in a corner. The other vertices go to the middle of their neighbours.
//! Those in an edge or a face get rational weights of corners, so that they lie in it exactly.
//! Doubles only propose; whether the result is a tiling is the business of the prover.

use super::relax::relax;
use super::remains::Remains;
use super::target::Target;
use acutile_core::tiling::{Domain, Frame, Polytope, Tiling};
use acutile_exact::geometry::cell600::{self, Golden};
use acutile_exact::geometry::linear::{cross, dot};
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::{BTreeMap, BTreeSet};

/// Coordinates and weights are multiples of 1 over this.
const DENOMINATOR: i64 = 10_000;

type Point = [f64; 3];
type Exact = [Number; 3];

/// A polyhedron with the remaining cells, which may be turned inside out. `None` if the ridges are not the
/// edges of a convex polyhedron with three faces at each corner.
pub fn placed(remains: &Remains, removed: &[usize]) -> Option<Tiling<3>> {
    let skeleton = Skeleton::of(remains)?;
    let points = projected(removed);
    let corners = corners_of_planes(&skeleton, &points)?;
    Solid::new(Frame::cubic(), corners).filled(remains, &skeleton, points)
}

/// The given polyhedron with the remaining cells, once for each way in which the ridges are its edges.
pub fn placed_in(remains: &Remains, removed: &[usize], target: &Target) -> Vec<Tiling<3>> {
    let Some(skeleton) = Skeleton::of(remains) else {
        return Vec::new();
    };
    let faces: Vec<Vec<usize>> = (0..skeleton.count)
        .map(|face| skeleton.corners_in(&[face]))
        .collect();
    let placements = target.placements(skeleton.corners.len(), &faces);
    let tiling = |images: Vec<usize>| {
        let corners = images.iter().map(|v| target.corners[*v].clone()).collect();
        let frame = Frame::space(target.field.clone(), target.gram.clone());
        Solid::new(frame, corners).filled(remains, &skeleton, projected(removed))
    };
    placements.into_iter().filter_map(tiling).collect()
}

/// Which faces each vertex of the boundary lies in. Ridges are the edges, and three faces or more meet at each corner.
struct Skeleton {
    /// Sets of faces, sorted: one face, the two at an edge, three or more at a corner.
    faces_at: BTreeMap<usize, Vec<usize>>,
    corners: Vec<usize>,
    /// The ends of edges at corners: two for each edge.
    ends: usize,
    count: usize,
}

impl Skeleton {
    fn of(remains: &Remains) -> Option<Self> {
        let labels = remains.faces();
        let names: BTreeSet<usize> = labels.iter().copied().collect();
        let number: BTreeMap<usize, usize> = names.into_iter().zip(0..).collect();
        let mut faces_at: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        for (triangle, label) in remains.triangles.iter().zip(&labels) {
            for vertex in triangle {
                faces_at.entry(*vertex).or_default().insert(number[label]);
            }
        }
        let mut degrees: BTreeMap<usize, usize> = BTreeMap::new();
        for (a, b) in remains.ridges() {
            *degrees.entry(*a).or_default() += 1;
            *degrees.entry(*b).or_default() += 1;
        }
        // Inside of a face no ridge ends, through an edge two pass, and at a corner as many meet as faces.
        let expected = |vertex: &usize| degrees.get(vertex).copied().unwrap_or(0).max(1);
        let is_regular = faces_at.iter().all(|(v, faces)| expected(v) == faces.len());
        let at_corners = faces_at.iter().filter(|(_, faces)| faces.len() >= 3);
        let ends = at_corners.clone().map(|(_, faces)| faces.len()).sum();
        let corners: Vec<usize> = at_corners.map(|(vertex, _)| *vertex).collect();
        let skeleton = Skeleton {
            faces_at: faces_at
                .into_iter()
                .map(|(vertex, faces)| (vertex, faces.into_iter().collect()))
                .collect(),
            corners,
            ends,
            count: number.len(),
        };
        (is_regular && skeleton.is_polyhedral()).then_some(skeleton)
    }

    /// Euler's formula, three or more corners in each face, and two in each edge.
    fn is_polyhedral(&self) -> bool {
        let in_edges = self.faces_at.values().filter(|faces| faces.len() == 2);
        2 * self.count + 2 * self.corners.len() == self.ends + 4
            && (0..self.count).all(|face| self.corners_in(&[face]).len() >= 3)
            && in_edges
                .into_iter()
                .all(|pair| self.corners_in(pair).len() == 2)
    }

    /// The corners that lie in all of these faces, by their places.
    fn corners_in(&self, faces: &[usize]) -> Vec<usize> {
        let is_in = |vertex: usize| faces.iter().all(|f| self.faces_at[&vertex].contains(f));
        (0..self.corners.len())
            .filter(|c| is_in(self.corners[*c]))
            .collect()
    }

    /// The corners of a face in cyclic order: successive ones have an edge in common.
    fn cycle(&self, face: usize) -> Option<Vec<usize>> {
        let mut rest = self.corners_in(&[face]);
        let are_joined = |a: usize, b: usize| {
            let [a, b] = [a, b].map(|c| &self.faces_at[&self.corners[c]]);
            a.iter().filter(|f| b.contains(f)).count() == 2
        };
        let mut cycle = vec![rest.pop()?];
        while let Some(last) = cycle.last().filter(|_| !rest.is_empty()) {
            let next = rest.iter().position(|c| are_joined(*c, *last))?;
            cycle.push(rest.swap_remove(next));
        }
        Some(cycle)
    }
}

/// The corners of planes n · x = 1 near those of the faces. `None` if the planes enclose no convex
/// polyhedron with these corners, or if not exactly three planes meet in a corner.
fn corners_of_planes(skeleton: &Skeleton, points: &[Point]) -> Option<Vec<Exact>> {
    let normal = |face: usize| {
        let corners = skeleton.corners_in(&[face]);
        let near: Vec<Point> = corners
            .iter()
            .map(|c| points[skeleton.corners[*c]])
            .collect();
        Some(rounded(nearest_plane(&near)?))
    };
    let normals: Vec<Exact> = (0..skeleton.count).map(normal).collect::<Option<_>>()?;
    let corner = |vertex: &usize| {
        let [a, b, c] = skeleton.faces_at[vertex][..] else {
            return None;
        };
        meeting_point([&normals[a], &normals[b], &normals[c]])
    };
    let corners: Vec<Exact> = skeleton.corners.iter().map(corner).collect::<Option<_>>()?;
    let one = Number::from(Rational::from(1));
    let is_below = |corner: &Exact, vertex: &usize| {
        let others = (0..normals.len()).filter(|f| !skeleton.faces_at[vertex].contains(f));
        others.into_iter().all(|f| dot(&normals[f], corner) < one)
    };
    let mut pairs = corners.iter().zip(&skeleton.corners);
    let is_convex = pairs.all(|(corner, vertex)| is_below(corner, vertex));
    is_convex.then_some(corners)
}

/// A polyhedron by its corners, in the order of the skeleton.
struct Solid {
    frame: Frame<3>,
    corners: Vec<Exact>,
}

impl Solid {
    fn new(frame: Frame<3>, corners: Vec<Exact>) -> Self {
        Solid { frame, corners }
    }

    /// The polyhedron with the remaining cells. `points` are where the vertices begin.
    fn filled(
        self,
        remains: &Remains,
        skeleton: &Skeleton,
        points: Vec<Point>,
    ) -> Option<Tiling<3>> {
        let mut points: BTreeMap<usize, Point> = points.into_iter().enumerate().collect();
        for (vertex, corner) in skeleton.corners.iter().zip(&self.corners) {
            points.insert(*vertex, corner.each_ref().map(Number::approximate));
        }
        relax(remains, &skeleton.faces_at, &mut points);
        let mut positions: BTreeMap<usize, Exact> = BTreeMap::new();
        for vertex in remains.cells.iter().flatten() {
            if !positions.contains_key(vertex) {
                positions.insert(*vertex, self.position(skeleton, *vertex, &points)?);
            }
        }
        let cells = remains.cells.iter();
        let tetrahedra: Vec<Vec<Exact>> = cells
            .map(|cell| cell.iter().map(|v| positions[v].clone()).collect())
            .collect();
        let domain = Domain::Solid(self.polytope(skeleton)?);
        Some(Tiling::from_positions(
            self.frame.with_domain(domain),
            &tetrahedra,
        ))
    }

    fn polytope(&self, skeleton: &Skeleton) -> Option<Polytope> {
        let faces = (0..skeleton.count).map(|face| skeleton.cycle(face));
        Some(Polytope {
            vertices: self.corners.iter().map(|corner| corner.to_vec()).collect(),
            faces: faces.collect::<Option<_>>()?,
        })
    }

    /// Near the point of a vertex, and in its faces.
    fn position(
        &self,
        skeleton: &Skeleton,
        vertex: usize,
        points: &BTreeMap<usize, Point>,
    ) -> Option<Exact> {
        let Some(faces) = skeleton.faces_at.get(&vertex) else {
            return Some(rounded(points[&vertex]));
        };
        let corners: Vec<&Exact> = skeleton
            .corners_in(faces)
            .into_iter()
            .map(|corner| &self.corners[corner])
            .collect();
        let first = corners[0];
        let mut position = first.clone();
        let others = &corners[1..corners.len().min(3)];
        for (corner, weight) in others.iter().zip(weights(first, others, points[&vertex])?) {
            let weight = fraction(weight);
            for k in 0..3 {
                position[k] = &position[k] + &(&weight * &(&corner[k] - &first[k]));
            }
        }
        Some(position)
    }
}

/// The weights of one or two directions from the first corner for which the point is nearest to `to`.
fn weights(first: &Exact, others: &[&Exact], to: Point) -> Option<Vec<f64>> {
    let origin = first.each_ref().map(Number::approximate);
    let from = |p: Point| [0, 1, 2].map(|k| p[k] - origin[k]);
    let target = from(to);
    let directions = others
        .iter()
        .map(|c| from(c.each_ref().map(Number::approximate)));
    let directions: Vec<Point> = directions.collect();
    match directions[..] {
        [] => Some(Vec::new()),
        [d] => Some(vec![dot(&d, &target) / dot(&d, &d)]),
        [d, e] => {
            let (dd, de, ee) = (dot(&d, &d), dot(&d, &e), dot(&e, &e));
            let (dt, et) = (dot(&d, &target), dot(&e, &target));
            let determinant = dd * ee - de * de;
            let is_regular = determinant > 0.0;
            is_regular.then(|| {
                let x = (dt * ee - et * de) / determinant;
                let y = (et * dd - dt * de) / determinant;
                vec![x, y]
            })
        }
        _ => None,
    }
}

/// The n for which n · p is nearest to 1 in the mean square.
fn nearest_plane(points: &[Point]) -> Option<Point> {
    let sum = |i: usize, j: usize| points.iter().map(|p| p[i] * p[j]).sum::<f64>();
    let rows: [Point; 3] = std::array::from_fn(|i| std::array::from_fn(|j| sum(i, j)));
    let right: Point = std::array::from_fn(|i| points.iter().map(|p| p[i]).sum());
    let [a, b, c] = &rows;
    let cofactors = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(a, &cofactors[0]);
    let solution = |k: usize| (0..3).map(|i| cofactors[i][k] * right[i]).sum::<f64>() / determinant;
    (determinant != 0.0).then(|| [0, 1, 2].map(solution))
}

/// The common point of three planes n · x = 1.
fn meeting_point([a, b, c]: [&Exact; 3]) -> Option<Exact> {
    let parts = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(a, &parts[0]);
    let sum = |k: usize| &(&parts[0][k] + &parts[1][k]) + &parts[2][k];
    let [x, y, z] = [0, 1, 2].map(|k| sum(k).divide(&determinant));
    Some([x?, y?, z?])
}

fn fraction(x: f64) -> Number {
    let steps = (x * DENOMINATOR as f64).round() as i64;
    Number::from(Rational::from_signeds(steps, DENOMINATOR))
}

fn rounded(point: Point) -> Exact {
    point.map(fraction)
}

/// All vertices, projected from the middle of some of them to space, with distances of about 1 at the boundary.
fn projected(removed: &[usize]) -> Vec<Point> {
    let double = |[a, b]: Golden| (f64::from(a) + f64::from(b) * (1.0 + 5f64.sqrt()) / 2.0) / 2.0;
    let vertices: Vec<[f64; 4]> = cell600::vertices().iter().map(|v| v.map(double)).collect();
    let middle: [f64; 4] = std::array::from_fn(|k| removed.iter().map(|v| vertices[*v][k]).sum());
    let length = dot(&middle, &middle).sqrt();
    let pole = middle.map(|x| x / length);
    // The reflection that exchanges the pole and an axis maps the other axes to a basis of space.
    let axis = [1.0, 0.0, 0.0, 0.0];
    let mirror: [f64; 4] = std::array::from_fn(|k| pole[k] - axis[k]);
    let square = dot(&mirror, &mirror);
    vertices
        .iter()
        .map(|vertex| {
            let scale = if square > 0.0 {
                2.0 * dot(&mirror, vertex) / square
            } else {
                0.0
            };
            let image: [f64; 4] = std::array::from_fn(|k| vertex[k] - scale * mirror[k]);
            let nearness = 1.0 - image[0];
            [1, 2, 3].map(|k| SIZE * image[k] / nearness)
        })
        .collect()
}

/// The boundary is at a distance of two or three units from the middle of a projection from the unit sphere.
const SIZE: f64 = 0.5;
