//! acutile proves that tilings by tetrahedra are valid and strictly acute.
//!
//! The crates, in the direction in which data flows, are in ARCHITECTURE.md.
