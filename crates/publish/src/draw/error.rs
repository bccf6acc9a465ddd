//! Why there is no figure, in words.

use super::order::PIECE_LIMIT;
use acutile_catalog::CatalogError;
use std::fmt;

/// Why there is no figure.
#[derive(Debug)]
pub enum DrawError {
    /// The Gram matrix is not one.
    NotPositiveDefinite,
    /// A place on the paper is not finite.
    TooLarge,
    /// The direction of sight is 0 or beyond doubles.
    NoDirection,
    /// A vertex beyond the last one, and how many there are.
    NoVertex(usize, usize),
    /// The number of simplices, more than the limit.
    TooMany(usize, usize),
    /// The number of congruence classes, more than the limit.
    TooManyClasses(usize, usize),
    /// Faces that cross one another in more than [`super::order::PIECE_LIMIT`] pieces.
    TooManyPieces,
    /// A figure of tetrahedra of a tiling of the plane.
    NotSolid,
    /// Cells of something that is not proved to be a weakly Delaunay triangulation of space.
    NoFoam(String),
    /// The font of the program cannot be read.
    NoFont(String),
    /// A picture so wide and high in dots, more than the limit.
    TooManyDots(f64, f64, f64),
    /// Steps of something else than the slab.
    NoSteps,
    /// A plane tiling under something that has none.
    NoPlane,
    /// A plane tiling that is not one.
    Catalog(CatalogError),
}

impl DrawError {
    /// Whether a limit was reached.
    pub fn is_limit(&self) -> bool {
        use DrawError::{TooMany, TooManyClasses, TooManyDots, TooManyPieces};
        matches!(
            self,
            TooMany(..) | TooManyClasses(..) | TooManyDots(..) | TooManyPieces
        )
    }
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            DrawError::NotPositiveDefinite => {
                write!(f, "the Gram matrix is not positive definite")
            }
            DrawError::TooLarge => write!(f, "lengths or coordinates are beyond those of doubles"),
            DrawError::NoDirection => write!(f, "the direction of view is 0 or too large"),
            DrawError::NoVertex(vertex, count) => {
                write!(
                    f,
                    "there is no vertex {vertex}: {count} vertices, counted from 0"
                )
            }
            DrawError::TooMany(count, limit) => write!(
                f,
                "{count} simplices are more than a figure shows; the limit is {limit}"
            ),
            DrawError::TooManyClasses(count, limit) => write!(
                f,
                "{count} congruence classes are more than a figure shows; the limit is {limit}"
            ),
            DrawError::TooManyPieces => write!(
                f,
                "faces cross one another too often: more than {PIECE_LIMIT} pieces"
            ),
            DrawError::NotSolid => {
                write!(
                    f,
                    "a tiling of the plane has the figures classes and plane only"
                )
            }
            DrawError::NoFoam(reason) => write!(
                f,
                "a foam has the Voronoi cells of a Delaunay triangulation of space: {reason}"
            ),
            DrawError::NoFont(reason) => write!(f, "the font of the program: {reason}"),
            DrawError::TooManyDots(width, height, limit) => write!(
                f,
                "{width} times {height} dots are more than a PNG has here; the limit is {limit}: a smaller --width, or --format pdf"
            ),
            DrawError::NoSteps => write!(f, "only the slab (acutile draw slab) is built in steps"),
            DrawError::NoPlane => write!(
                f,
                "there is no plane tiling under it: that have tilings of the plane, and z, a15, sigma, h, \
                 square-triangle-…"
            ),
            DrawError::Catalog(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for DrawError {}

impl From<CatalogError> for DrawError {
    fn from(error: CatalogError) -> Self {
        DrawError::Catalog(error)
    }
}
