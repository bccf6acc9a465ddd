//! Limits: input beyond them is refused.

/// No entry of a vertex or a lattice vector is larger in size: products of three of them, with
/// small factors, fit into an i64.
pub const ENTRY_LIMIT: i64 = 100_000;
/// No word is longer.
pub const WORD_LIMIT: usize = 64;
/// A plane tiling is inflated no more often than this. Each time has 14 times as many vertices.
pub const DEPTH_LIMIT: usize = 4;
/// A box has no more cubes than this.
pub const CUBE_LIMIT: i64 = 64;
