//! The three basic TCP structures (paper, section 4.1).

use super::CatalogError;
use super::points::delaunay;
use crate::tiling::AnyTiling;

/// A cube with its corners and its centre, and on every face a pair of points
/// that divides a middle line in the ratio 1 : 2 : 1: 8 points.
pub fn a15() -> Result<AnyTiling, CatalogError> {
    let cubic = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]];
    let points = [
        ["0", "0", "0"],
        ["1/2", "1/2", "1/2"],
        ["1/4", "0", "1/2"],
        ["3/4", "0", "1/2"],
        ["1/2", "1/4", "0"],
        ["1/2", "3/4", "0"],
        ["0", "1/2", "1/4"],
        ["0", "1/2", "3/4"],
    ];
    Ok(AnyTiling::Space(delaunay(cubic, &points)?))
}

/// Over the tiling of the plane by triangles with side 4, all of whose edges have the
/// same colour: heights 4k and 4k + 2 over the vertices, 4k - 1 over the midpoints
/// of the edges (black dots), 4k + 1 over the centres of the triangles (white
/// dots): 7 points.
pub fn z() -> Result<AnyTiling, CatalogError> {
    let hexagonal = [["16", "8", "0"], ["8", "16", "0"], ["0", "0", "16"]];
    let points = [
        ["0", "0", "0"],
        ["0", "0", "2/4"],
        ["1/2", "0", "-1/4"],
        ["0", "1/2", "-1/4"],
        ["1/2", "1/2", "-1/4"],
        ["1/3", "1/3", "1/4"],
        ["2/3", "2/3", "1/4"],
    ];
    Ok(AnyTiling::Space(delaunay(hexagonal, &points)?))
}

/// The diamond structure, fcc and its translate by a quarter of the diagonal, with
/// selected circumcentres of its Delaunay cells: 5/8 of the diagonal and what the
/// symmetry gives. Basis: the fcc vectors (0,1,1), (1,0,1), (1,1,0), for a cube of
/// side 2: 6 points.
pub fn c15() -> Result<AnyTiling, CatalogError> {
    let fcc = [["2", "1", "1"], ["1", "2", "1"], ["1", "1", "2"]];
    let points = [
        ["0", "0", "0"],
        ["1/4", "1/4", "1/4"],
        ["5/8", "5/8", "5/8"],
        ["1/8", "5/8", "5/8"],
        ["5/8", "1/8", "5/8"],
        ["5/8", "5/8", "1/8"],
    ];
    Ok(AnyTiling::Space(delaunay(fcc, &points)?))
}
