//! Tests of the public interface of `acutile-publish`, one binary for all.

mod draw;
mod foam;
mod gallery;

#[path = "../../../tests/common/well_formed.rs"]
mod well_formed;
