//! Rigorous measures of simplices: radius-edge ratios and dihedral angles, held
//! exactly and enclosed as tightly as asked, and congruence classes.
//!
//! No number here decides a proof: a bound that is found here is checked exactly
//! by [`crate::checker`] and by the verifier.

mod angle;
mod bounds;
mod closed_form;
mod decimal;
mod measure;
mod ranges;
mod shape;

pub use angle::{dihedral_degrees, display_width};
pub use bounds::{Bounds, bounds};
pub use closed_form::{rational_root, root};
pub use decimal::{
    ceiling_to_i64, decimal_range, floor_to_i64, rounded_down, rounded_nearest, rounded_up,
    short_decimal, short_point,
};
pub use measure::{DihedralAngle, Exact, RadiusEdge};
pub use ranges::{Measures, Range, Ranges, measures, measures_of_shapes, ranges};
pub use shape::{Shape, congruence_form, permutations, shapes, squared_edges};
