//! The table in the form of Table 1 of Eppstein, Sullivan and Üngör.
//!
//! Rounded outward to the paper's digits, a minimum down and a maximum up: the values of all
//! tetrahedra lie between the two numbers as printed.

use super::rational::decimal;
use super::subject::{Analysis, Subject};
use super::tex::{Table, escape};
use acutile_core::quality::{Exact, Range, measures_of_shapes, ranges, rounded_down, rounded_up};
use acutile_paper::table::label;
use malachite::Rational;

/// A row; nothing where there is no simplex.
pub fn row<const D: usize>(analysis: &Analysis<D>) -> Option<String> {
    let ranges = ranges(&measures_of_shapes(analysis.tiling, &analysis.shapes)?)?;
    let name = &analysis.subject.name;
    let title = match label(name) {
        Some(label) => escape(label),
        None => escape(name),
    };
    Some(format!(
        "{title} & {} & {} & {} & {}",
        analysis.tiling.len(),
        cells(&ranges.radius_edge, 3),
        cells(&ranges.smallest_dihedral, 2),
        cells(&ranges.largest_dihedral, 2),
    ))
}

fn cells<T: Exact>(range: &Range<T>, digits: u64) -> String {
    let width = Rational::from_signeds(1, 10_000_000_000i64);
    let (low, high) = (range.min.enclosure(&width), range.max.enclosure(&width));
    let ends = [
        (
            rounded_down(&low.0, digits),
            rounded_up(&low.1, digits),
            true,
        ),
        (
            rounded_down(&high.0, digits),
            rounded_up(&high.1, digits),
            false,
        ),
    ];
    let text = ends.map(|(below, above, is_min)| match (below == above, is_min) {
        (true, _) => below.trim_end_matches('0').trim_end_matches('.').to_owned(),
        (false, true) => below,
        (false, false) => above,
    });
    format!("${}$ & ${}$", decimal(&text[0]), decimal(&text[1]))
}

/// The table of all rows.
pub fn table(rows: Vec<String>, subjects: &[Subject]) -> String {
    let kind = if subjects.iter().all(Subject::is_in_space) {
        "tetrahedra"
    } else {
        "simplices"
    };
    Table {
        mark: "overview".to_owned(),
        columns: "lrrrrrrr",
        caption: format!(
            "The constructions in the form of Table~1 of~\\cite{{EppsteinSullivanUngor2004}}: number of {kind} in a cell, circumradius over \
             shortest edge, smallest and largest dihedral angle of each, with the minimum and the maximum over them. Minima are rounded down and maxima up.{}",
            if subjects.iter().any(|subject| subject.name == "icosahedral") {
" The names are those of the article; that the tiling from icosahedra is Z is refuted by \\texttt{acutile paper}: \
                         it is isomorphic to C14."
} else {
""
}
        ),
        label: "acutile:overview".to_owned(),
        heading: "& & \\multicolumn{2}{c}{radius/edge} & \\multicolumn{2}{c}{smallest angle} & \\multicolumn{2}{c}{largest angle} \\\\\n\
                  \\cmidrule(lr){3-4}\\cmidrule(lr){5-6}\\cmidrule(lr){7-8}\n\
                  construction & number & min & max & min & max & min & max"
            .to_owned(),
        rows,
    }
    .tex()
}
