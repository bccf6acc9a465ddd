//! The object that is proved: a lattice, vertices, and one simplex per orbit.
//!
//! Nothing here is checked; [`crate::checker`] does that. Catalogue, importers and
//! the triangulation of point sets make tilings, and everything downstream reads them.

mod buckets;
pub mod coordinates;
pub(crate) mod dimension;
mod facets;
mod floor;
mod frame;
mod index;
mod matching;
mod merged;
mod polytope;
mod supercell;

pub use coordinates::Coordinates;
pub use facets::{Facet, Mate, Mismatch};
pub use floor::{CELL_LIMIT, cell_of, floor};
pub use frame::{Domain, Frame};
pub use index::{FacetId, SimplexId, VertexId};
pub use matching::{Matching, match_facets};
pub use merged::merged;
pub use polytope::{Plane, Polytope};
pub use supercell::supercell;

use acutile_exact::geometry::Simplex;
use acutile_exact::number::Number;
use std::fmt;

/// A vertex moved by a lattice vector; `shift` holds its integer coordinates in
/// the basis, zero beyond the rank of the lattice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Corner<const D: usize> {
    /// Index into [`Tiling::vertices`].
    pub vertex: VertexId,
    /// The lattice vector, |entries| at most [`SHIFT_LIMIT`].
    pub shift: [i32; D],
}

/// No shift entry is larger in absolute value, so that sums and differences of a
/// few of them cannot overflow.
pub const SHIFT_LIMIT: i32 = 1 << 24;

impl<const D: usize> Corner<D> {
    /// The vertex itself, not moved.
    pub fn of(vertex: impl Into<VertexId>) -> Self {
        Corner {
            vertex: vertex.into(),
            shift: [0; D],
        }
    }

    /// The corner moved by a further lattice vector.
    pub fn moved(self, by: [i32; D]) -> Self {
        Corner {
            vertex: self.vertex,
            shift: std::array::from_fn(|k| self.shift[k] + by[k]),
        }
    }
}

/// `3`, or `3+(0, 1, -1)` with its shift.
impl<const D: usize> fmt::Display for Corner<D> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if self.shift.iter().all(|&s| s == 0) {
            return write!(f, "{}", self.vertex);
        }
        let shift: Vec<String> = self.shift.iter().map(i32::to_string).collect();
        write!(f, "{}+({})", self.vertex, shift.join(", "))
    }
}

/// `a - b`, entry by entry.
pub fn difference<const D: usize>(a: [i32; D], b: [i32; D]) -> [i32; D] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// Points of D-space up to the translations of a lattice.
#[derive(Clone, Debug)]
pub struct PointSet<const D: usize> {
    /// Basis, metric and lattice.
    pub frame: Frame<D>,
    /// Coordinates in the basis; no two may differ by a lattice vector.
    pub points: Vec<[Number; D]>,
}

/// A periodic arrangement of D-simplices, one for each orbit of the lattice.
#[derive(Clone, Debug)]
pub struct Tiling<const D: usize> {
    /// Basis, metric, lattice and domain.
    pub frame: Frame<D>,
    /// Coordinates in the basis.
    pub vertices: Coordinates<D>,
    /// D + 1 corners for each simplex, one simplex after the other.
    pub corners: Vec<Corner<D>>,
}

impl<const D: usize> Tiling<D> {
    /// The number of simplices in a cell.
    pub fn len(&self) -> usize {
        self.corners.len() / (D + 1)
    }

    /// Whether there is no simplex at all.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The D + 1 corners of a simplex.
    pub fn simplex(&self, index: SimplexId) -> &[Corner<D>] {
        let index = index.index();
        &self.corners[index * (D + 1)..(index + 1) * (D + 1)]
    }

    /// The indices of the simplices, in order.
    pub fn indices(&self) -> impl ExactSizeIterator<Item = SimplexId> + Clone + use<D> {
        (0..self.len() as u32).map(SimplexId::new)
    }

    /// The facets of all simplices, in order of their numbers.
    pub fn facets(&self) -> impl Iterator<Item = Facet> + Clone + use<D> {
        self.indices()
            .flat_map(|simplex| (0..=D).map(move |opposite| Facet::new(simplex, opposite)))
    }

    /// All simplices in order.
    pub fn simplices(&self) -> impl ExactSizeIterator<Item = &[Corner<D>]> {
        self.corners.chunks_exact(D + 1)
    }

    /// The tiling without some simplices, and the indices that the others have in this one. The list
    /// is in order.
    pub fn without(&self, left_out: &[SimplexId]) -> (Tiling<D>, Vec<SimplexId>) {
        let is_kept = |simplex: &SimplexId| left_out.binary_search(simplex).is_err();
        let kept: Vec<SimplexId> = self.indices().filter(is_kept).collect();
        let corners = kept.iter().flat_map(|s| self.simplex(*s).iter().copied());
        let part = Tiling {
            frame: self.frame.clone(),
            vertices: self.vertices.clone(),
            corners: corners.collect(),
        };
        (part, kept)
    }

    /// A simplex in exact basis coordinates.
    pub fn shape(&self, index: SimplexId) -> Simplex<Number, D> {
        let corners: Vec<[Number; D]> = self
            .simplex(index)
            .iter()
            .map(|corner| self.position(corner))
            .collect();
        Simplex::new(&corners)
    }

    /// The coordinates of a corner in the basis.
    pub fn position(&self, corner: &Corner<D>) -> [Number; D] {
        let vertex = self.vertices.vertex(corner.vertex);
        std::array::from_fn(|k| &vertex[k] + &self.frame.field.integer(i64::from(corner.shift[k])))
    }
}

/// A tiling of the plane or of space, where the dimension is known only when the
/// program runs.
#[derive(Clone, Debug)]
pub enum AnyTiling {
    /// D = 2
    Plane(Tiling<2>),
    /// D = 3
    Space(Tiling<3>),
}

/// A point set of the plane or of space.
#[derive(Clone, Debug)]
pub enum AnyPointSet {
    /// D = 2
    Plane(PointSet<2>),
    /// D = 3
    Space(PointSet<3>),
}

/// Runs the same code for either dimension: `with_dimension!(any, AnyTiling, t => code)`.
#[macro_export]
macro_rules! with_dimension {
    ($any:expr, $kind:ident, $name:ident => $code:expr) => {
        match $any {
            $crate::tiling::$kind::Plane($name) => $code,
            $crate::tiling::$kind::Space($name) => $code,
        }
    };
}
