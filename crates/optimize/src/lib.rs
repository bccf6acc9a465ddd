//! Better angles for a tiling: vertices and the lattice move, the combinatorics, the symmetry and the
//! boundary stay.
//!
//! | module | contents |
//! |---|---|
//! | `group` | the isometries that are kept, and how they act |
//! | `moves` | the allowed motions as affine functions of parameters, exactly |
//! | `goal`, `model` | values and gradients, in doubles |
//! | `program`, `descent` | linear programs in a trust region |
//! | `local` | large meshes: the stars of bad simplices, one after the other |
//! | `rounding` | points of a grid with a stated denominator |
//! | `search` | all steps, and the proof of the result |
//! | `value` | the proved value that a goal is about |
//! | `reason` | edges that prove that a tiling cannot become acute |
//! | [`balls`] | balls removed from the 600-cell |
//! | [`slabs`] | a search for slabs over plane tilings |
//! | `tight` | exact multipliers that prove local optimality |
//!
//! Doubles only propose. A result is rational, or lies in the field of the start, and
//! [`acutile_core::proved::prove`] has confirmed it.

pub mod balls;
mod descent;
mod goal;
mod group;
mod local;
mod model;
mod moves;
mod program;
mod reason;
mod rounding;
mod search;
pub mod slabs;
mod tight;
mod value;

pub use goal::Goal;
pub use group::{Element, Group, Keep, NoElement};
pub use moves::{Freedom, Moves};
pub use reason::{Reason, reasons};
pub use search::{Failure, Options, Outcome, Watch, optimize, prove_local};
pub use tight::{LocalProof, NotLocal};
pub use value::{Extreme, value};
