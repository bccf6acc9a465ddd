//! The table as text, Markdown, LaTeX, CSV and JSON.
//!
//! In the formats for readers a figure has the paper's digits and is rounded outward, a minimum down and a
//! maximum up. So the values of all tetrahedra lie between the two printed numbers. A rational value that
//! needs no more digits is printed as it is. CSV and JSON have both ends of the enclosures, rounded
//! outward.

use super::{COLUMNS, DIGITS, Figure, Row};
use acutile_core::quality::{rounded_down, rounded_up};
use acutile_exact::number::radical::with_radicals;
use serde_json::{Map, Value, json};

/// Columns with blanks between, then the closed forms.
pub fn text(rows: &[Row]) -> String {
    let mut lines = vec![HEADINGS.map(str::to_owned).to_vec()];
    lines.extend(rows.iter().map(cells));
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max();
    let widths: Vec<usize> = (0..HEADINGS.len()).map(|k| width(k).unwrap_or(0)).collect();
    let mut text = String::new();
    for line in &lines {
        let first = format!("{:w$}", line[0], w = widths[0]);
        let others = (1..line.len()).map(|k| format!("  {:>w$}", line[k], w = widths[k]));
        text.push_str(&std::iter::once(first).chain(others).collect::<String>());
        text.push('\n');
    }
    text.push_str("\nClosed forms (ρ radius-edge ratio, α smallest, β largest dihedral angle):\n");
    for row in rows {
        let forms = closed_forms(row);
        if !forms.is_empty() {
            text.push_str(&format!("{}: {}\n", row.label, forms.join(", ")));
        }
    }
    text
}

const HEADINGS: [&str; 8] = [
    "construction",
    "number",
    "ρ min",
    "ρ max",
    "α min",
    "α max",
    "β min",
    "β max",
];

/// A table as GitHub and pandoc read it; closed forms in parentheses.
pub fn markdown(rows: &[Row]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(&HEADINGS.map(str::to_owned));
    text.push_str(&line(
        &["---", "--:", "--:", "--:", "--:", "--:", "--:", "--:"].map(str::to_owned),
    ));
    for row in rows {
        text.push_str(&line(&cells_with_forms(row, |form| form.to_owned())));
    }
    text
}

/// A `tabular` environment like the paper's.
pub fn latex(rows: &[Row]) -> String {
    let mut text = String::from(
        "% Packages: booktabs\n{\\small\\setlength{\\tabcolsep}{3pt}\n\\begin{tabular}{lrrrrrrr}\n\\toprule\n\
         & & \\multicolumn{2}{c}{radius/edge} & \\multicolumn{2}{c}{smallest angle} \
         & \\multicolumn{2}{c}{largest angle} \\\\\n\\cmidrule(lr){3-4}\\cmidrule(lr){5-6}\\cmidrule(lr){7-8}\n\
         construction & number & min & max & min & max & min & max \\\\\n\\midrule\n",
    );
    for row in rows {
        let mut cells = cells(row);
        cells[0] = row.label.replace('σ', "$\\sigma$");
        text.push_str(&format!("{} \\\\\n", cells.join(" & ")));
    }
    text.push_str("\\bottomrule\n\\end{tabular}\\par}\n");
    text.push_str(&latex_forms(rows));
    text
}

/// The closed forms of the figures that are not exact, in a paragraph below the table.
fn latex_forms(rows: &[Row]) -> String {
    let measures = ["radius/edge", "smallest angle", "largest angle"];
    let mut text = String::new();
    for row in rows {
        let figures = measures.iter().zip(&row.figures);
        let forms: Vec<String> = figures
            .flat_map(|(measure, (min, max))| [(measure, "min", min), (measure, "max", max)])
            .filter_map(|(measure, end, figure)| {
                let form = latex_form(&inexact_form(figure)?);
                Some(format!("{measure} {end} ${form}$"))
            })
            .collect();
        if !forms.is_empty() {
            let label = row.label.replace('σ', "$\\sigma$");
            text.push_str(&format!(
                "\\par{{\\small\\sloppy {label}: {}.\\par}}\n",
                forms.join(", ")
            ));
        }
    }
    text
}

/// `arccos(-√(1/6))` as `\arccos(-\sqrt{1/6})`.
fn latex_form(form: &str) -> String {
    with_radicals(
        form,
        |text| text.replace("arccos", "\\arccos"),
        str::to_owned,
    )
}

