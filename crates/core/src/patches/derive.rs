//! The patch of a tile, taken from a tiling of space over the mosaic of this tile alone.
//!
//! A rule defines the points over a mosaic; their Delaunay triangulation is computed for the simplest
//! mosaic, in which every tile is this one. A tetrahedron whose corners lie in the prism over the tile
//! belongs to its piece. Any other one with a corner in the interior of the prism must have two corners in
//! one of its sides, and one beyond it. Those with the same two corners off the side are around the axis of
//! a join. So they give a polygon in the side, and the apex over it.

use super::{Patch, Pyramid};
use crate::tiling::{Corner, Plane, Polytope, Tiling, VertexId, cell_of, difference};
use acutile_exact::geometry::{RingElement, Sign, Simplex};
use acutile_exact::number::Number;
use std::collections::BTreeSet;
use std::fmt;

/// Why a tile has no patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeriveError {
    /// The tile is flat.
    Tile,
    /// A tetrahedron crosses a side in another way than a join does.
    Crossing,
    /// The tetrahedra around an axis form no cycle.
    Axis,
    /// A point is more than [`CELL_LIMIT`](crate::tiling::CELL_LIMIT) cells away from the origin.
    Far,
}

impl fmt::Display for DeriveError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            DeriveError::Tile => "the tile is flat",
            DeriveError::Crossing => "a tetrahedron is neither in the tile nor around an axis",
            DeriveError::Axis => "the tetrahedra around an axis form no cycle",
            DeriveError::Far => "a point is more than 2^29 cells away from the origin",
        })
    }
}

impl std::error::Error for DeriveError {}

/// The patch of the tile with this cross-section. `images` are the basis vectors of the tiling in
/// the coordinates of the system, and `rank` is that of its lattice.
///
/// # Errors
/// [`DeriveError`].
pub fn derive(
    tiling: &Tiling<3>,
    images: &[[Number; 3]; 3],
    rank: usize,
    tile: &Polytope,
    offsets: Vec<Vec<Number>>,
) -> Result<Patch, DeriveError> {
    let sides = (0..tile.faces.len()).map(|side| tile.plane(side));
    let sides: Vec<Plane> = sides.collect::<Option<_>>().ok_or(DeriveError::Tile)?;
    let mut finder = Finder {
        rank,
        sides,
        vertices: Vec::new(),
        rows: BTreeSet::new(),
        axes: Vec::new(),
    };
    for corners in translates(tiling, images, rank) {
        finder.add(&corners)?;
    }
    let simplices = finder.rows.iter().copied().collect();
    let simplices: Vec<[Corner<3>; 4]> = simplices;
    let axes = std::mem::take(&mut finder.axes);
    let pyramids = axes.iter().map(|axis| finder.pyramid(axis));
    let mut pyramids: Vec<Pyramid> = pyramids.collect::<Result<_, _>>()?;
    pyramids.sort_unstable();
    Ok(Patch {
        offsets,
        simplices: simplices.iter().map(|row| finder.positive(*row)).collect(),
        pyramids,
        vertices: finder.vertices,
    })
}

/// Translates of all tetrahedra by lattice vectors that move the base, in the coordinates of the
/// system.
fn translates(tiling: &Tiling<3>, images: &[[Number; 3]; 3], rank: usize) -> Vec<[[Number; 3]; 4]> {
    const FAR: i64 = 2;
    let image = |x: &[Number; 3]| -> [Number; 3] {
        std::array::from_fn(|k| {
            (0..3).fold(Number::zero(), |sum, i| &sum + &(&x[i] * &images[i][k]))
        })
    };
    let integer = |n: i64| tiling.frame.field.integer(n);
    let steps = |i: usize| {
        let is_still = images[i][rank..].iter().all(Number::is_zero);
        if is_still { 0..=0 } else { -FAR..=FAR }
    };
    let moves = steps(0).flat_map(|a| steps(1).map(move |b| (a, b)));
    let moves = moves.flat_map(|(a, b)| steps(2).map(move |c| [a, b, c]));
    let moves: Vec<[Number; 3]> = moves.map(|m| image(&m.map(integer))).collect();
    let mut translates = Vec::new();
    for simplex in tiling.simplices() {
        let corners: [[Number; 3]; 4] =
            std::array::from_fn(|k| image(&tiling.position(&simplex[k])));
        translates.extend(moves.iter().map(|m| {
            corners
                .each_ref()
                .map(|x| std::array::from_fn(|k| &x[k] + &m[k]))
        }));
    }
    translates
}

struct Finder {
    rank: usize,
    sides: Vec<Plane>,
    /// With lattice coordinates from 0 to 1.
    vertices: Vec<[Number; 3]>,
    /// Sorted corners, seen from the first.
    rows: BTreeSet<[Corner<3>; 4]>,
    axes: Vec<Axis>,
}

/// The tetrahedra of a join, seen from the apex in the tile.
struct Axis {
    side: usize,
    apex: VertexId,
    beyond: [Number; 3],
    edges: BTreeSet<[Corner<3>; 2]>,
}

/// Where a point is.
enum Place {
    Interior,
    /// In some sides of the prism.
    Sides(Vec<usize>),
    Outside,
}

impl Finder {
    fn place(&self, point: &[Number; 3]) -> Place {
        let mut sides = Vec::new();
        for (side, plane) in self.sides.iter().enumerate() {
            match plane.value(&point[self.rank..]).sign() {
                Sign::Less => return Place::Outside,
                Sign::Equal => sides.push(side),
                Sign::Greater => {}
            }
        }
        if sides.is_empty() {
            Place::Interior
        } else {
            Place::Sides(sides)
        }
    }

