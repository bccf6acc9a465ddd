//! Exact numbers: the rationals, real number fields, enclosures, and text.
//!
//! | file | holds |
//! |---|---|
//! | [`field`] | [`Field`]: Q and Q(a) |
//! | [`isolation`] | how a root becomes a field's, and limits |
//! | `element` | [`Number`]: arithmetic, comparison, display |
//! | `sign` | exact signs, enclosures, nearest doubles |
//! | `small` | products and signs in machine integers, where they fit |
//! | `root` | dyadic enclosures of a root and its powers |
//! | `polynomial` | polynomials over Q: Euclid, Sturm |
//! | `extension` | K(√d), K(b): a generator of a larger field |
//! | `recognition`, `lattice` | whether a real number lies in a field |
//! | [`text`] | the syntax of numbers |
//! | [`reader`] | the numbers of a file in one field |
//! | [`error`] | [`FieldError`], [`ReadError`] and their messages |
//! | [`enclosure`] | intervals, π, cosines and angles in degrees |
//!
//! It knows malachite, the certificate's way of writing numbers, and the
//! [`Scalar`](crate::geometry::Scalar) that predicates ask for. The verifier
//! uses nothing of it.

mod element;
pub mod enclosure;
pub mod error;
mod extension;
pub mod field;
pub mod isolation;
mod lattice;
mod polynomial;
pub mod reader;
pub mod recognition;
mod root;
mod sign;
mod small;
pub mod text;

pub use element::Number;
pub use enclosure::Interval;
pub use error::{FieldError, ReadError, ReadErrorKind};
pub use field::Field;
pub use reader::{Reader, numbers};
pub use text::{Expression, parse_rational};
