//! Exact numbers, and geometry over any ring.

pub mod geometry;
pub mod number;
