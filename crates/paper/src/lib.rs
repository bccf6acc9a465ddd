//! The paper: its constructions studied, its table, its statements decided.

pub mod paper;
pub mod records;
pub mod survey;
pub mod table;
