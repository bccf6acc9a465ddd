//! `acutile draw`: files are written whole, or a message says why not.

use crate::common::well_formed::well_formed;
use std::process::Command;

fn acutile(arguments: &[&str]) -> (Option<i32>, String, String) {
    let run = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(arguments)
        .output()
        .unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (run.status.code(), text(run.stdout), text(run.stderr))
}

#[test]
fn the_command_writes_whole_files_or_says_why_not() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cell.svg");
    let file = path.to_str().unwrap();
    let (code, out, error) = acutile(&["draw", "bcc", "-o", file]);
    assert_eq!((code, out.as_str(), error.as_str()), (Some(0), "", ""));
    let written = std::fs::read_to_string(&path).unwrap();
    well_formed(&written);
    assert_eq!(acutile(&["draw", "bcc"]).1, written);
    let (code, _, error) = acutile(&["draw", "a15", "--figure", "steps", "-o", file]);
    assert_eq!(code, Some(2));
    assert!(error.contains("only the slab"), "{error}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), written);
    for wrong in [
        ["--view", "0,0,0"],
        ["--view", "1,2"],
        ["--view", "a,b,c"],
        ["--width", "5"],
        ["--apart", "-1"],
        ["--vertex", "99999999999999999999999"],
        ["--format", "pdf"],
    ] {
        let (code, out, _) = acutile(&["draw", "a15", wrong[0], wrong[1]]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{wrong:?}");
    }
    let (code, _, error) = acutile(&["draw", "a15", "--standalone"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("--format tikz"), "{error}");
}

/// The picture in README.md is drawn by this program.
#[test]
fn the_picture_of_the_documents() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/images/a15.svg");
    let drawn = acutile(&["draw", "a15"]);
    assert_eq!(drawn.1, std::fs::read_to_string(file).expect(file));
}
