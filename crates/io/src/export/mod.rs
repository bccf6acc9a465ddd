//! Tilings and point sets written as files for other programs and for people.

mod algebra;
mod coq;
mod native;

pub use algebra::{System, algebra_text};
pub use coq::{coq_family_theorem, coq_file, coq_patches_theorem, coq_theorem};
pub use native::{labelled_tiling_text, points_text, tiling_text};
