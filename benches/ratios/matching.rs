//! Matching of ten million half-facets, beside a copy of the bytes of the corners.

use crate::clock::{compare, on_processor, once};
use crate::data::a15;
use crate::row::{Table, Target};
use acutile_core::tiling::match_facets;
use std::cell::RefCell;

/// 46 · 38³ tetrahedra have 10,096,448 half-facets.
const CELLS: u16 = 38;

/// The row of matching.
pub fn measure(table: &Table) {
    table.head("matching of half-facets");
    let tiling = a15(CELLS);
    let copy = RefCell::new(tiling.corners.clone());
    let copying = || {
        on_processor(1, || {
            copy.borrow_mut().copy_from_slice(&tiling.corners);
        })
    };
    let (measured, copied) = compare(|| once(|| match_facets(&tiling)).0, copying);
    let time = once(|| match_facets(&tiling)).0;
    let matching = match_facets(&tiling);
    assert!(matching.mismatches.is_empty());
    let bytes = size_of_val(tiling.corners.as_slice()) / 1_000_000;
    let note = format!(
        "{} half-facets; a copy of the {bytes} MB of corners takes {:.4} s",
        tiling.corners.len(),
        copied.as_secs_f64()
    );
    table.row("matching", measured, "x memcpy", Target::Most(10.0), &note);
    table.row("matching", time.as_secs_f64(), "s", Target::Most(0.5), "");
}
