//! Tests of the public interface of `acutile-format1`, one binary for all.

mod cbor;
mod certificates;
mod cli;
mod limits;
mod properties;
mod schema;
