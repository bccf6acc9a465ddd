//! Limits of the kernel for the prover's own certificates.

use acutile_kernel::Limits;

/// Limits for certificates that were written here. Their size is no reason to decline them.
pub fn own_limits() -> Limits {
    Limits {
        bytes: u64::MAX,
        simplices: u64::MAX,
        bits: 1 << 20,
        ..Limits::DEFAULT
    }
}
