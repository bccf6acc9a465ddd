//! acutile proves that tilings by tetrahedra are valid and strictly acute.
//!
//! The rooms, in the direction in which data flows, are in ARCHITECTURE.md.

#![forbid(unsafe_code)]

#[cfg(feature = "prover")]
pub mod advice;
#[cfg(feature = "prover")]
pub mod appendix;
#[cfg(feature = "prover")]
pub mod bundle;
#[cfg(feature = "prover")]
pub mod catalog;
pub mod certificate;
#[cfg(feature = "prover")]
pub mod checker;
#[cfg(feature = "prover")]
pub mod classify;
#[cfg(feature = "prover")]
pub mod cli;
#[cfg(feature = "prover")]
pub mod delaunay;
#[cfg(feature = "prover")]
pub mod draw;
#[cfg(feature = "prover")]
pub mod export;
#[cfg(feature = "prover")]
pub mod format;
pub mod front;
#[cfg(feature = "prover")]
pub mod geometry;
#[cfg(feature = "prover")]
pub mod import;
#[cfg(feature = "prover")]
pub mod mesh;
#[cfg(feature = "prover")]
pub mod number;
#[cfg(feature = "prover")]
pub mod paper;
#[cfg(feature = "prover")]
pub mod predicates;
#[cfg(feature = "prover")]
pub mod quality;
#[cfg(feature = "prover")]
pub mod report;
#[cfg(feature = "prover")]
pub mod statistics;
#[cfg(feature = "prover")]
pub mod survey;
#[cfg(feature = "prover")]
pub mod table;
#[cfg(feature = "prover")]
pub mod tiling;
pub mod verifier;
