//! Matching of ten million half-facets, beside a copy of the bytes of the corners.

use crate::clock::on_processor;
use crate::data::a15;
use crate::row::{Table, Target, ratio};
use acutile_core::tiling::match_facets;

/// 46 · 38³ tetrahedra have 10,096,448 half-facets.
const CELLS: u16 = 38;

/// The row of matching.
pub fn measure(table: &Table) {
    table.head("matching of half-facets");
    let tiling = a15(CELLS);
    let mut copy = tiling.corners.clone();
    let copied = on_processor(5, || copy.copy_from_slice(&tiling.corners));
    let time = on_processor(3, || match_facets(&tiling));
    let matching = match_facets(&tiling);
    assert!(matching.mismatches.is_empty());
    let bytes = size_of_val(tiling.corners.as_slice()) / 1_000_000;
    let note = format!(
        "{} half-facets; a copy of the {bytes} MB of corners takes {:.4} s",
        tiling.corners.len(),
        copied.as_secs_f64()
    );
    table.row(
        "matching",
        ratio(time, copied),
        "x memcpy",
        Target::Most(10.0),
        &note,
    );
    table.row("matching", time.as_secs_f64(), "s", Target::Most(0.5), "");
}
