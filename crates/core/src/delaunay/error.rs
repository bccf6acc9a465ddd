//! Why a point set has no triangulation here.

use crate::quality::short_decimal;
use crate::statement::counted;
use crate::tiling::Corner;
use acutile_exact::number::Number;
use std::fmt;

/// No cell may have more cospherical corners.
pub const COSPHERICAL_LIMIT: usize = 128;

/// Why there is no triangulation.
#[derive(Clone, Debug)]
pub enum DelaunayError {
    /// There is no point.
    Empty,
    /// The Gram matrix is not symmetric.
    NotSymmetric,
    /// The Gram matrix is not positive definite.
    NotPositiveDefinite,
    /// In the given basis the corners of a cell would lie more than
    /// [`SHIFT_LIMIT`](crate::tiling::SHIFT_LIMIT) cells apart.
    TooSkewed,
    /// The points leave holes that are so long in comparison with the lattice
    /// that one empty sphere meets millions of cells.
    TooElongated,
    /// These two points differ by a lattice vector.
    Coincident(usize, usize),
    /// Empty spheres with more than D + 1 points, which were not to be
    /// triangulated ([`Ties::Refuse`](super::Ties::Refuse)).
    Cospherical(Vec<CosphericalSet>),
    /// An empty sphere with more than [`COSPHERICAL_LIMIT`] points.
    TooManyCospherical(usize),
    /// The exact check of the result failed: an error of this program.
    Uncertified,
}

/// Points on an empty sphere: the corners of one Delaunay cell, not a simplex.
#[derive(Clone, Debug, PartialEq)]
pub struct CosphericalSet {
    /// Point index and lattice shift (of the point moved into the cell
    /// 0 <= x < 1 of the given basis), sorted.
    pub corners: Vec<(u32, Vec<i32>)>,
    /// The centre, in basis coordinates.
    pub center: Vec<Number>,
    /// The exact square of the radius.
    pub squared_radius: Number,
}

impl CosphericalSet {
    pub(super) fn new<const D: usize>(
        corners: &[Corner<D>],
        center: [Number; D],
        squared_radius: Number,
    ) -> Self {
        CosphericalSet {
            corners: corners
                .iter()
                .map(|c| (c.vertex.number(), c.shift.to_vec()))
                .collect(),
            center: center.to_vec(),
            squared_radius,
        }
    }
}

impl fmt::Display for CosphericalSet {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let radius = &self.squared_radius;
        let radius = match radius.to_string() {
            short if short.len() <= 24 => short,
            _ => format!("about {}", short_decimal(radius)),
        };
        write!(
            f,
            "{} points with squared radius {radius}:",
            self.corners.len()
        )?;
        for (vertex, shift) in &self.corners {
            write!(f, " {vertex}{shift:?}")?;
        }
        Ok(())
    }
}

/// How many sets a message lists.
const LISTED: usize = 8;

impl fmt::Display for DelaunayError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "there is no point to triangulate"),
            Self::NotSymmetric => write!(f, "the Gram matrix is not symmetric"),
            Self::NotPositiveDefinite => write!(f, "the Gram matrix is not positive definite"),
            Self::TooSkewed => write!(
                f,
                "the basis is too skewed: corners of one cell would have shifts beyond {}; give a reduced basis",
                crate::tiling::SHIFT_LIMIT
            ),
            Self::TooElongated => {
                write!(
                    f,
                    "an empty sphere meets too many cells: the lattice is too elongated for so few points"
                )
            }
            Self::Coincident(a, b) => {
                write!(f, "the points {a} and {b} differ by a lattice vector")
            }
            Self::Cospherical(sets) => {
                let cells = counted(
                    sets.len(),
                    "Delaunay cell is no simplex",
                    "Delaunay cells are not simplices",
                );
                write!(f, "{cells}")?;
                sets.iter()
                    .take(LISTED)
                    .try_for_each(|set| write!(f, "\n  {set}"))?;
                match sets.len().saturating_sub(LISTED) {
                    0 => Ok(()),
                    more => write!(f, "\n  and {more} more"),
                }
            }
            Self::TooManyCospherical(count) => write!(
                f,
                "{count} points lie on one empty sphere; the limit is {COSPHERICAL_LIMIT}"
            ),
            Self::Uncertified => {
                write!(
                    f,
                    "the exact check of the triangulation failed, which is an error of this program"
                )
            }
        }
    }
}

impl std::error::Error for DelaunayError {}
