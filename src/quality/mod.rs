//! Rigorous enclosures of angles, for messages and tables.
//!
//! No number here decides a proof: a bound that is found here is checked exactly
//! by [`crate::checker`] and by the verifier.

mod angle;
mod decimal;
mod shape;

pub use angle::{dihedral_degrees, display_width, largest_angles, least_bounds};
pub use decimal::{ceiling_to_i64, decimal_range, short_decimal};
pub use shape::{Shape, shapes, squared_edges};
