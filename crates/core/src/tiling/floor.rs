//! The cell of the lattice in which a point lies.

use acutile_exact::number::Number;

/// Cells with larger entries are refused, so that differences of cells and shifts fit into 32 bits.
pub const CELL_LIMIT: i32 = 1 << 29;

/// The largest integer that is not more than x; `None` if its size exceeds [`CELL_LIMIT`].
pub fn floor(x: &Number) -> Option<i32> {
    let floor = i32::try_from(&x.floor()).ok()?;
    (floor.unsigned_abs() <= CELL_LIMIT.unsigned_abs()).then_some(floor)
}

/// The floors of the first `rank` coordinates, the directions of the lattice, and zeros; `None` as
/// for [`floor`].
pub fn cell_of<const D: usize>(point: &[Number; D], rank: usize) -> Option<[i32; D]> {
    let mut cell = [0; D];
    for k in 0..rank.min(D) {
        cell[k] = floor(&point[k])?;
    }
    Some(cell)
}
