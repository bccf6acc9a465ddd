//! Tests of the public interface of `acutile-catalog`, one binary for all.

mod catalog;
mod patches;
