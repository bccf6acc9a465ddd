//! Tests of the public interface of `acutile-paper`, one binary for all.

mod classify;
mod constructions;
