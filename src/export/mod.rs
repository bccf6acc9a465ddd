//! Tilings and point sets written as files for other programs and for people.

mod native;

pub use native::{points_text, tiling_text};
