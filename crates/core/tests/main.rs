//! Tests of the public interface of `acutile-core`, one binary for all.

mod advice;
mod curve;
mod curved;
mod delaunay;
mod families;
mod format;
mod plane_regions;
mod planes;
mod predicates;
mod prover_properties;
mod quality;
mod region;
mod requirements;
mod rungs;
mod search;
mod soup;
mod statistics;
mod symmetry;
mod tcp;
mod transcribe;

#[path = "../../../tests/common/kuhn.rs"]
mod kuhn;
#[path = "../../../tests/common/meeting.rs"]
mod meeting;
