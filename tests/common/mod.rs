//! What the integration tests share: running the programs, and the Kuhn cube.
#![allow(dead_code)] // each test file uses a part of it

use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Runs `acutile` with these arguments.
pub fn acutile<A: AsRef<std::ffi::OsStr>>(arguments: impl IntoIterator<Item = A>) -> Output {
    Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(arguments)
        .output()
        .expect("acutile runs")
}

/// Runs `acutile-verify` with these arguments.
pub fn acutile_verify<A: AsRef<std::ffi::OsStr>>(arguments: impl IntoIterator<Item = A>) -> Output {
    Command::new(env!("CARGO_BIN_EXE_acutile-verify"))
        .args(arguments)
        .output()
        .expect("acutile-verify runs")
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

pub fn code(output: &Output) -> i32 {
    output.status.code().expect("an exit code, not a signal")
}

/// Writes `text` to a file in `directory`.
pub fn file(directory: &Path, name: &str, text: &str) -> PathBuf {
    let path = directory.join(name);
    std::fs::write(&path, text).expect("the test's own directory can be written");
    path
}

/// The cube [0, 1]^3 cut into the six tetrahedra of the paths from (0,0,0) to
/// (1,1,1) along edges, one for each order of the axes (Kuhn). One vertex.
/// Written by hand: the shifts along the path x, y, z are 000, 100, 110, 111;
/// odd orders have two corners exchanged.
pub fn kuhn() -> Value {
    json!({
        "format": "acutile-tiling",
        "version": 1,
        "dimension": 3,
        "lattice": { "gram": [[1, 0, 0], [0, 1, 0], [0, 0, 1]] },
        "vertices": [[0, 0, 0]],
        "simplices": [
            [0, [0, 1, 0, 0], [0, 1, 1, 0], [0, 1, 1, 1]],
            [0, [0, 0, 1, 0], [0, 0, 1, 1], [0, 1, 1, 1]],
            [0, [0, 0, 0, 1], [0, 1, 0, 1], [0, 1, 1, 1]],
            [0, [0, 1, 0, 0], [0, 1, 1, 1], [0, 1, 0, 1]],
            [0, [0, 0, 1, 0], [0, 1, 1, 1], [0, 1, 1, 0]],
            [0, [0, 0, 0, 1], [0, 1, 1, 1], [0, 0, 1, 1]],
        ],
    })
}
