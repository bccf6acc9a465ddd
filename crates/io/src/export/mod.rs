//! Tilings and point sets written as files for other programs and for people.

mod coq;
mod native;

pub use coq::{NotATheorem, coq_theorem};
pub use native::{labelled_tiling_text, points_text, tiling_text};
