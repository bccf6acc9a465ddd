//! Right prisms over a regular triangle and a regular pentagon: the 600-cell without a bipyramid.
//!
//! Two cells with a common triangle form a bipyramid over a triangle, and the five cells at an edge one
//! over a pentagon. The tetrahedra without a vertex of it triangulate the dual polyhedron, a prism. Each
//! vertex of the ring belongs to a side, and each apex to an end.
//!
//! In the basis are the directions of two successive sides, of length 1, and the axis. A side has the distance 1
//! from the axis. A vertex is named by its inner products with the vertices of the bipyramid, and rotations
//! and reflections permute these names along with the directions.

use super::piece::{UNIT, rank_of};
use super::prism_tables::{Orbit, Outward, PENTAGON, PENTAGON_HEIGHT, TRIANGLE, TRIANGLE_HEIGHT};
use super::without;
use crate::CatalogError;
use crate::recipe::fraction;
use acutile_core::tiling::{Domain, Frame, Polytope, Tiling};
use acutile_exact::geometry::cell600::{self, Golden};
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};
use std::collections::HashMap;

type Built = Result<Tiling<3>, CatalogError>;
type Vertices = [[Golden; 4]];

/// The prism over a regular triangle.
pub fn prism_533() -> Built {
    let shape = Shape {
        field: Field::rationals(),
        sides: 3,
        twice_cosine: fraction(-1, 1),
        radius: fraction(2, 1),
        height: TRIANGLE_HEIGHT,
    };
    let vertices = cell600::vertices();
    let [a, b, c, _] = cell600::cells()[0];
    let ring = vec![a, b, c];
    let apices = adjacent_to_all(&vertices, &ring);
    shape.tiling(&vertices, &ring, &apices, TRIANGLE)
}

/// The prism over a regular pentagon. 2 cos 72° is φ - 1, and the corners have the distance 1/cos 36°, 2φ - 2.
pub fn pentagonal_prism_515() -> Built {
    let polynomial = [-1, -1, 1].map(Integer::from);
    let (field, phi) = Field::adjoin_root(&polynomial, Rational::from(1), Rational::from(2))?;
    let twice_cosine = &phi - &fraction(1, 1);
    let shape = Shape {
        field,
        sides: 5,
        radius: &twice_cosine + &twice_cosine,
        twice_cosine,
        height: PENTAGON_HEIGHT,
    };
    let vertices = cell600::vertices();
    let [a, b, _, _] = cell600::cells()[0];
    let apices = vec![a, b];
    let ring = in_a_ring(&vertices, adjacent_to_all(&vertices, &apices));
    shape.tiling(&vertices, &ring, &apices, PENTAGON)
}

fn are_adjacent(vertices: &Vertices, v: usize, w: usize) -> bool {
    cell600::inner(&vertices[v], &vertices[w]) == [0, 2]
}

fn adjacent_to_all(vertices: &Vertices, set: &[usize]) -> Vec<usize> {
    let is_adjacent = |v: &usize| set.iter().all(|w| are_adjacent(vertices, *v, *w));
    (0..vertices.len()).filter(is_adjacent).collect()
}

/// The vertices of a cycle, each adjacent to the next.
fn in_a_ring(vertices: &Vertices, mut rest: Vec<usize>) -> Vec<usize> {
    let mut ring: Vec<usize> = rest.pop().into_iter().collect();
    while let Some(next) = ring
        .last()
        .and_then(|last| rest.iter().position(|v| are_adjacent(vertices, *v, *last)))
    {
        ring.push(rest.swap_remove(next));
    }
    ring
}

/// A right prism over a regular polygon.
struct Shape {
    field: Field,
    sides: usize,
    /// Twice the cosine of the angle between the directions of two successive sides.
    twice_cosine: Number,
    /// The distance of the corners from the axis.
    radius: Number,
    /// Half the height, in units.
    height: i64,
}

