//! Tests of the public interface of `acutile-publish`, one binary for all.

mod gallery;
