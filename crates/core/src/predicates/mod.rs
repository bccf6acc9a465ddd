//! Exact signs of polynomials over all simplices of a tiling, at the speed of doubles.
//!
//! | file | holds |
//! |---|---|
//! | [`polynomials`] | the predicates, one text for every kind of number |
//! | [`floats`] | edges in doubles with a proved error |
//! | [`filter`] | values in doubles with a proved error: in front of all else |
//! | [`ring`] | the cleared coordinates, and the edges of a simplex in them |
//! | [`binary`] | doubles as integers in one binary unit |
//! | [`ladder`] | integers as wide as the bounds require, for the signs that the filter leaves open |
//! | [`model`] | a tiling made ready; both together |
//! | [`shapes`] | orientation and right angles of all simplices, in one pass |
//! | [`pairs`] | the in-sphere predicate for all pairs of neighbours |
//! | `positions` | [`Tiling::orient`](crate::tiling::Tiling), and tilings from positions |
//! | `vectors` | the vectors of a simplex from its first corner |
//! | [`volume`] | the sum of the determinants |
//!
//! A filter returns a sign that it proves, or none. The others are decided
//! exactly.

pub mod binary;
pub mod filter;
pub mod floats;
pub mod ladder;
pub mod model;
pub mod pairs;
pub mod polynomials;
mod positions;
pub mod ring;
pub mod shapes;
mod signs;
mod vectors;
pub mod volume;

pub use model::{Model, Prepared};
pub use polynomials::{
    Angles, AnglesAgainst, InSphere, Metric, Orientation, Predicate, Products, RadiusAgainst, Shape,
};
pub use shapes::Shapes;
pub use signs::Signs;
