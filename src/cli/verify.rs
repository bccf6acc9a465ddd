//! `acutile verify`: the same kernel and the same lines as `acutile-verify`.

use super::outcome::{Outcome, exit_outcome};
use super::output::Output;
use acutile_format1::front::verify_files;
use acutile_format1::verifier::{Limits, Verified};
use clap::Args;
use std::ffi::OsString;

#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// Certificates (`-` for standard input)
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<OsString>,
    /// One JSON object for each file
    #[arg(long)]
    pub json: bool,
    /// Bytes of a file
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.bytes)]
    pub limit_bytes: u64,
    /// Simplices of a certificate
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.simplices)]
    pub limit_simplices: usize,
    /// Decimal digits of a number
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.digits)]
    pub limit_digits: usize,
    /// Degree of the field
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.degree)]
    pub limit_degree: usize,
    /// Halvings of the root's interval
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.bisections)]
    pub limit_bisections: usize,
    /// Word products for one product of numbers in every simplex
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.work)]
    pub limit_work: u64,
}

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
