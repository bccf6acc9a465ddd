//! Why a construction fails.

use super::limits::{CUBE_LIMIT, ENTRY_LIMIT, WORD_LIMIT};
use acutile_core::delaunay::DelaunayError;
use acutile_core::patches::derive::DeriveError;
use acutile_exact::number::{FieldError, ReadError};
use std::fmt;

/// Why a construction fails.
#[derive(Clone, Debug)]
pub enum CatalogError {
    /// There is no construction with this name.
    UnknownName(String),
    /// This construction is a tiling for each point of a box.
    Family(String),
    /// This construction takes no parameter.
    NoParameter(String),
    /// The parameter must be positive, and this text is not.
    NotPositive(String),
    /// A parameter, or a side of a triangle, is no number.
    Number(String, ReadError),
    /// These are not the sides of a triangle.
    NotATriangle(String),
    /// Not a word of `z`, `+`, `-` with 1 to [`WORD_LIMIT`] letters.
    Word(String),
    /// Not three positive integers whose product is at most [`CUBE_LIMIT`].
    Sides(String),
    /// A table has no row for the orbit of this vertex.
    NoOrbit(Vec<i8>),
    /// A file of a plane tiling cannot be read.
    File(String),
    /// Two neighbouring edges at this vertex enclose an angle, in degrees, that belongs to no triangle or
    /// square. So this is no edge-to-edge tiling by squares and triangles.
    NotSquareTriangle {
        /// Index of the vertex.
        vertex: usize,
        /// The angle between neighbouring edges.
        angle: usize,
    },
    /// Two vertices of a plane tiling differ by a lattice vector.
    SameVertex(usize, usize),
    /// The tiles do not cover the plane exactly once: these numbers of triangles and squares have
    /// another area than the cell.
    NotACover {
        /// Triangles in a cell.
        triangles: usize,
        /// Squares in a cell.
        squares: usize,
    },
    /// An entry of a plane tiling is larger than [`ENTRY_LIMIT`].
    EntryTooLarge(i64),
    /// No choice of blank edges fits the tiles around this vertex.
    NoBlankEdges {
        /// The vertex.
        vertex: usize,
        /// The tiles at it by their numbers of sides, `3.3.3.3.3.3`.
        tiles: String,
        /// Steps along edges from the vertex to the centres of the stars that are examined.
        radius: usize,
        /// The vertices in the middle of these stars.
        stars: usize,
    },
    /// No periodic choice of blank edges was found in the cells tried, and no local reason
    /// against one either.
    BlankEdgesNotFound,
    /// The tetrahedra cannot be coloured black and white.
    NotTwoColourable,
    /// The lattice vectors are dependent.
    Degenerate,
    /// The field could not be made.
    Field(FieldError),
    /// The points have no Delaunay triangulation.
    Delaunay(DelaunayError),
    /// A tile has no patch.
    Patch(DeriveError),
}

impl From<DeriveError> for CatalogError {
    fn from(error: DeriveError) -> Self {
        CatalogError::Patch(error)
    }
}

impl From<DelaunayError> for CatalogError {
    fn from(error: DelaunayError) -> Self {
        CatalogError::Delaunay(error)
    }
}

impl From<FieldError> for CatalogError {
    fn from(error: FieldError) -> Self {
        CatalogError::Field(error)
    }
}

impl fmt::Display for CatalogError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::UnknownName(name) => {
                write!(f, "there is no construction `{name}`")?;
                match crate::suggestion(name) {
                    Some(other) => write!(f, "; did you mean {other}?"),
                    None => Ok(()),
                }
            }
            Self::Family(name) => write!(
                f,
                "`{name}` is a tiling for each point of a box of parameters, expected a single \
                 tiling; `acutile certify {name}` and `acutile show {name}` take it"
            ),
            Self::NoParameter(name) => write!(
                f,
                "`{name}` takes no parameter; goldberg-1, goldberg-2, goldberg-3 and two-corners take one"
            ),
            Self::NotPositive(text) => {
                write!(f, "the parameter is {text}, expected a positive number")
            }
            Self::Number(text, error) => write!(f, "`{text}` is not a number: {error}"),
            Self::NotATriangle(word) => write!(
                f,
                "`{word}` are not the three sides of a triangle, like 4,5,6 or 1,1,sqrt(3)"
            ),
            Self::Word(word) => write!(
                f,
                "`{word}` is not a word of 1 to {WORD_LIMIT} letters `z`, `+`, `-`"
            ),
            Self::Sides(word) => write!(
                f,
                "`{word}` are not the sides of a box: expected three positive integers with a \
                 product of at most {CUBE_LIMIT}, like 2,1,1"
            ),
            Self::NoOrbit(place) => write!(f, "no row places the vertex {place:?}"),
            Self::File(message) => message.fmt(f),
            Self::NotSquareTriangle { vertex, angle } => write!(
                f,
                "edges at vertex {vertex} are {angle} degrees apart: not an edge-to-edge tiling by squares and triangles, so it cannot be coloured"
            ),
            Self::SameVertex(i, j) => {
                write!(f, "vertices {i} and {j} differ by a lattice vector")
            }
            Self::NotACover { triangles, squares } => write!(
                f,
                "{triangles} triangles and {squares} squares have another area than the cell: the tiles do not cover the plane once"
            ),
            Self::EntryTooLarge(entry) => write!(
                f,
                "found the entry {entry}, expected at most {ENTRY_LIMIT} in size"
            ),
            Self::NoBlankEdges {
                vertex,
                tiles,
                radius,
                stars,
            } => write!(
                f,
                "there are no blank edges (one side of every triangle, two opposite sides of every square, two edges of one kind at every vertex): none fit the tiles around vertex {vertex}, where {tiles} meet, and around the {} other vertices within {radius} edges",
                stars - 1
            ),
            Self::BlankEdgesNotFound => write!(
                f,
                "no set of blank edges was found that has the period of a small multiple of the cell"
            ),
            Self::NotTwoColourable => {
                write!(f, "the tetrahedra cannot be coloured black and white")
            }
            Self::Degenerate => write!(f, "the lattice vectors are dependent"),
            Self::Field(error) => error.fmt(f),
            Self::Delaunay(error) => error.fmt(f),
            Self::Patch(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for CatalogError {}
