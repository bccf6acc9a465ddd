//! The types of the library. None of them shows a type of a crate for big numbers.

mod certificate;
mod error;
mod number;
mod tiling;
mod verdict;

pub use certificate::{Certificate, Limits, Verified, verify};
pub use error::Error;
pub use number::Number;
pub use tiling::{ReadOptions, Tiling};
pub use verdict::{Finding, Options, Statement, Verdict, certify};
