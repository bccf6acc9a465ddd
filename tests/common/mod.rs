//! Common functions of the integration tests: running the programs, and the Kuhn cube.

mod kuhn;
pub mod well_formed;

pub use kuhn::kuhn;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Runs `acutile` with these arguments.
pub fn acutile<A: AsRef<std::ffi::OsStr>>(arguments: impl IntoIterator<Item = A>) -> Output {
    Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(arguments)
        .output()
        .expect("acutile runs")
}

/// The program `acutile-verify`, which cargo puts beside `acutile` when it builds the workspace.
pub fn verifier() -> PathBuf {
    let program = Path::new(env!("CARGO_BIN_EXE_acutile"))
        .with_file_name(format!("acutile-verify{}", std::env::consts::EXE_SUFFIX));
    assert!(
        program.exists(),
        "{} is missing; build it with `cargo build` or test with `cargo test`",
        program.display()
    );
    program
}

/// Runs `acutile-verify` with these arguments.
pub fn acutile_verify<A: AsRef<std::ffi::OsStr>>(arguments: impl IntoIterator<Item = A>) -> Output {
    Command::new(verifier())
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
