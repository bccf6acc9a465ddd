//! The only input that a page shows as proved: a certificate that the kernel has confirmed, with the tiling
//! that it describes.

use acutile_core::checker::Options;
use acutile_core::format::print;
use acutile_core::proved::{self, prove};
use acutile_core::statement::Statement;
use acutile_core::tiling::AnyTiling;
use acutile_core::transcribe;
use acutile_core::with_dimension;
use acutile_kernel::{Limits, Verified};
use std::fmt;

/// A confirmed certificate with a name. The tiling has the certificate's order of vertices,
/// simplices and corners.
#[derive(Debug)]
pub struct Proved {
    /// A name of the catalogue, or the name of its file. It is no part of the proof.
    pub name: String,
    /// A description in a line, or nothing. It is no part of the proof.
    pub description: String,
    proved: proved::Proved,
    tiling: AnyTiling,
    json: String,
}

/// Why there is nothing to show as proved.
#[derive(Debug)]
pub struct NotProved {
    /// The verdict of the prover.
    pub reason: Box<proved::NotProved>,
    /// The same in words, with the first defect of a tiling.
    pub message: String,
}

impl fmt::Display for NotProved {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl From<proved::NotProved> for NotProved {
    fn from(reason: proved::NotProved) -> Self {
        NotProved {
            message: reason.to_string(),
            reason: Box::new(reason),
        }
    }
}

impl Proved {
    /// Asks the kernel whether `bytes`, in either encoding, prove what they claim.
    ///
    /// # Errors
    /// The kernel's refusal, or what cannot be read.
    pub fn of_certificate(
        name: String,
        description: String,
        bytes: &[u8],
        limits: &Limits,
    ) -> Result<Proved, NotProved> {
        let (proved, tiling) = proved::Proved::of_certificate(bytes, limits)?;
        Ok(Proved::new(name, description, proved, tiling))
    }

    /// Proves a tiling with these options, calling `progress` with each step.
    ///
    /// # Errors
    /// The first defect, or the kernel's refusal.
    pub fn of_tiling(
        name: String,
        description: String,
        tiling: &AnyTiling,
        options: &Options,
        progress: &dyn Fn(&str),
    ) -> Result<Proved, NotProved> {
        let proved = with_dimension!(tiling, AnyTiling, t => {
            prove(t, options, progress).map_err(|reason| NotProved {
                message: reason.in_words(t),
                reason: Box::new(reason),
            })
        })?;
        let (tiling, _) = transcribe::of_certificate(proved.certificate())
            .map_err(proved::NotProved::Unreadable)?;
        Ok(Proved::new(name, description, proved, tiling))
    }

    fn new(name: String, description: String, proved: proved::Proved, tiling: AnyTiling) -> Proved {
        // The kernel has read the bytes.
        let json = print::to_json(proved.certificate()).unwrap_or_default();
        Proved {
            name,
            description,
            json: String::from_utf8(json).unwrap_or_default(),
            proved,
            tiling,
        }
    }

    /// The certificate, in CBOR.
    pub fn certificate(&self) -> &[u8] {
        self.proved.certificate()
    }

    /// The certificate in JSON.
    pub fn json(&self) -> &str {
        &self.json
    }

    /// The kernel's verdict.
    pub fn verified(&self) -> &Verified {
        self.proved.verified()
    }

    /// The statements of the claim.
    pub fn statements(&self) -> &[Statement] {
        self.proved.statements()
    }

    /// The SHA-256 of the certificate, which is its CBOR, in hexadecimal digits.
    pub fn sha256(&self) -> String {
        self.proved.sha256()
    }

    /// The claim in words: the tiling and its further statements, with semicolons between.
    pub fn in_words(&self) -> String {
        proved::in_words(self.verified())
    }

    /// The tiling that the certificate describes.
    pub fn tiling(&self) -> &AnyTiling {
        &self.tiling
    }
}
