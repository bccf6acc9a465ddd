//! Rigorous measures of simplices: radius-edge ratios and dihedral angles, stored
//! exactly and enclosed as tightly as asked, and congruence classes.
//!
//! No number here decides a proof: a bound that is found here is checked exactly
//! by [`crate::checker`] and by the verifier.

mod angle;
mod closed_form;
mod compare;
mod decimal;
mod extremes;
mod measure;
mod ranges;
mod shape;

pub use angle::{dihedral_degrees, display_width};
pub use closed_form::{rational_root, root};
pub use compare::{compare_with_degrees, cosine_above, cosine_below};
pub use decimal::{
    decimal_range, plain_decimal, rounded_down, rounded_nearest, rounded_up, short_decimal,
    short_number, short_point,
};
pub use extremes::exact_ranges;
pub use measure::{DihedralAngle, Exact, RadiusEdge};
pub use ranges::{Measures, Range, Ranges, measures, measures_of_shapes, ranges};
pub use shape::{Shape, congruence_form, kinds, permutations, shapes, squared_edges};
