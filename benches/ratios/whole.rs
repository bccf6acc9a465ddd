//! The whole check of A15 in memory: orientation, acuteness, matching and volume, on all cores.

use crate::child::{self, Work};
use crate::row::{Table, Target};

/// The rows of the whole check, in a process of its own because of its peak.
pub fn measure(table: &Table) {
    table.head("the whole check of A15, 50 x 50 x 50 cells, on all cores");
    let found = child::start(&Work::new("whole", 50));
    let note = format!("{} tetrahedra", found.count);
    table.plain("whole check, processors", found.seconds, "s", &note);
    let elapsed = found.elapsed;
    table.row(
        "whole check, elapsed",
        elapsed,
        "s",
        Target::Most(3.0),
        &note,
    );
    let note = "with the tiling itself and what made it";
    table.row(
        "whole check, peak",
        found.megabytes,
        "MB",
        Target::Most(700.0),
        note,
    );
    println!("  {}", found.remark);
}
