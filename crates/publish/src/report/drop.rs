//! The page that verifies certificates in the reader's browser. It holds the verifier and loads nothing.

use super::html::{fill, policy_hash};
use super::page::{STYLE, VERIFIER, verifier};

const TEMPLATE: &str = include_str!("assets/drop.html");
/// Certificates in CBOR for the verifier, which reads JSON.
const CBOR: &str = include_str!("assets/cbor.js");
const PROGRAM: [&str; 3] = [
    include_str!("assets/elements.js"),
    include_str!("assets/recheck.js"),
    include_str!("assets/drop.js"),
];

/// The page.
pub fn page() -> String {
    let source = [VERIFIER, CBOR, "export { verifyEither };\n"].concat();
    let program = verifier(&source) + &PROGRAM.concat();
    let policy = format!(
        "default-src 'none'; script-src {} blob:; worker-src blob:; style-src {}; base-uri 'none'; form-action 'none'",
        policy_hash(&program),
        policy_hash(STYLE)
    );
    fill(
        TEMPLATE,
        &[
            ("policy", &policy),
            ("style", STYLE),
            ("version", env!("CARGO_PKG_VERSION")),
            ("program", &program),
        ],
    )
}
