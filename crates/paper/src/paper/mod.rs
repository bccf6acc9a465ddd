//! Every checkable statement of the paper, decided when it is asked for.
//!
//! The paper is D. Eppstein, J. M. Sullivan, A. Üngör, Tiling space and slabs with acute
//! tetrahedra; sections are numbered as printed, with the introduction and motivation as 1.
//!
//! | file | section |
//! |---|---|
//! | `introduction` | abstract, 1 |
//! | `squares` | 2.1 Acute and nonobtuse triangulations |
//! | `tilings` | 2.2 Acute and nonobtuse tilings |
//! | `sommerville` | 2.2 and its figures: Sommerville's and Goldberg's tetrahedra |
//! | `acuteness` | 3.1 Acuteness test |
//! | `delaunay` | 3.2 Acuteness of Delaunay triangulations |
//! | `tcp`, `valence`, `structures` | 4.1 TCP triangulations |
//! | `icosahedra` | 4.2 |
//! | `slab` | 4.3 |
//! | `evaluation` | 5 and Table 1 |
//! | `question` | 5, open problem 2 |
//!
//! `row` defines a row and judges printed figures; `identity` and `infinitesimal`
//! prove polynomial identities; `random` makes tetrahedra. No verdict is stored: each is
//! computed from the constructions, which the checker has proved, or from an identity.

mod acuteness;
mod delaunay;
mod evaluation;
mod icosahedra;
mod identity;
mod infinitesimal;
mod introduction;
mod question;
mod random;
mod row;
mod slab;
mod sommerville;
mod squares;
mod structures;
mod tcp;
mod tilings;
mod valence;

pub use row::{Finding, Rounding, Row, Verdict, judge, mixed_number};

use crate::survey::Survey;

/// All statements, in the paper's order.
pub fn rows(survey: &Survey) -> Vec<Row> {
    [
        introduction::rows(survey),
        squares::rows(survey),
        tilings::rows(survey),
        sommerville::rows(survey),
        acuteness::rows(),
        delaunay::rows(survey),
        tcp::rows(survey),
        structures::rows(survey),
        valence::rows(survey),
        icosahedra::rows(survey),
        slab::rows(survey),
        evaluation::rows(survey),
        question::rows(survey),
    ]
    .concat()
}