/// One line for each row: both ends and the closed form of each figure.
pub fn csv(rows: &[Row]) -> String {
    let mut header = vec![
        "name".to_owned(),
        "label".into(),
        "dimension".into(),
        "simplices".into(),
    ];
    for (column, _) in COLUMNS {
        for end in ["min", "max"] {
            header.extend(["lo", "hi", "closed"].map(|part| format!("{column}_{end}_{part}")));
        }
    }
    header.push("certificate".into());
    let mut text = header.join(",") + "\n";
    for row in rows {
        let mut line = vec![
            field(&row.name),
            field(&row.label),
            row.dimension.to_string(),
            count(row),
        ];
        for figure in row.figures.iter().flat_map(|(min, max)| [min, max]) {
            let ends = figure.as_ref().map(ends).unwrap_or_default();
            line.extend(ends);
            line.push(closed_form(figure).unwrap_or_default());
        }
        line.push(row.certificate.clone());
        text.push_str(&(line.join(",") + "\n"));
    }
    text
}

/// A field of a CSV file, quoted where it must be.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// An object with the member `rows`. `tetrahedra` counts the simplices, which for
/// `dimension` 2 are triangles.
pub fn json(rows: &[Row]) -> Value {
    let rows: Vec<Value> = rows.iter().map(json_row).collect();
    json!({ "rows": rows })
}

fn json_row(row: &Row) -> Value {
    let mut object = Map::new();
    object.insert("name".into(), json!(row.name));
    object.insert("label".into(), json!(row.label));
    object.insert("dimension".into(), json!(row.dimension));
    object.insert("tetrahedra".into(), json!(row.simplices));
    object.insert("shapes".into(), json!(row.shapes));
    for ((column, _), (min, max)) in COLUMNS.iter().zip(&row.figures) {
        let [low, high] = [min, max].map(|figure| figure.as_ref().map(ends));
        let mut measure = json!({ "min": low, "max": high });
        measure["closed"] = json!({ "min": closed_form(min), "max": closed_form(max) });
        object.insert((*column).into(), measure);
    }
    object.insert("certificate".into(), json!(row.certificate));
    Value::Object(object)
}

/// Both ends of an enclosure, rounded outward.
fn ends(figure: &Figure) -> [String; 2] {
    let (low, high) = &figure.bounds;
    [rounded_down(low, DIGITS), rounded_up(high, DIGITS)]
}

/// The number of simplices in a cell.
fn count(row: &Row) -> String {
    row.simplices.map_or(String::new(), |n| n.to_string())
}

fn closed_form(figure: &Option<Figure>) -> Option<String> {
    figure.as_ref()?.closed_form.clone()
}

/// The label, the number of simplices and the six figures; a dash where no bound is known.
fn cells(row: &Row) -> Vec<String> {
    let mut cells = vec![row.label.clone(), count(row)];
    let dash = || "–".to_owned();
    for ((_, digits), (min, max)) in COLUMNS.iter().zip(&row.figures) {
        let low = |min: &Figure| outward(min, *digits, rounded_down(&min.bounds.0, *digits));
        let high = |max: &Figure| outward(max, *digits, rounded_up(&max.bounds.1, *digits));
        cells.push(min.as_ref().map_or_else(dash, low));
        cells.push(max.as_ref().map_or_else(dash, high));
    }
    cells
}

/// The figure as it was rounded; without zeros at the end where that is the value itself.
fn outward(figure: &Figure, digits: u64, rounded: String) -> String {
    let (low, high) = &figure.bounds;
    if rounded_down(low, digits) == rounded_up(high, digits) {
        rounded
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
    } else {
        rounded
    }
}

/// As [`cells`], with the closed forms after those figures that are not exact.
fn cells_with_forms(row: &Row, write: impl Fn(&str) -> String) -> Vec<String> {
    let mut cells = cells(row);
    let figures = row.figures.iter().flat_map(|(min, max)| [min, max]);
    for (cell, figure) in cells[2..].iter_mut().zip(figures) {
        if let Some(form) = inexact_form(figure) {
            *cell = format!("{cell} ({})", write(&form));
        }
    }
    cells
}

/// The closed form of a figure that is not exact as printed.
fn inexact_form(figure: &Option<Figure>) -> Option<String> {
    let figure = figure.as_ref().filter(|figure| !figure.is_rational());
    figure?.closed_form.clone()
}

/// `ρ min √(5/12)` for every figure with a closed form that is not a number.
fn closed_forms(row: &Row) -> Vec<String> {
    let figures = row.figures.iter().flat_map(|(min, max)| [min, max]);
    HEADINGS[2..]
        .iter()
        .zip(figures)
        .filter_map(|(heading, figure)| Some(format!("{heading} {}", inexact_form(figure)?)))
        .collect()
}
