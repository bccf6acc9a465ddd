//! Tests of the public interface of `acutile-optimize`, one binary for all.

mod closed_forms;
mod periodic;
mod regions;
