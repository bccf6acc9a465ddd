//! Tilings by simplices, and everything that is decided about them.

pub mod advice;
pub mod anatomy;
pub mod checker;
pub mod classify;
pub mod curved;
pub mod delaunay;
pub mod family;
pub mod foam;
pub mod format;
pub mod limits;
mod parallel;
pub mod patches;
pub mod predicates;
pub mod proved;
pub mod quality;
pub mod refusal;
pub mod statement;
pub mod statistics;
mod stream;
pub mod tiling;
pub mod transcribe;
