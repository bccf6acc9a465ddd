//! Tests of the public interface of `acutile-io`, one binary for all.

mod cif;
mod coq_export;
mod crystal_mutations;
mod crystals;
mod mesh_mutations;
mod meshes;
mod tiling_files;

#[path = "../../../tests/common/kuhn.rs"]
mod kuhn;
