//! Prints what is proved: figures, pages, appendices and archives. Decides nothing.

pub mod appendix;
pub mod bundle;
pub mod draw;
pub mod report;
