//! The verifier in JavaScript (verifiers/javascript/verifier.js) agrees with the kernel: on every
//! file of tests/certificates, and on certificates that are changed at random.
//!
//! The tests are in tests/browser/verifier.test.mjs and run under Node 20 or later. The variables MUTATIONS and SEED choose the
//! changes; without them 500 are tried.

use crate::common::verifier;
use std::path::Path;
use std::process::Command;

#[test]
#[ignore = "needs node 20 and python3"]
fn the_verifier_in_javascript_agrees() {
    let output = Command::new("node")
        .args(["--test", "--test-reporter=tap"])
        .arg("tests/browser/verifier.test.mjs")
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")))
        .env("ACUTILE_VERIFY", verifier())
        .env(
            "MUTATIONS",
            std::env::var("MUTATIONS").unwrap_or("500".into()),
        )
        .output()
        .expect("node runs");
    let report = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{report}");
    assert!(report.contains("# skipped 0"), "{report}");
}
