//! Rows of corners, and the mates of their facets, as a hint for the checker.
//!
//! A facet is named by its sorted corners, moved so that the first one has the shift zero.
//! Translates have one name. The second facet with a name closes the first one.

use super::error::{NotATheorem, require};
use acutile_core::format::{Corner, Witness};
use std::collections::HashMap;

/// The facet `facet` of the simplex `simplex`, moved by `shift`.
#[derive(Clone, Copy)]
pub(super) struct Mate {
    pub(super) simplex: usize,
    pub(super) facet: usize,
    pub(super) shift: [i64; 3],
}

/// The corners of each simplex.
pub(super) fn rows(witness: &Witness, dimension: usize) -> Result<Vec<&[Corner]>, NotATheorem> {
    let rows = witness.simplices.chunks_exact(dimension + 1);
    require(rows.remainder().is_empty(), "the length of a row")?;
    Ok(rows.collect())
}

/// For each facet of each row its mate, if another facet has its name.
pub(super) fn mates(rows: &[impl AsRef<[Corner]>]) -> Vec<Vec<Option<Mate>>> {
    let empty = |row: &_| vec![None; AsRef::<[Corner]>::as_ref(row).len()];
    let mut found: Vec<Vec<Option<Mate>>> = rows.iter().map(empty).collect();
    let mut open = HashMap::new();
    for (k, row) in rows.iter().enumerate() {
        for i in 0..row.as_ref().len() {
            let (name, offset) = facet(row.as_ref(), i);
            let Some((k2, i2, offset2)) = open.remove(&name) else {
                open.insert(name, (k, i, offset));
                continue;
            };
            let mate = |simplex, facet, shift| {
                Some(Mate {
                    simplex,
                    facet,
                    shift,
                })
            };
            found[k][i] = mate(k2, i2, minus(offset, offset2));
            found[k2][i2] = mate(k, i, minus(offset2, offset));
        }
    }
    found
}

/// Vertices and shifts relative to the first corner.
type Name = Vec<(u32, [i64; 3])>;

/// The name of the facet opposite to corner `i`, and the shift of its first corner.
fn facet(row: &[Corner], i: usize) -> (Name, [i64; 3]) {
    let corners = row.iter().enumerate().filter(|(k, _)| *k != i);
    let mut name: Name = corners
        .map(|(_, c)| (c.vertex, c.shift.map(i64::from)))
        .collect();
    name.sort_unstable();
    let offset = name.first().map_or([0; 3], |(_, shift)| *shift);
    for (_, shift) in &mut name {
        *shift = minus(*shift, offset);
    }
    (name, offset)
}

fn minus(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}
