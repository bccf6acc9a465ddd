//! Tests of the programs and of several crates together, one binary for all.

mod appendix;
mod bundle;
mod cbor_files;
mod certificate_inputs;
mod cif;
mod cli;
mod common;
mod documents;
mod draw;
mod help;
mod interrupt;
mod js_verifier;
mod lower_bound;
mod mesh_cases;
mod meshes;
mod messages;
mod optimize;
mod paper;
mod quality;
mod records;
mod report;
mod starting_files;
mod tutorials;
mod verify;
