//! The verifier in JavaScript (verifiers/javascript/verifier.js) agrees with the kernel: on every
//! file of tests/certificates, and on certificates that are changed at random.
//!
//! The tests are in tests/browser/verifier.test.mjs and run under Node, which need not be there.

use crate::common::verifier;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, Stdio};

#[test]
fn the_verifier_in_javascript_agrees() {
    if !has_node() {
        // Not by eprintln, which is shown for failures only.
        writeln!(
            io::stderr(),
            "SKIPPED: node (20 or later) is not installed, so the verifier in JavaScript is not tested"
        )
        .unwrap();
        return;
    }
    let output = Command::new("node")
        .args(["--test", "--test-reporter=tap"])
        .arg("tests/browser/verifier.test.mjs")
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")))
        .env("ACUTILE_VERIFY", verifier())
        .env("MUTATIONS", "500")
        .output()
        .unwrap();
    let report = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{report}");
    assert!(report.contains("# skipped 0"), "{report}");
}

fn has_node() -> bool {
    let major = "process.exit(parseInt(process.versions.node) < 20 ? 1 : 0)";
    let status = Command::new("node")
        .args(["-e", major])
        .stderr(Stdio::null())
        .status();
    status.is_ok_and(|status| status.success())
}
