//! The trusted kernel: it re-checks a certificate from its bytes alone.
//!
//! It shares the description of the data ([`crate::certificate`]) with the
//! prover, and no arithmetic and no judgement. The order of reading:
//!
//! | file | what it establishes |
//! |---|---|
//! | `document` | the bytes are a certificate of a known version, in the one notation it has |
//! | `shape` | lengths, ranges and order: every index points at something |
//! | `number`, `integer` | rationals from text; integers of any length |
//! | `ring`, `root` | the field; sums, products and signs in it |
//! | `tiling` | all numbers of the certificate as elements of one ring |
//! | `domain` | the domain's polytope, and that the tiling keeps to its boundary |
//! | `mates` | the facets are paired, each pair one facet seen from two sides |
//! | `region`, `extent`, `apart` | the boundary of a region does not meet itself, and nothing is outside of it |
//! | `geometry` | metric, orientation, volume, and the claimed statements |
//! | `angle`, `radius`, `tcp` | the statements that need more than a sign of a product |
//! | `words` | the claim in words |
//! | `refusal`, `render` | what can be wrong, and the words for it |
//!
//! Whatever goes wrong is a [`Refusal`]. There is no panic, no clock, no thread,
//! no floating point, and no loop that the [`Limits`] do not bound.

mod angle;
mod apart;
mod document;
mod domain;
mod extent;
mod geometry;
mod integer;
mod limits;
mod mates;
mod matrix;
mod number;
mod radius;
mod refusal;
mod region;
mod render;
mod ring;
mod root;
#[cfg(test)]
mod sabotage;
mod shape;
mod tcp;
mod tiling;
mod words;

use crate::certificate::{Certificate, Claim};
use sha2::{Digest, Sha256};

pub use limits::Limits;
pub use refusal::{Kind, Refusal};

/// A claim that has been checked. Only [`verify`] makes one; its `Display` says
/// the claim in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verified {
    claim: Claim,
    vertices: usize,
    simplices: usize,
    boundary: usize,
    sha256: String,
}

impl Verified {
    /// What is proved.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// Vertices, up to lattice translations.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// Simplices, up to lattice translations.
    pub fn simplices(&self) -> usize {
        self.simplices
    }

    /// Facets in the boundary of the domain, up to lattice translations.
    pub fn boundary(&self) -> usize {
        self.boundary
    }

    /// SHA-256 of the certificate's bytes: 64 hexadecimal digits.
    pub fn sha256(&self) -> &str {
        &self.sha256
    }
}

/// Checks everything that the certificate in `bytes` claims.
///
/// Pure. The first check that fails gives the refusal.
pub fn verify(bytes: &[u8], limits: &Limits) -> Result<Verified, Refusal> {
    verify_by(bytes, limits, shape::CHECKS, geometry::CHECKS)
}

/// [`verify`], with its checks as a parameter so that the tests can show what
/// would be accepted without each of them.
fn verify_by(
    bytes: &[u8],
    limits: &Limits,
    shape: &[(&str, shape::Check)],
    geometry: &[(&str, geometry::Check)],
) -> Result<Verified, Refusal> {
    let certificate = document::read(bytes, limits)?;
    for (_, check) in shape {
        check(&certificate, limits)?;
    }
    let tiling = tiling::Tiling::new(&certificate, limits)?;
    for (_, check) in geometry {
        check(&tiling)?;
    }
    Ok(verified(&certificate, bytes))
}

fn verified(certificate: &Certificate, bytes: &[u8]) -> Verified {
    let digest = Sha256::digest(bytes);
    let mates = certificate.witness.mates.iter().flatten();
    Verified {
        claim: certificate.claim.clone(),
        vertices: certificate.witness.vertices.len(),
        simplices: certificate.witness.simplices.len(),
        boundary: mates.filter(|mate| mate.0.len() < 2).count(),
        sha256: digest.iter().map(|byte| format!("{byte:02x}")).collect(),
    }
}
