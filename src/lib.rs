//! acutile proves in exact arithmetic that tilings and meshes of tetrahedra are valid and acute.
//!
//! [`certify`] proves a [`Tiling`] and returns its [`Certificate`], after the kernel has confirmed it.
//! [`verify`] checks a certificate again, from its bytes alone.
//!
//! ```
//! use acutile::{Limits, Options, Tiling, Verdict, certify, verify};
//!
//! let a15 = Tiling::named("a15")?;
//! let options = Options::default().require("acute".parse()?);
//! let Verdict::Proved(certificate) = certify(&a15, &options)? else {
//!     panic!("A15 is acute");
//! };
//! let verified = verify(&certificate, &Limits::default())?;
//! assert!(verified.claim.contains("\"acute\""));
//! # Ok::<(), acutile::Error>(())
//! ```
//!
//! # Features
//!
//! `cli`, on by default, is what the program `acutile` needs: the command line, reports, appendices
//! and archives. A library user turns it off with `default-features = false`.
//!
//! This page leaves out families, systems of patches, quality and classification. The crates of the
//! workspace have them; ARCHITECTURE.md lists the crates. Their interfaces may still change.

#![warn(missing_docs)]

mod library;

pub use library::*;
