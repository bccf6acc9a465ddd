//! acutile proves that tilings by tetrahedra are valid and strictly acute.
//!
//! This library is the short way in: [`certify`] proves a tiling and returns its certificate, and
//! [`verify`] re-checks a certificate from its bytes alone. The crates of the workspace, listed in
//! ARCHITECTURE.md, hold everything else.
//!
//! ```
//! use acutile::{Limits, Requirement, certify, verify};
//!
//! let a15 = acutile::catalog::build("a15")?;
//! let certificate = certify(&a15, vec![Requirement::Acute]).expect("A15 is acute");
//! let verified = verify(&certificate, &Limits::DEFAULT).expect("and the kernel confirms it");
//! assert!(verified.claim.print().contains("\"acute\""));
//! # Ok::<(), acutile::catalog::CatalogError>(())
//! ```

pub use acutile_catalog as catalog;
pub use acutile_core::proved::NotProved;
pub use acutile_core::statement::{Requirement, Statement};
pub use acutile_core::tiling::{AnyTiling, Tiling};
pub use acutile_kernel::{Limits, Refusal, Verified};

use acutile_core::checker::Options;
use acutile_core::proved::{Proved, prove};
use acutile_core::with_dimension;

/// Proves that a tiling is one and that the requirements hold, and returns the certificate, in
/// CBOR, after the kernel has confirmed it.
///
/// ```
/// use acutile::{NotProved, Requirement, certify};
///
/// // The largest angles of Sommerville's tetrahedra are right angles.
/// let bcc = acutile::catalog::build("bcc")?;
/// assert!(certify(&bcc, vec![Requirement::Nonobtuse]).is_ok());
/// assert!(matches!(certify(&bcc, vec![Requirement::Acute]), Err(NotProved::Refuted(_))));
/// # Ok::<(), acutile::catalog::CatalogError>(())
/// ```
///
/// # Errors
/// The defects of the tiling, and the simplices that violate a requirement.
pub fn certify(tiling: &AnyTiling, required: Vec<Requirement>) -> Result<Vec<u8>, NotProved> {
    let options = Options {
        required,
        ..Options::default()
    };
    let proved = with_dimension!(tiling, AnyTiling, t => prove(t, &options, &|_| {}))?;
    Ok(proved.certificate().to_vec())
}

/// Checks a certificate in CBOR from its bytes alone.
///
/// # Errors
/// The first condition that does not hold.
pub fn verify(mut certificate: &[u8], limits: &Limits) -> Result<Verified, Refusal> {
    acutile_kernel::verify(&mut certificate, limits)
}

/// Checks a certificate in either encoding, and reads its tiling.
///
/// # Errors
/// As [`verify`], and where JSON is not canonical.
pub fn read(certificate: &[u8], limits: &Limits) -> Result<(Proved, AnyTiling), NotProved> {
    Proved::of_certificate(certificate, limits)
}
