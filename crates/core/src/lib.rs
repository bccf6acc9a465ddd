//! Tilings by simplices, and everything that is decided about them.

pub mod advice;
pub mod checker;
pub mod classify;
pub mod delaunay;
pub mod predicates;
pub mod quality;
pub mod statistics;
pub mod tiling;
