//! The combinatorial type of a tiling: valences, vertex stars, TCP or not, and with
//! which other tilings it is isomorphic.
//!
//! | file | holds |
//! |---|---|
//! | `ridges` | (D-2)-faces up to lattice translation and their valences |
//! | `sphere` | triangulated spheres and their canonical codes |
//! | `frank_kasper` | the vertex stars of TCP triangulations, found by exhaustion |
//! | `neighbours` | Voronoi neighbours of points, from uncut Delaunay cells |
//! | `polyhedra` | names of Delaunay cells |
//! | `star` | the type of each vertex |
//! | `tcp` | the definition of TCP, or the edges and triangles that violate it |
//! | `symbol` | Delaney-Dress symbols: isomorphism decided |
//! | `symmetry` | the isometries that keep a tiling, and orbits under them |
//!
//! Input is a tiling that passed the checker's hypotheses; nothing here is proved
//! about one that did not. Lengths play no part, but for the symbols that carry
//! them.

pub mod frank_kasper;
mod neighbours;
mod polyhedra;
mod ridges;
mod sphere;
mod star;
mod symbol;
mod symmetry;
mod tcp;

pub use neighbours::{Surroundings, surroundings};
pub use polyhedra::polyhedra;
pub use ridges::{Ridge, Ridges, Wedge};
pub use sphere::{Code, Triangle, code};
pub use star::{Star, stars};
pub use symbol::{Symbol, combinatorial_symbol, metric_symbol};
pub use symmetry::{Isometry, Symmetry, generators};
pub use tcp::{NotTcp, check_tcp, six_valent};
