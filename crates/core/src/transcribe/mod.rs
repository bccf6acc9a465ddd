//! From a tiling to its certificate, and back.
//!
//! | file | contains |
//! |---|---|
//! | [`field`](mod@field) | the smallest field, and numbers in it |
//! | [`order`] | the order of the rows and the numbers of the vertices |
//! | [`curve`] | a space-filling curve |
//! | [`write`](mod@write) | tiling → certificate, row by row |
//! | [`read`] | certificate → tiling |
//! | [`family`] | family ⇄ certificate |
//!
//! The certificate of a tiling is determined by the tiling and its statements. Its Gram matrix is
//! primitive, and its vertices lie in the first cell. Its rows have an order for which few facets are open
//! at a time. Nothing here is checked: the kernel does that.

pub mod curve;
pub mod family;
pub mod field;
pub mod order;
pub mod read;
pub mod write;

pub use field::Written;
pub(crate) use read::Numbers;
pub use read::{ReadError, claim_in_words, of_certificate};
pub use write::{Parts, claim, to_certificate, write};
