//! Exact numbers, polynomials in parameters, and geometry over any ring.

pub mod geometry;
pub mod number;
pub mod polynomial;
