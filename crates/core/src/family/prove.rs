//! The one way to a proved family: the prover examines, writes a certificate, and the kernel checks
//! it.

use super::{AnyFamily, Family, FamilyProof, NotProvable, Tree, examine};
use crate::checker::{Options, Progress};
use crate::format;
use crate::proved::{NotProved, hexadecimal};
use crate::refusal::Refused;
use crate::statement::Statement;
use crate::transcribe::family;
use acutile_kernel::{Limits, Refusal, Verified, verify};

/// A certificate of a family that the kernel has confirmed.
#[derive(Debug)]
pub struct ProvedFamily {
    certificate: Vec<u8>,
    verified: Verified,
    statements: Vec<Statement>,
    tree: Tree,
}

/// Why a family is not proved.
#[derive(Debug)]
pub enum FamilyNotProved {
    /// By the prover.
    Prover(NotProvable),
    /// The kernel does not confirm the certificate.
    Unconfirmed(Box<Refusal>),
}

/// Proves a family: every member is a face-to-face tiling with the required statements. The other
/// statements that the prover finds to hold for all members are proved, too.
///
/// # Errors
/// [`FamilyNotProved`], with a point of the box where the family is refuted.
pub fn prove<const D: usize>(
    family: &Family<D>,
    options: &Options,
    progress: Progress,
) -> Result<ProvedFamily, FamilyNotProved> {
    let proof = examine(family, options, progress).map_err(FamilyNotProved::Prover)?;
    confirm(family, &proof, options, progress)
}

/// Writes the certificate of a proof, and asks the kernel.
///
/// # Errors
/// The kernel's refusal.
pub fn confirm<const D: usize>(
    family: &Family<D>,
    proof: &FamilyProof<D>,
    options: &Options,
    progress: Progress,
) -> Result<ProvedFamily, FamilyNotProved> {
    progress("certificate");
    let certificate = family::to_certificate(family, proof);
    progress("verification");
    let verified = verify(&mut &certificate[..], &options.limits);
    Ok(ProvedFamily {
        verified: verified.map_err(|refusal| FamilyNotProved::Unconfirmed(Box::new(refusal)))?,
        certificate,
        statements: proof.statements.clone(),
        tree: proof.tree.clone(),
    })
}

impl ProvedFamily {
    /// Asks the kernel about a certificate in either encoding, and reads its family.
    ///
    /// # Errors
    /// The kernel's refusal, or numbers that cannot be read.
    pub fn of_certificate(
        bytes: &[u8],
        limits: &Limits,
    ) -> Result<(ProvedFamily, AnyFamily), NotProved> {
        let cbor = format::to_cbor(bytes).map_err(NotProved::Json)?;
        let verified = verify(&mut &cbor[..], limits)
            .map_err(|refusal| NotProved::Unconfirmed(Refused::of_file(bytes, &cbor, refusal)))?;
        let (read, statements, tree) =
            family::of_certificate(&cbor).map_err(NotProved::Unreadable)?;
        let proved = ProvedFamily {
            certificate: cbor.into_owned(),
            verified,
            statements,
            tree,
        };
        Ok((proved, read))
    }

    /// The kernel's verdict alone.
    pub fn into_verified(self) -> Verified {
        self.verified
    }

    /// The certificate in CBOR.
    pub fn certificate(&self) -> &[u8] {
        &self.certificate
    }

    /// The kernel's verdict.
    pub fn verified(&self) -> &Verified {
        &self.verified
    }

    /// The statements of the claim.
    pub fn statements(&self) -> &[Statement] {
        &self.statements
    }

    /// How the box is cut.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The SHA-256 of the certificate, in hexadecimal digits.
    pub fn sha256(&self) -> String {
        hexadecimal(&self.verified.sha256)
    }
}
