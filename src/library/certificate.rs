//! Certificates and the kernel's verdict on them.

use super::Error;
use acutile_core::format::{print, to_cbor};
use acutile_core::proved;
use acutile_core::refusal::Refused;
use acutile_kernel::{self as kernel, Refusal};

/// The bytes of a certificate, in deterministic CBOR. They need not prove anything:
/// [`crate::verify`] asks the kernel.
///
/// ```
/// use acutile::Certificate;
///
/// let file = std::fs::read("certificates/bcc.json")?;
/// let certificate = Certificate::from_bytes(&file)?;
/// // Both encodings contain the same.
/// assert_eq!(certificate.to_json()?.as_bytes(), file);
/// assert_eq!(Certificate::from_bytes(certificate.as_bytes())?, certificate);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Certificate {
    cbor: Vec<u8>,
    /// The JSON that it was read from, so that a refusal names a line and not a byte.
    json: Option<Vec<u8>>,
}

/// Two certificates are equal if their CBOR is.
impl PartialEq for Certificate {
    fn eq(&self, other: &Self) -> bool {
        self.cbor == other.cbor
    }
}

impl Eq for Certificate {}

impl Certificate {
    /// Reads a certificate in either encoding, CBOR or canonical JSON.
    ///
    /// # Errors
    /// JSON that is not canonical.
    pub fn from_bytes(bytes: &[u8]) -> Result<Certificate, Error> {
        let cbor = to_cbor(bytes).map_err(Error::new)?;
        let json = (cbor != bytes).then(|| bytes.to_vec());
        Ok(Certificate {
            cbor: cbor.into_owned(),
            json,
        })
    }

    pub(crate) fn of_cbor(cbor: Vec<u8>) -> Certificate {
        Certificate { cbor, json: None }
    }

    /// The certificate in CBOR, the encoding that the kernel reads.
    pub fn as_bytes(&self) -> &[u8] {
        &self.cbor
    }

    /// The certificate in canonical JSON, the encoding for people.
    ///
    /// # Errors
    /// Bytes that are no certificate.
    pub fn to_json(&self) -> Result<String, Error> {
        let json = print::to_json(&self.cbor).map_err(Error::new)?;
        String::from_utf8(json).map_err(Error::new)
    }

    fn refused(&self, refusal: Refusal) -> Refused {
        let file = self.json.as_ref().unwrap_or(&self.cbor);
        Refused::of_file(file, &self.cbor, refusal)
    }
}

/// Limits of the kernel: at most 2^28 simplices, and work in proportion to the length of the
/// certificate. A certificate that exceeds a limit is declined, not refuted.
///
/// ```
/// use acutile::{Certificate, Limits, verify};
///
/// let certificate = Certificate::from_bytes(&std::fs::read("certificates/a15.json")?)?;
/// let refusal = verify(&certificate, &Limits::default().simplices(45)).unwrap_err();
/// assert!(refusal.to_string().contains("46"), "{refusal}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Limits(pub(crate) kernel::Limits);

impl Default for Limits {
    fn default() -> Self {
        Limits(kernel::Limits::DEFAULT)
    }
}

impl Limits {
    /// As they are, with at most `count` simplices.
    pub fn simplices(mut self, count: u64) -> Limits {
        self.0.simplices = count;
        self
    }

    /// As they are, with at most `units` units of work (docs/format.md defines the unit).
    pub fn work(mut self, units: u64) -> Limits {
        self.0.work = units;
        self
    }
}

/// A claim that the kernel has verified.
///
/// ```
/// use acutile::{Certificate, Limits, verify};
///
/// let certificate = Certificate::from_bytes(&std::fs::read("certificates/a15.json")?)?;
/// let verified = verify(&certificate, &Limits::default())?;
/// assert_eq!((verified.vertices, verified.simplices), (8, 46));
/// assert!(verified.words.contains("all dihedral angles are acute"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Verified {
    /// The claim, in canonical JSON. It alone defines what is proved.
    pub claim: String,
    /// The claim in words.
    pub words: String,
    /// The SHA-256 of the certificate's CBOR, in hexadecimal.
    pub sha256: String,
    /// The number of vertices, up to the lattice.
    pub vertices: u64,
    /// The number of simplices, up to the lattice.
    pub simplices: u64,
}

/// Asks the kernel whether a certificate proves its claim.
///
/// ```
/// use acutile::{Certificate, Limits, verify};
///
/// let file = std::fs::read("certificates/a15.json")?;
/// let certificate = Certificate::from_bytes(&file)?;
/// let verified = verify(&certificate, &Limits::default())?;
/// assert_eq!(verified.simplices, 46);
///
/// // One changed byte, and it is no certificate.
/// let mut bytes = certificate.as_bytes().to_vec();
/// bytes[100] ^= 1;
/// let changed = Certificate::from_bytes(&bytes).and_then(|c| verify(&c, &Limits::default()));
/// assert!(changed.is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The first condition that does not hold, with its code, place and exact value; or a limit. A place in
/// a certificate that was read from JSON is a line and a column.
pub fn verify(certificate: &Certificate, limits: &Limits) -> Result<Verified, Error> {
    let verified = kernel::verify(&mut certificate.as_bytes(), &limits.0);
    let verified = verified.map_err(|refusal| Error::new(certificate.refused(refusal)))?;
    Ok(Verified {
        claim: verified.claim.print().to_owned(),
        words: proved::in_words(&verified),
        sha256: proved::hexadecimal(&verified.sha256),
        vertices: u64::from(verified.vertices),
        simplices: verified.simplices,
    })
}
