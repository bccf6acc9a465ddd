//! The trusted kernel of acutile.
//!
//! [`verify`] reads a certificate once, in deterministic CBOR, and checks everything that its claim states. The kernel
//! shares no code with the prover. It writes no certificates and no sentences, and it reads no JSON.

#![forbid(unsafe_code)]

#[macro_use]
mod refusal;
mod boxes;
mod cbor;
mod claim;
mod corners;
mod domain;
mod edges;
mod family;
mod filter;
mod front;
mod int;
mod joins;
mod limits;
mod meets;
mod numbers;
mod patch;
mod patches;
mod planes;
mod polynomial;
mod region;
mod ring;
mod root;
mod row;
mod rules;
mod table;
mod tiling;
mod transcript;
mod valences;
mod vertices;
mod walls;

pub use claim::Claim;
pub use limits::Limits;
pub use refusal::{Code, Kind, Place, Refusal, Value};
pub use tiling::{Facts, Verified};

use cbor::Cbor;
use claim::Domain;
use limits::Work;
use refusal::{Checked, Stop};
use std::io::Read;
use std::rc::Rc;

/// Checks a certificate.
///
/// # Errors
/// The first condition that does not hold, in the order in which the file is read.
pub fn verify(input: &mut dyn Read, limits: &Limits) -> Result<Verified, Refusal> {
    let work = Rc::new(Work::new(limits.work));
    read(Cbor::new(input, limits, &work)).map(Verified).map_err(Stop::refusal)
}

fn read(mut cbor: Cbor) -> Checked<Facts> {
    cbor.array_of(5)?;
    ensure!(cbor.text()? == "acutile-certificate", Format, cbor.place());
    let version = cbor.small()?;
    ensure!(version == 2, Version, cbor.place(), version);
    let kind = cbor.text()?;
    ensure!(["tiling", "family", "patches"].contains(&kind.as_str()), UnknownKind, cbor.place());
    let claim = Claim::read(&mut cbor, &kind)?;
    // The number is the capacity for coefficients. The compiler knows the degrees 1 and 2.
    match claim.field.degree() {
        1 => check::<1>(cbor, claim),
        2 => check::<2>(cbor, claim),
        _ => check::<8>(cbor, claim),
    }
}

fn check<const N: usize>(cbor: Cbor, claim: Claim) -> Checked<Facts> {
    match &claim.domain {
        Domain::Mosaics(_) => patches::verify::<N>(cbor, claim),
        _ if !claim.parameters.is_empty() => family::verify::<N>(cbor, claim),
        _ => tiling::verify::<N>(cbor, claim),
    }
}

#[cfg(test)]
#[path = "../tests/unit/mod.rs"]
mod tests;
