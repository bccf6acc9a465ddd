//! Exact numbers: the rationals, real number fields, enclosures, and text.
//!
//! | file | holds |
//! |---|---|
//! | [`field`] | Q and Q(a), and how a field is made |
//! | `element` | [`Number`]: arithmetic, comparison, display |
//! | `sign` | exact signs, enclosures, nearest doubles |
//! | `root` | dyadic enclosures of a root and its powers |
//! | `polynomial` | polynomials over Q: Euclid, Sturm |
//! | [`enclosure`] | interval arithmetic |
//!
//! It knows malachite, the certificate's way of writing numbers, and the
//! [`Scalar`](crate::geometry::Scalar) that predicates ask for. The verifier
//! uses nothing of it.

mod element;
pub mod enclosure;
pub mod field;
mod polynomial;
mod root;
mod sign;

pub use element::Number;
pub use enclosure::Interval;
pub use field::{Field, FieldError};
