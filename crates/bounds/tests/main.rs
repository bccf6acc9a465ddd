//! Tests of the public interface of `acutile-bounds`, one binary for all.

mod proof;
