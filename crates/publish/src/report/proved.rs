//! What a page may show as proved: a certificate that the kernel has confirmed, with the
//! tiling that it describes.

use acutile_core::checker::{self, Names, Options};
use acutile_core::tiling::AnyTiling;
use acutile_core::with_dimension;
use acutile_format1::certificate::{self, Certificate};
use acutile_format1::verifier::{Limits, Refusal, Verified, verify};
use acutile_io::import::{ImportError, tiling_of_certificate};
use std::fmt;

/// A confirmed certificate. Made by [`Proved::of_certificate`] alone, after the kernel.
#[derive(Debug)]
pub struct Proved {
    /// A name of the catalogue, or what its file is called. Not part of what is proved.
    pub name: String,
    /// What it is, in a line, or nothing; nor is this.
    pub description: String,
    bytes: Vec<u8>,
    verified: Verified,
    tiling: AnyTiling,
}

/// Why there is nothing to show as proved.
#[derive(Debug)]
pub enum NotProved {
    /// The checker found the tiling wrong; the first defect, in words.
    Refuted(String),
    /// The kernel does not confirm the certificate.
    Refused(Refusal),
    /// The kernel confirms it, and its numbers are beyond the prover's limits.
    Unreadable(ImportError),
}

impl fmt::Display for NotProved {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotProved::Refuted(reason) => write!(f, "refuted: {reason}"),
            NotProved::Refused(refusal) => {
                write!(f, "{} [{}] {refusal}", refusal.kind(), refusal.code())
            }
            NotProved::Unreadable(error) => write!(f, "{error}"),
        }
    }
}

impl Proved {
    /// Asks the kernel whether `bytes` prove what they claim, and reads the tiling from them.
    ///
    /// # Errors
    /// What the kernel says, or what cannot be read.
    pub fn of_certificate(
        name: String,
        description: String,
        bytes: Vec<u8>,
        limits: &Limits,
    ) -> Result<Proved, NotProved> {
        let verified = verify(&bytes, limits).map_err(NotProved::Refused)?;
        let json = |error| NotProved::Unreadable(ImportError::Json(error));
        let certificate: Certificate = serde_json::from_slice(&bytes).map_err(json)?;
        Ok(Proved {
            tiling: tiling_of_certificate(&certificate).map_err(NotProved::Unreadable)?,
            name,
            description,
            bytes,
            verified,
        })
    }

    /// Proves a tiling, telling the steps to `progress`, and asks the kernel.
    ///
    /// # Errors
    /// The first defect, or what the kernel says.
    pub fn of_tiling(
        name: String,
        description: String,
        tiling: &AnyTiling,
        progress: &dyn Fn(&str),
    ) -> Result<Proved, NotProved> {
        let bytes = with_dimension!(tiling, AnyTiling, t => certificate_bytes(t, progress))?;
        // Its size is no reason to doubt what was proved here.
        let limits = Limits {
            bytes: u64::MAX,
            simplices: usize::MAX,
            ..Limits::DEFAULT
        };
        Proved::of_certificate(name, description, bytes, &limits)
    }

    /// The certificate.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// What the kernel confirmed.
    pub fn verified(&self) -> &Verified {
        &self.verified
    }

    /// The tiling that the certificate describes.
    pub fn tiling(&self) -> &AnyTiling {
        &self.tiling
    }
}

fn certificate_bytes<const D: usize>(
    tiling: &acutile_core::tiling::Tiling<D>,
    progress: &dyn Fn(&str),
) -> Result<Vec<u8>, NotProved> {
    match checker::prove(tiling, &Options::default(), progress) {
        Ok(certificate) => Ok(certificate::to_bytes(&certificate)),
        Err(refutation) => {
            let first = refutation.kept().first();
            let words = first.map(|defect| checker::describe::<D>(&Names::of(tiling), defect));
            Err(NotProved::Refuted(words.unwrap_or_default()))
        }
    }
}
