//! Tilings of the plane.

use super::CatalogError;
use super::points::delaunay;
use crate::tiling::AnyTiling;

/// Equilateral triangles of side 1: the Delaunay triangulation of their lattice.
pub fn equilateral() -> Result<AnyTiling, CatalogError> {
    Ok(AnyTiling::Plane(delaunay(
        [["1", "1/2"], ["1/2", "1"]],
        &[["0", "0"]],
    )?))
}
