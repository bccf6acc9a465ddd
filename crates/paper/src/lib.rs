//! The paper: its constructions studied, its table, its statements decided.

pub mod paper;
pub mod survey;
pub mod table;
