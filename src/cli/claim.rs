//! A verified claim, in words and as data.

use acutile_core::proved::{hexadecimal, in_words};
use acutile_core::statement::counted;
use acutile_kernel::Verified;
use serde_json::Value;

/// The claim as the kernel prints it.
pub fn claim_json(verified: &Verified) -> Value {
    let file: Value = serde_json::from_str(verified.claim.print()).unwrap_or_default();
    file["claim"].clone()
}

/// The claim in words with counts and digest, in a line.
pub fn summary(verified: &Verified) -> String {
    format!(
        "{}. ({}, {}, sha256 {})",
        in_words(verified),
        counted(verified.vertices as usize, "vertex", "vertices"),
        counted(verified.simplices as usize, "simplex", "simplices"),
        hexadecimal(&verified.sha256)
    )
}

/// The statements of a sentence that joins them with semicolons, the counts at its end apart.
pub fn statements(words: &str) -> Vec<String> {
    let parts = words
        .split("; ")
        .flat_map(|part| match part.split_once(". (") {
            Some((statement, counts)) => vec![statement, counts.trim_end_matches(')')],
            None => vec![part],
        });
    parts.map(str::to_owned).collect()
}
