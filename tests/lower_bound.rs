//! `acutile lower-bound`, through the program.

use crate::common::{acutile, code, stderr, stdout};
use serde_json::Value;

#[test]
fn the_proof_in_json() {
    let output = acutile(["lower-bound", "--json"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let checks = report["checks"].as_array().expect("checks");
    let theorems = report["theorems"].as_array().expect("theorems");
    assert!(checks.len() > 60 && theorems.len() == 8);
    for row in checks.iter().chain(theorems) {
        assert_eq!(row["verdict"], "holds", "{row}");
        let place = row["place"].as_str().expect("a place");
        assert!(place.starts_with("docs/lower-bound.md, "), "{place}");
    }
}

#[test]
fn the_proof_in_words() {
    let output = acutile(["lower-bound"]);
    let text = stdout(&output);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for part in [
        "holds contradiction/tetrahedron-with-three-a0 [section 6, step C]",
        "601 deductions; 1200 triangles are known",
        "holds face-to-face-73.31 [Theorem 8]",
        "holds tcp-73.44 [Theorem 7]",
        "0 fails, 0 undecided",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    // Nothing but the report where standard error is no terminal.
    assert_eq!(stderr(&output), "");
}
