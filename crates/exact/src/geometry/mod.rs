//! Exact predicates of simplices, written once for every dimension and every
//! kind of number.

pub mod bound;
pub mod boxes;
pub mod cell600;
pub mod linear;
pub mod quadratic;
pub mod scalar;
pub mod simplex;
pub mod space;
pub mod triangle;
pub mod wide;

pub use bound::Bound;
pub use quadratic::Quadratic;
pub use scalar::{RingElement, Scalar, Sign};
pub use simplex::{NormalProducts, Simplex};
pub use wide::{I128, I256, I512};
