//! Hilbert's curve through a grid of 2^b cells in each direction (Skilling, AIP Conf. Proc. 707,
//! 2004). Cells that are near on the curve are near in space.

/// Bits of a coordinate: the index has at most 60 bits.
pub const BITS: u32 = 20;

/// The index on the curve of a cell with coordinates below 2^[`BITS`], for D = 2 or 3.
pub fn index<const D: usize>(mut cell: [u32; D]) -> u64 {
    let mut bit = 1 << (BITS - 1);
    // Undoes the reflections and exchanges of axes, from the coarsest bit down.
    while bit > 1 {
        let lower = bit - 1;
        for k in 0..D {
            if cell[k] & bit != 0 {
                cell[0] ^= lower;
            } else {
                let difference = (cell[0] ^ cell[k]) & lower;
                cell[0] ^= difference;
                cell[k] ^= difference;
            }
        }
        bit >>= 1;
    }
    // Gray code.
    for k in 1..D {
        cell[k] ^= cell[k - 1];
    }
    let mut flips = 0;
    let mut bit = 1 << (BITS - 1);
    while bit > 1 {
        if cell[D - 1] & bit != 0 {
            flips ^= bit - 1;
        }
        bit >>= 1;
    }
    cell.iter_mut().for_each(|x| *x ^= flips);
    interleaved(cell)
}

/// The bits of all coordinates, the most significant ones first.
fn interleaved<const D: usize>(cell: [u32; D]) -> u64 {
    (0..BITS).rev().fold(0, |index, bit| {
        cell.iter()
            .fold(index, |index, x| index << 1 | u64::from(x >> bit & 1))
    })
}
