//! Tests of the public interface of `acutile-bounds`, one binary for all.

mod boxes;
mod cells;
mod claims;
mod links;
mod numbers;
mod proof;
