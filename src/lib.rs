//! acutile proves that tilings by tetrahedra are valid and strictly acute.
//!
//! This library is the short way in: [`certify`] proves a tiling and returns its certificate, and
//! [`verify`] re-checks a certificate from its bytes alone. The crates of the workspace, listed in
//! ARCHITECTURE.md, hold everything else.
//!
//! ```
//! use acutile::{Limits, Statement, certify, verify};
//!
//! let a15 = acutile::catalog::build("a15")?;
//! let certificate = certify(&a15, vec![Statement::Acute]).expect("A15 is acute");
//! let verified = verify(&certificate, &Limits::DEFAULT).expect("and the verifier confirms it");
//! assert!(verified.claim().statements.contains(&Statement::Acute));
//! # Ok::<(), acutile::catalog::CatalogError>(())
//! ```

pub use acutile_catalog as catalog;
pub use acutile_core::checker::Refutation;
pub use acutile_core::tiling::{AnyTiling, Tiling};
pub use acutile_format1::certificate::Statement;
pub use acutile_format1::verifier::{Limits, Refusal, Verified, verify};

use acutile_core::checker::{Options, prove};
use acutile_core::with_dimension;
use acutile_format1::certificate::to_bytes;

/// Proves that a tiling is one and that the statements hold, and returns the certificate.
///
/// ```
/// use acutile::{Statement, certify};
///
/// // The largest angles of Sommerville's tetrahedra are right angles.
/// let bcc = acutile::catalog::build("bcc")?;
/// assert!(certify(&bcc, vec![Statement::Nonobtuse]).is_ok());
/// assert!(certify(&bcc, vec![Statement::Acute]).is_err());
/// # Ok::<(), acutile::catalog::CatalogError>(())
/// ```
///
/// # Errors
/// The defects of the tiling, and the simplices that violate a statement.
pub fn certify(tiling: &AnyTiling, required: Vec<Statement>) -> Result<Vec<u8>, Refutation> {
    let options = Options {
        required,
        ..Options::default()
    };
    let certificate = with_dimension!(tiling, AnyTiling, t => prove(t, &options, &|_| {}))?;
    Ok(to_bytes(&certificate))
}
