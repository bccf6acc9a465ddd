//! The trusted kernel of acutile.
//!
//! [`verify`] reads a certificate once, in deterministic CBOR, and checks everything that its
//! claim states. It shares no code with the prover.

#![forbid(unsafe_code)]

#[macro_use]
mod refusal;
mod cbor;
mod claim;
mod filter;
mod int;
mod limits;
mod ring;
mod root;
mod row;
mod vertices;

pub use claim::{Bound, Claim, Domain, Field, Number, Polytope, Quantity, Relation, Statement};
pub use limits::Limits;
pub use refusal::{Checked, Code, Kind, Limit, Place, Refusal, Value};

#[cfg(test)]
#[path = "../tests/unit/mod.rs"]
mod tests;
