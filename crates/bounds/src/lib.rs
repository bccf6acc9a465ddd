//! Lower bounds for the largest dihedral angle of any tiling of space by tetrahedra.
//!
//! The theorems and their proof are in docs/lower-bound.md. This crate decides everything in the
//! proof that is finite: numerical inequalities, boxes, and facts about the 600-cell and about
//! triangulated spheres. The rest of the proof is for a reader.
//!
//! | file | contents |
//! |---|---|
//! | `check` | [`Check`] and [`Verdict`] |
//! | `theorem` | [`Theorem`]: a statement and the checks that its proof uses |
//! | `arithmetic` | the value of an expression, over any [`Arithmetic`] |
//! | `exact`, `enclosure` | number fields; rational enclosures, π, cosines and arccosines |
//! | `part` | a list of definitions and claims as text, and its checks |
//! | `lists` | these lists for all parts of the proof |
//! | `boxes` | inequalities for all triangles in a box, by bisection |
//! | `cell600`, `links` | the combinatorial lemmas |
//!
//! A claim is decided from the text that is printed. No floating-point number is used.

pub mod arithmetic;
pub mod boxes;
pub mod cell600;
pub mod check;
pub mod enclosure;
pub mod exact;
pub mod links;
pub mod lists;
pub mod part;
pub mod theorem;

pub use arithmetic::Arithmetic;
pub use check::{Check, Verdict};
pub use theorem::{THEOREMS, Theorem, theorem, worst};

/// Decides every finite step of the proof. `step` is called with the name of each part.
pub fn checks(step: &dyn Fn(&str)) -> Vec<Check> {
    let mut checks = Vec::new();
    for part in lists::PARTS {
        step(part.id);
        checks.extend(part.checks());
    }
    step(cell600::PART);
    checks.extend(cell600::checks(&cell600::Cells::of_600_cell()));
    step(links::PART);
    checks.extend(links::checks());
    checks.extend(boxes::Setting::proved().checks(step));
    checks
}
