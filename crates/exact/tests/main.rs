//! Tests of the public interface of `acutile-exact`, one binary for all.

mod enclosure;
mod field;
mod polynomial;
mod reader;
mod subfield;
mod text;
mod twins;
