//! The definitions and claims of all parts of the proof.
//!
//! | file | parts |
//! |---|---|
//! | `ideal` | the angle arccos(√3/6), exactly |
//! | `simple` | valences, tilings that are not face to face |
//! | `refined` | angles given in degrees |
//!
//! Angles are in degrees. The names are those of docs/lower-bound.md: `c` and `s` are the cosine and
//! sine of theta, `ca` and `sa` those of a0 = 360 - 4 theta.

mod ideal;
mod refined;
mod simple;

use super::part::Part;

pub use ideal::{CONTRADICTION, NUMBERS, STAR};
pub use refined::{REFINED_STAR, REFINED_VALENCES, WIDER_VALENCES};
pub use simple::{ANY_TILING, DIGITS, FIVE_OR_SIX, FOURTEEN, VALENCES};

/// All parts, in the order of the proof.
pub const PARTS: [&Part; 11] = [
    &NUMBERS,
    &DIGITS,
    &FIVE_OR_SIX,
    &ANY_TILING,
    &VALENCES,
    &CONTRADICTION,
    &STAR,
    &FOURTEEN,
    &REFINED_VALENCES,
    &REFINED_STAR,
    &WIDER_VALENCES,
];
