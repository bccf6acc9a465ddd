//! Periodic Delaunay triangulations, exact and certified. The points are one cell of a TCP structure,
//! supercells of A15 in a cube, and the same moved a little in a skewed lattice.

use crate::child::{self, Work};
use crate::clock::fastest;
use crate::data::{entry, points};
use crate::row::{Table, Target};
use acutile_core::delaunay::{Ties, triangulate};

/// The rows of the Delaunay triangulation. Large ones run in processes of their own.
pub fn measure(table: &Table) {
    table.head("exact periodic Delaunay triangulation");
    for name in ["a15", "c15", "sigma"] {
        let set = points(&entry(name));
        let count = triangulate(&set, Ties::Refuse).expect("it is one").len();
        let milliseconds = fastest(|| triangulate(&set, Ties::Refuse)).as_secs_f64() * 1e3;
        let note = format!("{} points, {count} tetrahedra", set.points.len());
        let target = Target::Most(20.0);
        table.row(
            &format!("one cell of {name}"),
            milliseconds,
            "ms",
            target,
            &note,
        );
    }
    for (kind, name) in [("delaunay", "cube"), ("delaunay-skewed", "skewed lattice")] {
        for (n, limit) in [(23, 3.0), (50, 30.0)] {
            let found = child::start(&Work::new(kind, n));
            let points = 8 * usize::from(n).pow(3);
            let note = format!("{} tetrahedra, peak {:.0} MB", found.count, found.megabytes);
            let work = format!("{points} points, {name}");
            table.row(&work, found.seconds, "s", Target::Most(limit), &note);
        }
    }
}
