//! The P, M, R and T phases of Frank and Kasper, by the digests of their minimal symbols.
//!
//! The files of `examples/frank-kasper` have their coordinates, with sources, and `examples/frank-kasper-phases.py`
//! computes the digests from them. Equal minimal symbols mean isomorphic triangulations.

/// Name and digest.
const LIST: &str = include_str!("phases.txt");

/// The name of the phase whose minimal symbol has this digest.
pub fn frank_kasper_phase(digest: &str) -> Option<String> {
    let rows = LIST.lines().filter_map(|line| line.split_once(' '));
    rows.filter(|row| row.1 == digest)
        .map(|row| format!("Frank-Kasper {} phase", row.0))
        .next()
}
