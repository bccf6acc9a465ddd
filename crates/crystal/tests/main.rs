//! Tests of the crate, in one binary.

mod identify;
mod settings;
