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
use limits::Work;
use patch::Head;
use refusal::{Checked, Stop};
use std::io::Read;
use std::rc::Rc;

/// Checks a certificate.
///
/// # Errors
/// The first condition that does not hold, in the order in which the file is read.
pub fn verify(input: &mut dyn Read, limits: &Limits) -> Result<Verified, Refusal> {
    let work = Rc::new(Work::new(limits.work));
    let facts = read(Cbor::new(input, limits, &work), limits, &work);
    facts.map(Verified).map_err(Stop::refusal)
}

fn read(mut cbor: Cbor, limits: &Limits, work: &Rc<Work>) -> Checked<Facts> {
    cbor.array_of(5)?;
    ensure!(cbor.text()? == "acutile-certificate", Format, cbor.place());
    let version = cbor.small()?;
    ensure!(version == 2, Version, cbor.place(), version);
    let kind = cbor.text()?;
    if kind == "patches" {
        let head = Head::read(&mut cbor, limits)?;
        return match head.claim.field.degree() {
            1 => patches::verify::<1>(cbor, head, limits, work),
            2 => patches::verify::<2>(cbor, head, limits, work),
            _ => patches::verify::<8>(cbor, head, limits, work),
        };
    }
    let is_family = kind == "family";
    ensure!(is_family || kind == "tiling", UnknownKind, cbor.place());
    let claim = Claim::read(&mut cbor, limits, is_family)?;
    // The number is the capacity for coefficients. The compiler knows the degrees 1 and 2.
    match claim.field.degree() {
        1 if is_family => family::verify::<1>(cbor, claim, limits, work),
        2 if is_family => family::verify::<2>(cbor, claim, limits, work),
        _ if is_family => family::verify::<8>(cbor, claim, limits, work),
        1 => tiling::verify::<1>(cbor, claim, limits, work),
        2 => tiling::verify::<2>(cbor, claim, limits, work),
        _ => tiling::verify::<8>(cbor, claim, limits, work),
    }
}

#[cfg(test)]
#[path = "../tests/unit/mod.rs"]
mod tests;
