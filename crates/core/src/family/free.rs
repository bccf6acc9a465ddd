//! A tiling becomes a family in which some coordinates vary.
