//! `acutile verify`: the same kernel and the same lines as `acutile-verify`.

use super::args::VerifyArguments;
use super::output::Output;
use super::{Outcome, exit_outcome};
use acutile_format1::front::verify_files;
use acutile_format1::verifier::{Limits, Verified};

/// Verifies every file.
pub fn run(arguments: &VerifyArguments, output: &mut Output) -> Outcome {
    let limits = Limits {
        bytes: arguments.limit_bytes,
        simplices: arguments.limit_simplices,
        digits: arguments.limit_digits,
        degree: arguments.limit_degree,
        bisections: arguments.limit_bisections,
        work: arguments.limit_work,
    };
    // Output keeps its errors to itself until it is finished.
    match verify_files(&arguments.files, &limits, arguments.json, output) {
        Ok(code) => exit_outcome(code),
        Err(_) => Outcome::Failed,
    }
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
