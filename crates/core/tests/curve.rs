//! The space-filling curve that orders rows.

use acutile_core::transcribe::curve::{BITS, index};

/// The cells of a coarse grid, in the order of the curve: every step is to a neighbour.
fn steps<const D: usize>(bits: u32) -> bool {
    let side = 1u32 << bits;
    let cells = (0..side.pow(D as u32)).map(|n| -> [u32; D] {
        std::array::from_fn(|k| (n / side.pow(k as u32) % side) << (BITS - bits))
    });
    let mut cells: Vec<[u32; D]> = cells.collect();
    cells.sort_by_key(|cell| index(*cell));
    cells.windows(2).all(|pair| {
        let distance: u32 = (0..D).map(|k| pair[0][k].abs_diff(pair[1][k])).sum();
        distance == 1 << (BITS - bits)
    })
}

#[test]
fn neighbours() {
    for bits in 1..=4 {
        assert!(steps::<2>(bits), "plane, {bits}");
        assert!(steps::<3>(bits), "space, {bits}");
    }
}
