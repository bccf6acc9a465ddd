//! Systems of patches: one theorem about all tilings that they build, periodic or not.
//!
//! docs/format.md defines tiles, pieces, pyramids and joins. A recipe makes a [`System`];
//! [`mod@derive`] takes the patch of a tile from a tiling of space; [`prove`] writes the certificate
//! and asks the kernel. Nothing is decided here.

pub mod derive;
mod prove;
mod read;
mod words;

pub use prove::{Theorem, certificate, prove, prove_bounds};
pub use words::in_words;

use crate::tiling::{Corner, Domain, Frame, Polytope, Tiling};
use acutile_exact::number::{Field, Number};

/// Tiles with their patches.
#[derive(Clone, Debug)]
pub struct System {
    /// The field of all numbers.
    pub field: Field,
    /// Inner products of b_1, b_2, b_3.
    pub gram: [[Number; 3]; 3],
    /// The rank r of the lattice that b_1, …, b_r span: 1 or 2.
    pub rank: usize,
    /// The tiles of the mosaics.
    pub tiles: Vec<Tile>,
}

/// A polygon (r = 1) or a segment (r = 2) of the base.
#[derive(Clone, Debug)]
pub struct Tile {
    /// The last 3 - r coordinates of the corners.
    pub corners: Vec<Vec<Number>>,
    /// The class of each side.
    pub classes: Vec<i64>,
    /// The cells over the tile.
    pub patch: Patch,
}

/// The tetrahedra and pyramids over a tile.
#[derive(Clone, Debug)]
pub struct Patch {
    /// A vector of the span of the lattice for each side.
    pub offsets: Vec<Vec<Number>>,
    /// The vertices, in coordinates of the basis.
    pub vertices: Vec<[Number; 3]>,
    /// Positively oriented.
    pub simplices: Vec<[Corner<3>; 4]>,
    /// The pyramids on the sides.
    pub pyramids: Vec<Pyramid>,
}

/// An apex over a polygon in a side. (h_0, h_1, h_2, apex) is positive.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Pyramid {
    /// The apex.
    pub apex: Corner<3>,
    /// The corners h_0, h_1, … of the polygon, in order.
    pub polygon: Vec<Corner<3>>,
}

impl System {
    /// The piece of a tile as a region that is periodic under the lattice.
    pub fn piece(&self, tile: &Tile) -> Tiling<3> {
        let frame = Frame::space(self.field.clone(), self.gram.clone());
        Tiling {
            frame: frame.with_domain(Domain::Region(self.rank)),
            vertices: tile.patch.vertices.clone().into(),
            corners: tile.patch.simplices.concat(),
        }
    }
}

impl Tile {
    /// The polygon or the segment.
    pub fn polytope(&self) -> Polytope {
        match self.corners.as_slice() {
            [low, high] => Polytope::interval(low[0].clone(), high[0].clone()),
            corners => Polytope::polygon(corners.to_vec()),
        }
    }
}