    /// Sorts a tetrahedron into the piece or to an axis; one that has neither is left out.
    fn add(&mut self, corners: &[[Number; 3]; 4]) -> Result<(), DeriveError> {
        let (mut inner, mut flat, mut outer) = (Vec::new(), Vec::new(), Vec::new());
        for corner in corners {
            match self.place(corner) {
                Place::Interior => inner.push(corner),
                Place::Sides(sides) => flat.push((corner, sides)),
                Place::Outside => outer.push(corner),
            }
        }
        if outer.is_empty() {
            let [a, b, c, d] = corners;
            let row = [
                self.corner(a)?,
                self.corner(b)?,
                self.corner(c)?,
                self.corner(d)?,
            ];
            self.rows.insert(seen_from_first(row));
            return Ok(());
        }
        if inner.is_empty() {
            return Ok(());
        }
        let ([apex], [(one, sides), (other, more)], [beyond]) =
            (inner.as_slice(), flat.as_slice(), outer.as_slice())
        else {
            return Err(DeriveError::Crossing);
        };
        let shared = sides.iter().find(|side| {
            more.contains(side)
                && self.sides[**side]
                    .value(&beyond[self.rank..])
                    .sign()
                    .is_lt()
        });
        let side = *shared.ok_or(DeriveError::Crossing)?;
        self.add_to_axis(side, apex, beyond, [one, other])
    }

    fn add_to_axis(
        &mut self,
        side: usize,
        apex: &[Number; 3],
        beyond: &[Number; 3],
        edge: [&[Number; 3]; 2],
    ) -> Result<(), DeriveError> {
        let apex = self.corner(apex)?;
        let back = apex.shift.map(|s| -s);
        let mut edge = [
            self.corner(edge[0])?.moved(back),
            self.corner(edge[1])?.moved(back),
        ];
        edge.sort_unstable();
        let beyond = std::array::from_fn(|k| &beyond[k] + &beyond[k].integer(i64::from(back[k])));
        let is_same =
            |axis: &&mut Axis| (axis.side, axis.apex, &axis.beyond) == (side, apex.vertex, &beyond);
        match self.axes.iter_mut().find(is_same) {
            Some(axis) => {
                axis.edges.insert(edge);
            }
            None => self.axes.push(Axis {
                side,
                apex: apex.vertex,
                beyond,
                edges: BTreeSet::from([edge]),
            }),
        }
        Ok(())
    }

    /// The corner at a point; a new vertex where there is none yet.
    fn corner(&mut self, point: &[Number; 3]) -> Result<Corner<3>, DeriveError> {
        let shift = cell_of(point, self.rank).ok_or(DeriveError::Far)?;
        let base: [Number; 3] =
            std::array::from_fn(|k| &point[k] - &point[k].integer(i64::from(shift[k])));
        let known = self.vertices.iter().position(|vertex| *vertex == base);
        let vertex = known.unwrap_or_else(|| {
            self.vertices.push(base);
            self.vertices.len() - 1
        });
        Ok(Corner {
            vertex: VertexId::at(vertex),
            shift,
        })
    }

    fn position(&self, corner: &Corner<3>) -> [Number; 3] {
        let vertex = &self.vertices[corner.vertex.index()];
        std::array::from_fn(|k| &vertex[k] + &vertex[k].integer(i64::from(corner.shift[k])))
    }

    fn is_positive(&self, corners: &[Corner<3>; 4]) -> bool {
        let corners = corners.each_ref().map(|corner| self.position(corner));
        Simplex::new(&corners).determinant.sign().is_gt()
    }

    /// A sorted row, with the last two exchanged where that makes it positive.
    fn positive(&self, row: [Corner<3>; 4]) -> [Corner<3>; 4] {
        let [a, b, c, d] = row;
        if self.is_positive(&row) {
            row
        } else {
            [a, b, d, c]
        }
    }

    /// The pyramid of an axis: its edges in the side, as a cycle.
    fn pyramid(&self, axis: &Axis) -> Result<Pyramid, DeriveError> {
        let mut edges = axis.edges.clone();
        let [first, mut last] = edges.pop_first().ok_or(DeriveError::Axis)?;
        let mut polygon = vec![first];
        while last != first {
            polygon.push(last);
            let next = edges.iter().find(|edge| edge.contains(&last)).copied();
            let next = next.ok_or(DeriveError::Axis)?;
            edges.remove(&next);
            last = if next[0] == last { next[1] } else { next[0] };
        }
        if !edges.is_empty() || polygon.len() < 3 {
            return Err(DeriveError::Axis);
        }
        let apex = Corner::of(axis.apex);
        if !self.is_positive(&[polygon[0], polygon[1], polygon[2], apex]) {
            polygon[1..].reverse();
        }
        let back = first.shift.map(|s| -s);
        Ok(Pyramid {
            apex: apex.moved(back),
            polygon: polygon
                .into_iter()
                .map(|corner| corner.moved(back))
                .collect(),
        })
    }
}

fn seen_from_first(mut corners: [Corner<3>; 4]) -> [Corner<3>; 4] {
    corners.sort_unstable();
    let origin = corners[0].shift;
    corners.map(|corner| Corner {
        vertex: corner.vertex,
        shift: difference(corner.shift, origin),
    })
}
