//! An interrupt leaves neither half a certificate nor a temporary file.
#![cfg(target_os = "linux")] // env --default-signal is of GNU

use crate::common::{acutile, code, stderr};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use tempfile::TempDir;

/// A directory with a tiling that takes a while, 46 · 6³ tetrahedra, and an empty one.
fn places() -> (TempDir, TempDir) {
    let [tiling, empty] = [(); 2].map(|()| tempfile::tempdir().expect("a directory"));
    let big = tiling.path().join("big.json");
    let big = big.to_str().expect("a path in UTF-8");
    let converted = acutile(["convert", "a15", big, "--supercell", "6,6,6"]);
    assert_eq!(code(&converted), 0, "{}", stderr(&converted));
    (tiling, empty)
}

/// Certifies it; whatever signals the tests are run with, those in `options` are as said.
fn certify(tiling: &Path, place: &Path, options: &[&str]) -> Child {
    Command::new("env")
        .args(options)
        .arg(env!("CARGO_BIN_EXE_acutile"))
        .arg("certify")
        .arg(tiling.join("big.json"))
        .arg("-o")
        .arg(place.join("o.cbor"))
        .stdout(Stdio::null())
        .spawn()
        .expect("env runs")
}

fn names(place: &Path) -> Vec<String> {
    let entries = fs::read_dir(place).expect("a directory");
    let name = |entry: std::io::Result<fs::DirEntry>| entry.expect("an entry").file_name();
    entries
        .map(|entry| name(entry).into_string().expect("a name in UTF-8"))
        .collect()
}

/// Waits for the temporary file, and sends the signal.
fn interrupt(child: &mut Child, place: &Path, signal: &str) {
    while !names(place)
        .iter()
        .any(|name| name.starts_with(".acutile-"))
    {
        let ended = child.try_wait().expect("a child");
        assert_eq!(ended, None, "ended before a temporary file was seen");
        std::thread::sleep(Duration::from_millis(1));
    }
    let sent = Command::new("kill")
        .args(["-s", signal, &child.id().to_string()])
        .status();
    assert!(sent.expect("kill runs").success());
}

#[test]
fn no_temporary_file_is_left() {
    let (tiling, place) = places();
    for signal in ["INT", "TERM", "HUP"] {
        let mut child = certify(tiling.path(), place.path(), &["--default-signal"]);
        interrupt(&mut child, place.path(), signal);
        let status = child.wait().expect("a child");
        assert_eq!(status.code(), Some(130), "{signal}");
        assert_eq!(names(place.path()), [""; 0], "{signal}");
    }
}

/// As under `nohup`.
#[test]
fn an_ignored_signal_stays_ignored() {
    let (tiling, place) = places();
    let options = ["--default-signal", "--ignore-signal=HUP"];
    let mut child = certify(tiling.path(), place.path(), &options);
    interrupt(&mut child, place.path(), "HUP");
    assert_eq!(child.wait().expect("a child").code(), Some(0));
    assert_eq!(names(place.path()), ["o.cbor"]);
}
