//! The one way to "proved": the prover examines, writes a certificate, and the kernel checks it.
//!
//! [`Proved`] and [`Confirmed`] are made here only, and only after the kernel. A tiling gives a
//! certificate in memory ([`prove`]) or in a file ([`prove_to`]); a certificate is read again with
//! [`Proved::of_certificate`].

use crate::checker::{self, Findings, Names, Options, Progress};
use crate::format::{self, json::JsonError};
use crate::refusal::Refused;
use crate::statement::Statement;
use crate::stream::stream;
use crate::tiling::dimension::same;
use crate::tiling::{AnyTiling, Tiling};
use crate::transcribe::{self, ReadError};
use acutile_kernel::{Limits, Value, Verified, verify};
use std::fmt;
use std::io::{self, BufReader, BufWriter, IntoInnerError, Read, Seek, Write};
use std::panic::resume_unwind;
use std::thread;

/// A certificate that the kernel has confirmed, and its claim.
#[derive(Debug)]
pub struct Proved {
    certificate: Vec<u8>,
    verified: Verified,
    statements: Vec<Statement>,
}

/// The same without the certificate's bytes, which are in a file.
#[derive(Debug)]
pub struct Confirmed {
    verified: Verified,
    statements: Vec<Statement>,
}

/// Why nothing is proved.
#[derive(Debug)]
pub enum NotProved {
    /// Something is wrong with the tiling.
    Refuted(Findings),
    /// Nothing is known to be wrong, and a limit left something open.
    Declined(Findings),
    /// The kernel does not confirm the certificate.
    Unconfirmed(Refused),
    /// The certificate cannot be written, or not read again.
    Io(io::Error),
    /// The certificate's JSON is not canonical.
    Json(JsonError),
    /// The kernel confirms the certificate, and its numbers are beyond the prover's limits.
    Unreadable(ReadError),
}

impl NotProved {
    /// In words: the first defect of a tiling, or the other obstacle.
    pub fn in_words<const D: usize>(&self, tiling: &Tiling<D>) -> String {
        self.in_words_with::<D>(&Names::of(tiling))
    }

    /// The same with other names of simplices and vertices, like those of a mesh file.
    pub fn in_words_with<const D: usize>(&self, names: &Names) -> String {
        let first = |findings: &Findings| {
            let defect = findings.kept().first();
            let words = |defect| checker::describe::<D>(names, defect);
            defect.map_or_else(|| self.to_string(), words)
        };
        match self {
            NotProved::Refuted(findings) => format!("refuted: {}", first(findings)),
            NotProved::Declined(findings) => format!("declined: {}", first(findings)),
            _ => self.to_string(),
        }
    }
}

/// Defects by their codes; [`NotProved::in_words`] says more.
impl fmt::Display for NotProved {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let codes = |findings: &Findings| {
            let codes: Vec<&str> = findings.counts().keys().copied().collect();
            codes.join(", ")
        };
        match self {
            NotProved::Refuted(findings) => write!(f, "refuted: {}", codes(findings)),
            NotProved::Declined(findings) => write!(f, "declined: {}", codes(findings)),
            NotProved::Unconfirmed(refusal) => {
                write!(f, "the kernel does not confirm the certificate: {refusal}")
            }
            NotProved::Io(error) => write!(f, "{error}"),
            NotProved::Json(error) => {
                let verdict = if error.code.is_declined() {
                    "declined"
                } else {
                    "malformed"
                };
                write!(f, "{verdict} [{}] {error}", error.code.name())
            }
            NotProved::Unreadable(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for NotProved {}

impl From<Findings> for NotProved {
    fn from(findings: Findings) -> Self {
        if findings.is_declined() {
            NotProved::Declined(findings)
        } else {
            NotProved::Refuted(findings)
        }
    }
}

/// Proves a tiling: it is a face-to-face tiling with the required statements, and with the
/// strongest of the others that hold.
///
/// # Errors
/// [`NotProved`], with exact witnesses where the tiling is refuted.
pub fn prove<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
) -> Result<Proved, NotProved> {
    match D {
        2 => prove_in_plane(same(tiling), options, progress),
        _ => prove_in_space(same(tiling), options, progress),
    }
}

#[inline(never)]
fn prove_in_plane(
    tiling: &Tiling<2>,
    options: &Options,
    progress: Progress,
) -> Result<Proved, NotProved> {
    proved(tiling, options, progress)
}

#[inline(never)]
fn prove_in_space(
    tiling: &Tiling<3>,
    options: &Options,
    progress: Progress,
) -> Result<Proved, NotProved> {
    proved(tiling, options, progress)
}

/// The kernel reads the certificate in a thread of its own while it is written.
fn proved<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
) -> Result<Proved, NotProved> {
    let proof = checker::examine(tiling, options, progress)?;
    progress("certificate");
    let (writer, reader) = stream();
    thread::scope(|scope| {
        let kernel = scope.spawn(|| verify(&mut BufReader::new(reader), &options.limits));
        let mut out = BufWriter::with_capacity(1 << 16, writer);
        let written = transcribe::write(proof.parts(tiling), &mut out);
        let writer = written.and_then(|()| out.into_inner().map_err(IntoInnerError::into_error));
        progress("verification");
        // After an error the writer is gone, so that the kernel ends too.
        let certificate = writer.map_err(NotProved::Io)?.finish();
        let verified = kernel.join().unwrap_or_else(|panic| resume_unwind(panic));
        Ok(Proved {
            certificate,
            verified: verified.map_err(|refusal| NotProved::Unconfirmed(refusal.into()))?,
            statements: proof.statements,
        })
    })
}

/// As [`prove`], and writes the certificate to `storage`, from which the kernel reads it.
///
/// # Errors
/// As [`prove`].
pub fn prove_to<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
    storage: &mut (impl Read + Write + Seek),
) -> Result<Confirmed, NotProved> {
    match D {
        2 => prove_plane(same(tiling), options, progress, storage),
        _ => prove_space(same(tiling), options, progress, storage),
    }
}

