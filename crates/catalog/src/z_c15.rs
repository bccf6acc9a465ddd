//! Section 4.1: the variant that builds combinations of Z and C15 from a square/triangle
//! tiling (after Sullivan, New tetrahedrally close-packed structures, 2000).
//!
//! *Derivation.* Stacks of kagome layers over a word of `z`, `+`, `-` are mixtures of Z and C15. Along a
//! row of the layers they look like plane tilings by strips of rectangles (from `z`) and of isosceles
//! triangles (from `+`, `-`). The points have these heights, with period 4. Only the local rules carry over
//! to other tilings. Blank edges (see `blank`) have no dot in the middle; every tile has a colour c = ±1
//! (see `colours`), and there are points
//!
//! - over vertices at 0 and 2;
//! - over the middle of an edge that is not blank at c, the colour of both its tiles;
//! - in a triangle at -c, 3/4 of the way from a corner to the blank side opposite to it;
//! - in a square at -c, 1 inwards from the middle of each side that is not blank; also at c, 1/sqrt 3
//!   inwards from the middle of each blank side.
//!
//! In the layers blank edges have length 4 and the others 2 sqrt 3. Here all have length 3.7;
//! that the Delaunay triangulation is TCP and acute is not assumed, the checker proves it.

use super::CatalogError;
use super::blank::{Marking, marking};
use super::plane_tiling::{Cyclotomic, POWERS, PlaneTiling, TileCorner, scaled, sum};
use super::square_triangle::lifted;
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::Tiling;
use malachite::Rational;

/// Places in the plane are counted in 888th parts of a side: a side is 3.7, so 1 is
/// 240 parts, and 1/sqrt 3 is 80 sqrt 3 parts.
const SCALE: i64 = 888;

/// The structure over a plane tiling, with the period of a small multiple of its cell.
///
/// # Errors
/// Where the tiling is not one, or admits no blank edges: the tiles that show it.
pub fn z_c15(plane: &PlaneTiling) -> Result<Tiling<3>, CatalogError> {
    let marking = marking(plane)?;
    let points = points(&marking)?;
    let side_square = Rational::from_unsigneds(1369u32, 100);
    let set = lifted(&marking.plane, &side_square, SCALE, &points)?;
    Ok(triangulate(&set, Ties::Refuse)?)
}

fn points(marking: &Marking) -> Result<Vec<(Cyclotomic, i64)>, CatalogError> {
    let mut points = Vec::new();
    for (index, &vertex) in marking.plane.vertices.iter().enumerate() {
        let corner = scaled(vertex, SCALE);
        points.extend([(corner, 0), (corner, 2)]);
        for tile in &marking.stars[index] {
            let is_blank = marking.is_blank(vertex, tile.direction);
            let colour = marking.colour(index, tile.direction)?;
            points.extend(at_side(corner, tile, is_blank, colour));
        }
    }
    Ok(points)
}

/// The points that belong to the side of a tile from a corner. Every point of the structure belongs to one
/// side, except the points over vertices.
fn at_side(
    corner: Cyclotomic,
    tile: &TileCorner,
    is_blank: bool,
    colour: i64,
) -> Vec<(Cyclotomic, i64)> {
    let k = tile.direction;
    let power = |n: usize| POWERS[(k + n) % 12];
    let middle = sum(corner, scaled(power(0), SCALE / 2));
    let inwards = |parts| sum(middle, scaled(power(3), parts));
    let mut points = Vec::new();
    // An edge is a side of two tiles, in opposite directions.
    if !is_blank && k < 6 {
        points.push((middle, colour));
    }
    match (tile.is_square(), is_blank) {
        (true, false) => points.push((inwards(240), -colour)),
        (true, true) => {
            // sqrt 3 i = z² + z^4
            let root = sum(power(2), power(4));
            points.push((sum(middle, scaled(root, 80)), colour));
        }
        (false, true) => {
            let apex = sum(corner, scaled(power(2), SCALE));
            let quarter = std::array::from_fn(|n| (3 * middle[n] + apex[n]) / 4);
            points.push((quarter, -colour));
        }
        (false, false) => {}
    }
    points
}
