//! Section 5, open problem 2: which tiling of space minimizes the largest dihedral angle.
//!
//! The bounds from below are the theorems of docs/lower-bound.md, if all their finite steps hold.
//! The bound from above is the best value among the certificates of the catalogue.

use super::row::{Row, Verdict};
use crate::survey::{Study, Survey};
use acutile_bounds::{Theorem, Verdict as Step, checks, theorem};
use acutile_catalog as catalog;
use acutile_core::quality::{DihedralAngle, Exact, decimal_range, display_width};

/// The theorems that the row cites, in the order of their strength.
const BELOW: [&str; 2] = ["face-to-face-73.31", "tcp-73.44"];

/// The row of the open problem.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = Row::new(
        "5",
        "smallest-largest-angle",
        "which tiling of space with tetrahedra minimizes the maximum dihedral angle?",
        "open problem",
    );
    vec![match (bounds_below(), best(survey)) {
        (Err(reason), _) => row.found(Err(reason)),
        (_, None) => row.found(Err("no construction of space is proved".to_owned())),
        (Ok(below), Some((name, angle))) => Row {
            proved: format!("{}; {below}", bound_above(name, angle)),
            verdict: Verdict::Open,
            ..row.citing(survey, &[name])
        },
    }]
}

/// The theorems, if they are proved.
///
/// # Errors
/// A finite step that does not hold, or was not decided.
fn bounds_below() -> Result<String, String> {
    let checks = checks(&|_| {});
    let statements = BELOW.map(|id| {
        let theorem = theorem(id).ok_or_else(|| format!("{id}: there is no such theorem"))?;
        match theorem.verdict(&checks) {
            Step::Holds => Ok(in_words(theorem)),
            verdict => Err(format!(
                "{id}: a finite step of the proof {}",
                verdict.word()
            )),
        }
    });
    let [any, tcp] = statements;
    Ok(format!("{}; {}", any?, tcp?))
}

fn in_words(theorem: &Theorem) -> String {
    let Theorem {
        statement, place, ..
    } = theorem;
    format!("{statement} (docs/lower-bound.md, {place}; its finite steps: acutile lower-bound)")
}

/// The construction of space whose largest dihedral angle is the smallest.
fn best(survey: &Survey) -> Option<(&str, &DihedralAngle)> {
    let tiles_space = |name: &str| catalog::find(name).is_some_and(|entry| entry.domain == "space");
    let largest = |study: &'_ Study<3>| study.ranges.largest_dihedral.max.clone();
    survey
        .spaces()
        .filter(|(name, _)| tiles_space(name))
        .min_by_key(|(_, study)| largest(study))
        .map(|(name, study)| (name, &study.ranges.largest_dihedral.max))
}

fn bound_above(name: &str, angle: &DihedralAngle) -> String {
    let range = decimal_range(&angle.enclosure(&display_width()));
    let form = angle
        .closed_form()
        .map_or(range.clone(), |form| format!("{form} = {range}"));
    format!("the catalogue's best certificate is {name}: all angles at most {form}°")
}
