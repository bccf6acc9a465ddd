//! Section 4.3: the slab.

use super::introduction::{all_state, states_for_all};
use super::row::{Finding, Row};
use crate::survey::Survey;
use acutile_core::statement::Statement;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeSet;

/// The rows of section 4.3.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id, statement, printed| Row::new("4.3", id, statement, printed);
    vec![
        row(
            "slab-step-8",
            "the height of the vertices of step 8 is 2 (7.1 - 4.6) + 4.6 = 9.6",
            "9.6",
        )
        .found(Ok(height_of_step_8())),
        row(
            "slab-height",
            "bumps equal holes: the seven steps in reverse order end at the height 9.6 + 4.6 = 14.2, so that \
             γ = h/14.2",
            "h/14.2",
        )
        .found(Ok(height())),
        row(
            "slab-layers",
            "the vertices of the slab lie at the heights 0, 4, 4.6, 7.1, 9.6, 10.2, 14.2 times γ",
            "0, 4, 4.6, 7.1, 9.6",
        )
        .citing(survey, &["slab"])
        .found(layers(survey)),
        row(
            "slab-steps",
            "the eight steps fill the slab: for each vertex of the base 2, 3, 6, 6, 6 and 2 tetrahedra in the steps \
             2 to 7, 6 in step 8, and the seven steps again",
            "eight steps",
        )
        .citing(survey, &["slab"])
        .found(steps(survey)),
        row(
            "slab-acute",
            "the slab is triangulated by acute tetrahedra between its two planes",
            "acute triangulation of a slab",
        )
        .citing(survey, &["slab"])
        .found(all_state(survey, &["slab"], &Statement::Acute)),
        row(
            "slab-heights",
            "the slab with other heights z1, z2, z3 for 4, 4.6 and 7.1 is acute, too, in a box around the paper's \
             heights",
            "4, 4.6, 7.1",
        )
        .citing(survey, &["slab-all"])
        .found_for_all(states_for_all(survey, "slab-all", &[Statement::Acute])),
        row(
            "slab-stretch",
            "the slab with the paper's heights over grids with other squared sides w than 36 is acute, too",
            "γ = h/14.2",
        )
        .citing(survey, &["slab-stretch-all"])
        .found_for_all(states_for_all(survey, "slab-stretch-all", &[Statement::Acute])),
        row("slab-stack", "the slab can be repeated to fill all of space", "repeated")
            .citing(survey, &["slab-stack"])
            .found(all_state(survey, &["slab-stack"], &Statement::Acute)),
    ]
}

fn tenths(n: i64) -> Rational {
    Rational::from_signeds(n, 10)
}

fn height_of_step_8() -> (bool, String) {
    let height = Rational::from(2) * (tenths(71) - tenths(46)) + tenths(46);
    (height == tenths(96), format!("{height} γ, exactly"))
}

/// The layers from the top are those from the bottom. So the bumps of step 8 at 9.6 must be the tops of the
/// bumps of step 4 seen from above, 4.6 below the upper plane.
fn height() -> (bool, String) {
    let height = tenths(96) + tenths(46);
    // The midpoints at 7.1 must be in the middle.
    let holds = height == tenths(142) && tenths(71) * Rational::from(2) == height;
    (holds, format!("{height} γ, twice 7.1 γ"))
}

/// The base has one vertex, two triangles and three edges in a cell. A kagome layer, like that of the bumps
/// of step 5, has six pairs of neighbours.
fn steps(survey: &Survey) -> Finding {
    let study = survey.space("slab")?;
    let half: usize = [2, 3, 6, 6, 6, 2].iter().sum();
    let expected = 2 * half + 6;
    // Cells of the lattice may hold several vertices of the base.
    let bases = study.tiling.vertices.iter().map(|[_, _, height]| height);
    let lowest = bases.clone().min();
    let cells = bases
        .filter(|height| Some(height) == lowest.as_ref())
        .count();
    let found = study.tiling.len();
    Ok((
        found == expected * cells,
        format!("{found} tetrahedra for {cells} vertices of the base"),
    ))
}

/// The first two basis vectors span the base. So the height of a point is its third coordinate up to a
/// factor. In units of the slab's height times 14.2 it must be a whole number of tenths.
fn layers(survey: &Survey) -> Finding {
    let study = survey.space("slab")?;
    let heights: BTreeSet<Number> = study.tiling.vertices.iter().map(|[_, _, z]| z).collect();
    let (Some(lowest), Some(highest)) = (heights.first(), heights.last()) else {
        return Err("the slab has no vertices".to_owned());
    };
    let scale = (highest - lowest).inverse().ok_or("the slab is flat")?;
    let found: Vec<Number> = heights
        .iter()
        .map(|height| (height - lowest) * &scale * Number::from(tenths(142)))
        .collect();
    let expected: Vec<Number> = [0, 40, 46, 71, 96, 102, 142]
        .map(|n| Number::from(tenths(n)))
        .into();
    let words: Vec<String> = found.iter().map(Number::to_string).collect();
    Ok((found == expected, format!("{} times γ", words.join(", "))))
}
