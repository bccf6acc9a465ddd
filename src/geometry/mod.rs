//! Exact predicates of simplices, written once for every dimension and every
//! kind of number. Called by the Delaunay room, the checker and the quality room.

pub mod boxes;
pub mod linear;
pub mod scalar;
pub mod simplex;
pub mod triangle;

pub use scalar::{Scalar, Sign};
pub use simplex::{NormalProducts, Simplex};
