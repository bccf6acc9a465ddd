//! What the readers of all formats of crystal structures share: the atoms of a cell, elements, decimals, options.
//!
//! | file | does |
//! |---|---|
//! | `structure` | the atoms of a cell with their labels |
//! | `element` | elements in symbols and labels |
//! | `distance` | the shortest distance |
//! | `decimal` | numbers exactly as written, and snapping |
//! | `options` | the options of the readers |
//! | `select` | the sites that the options choose |

pub mod decimal;
mod distance;
pub mod element;
pub mod options;
pub mod select;
pub mod structure;

pub use distance::Shortest;
