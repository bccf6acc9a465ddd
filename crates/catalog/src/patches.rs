//! Systems of patches: a theorem about all tilings by squares and triangles, and one about all
//! words of kagome layers.
//!
//! *Squares and triangles* (section 4.1). A tile is a prism of period 4 over a square or triangle
//! of side 4. The points over it are those of `square_triangle`. The offset of a side is half a
//! period if its colour is white. So it changes at each corner of a square, and never in a
//! triangle. The pieces are taken from the structures over squares alone and triangles alone.
//!
//! *Kagome layers.* A tile is a segment: the height of a block. The offset of its upper end is the
//! registry of the layer there, seen from the registry of the lower one. The pieces are taken from
//! the structures of the words z, + and -.

use super::CatalogError;
use super::kagome::{axis, kagome, laves_height};
use super::plane_tiling::{POWERS, PlaneTiling, squares, sum, triangles};
use super::recipe::{common_field, fraction};
use super::square_triangle::{cartesian, square_root_of_3};
use acutile_core::patches::{System, Tile, derive::derive};
use acutile_core::tiling::Polytope;
use acutile_exact::number::Number;

/// The patches over all edge-to-edge tilings of the plane by squares and equilateral triangles.
///
/// # Errors
/// If the structures cannot be triangulated.
pub fn square_triangle_all() -> Result<System, CatalogError> {
    let root = square_root_of_3()?;
    let triangle = polygon_tile(&triangles(), 2, &[0, 0, 0], &root)?;
    let square = polygon_tile(&squares(), 3, &[0, 1, 0, 1], &root)?;
    let gram = std::array::from_fn(|i| std::array::from_fn(|j| fraction(i64::from(i == j), 1)));
    system(gram, 1, vec![triangle, square])
}

/// The patches over all words of kagome layers, also infinite ones.
///
/// # Errors
/// As [`square_triangle_all`].
pub fn kagome_all() -> Result<System, CatalogError> {
    // In units of the square root of 8: a² = 16, and the height is in units of 4.
    let gram = [[2, -1, 0], [-1, 2, 0], [0, 0, 2]].map(|row| row.map(|x| fraction(x, 1)));
    let low = &laves_height()? * &fraction(1, 4);
    let tiles = vec![
        block_tile("z", 0, fraction(1, 1))?,
        block_tile("+", 1, low.clone())?,
        block_tile("-", 2, low)?,
    ];
    system(gram, 2, tiles)
}

fn system(gram: [[Number; 3]; 3], rank: usize, tiles: Vec<Tile>) -> Result<System, CatalogError> {
    let points = tiles
        .iter()
        .flat_map(|tile| tile.patch.vertices.iter().flatten());
    Ok(System {
        field: common_field(points),
        gram,
        rank,
        tiles,
    })
}

/// The square or triangle whose sides from 0 are 1 and the power `angle` of the root of unity, in
/// the mosaic of such tiles alone. `halves` are the offsets in half periods.
fn polygon_tile(
    plane: &PlaneTiling,
    angle: usize,
    halves: &[i64],
    root: &Number,
) -> Result<Tile, CatalogError> {
    let mut corners = vec![[0; 4], POWERS[0]];
    if halves.len() == 4 {
        corners.push(sum(POWERS[0], POWERS[angle]));
    }
    corners.push(POWERS[angle]);
    let corners = corners.iter().map(|x| cartesian(*x, root).to_vec());
    let corners: Vec<Vec<Number>> = corners.collect();
    let [a, b] = plane.lattice.map(|x| cartesian(x, root));
    // The height comes first in the system, and last in the structure.
    let flat = |[x, y]: [Number; 2]| [Number::zero(), x, y];
    let up = [fraction(1, 1), Number::zero(), Number::zero()];
    let offsets = halves.iter().map(|n| vec![fraction(*n, 2)]).collect();
    let polytope = Polytope::polygon(corners.clone());
    let images = [flat(a), flat(b), up];
    Ok(Tile {
        classes: vec![0; corners.len()],
        patch: derive(&plane.structure()?, &images, 1, &polytope, offsets)?,
        corners,
    })
}

/// The block of a letter, which moves the registry by `step`.
fn block_tile(letter: &str, step: i64, height: Number) -> Result<Tile, CatalogError> {
    let [x, y] = axis(step);
    let unit = |k: i64| std::array::from_fn(|i| fraction(i64::from(i as i64 == k), 1));
    let images = [unit(0), unit(1), [x.clone(), y.clone(), height.clone()]];
    let corners = vec![vec![Number::zero()], vec![height.clone()]];
    let polytope = Polytope::interval(Number::zero(), height);
    let offsets = vec![vec![Number::zero(), Number::zero()], vec![x, y]];
    Ok(Tile {
        classes: vec![0, 0],
        patch: derive(&kagome(letter)?, &images, 2, &polytope, offsets)?,
        corners,
    })
}
