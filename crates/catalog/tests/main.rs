//! Tests of the public interface of `acutile-catalog`, one binary for all.

mod angles;
mod common;
mod entries;
mod patches;
mod plane_tilings;
mod structures;
