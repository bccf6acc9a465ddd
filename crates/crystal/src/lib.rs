//! Space groups in exact arithmetic.
//!
//! | module | contents |
//! |---|---|
//! | `motion` | x -> R x + t with R integral and t rational; groups of them modulo the lattice |
//! | `extra` | settings beyond the 530 |
//! | `hall`, `change` | Hall symbols, parsed into groups; changes of basis after them |
//! | `setting` | the 530 settings of the tables, found by Hermann-Mauguin symbol or number |
//! | `lattice` | the lattice of all translations of a group, and the change to a basis of it |
//! | `symmetry` | all motions that keep a point set with kinds of points |
//! | `identify` | the type of a group and a transformation to its standard setting |
//! | `wyckoff` | the Wyckoff letters of points |
//! | `solve` | linear equations over the rationals |
//!
//! The tables of symbols and Wyckoff positions and the search for a transformation are moyo's, which
//! works in doubles. It only proposes: every transformation is made exact and checked exactly.
//! The crate knows no file.

mod change;
mod extra;
pub mod hall;
pub mod identify;
mod lattice;
pub mod motion;
pub mod setting;
mod solve;
pub mod symmetry;
pub mod wyckoff;
