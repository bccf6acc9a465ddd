//! Certificates of format 1 and the kernel that re-checks them.

pub mod certificate;
pub mod front;
pub mod verifier;