/// A place that a certificate is written to and read from.
trait Storage: Read + Write + Seek {}

impl<S: Read + Write + Seek> Storage for S {}

#[inline(never)]
fn prove_plane(
    tiling: &Tiling<2>,
    options: &Options,
    progress: Progress,
    storage: &mut dyn Storage,
) -> Result<Confirmed, NotProved> {
    confirmed(tiling, options, progress, storage)
}

#[inline(never)]
fn prove_space(
    tiling: &Tiling<3>,
    options: &Options,
    progress: Progress,
    storage: &mut dyn Storage,
) -> Result<Confirmed, NotProved> {
    confirmed(tiling, options, progress, storage)
}

fn confirmed<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
    storage: &mut dyn Storage,
) -> Result<Confirmed, NotProved> {
    let proof = checker::examine(tiling, options, progress)?;
    progress("certificate");
    let mut out = BufWriter::new(&mut *storage);
    let written = transcribe::write(proof.parts(tiling), &mut out).and_then(|()| out.flush());
    drop(out);
    written.map_err(NotProved::Io)?;
    let statements = proof.statements;
    progress("verification");
    storage.rewind().map_err(NotProved::Io)?;
    let verified = verify(&mut BufReader::new(storage), &options.limits);
    Ok(Confirmed {
        verified: verified.map_err(|refusal| NotProved::Unconfirmed(refusal.into()))?,
        statements,
    })
}

impl Proved {
    /// Asks the kernel about a certificate in either encoding, and reads its tiling.
    ///
    /// # Errors
    /// The kernel's refusal, or numbers that cannot be read.
    pub fn of_certificate(bytes: &[u8], limits: &Limits) -> Result<(Proved, AnyTiling), NotProved> {
        let cbor = format::to_cbor(bytes).map_err(NotProved::Json)?;
        let length = cbor.len() as u64;
        let verified = verify(&mut &cbor[..], limits).map_err(|mut refusal| {
            if let Value::Limit("bytes", enough) = &mut refusal.value {
                *enough = Some(length);
            }
            NotProved::Unconfirmed(Refused::of_file(bytes, &cbor, refusal))
        })?;
        let (tiling, statements) =
            transcribe::of_certificate(&cbor).map_err(NotProved::Unreadable)?;
        let proved = Proved {
            certificate: cbor.into_owned(),
            verified,
            statements,
        };
        Ok((proved, tiling))
    }

    /// The certificate in CBOR.
    pub fn certificate(&self) -> &[u8] {
        &self.certificate
    }

    /// The kernel's verdict.
    pub fn verified(&self) -> &Verified {
        &self.verified
    }

    /// The statements of the claim, in the tiling's field.
    pub fn statements(&self) -> &[Statement] {
        &self.statements
    }

    /// The SHA-256 of the certificate, in hexadecimal digits.
    pub fn sha256(&self) -> String {
        hexadecimal(&self.verified.sha256)
    }
}

impl Confirmed {
    /// The kernel's verdict alone.
    pub fn into_verified(self) -> Verified {
        self.verified
    }

    /// The kernel's verdict.
    pub fn verified(&self) -> &Verified {
        &self.verified
    }

    /// The statements of the claim, in the tiling's field.
    pub fn statements(&self) -> &[Statement] {
        &self.statements
    }

    /// The SHA-256 of the certificate, in hexadecimal digits.
    pub fn sha256(&self) -> String {
        hexadecimal(&self.verified.sha256)
    }
}

/// The claim that the kernel confirmed, as data: read from the text that the kernel prints. `None`
/// for a family.
pub fn claim_of(verified: &Verified) -> Option<format::Claim> {
    let cbor = format::json::claim_to_cbor(verified.claim.print().as_bytes()).ok()?;
    format::read::claim_file(&cbor).ok()
}

/// The claim about a family that the kernel confirmed, as data.
pub fn family_claim_of(verified: &Verified) -> Option<format::family::FamilyClaim> {
    let cbor = format::json::claim_to_cbor(verified.claim.print().as_bytes()).ok()?;
    format::family::read_claim_file(&cbor).ok()
}

/// The claim that the kernel confirmed, in words, one line. A claim beyond the prover's limits is
/// given as its JSON.
pub fn in_words(verified: &Verified) -> String {
    let file = format::json::claim_to_cbor(verified.claim.print().as_bytes());
    if let Ok(theorem) = file.map(|file| format::patches::claim_of_file(&file))
        && let Ok(Ok(words)) = theorem.map(|claim| crate::patches::in_words(&claim))
    {
        return words;
    }
    let (simplices, boundary) = (verified.simplices, verified.boundary_facets);
    let family = || {
        let claim = family_claim_of(verified)?;
        transcribe::family::claim_in_words(&claim, simplices as usize).ok()
    };
    let words = match claim_of(verified) {
        Some(claim) => {
            transcribe::claim_in_words(&claim, simplices as usize, boundary as usize).ok()
        }
        None => family(),
    };
    words.unwrap_or_else(|| verified.claim.print().replace('\n', ""))
}

/// Bytes in hexadecimal digits.
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
