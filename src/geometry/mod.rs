//! Exact predicates of simplices, written once for every dimension and every
//! kind of number.

pub mod scalar;

pub use scalar::{Scalar, Sign};
