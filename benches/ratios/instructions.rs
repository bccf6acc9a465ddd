//! Instruction counts of fixed cases by callgrind, which other programs on the machine do
//! not disturb. A case is run once and twice in a process, and the difference taken, so that
//! making its data is not counted.

use crate::child::{Work, prepared};
use crate::row::Table;
use std::process::Command;

/// The cases, and cells of A15 in each direction.
const CASES: [(&str, u16); 4] = [
    ("filter", 8),
    ("exact", 4),
    ("verifier, Q", 3),
    ("matching", 8),
];

/// The rows of instruction counts.
pub fn measure(table: &Table) {
    table.head("instructions, counted by callgrind");
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("  valgrind is not there: nothing counted");
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    for (kind, n) in CASES {
        let work = prepared(kind, n, folder.path());
        let counts = [1, 2].map(|times| count(&work.clone().times(times)));
        let [Some(once), Some(twice)] = counts else {
            println!("  {kind}: valgrind counted nothing");
            continue;
        };
        let tetrahedra = 46.0 * f64::from(n).powi(3);
        let note = format!("{} for {tetrahedra} tetrahedra", twice - once);
        table.plain(kind, (twice - once) / tetrahedra, "a tetrahedron", &note);
    }
}

/// The instructions of a child.
fn count(work: &Work) -> Option<f64> {
    let valgrind = [
        "valgrind",
        "--tool=callgrind",
        "--callgrind-out-file=/dev/null",
    ];
    let output = work.command(&valgrind).output().ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let (_, collected) = text.split_once("Collected : ")?;
    collected.split_whitespace().next()?.parse().ok()
}