impl Shape {
    fn tiling(
        &self,
        vertices: &Vertices,
        ring: &[usize],
        apices: &[usize],
        table: &[Orbit],
    ) -> Built {
        let removed = [ring, apices].concat();
        let positions = self.positions(table);
        let position = |vertex: usize| {
            let ranks = removed.iter().map(|&other| {
                let product = cell600::inner(&vertices[vertex], &vertices[other]);
                rank_of(product).ok_or(CatalogError::Degenerate)
            });
            let place = ranks.collect::<Result<Vec<i8>, _>>()?;
            let found = positions.get(&place).cloned();
            found.ok_or(CatalogError::NoOrbit(place))
        };
        let tetrahedra: Result<Vec<Vec<_>>, CatalogError> = without(&removed)
            .into_iter()
            .map(|cell| cell.into_iter().map(position).collect())
            .collect();
        let frame = self.frame().with_domain(Domain::Solid(self.hull()));
        Ok(Tiling::from_positions(frame, &tetrahedra?))
    }

    fn frame(&self) -> Frame<3> {
        let cosine = &self.twice_cosine * &fraction(1, 2);
        let (one, zero) = (|| fraction(1, 1), Number::zero);
        let gram = [
            [one(), cosine.clone(), zero()],
            [cosine, one(), zero()],
            [zero(), zero(), one()],
        ];
        Frame::space(self.field.clone(), gram)
    }

    /// The direction of each side: each is the last one turned, d_k+1 = 2 cos · d_k - d_k-1.
    fn directions(&self) -> Vec<[Number; 2]> {
        let (one, zero) = (|| fraction(1, 1), Number::zero);
        let mut all = vec![[one(), zero()], [zero(), one()]];
        for k in 1..self.sides - 1 {
            let next = [0, 1].map(|i| &(&self.twice_cosine * &all[k][i]) - &all[k - 1][i]);
            all.push(next);
        }
        all
    }

    /// The positions of all vertices by their names.
    fn positions(&self, table: &[Orbit]) -> HashMap<Vec<i8>, [Number; 3]> {
        let n = self.sides;
        let directions = self.directions();
        let mut positions = HashMap::new();
        for orbit in table {
            let outward = match orbit.outward {
                Outward::Part(units) => fraction(units, UNIT),
                Outward::Corner => -self.radius.clone(),
            };
            for (turn, is_mirrored, is_turned_over) in images(n) {
                // The side j goes to the side turn + j, or turn - j.
                let image = |j: usize| {
                    if is_mirrored {
                        (turn + n - j) % n
                    } else {
                        (turn + j) % n
                    }
                };
                let mut place = orbit.place.to_vec();
                for j in 0..n {
                    place[image(j)] = orbit.place[j];
                }
                let mut height = fraction(orbit.height, UNIT);
                if is_turned_over {
                    place.swap(n, n + 1);
                    height = -height;
                }
                let sideways = fraction(orbit.sideways, UNIT);
                let [x, y] = [0, 1].map(|i| {
                    let along = &directions[image(1)][i] - &directions[image(n - 1)][i];
                    &(&outward * &directions[turn][i]) + &(&sideways * &along)
                });
                positions.insert(place, [x, y, height]);
            }
        }
        positions
    }

    /// Corner k is opposite to side k. Successive directions are those of sides that meet.
    fn hull(&self) -> Polytope {
        let n = self.sides;
        let corner = |[x, y]: &[Number; 2], sign: i64| {
            let opposite = |x: &Number| -(&self.radius * x);
            vec![opposite(x), opposite(y), fraction(sign * self.height, UNIT)]
        };
        let directions = self.directions();
        let at = |sign: i64| directions.iter().map(move |d| corner(d, sign));
        let side = |k: usize| vec![k, (k + 1) % n, n + (k + 1) % n, n + k];
        let mut faces = vec![(0..n).collect(), (n..2 * n).collect()];
        faces.extend((0..n).map(side));
        Polytope {
            vertices: at(1).chain(at(-1)).collect(),
            faces,
        }
    }
}

/// Rotations about the axis, with and without a reflection, and with the ends exchanged or not.
fn images(sides: usize) -> impl Iterator<Item = (usize, bool, bool)> {
    (0..sides).flat_map(|turn| {
        let flags = [(false, false), (false, true), (true, false), (true, true)];
        flags.map(|(is_mirrored, is_turned_over)| (turn, is_mirrored, is_turned_over))
    })
}
