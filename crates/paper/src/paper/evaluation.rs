//! Section 5: the 84 figures of Table 1.

use super::row::Row;
use crate::survey::Survey;
use crate::table::{self, COLUMNS, Figure, PAPER_ROWS};

/// The figures as printed: minimum and maximum of the radius-edge ratio, of the smallest
/// and of the largest dihedral angle.
const PRINTED: [[&str; 6]; 14] = [
    [".651", ".737", "53.13", "67.37", "73.89", "77.07"],
    [".645", ".707", "53.13", "67.79", "73.39", "78.46"],
    [".645", ".737", "53.13", "67.79", "73.39", "78.46"],
    [".612", ".711", "60", "70.52", "70.52", "74.20"],
    [".629", "1.000", "41.81", "69.09", "71.99", "83.62"],
    [".636", ".938", "46.83", "67.88", "74.39", "87.70"],
    ["1.118", "1.118", "45", "45", "90", "90"],
    [".645", ".645", "60", "60", "90", "90"],
    [".866", ".866", "45", "45", "120", "120"],
    ["1.581", "1.581", "30", "30", "131.81", "131.81"],
    [".612", ".866", "54.73", "70.53", "70.53", "90"],
    [".866", ".866", "45", "45", "90", "90"],
    [".612", ".612", "70.53", "70.53", "70.53", "70.53"],
    [".866", ".866", "54.73", "54.73", "90", "90"],
];

/// A row for each figure.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let mut rows = Vec::new();
    for ((name, label), printed) in PAPER_ROWS.iter().zip(&PRINTED) {
        for (k, printed) in printed.iter().enumerate() {
            rows.push(row(survey, name, label, k, printed));
        }
    }
    rows
}

fn row(survey: &Survey, name: &str, label: &str, k: usize, printed: &str) -> Row {
    let (column, _) = COLUMNS[k / 2];
    let (end, most) = if k.is_multiple_of(2) {
        ("min", "smallest")
    } else {
        ("max", "largest")
    };
    let (measure, unit) = match column {
        "radius_edge" => ("radius-edge ratio", ""),
        "smallest_dihedral" => ("smallest dihedral angle", "°"),
        _ => ("largest dihedral angle", "°"),
    };
    let statement = format!("{label}: the {most} value of the {measure} over all tetrahedra");
    Row::new(
        "5",
        &format!("table1/{name}/{column}/{end}"),
        &statement,
        printed,
    )
    .citing(survey, &[name])
    .figure(unit, figure(survey, name, k))
}

fn figure(survey: &Survey, name: &str, k: usize) -> Result<Figure, String> {
    let row = table::Row::of(name, survey.get(name)?);
    let (min, max) = row.figures[k / 2].clone();
    let figure = if k.is_multiple_of(2) { min } else { max };
    figure.ok_or_else(|| format!("{name}: has no bound"))
}
