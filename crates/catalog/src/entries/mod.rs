//! The table of constructions, in parts.

mod families;
mod make;
mod polyhedra;
mod structures;
mod tilings;

use super::entry::Entry;
use std::sync::LazyLock;

/// All constructions, in the order in which they are listed.
pub(super) static ENTRIES: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    [
        structures::ENTRIES,
        tilings::ENTRIES,
        polyhedra::ENTRIES,
        families::ENTRIES,
    ]
    .concat()
});
