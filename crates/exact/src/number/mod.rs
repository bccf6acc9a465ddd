//! Exact numbers: the rationals, real number fields, enclosures, and text.
//!
//! | file | holds |
//! |---|---|
//! | [`field`] | [`Field`]: Q and Q(a) |
//! | [`isolation`] | how a root becomes a field's |
//! | [`limits`] | numbers beyond them are declined |
//! | `denominator` | common denominators |
//! | `adjoin` | the numbers of a field, fields from roots |
//! | `element` | [`Number`]: arithmetic, comparison, display |
//! | `sign` | exact signs, enclosures, nearest doubles |
//! | `small` | products and signs in machine integers, where they fit |
//! | `root` | dyadic enclosures of a root and its powers |
//! | `polynomial` | polynomials over Q: Euclid, Sturm |
//! | `extension` | K(√d), K(b): a generator of a larger field |
//! | `recognition`, `lattice` | whether a real number lies in a field |
//! | `surd` | square roots in simplest form, generators of quadratic fields |
//! | [`subfield`] | the field that some numbers generate |
//! | [`text`] | the syntax of numbers |
//! | [`reader`] | the numbers of a file in one field |
//! | [`error`] | [`FieldError`], [`ReadError`] and their messages |
//! | [`enclosure`] | intervals, π, cosines and angles in degrees |
//!
//! It knows malachite and the [`Scalar`](crate::geometry::Scalar) that predicates ask for. The
//! verifier uses nothing of it.

mod adjoin;
mod denominator;
mod element;
pub mod enclosure;
pub mod error;
mod extension;
pub mod field;
pub mod isolation;
mod lattice;
pub mod limits;
mod polynomial;
pub mod radical;
pub mod reader;
pub mod recognition;
mod root;
mod sign;
mod small;
pub mod subfield;
mod surd;
pub mod text;

pub use denominator::{common_denominator, over_common_denominator};
pub use element::Number;
pub use enclosure::Interval;
pub use error::{Declared, FieldError, ReadError, ReadErrorKind};
pub use field::Field;
pub use reader::{Reader, numbers, parse_rational};
pub use subfield::Subfield;
pub use surd::{Quadratic, square_part};
pub use text::Expression;
