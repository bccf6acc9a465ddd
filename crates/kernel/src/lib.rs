//! The trusted kernel of acutile.
//!
//! [`verify`] reads a certificate once, in deterministic CBOR, and checks everything that its
//! claim states. The kernel shares no code with the prover. It writes no certificates and no
//! sentences, and it reads no JSON.

#![forbid(unsafe_code)]

#[macro_use]
mod refusal;
mod boxes;
mod cbor;
mod claim;
mod domain;
mod edges;
mod filter;
mod front;
mod grid;
mod int;
mod judge;
mod limits;
mod meets;
mod print;
mod questions;
mod region;
mod ring;
mod root;
mod row;
mod rules;
mod table;
mod tiling;
mod vertices;

pub use claim::{Bound, Claim, Domain, Field, Number, Polytope, Quantity, Relation, Statement};
pub use limits::Limits;
pub use refusal::{Checked, Code, Kind, Limit, Place, Refusal, Value};
pub use tiling::Verified;

use cbor::Cbor;
use limits::Work;
use std::io::Read;
use std::rc::Rc;

/// Checks a certificate.
///
/// # Errors
/// The first condition that does not hold, in the order in which the file is read.
pub fn verify(input: &mut dyn Read, limits: &Limits) -> Checked<Verified> {
    let work = Rc::new(Work::new(limits));
    let mut cbor = Cbor::new(input, limits, &work);
    cbor.array_of(5)?;
    let format = cbor.text()?;
    ensure!(format == "acutile-certificate", Format, cbor.place());
    let version = cbor.small()?;
    ensure!(version == 2, Version, cbor.place(), version);
    let kind = cbor.text()?;
    ensure!(kind == "tiling", UnknownKind, cbor.place());
    let claim = Claim::read(&mut cbor, limits)?;
    // The number is the capacity for coefficients. The compiler knows the degrees 1 and 2.
    match claim.field.degree() {
        1 => tiling::verify::<1>(cbor, claim, limits, work),
        2 => tiling::verify::<2>(cbor, claim, limits, work),
        3 | 4 => tiling::verify::<4>(cbor, claim, limits, work),
        _ => tiling::verify::<8>(cbor, claim, limits, work),
    }
}

#[cfg(test)]
#[path = "../tests/unit/mod.rs"]
mod tests;
