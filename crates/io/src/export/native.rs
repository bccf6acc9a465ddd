//! Writes the project's own tiling file, the format that [`crate::import`] reads.

use acutile_core::tiling::{Corner, Domain, Frame, PointSet, Polytope, Tiling};
use acutile_exact::number::{Field, Number};
use serde_json::{Value, json};
use std::borrow::Borrow;
use std::fmt::Write;

/// The text of a tiling file.
pub fn tiling_text<const D: usize>(tiling: &Tiling<D>, name: &str) -> String {
    labelled_tiling_text(tiling, name, &[])
}

/// The text of a tiling file with a label for each vertex, if there are labels.
pub fn labelled_tiling_text<const D: usize>(
    tiling: &Tiling<D>,
    name: &str,
    labels: &[String],
) -> String {
    let vertices = rows(tiling.vertices.iter());
    let simplices = tiling
        .simplices()
        .map(|corners| simplex(corners, tiling.frame.rank()));
    let mut text = head("acutile-tiling", &tiling.frame, name);
    list(&mut text, "vertices", vertices);
    text.push_str(",\n");
    if !labels.is_empty() {
        list(&mut text, "labels", labels.iter().map(|label| json!(label)));
        text.push_str(",\n");
    }
    list(&mut text, "simplices", simplices);
    text.push_str("\n}\n");
    text
}

/// The text of a point-set file.
pub fn points_text<const D: usize>(points: &PointSet<D>, name: &str) -> String {
    let mut text = head("acutile-points", &points.frame, name);
    list(&mut text, "points", rows(&points.points));
    text.push_str("\n}\n");
    text
}

/// Everything before the lists, without the closing brace.
fn head<const D: usize>(format: &str, frame: &Frame<D>, name: &str) -> String {
    let gram = rows(&frame.gram).collect::<Vec<_>>();
    let mut members = vec![
        ("format", json!(format)),
        ("version", json!(1)),
        ("name", json!(name)),
        ("dimension", json!(D)),
    ];
    if frame.field.degree() > 1 {
        members.push(("generators", generator(&frame.field)));
    }
    members.push(("lattice", json!({ "gram": gram })));
    members.push(("domain", domain(&frame.domain)));
    let mut text = String::from("{\n");
    for (name, value) in members {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {}: {value},", json!(name));
    }
    text
}

fn domain(domain: &Domain) -> Value {
    match domain {
        Domain::Space => json!("space"),
        Domain::Slab(interval) => {
            let heights: Vec<String> = interval.vertices.iter().map(|x| number(&x[0])).collect();
            json!({ "slab": heights })
        }
        Domain::Prism(polygon) => json!({ "prism": polytope(polygon) }),
        Domain::Solid(solid) => json!({ "solid": polytope(solid) }),
        Domain::Region(0) => json!("region"),
        Domain::Region(rank) => json!({ "region": rank }),
    }
}

fn polytope(polytope: &Polytope) -> Value {
    let vertices: Vec<Vec<String>> = polytope
        .vertices
        .iter()
        .map(|vertex| vertex.iter().map(number).collect())
        .collect();
    json!({ "vertices": vertices, "faces": polytope.faces })
}

fn generator(field: &Field) -> Value {
    let (lower, upper) = field.root();
    let polynomial: Vec<String> = field.polynomial().iter().map(ToString::to_string).collect();
    json!({ field.symbol(): { "polynomial": polynomial, "root": [lower.to_string(), upper.to_string()] } })
}

fn rows<const D: usize>(
    rows: impl IntoIterator<Item = impl Borrow<[Number; D]>>,
) -> impl Iterator<Item = Value> {
    rows.into_iter()
        .map(|row| Value::Array(row.borrow().iter().map(|x| json!(number(x))).collect()))
}

/// A number in the generator of its field, by the symbol of that.
fn number(number: &Number) -> String {
    number_in(number, number.field().map_or("", Field::symbol))
}

/// `1/2+3/4*a^2`, where `a` is the symbol.
pub(super) fn number_in(number: &Number, symbol: &str) -> String {
    let mut text = String::new();
    for (power, coefficient) in number.coefficients().iter().enumerate() {
        if *coefficient == 0 {
            continue;
        }
        if !text.is_empty() && *coefficient > 0 {
            text.push('+');
        }
        let _ = match power {
            0 => write!(text, "{coefficient}"),
            1 => write!(text, "{coefficient}*{symbol}"),
            _ => write!(text, "{coefficient}*{symbol}^{power}"),
        };
    }
    if text.is_empty() {
        "0".to_owned()
    } else {
        text
    }
}

fn simplex<const D: usize>(corners: &[Corner<D>], rank: usize) -> Value {
    let corner = |corner: &Corner<D>| {
        if corner.shift.iter().all(|&s| s == 0) {
            json!(corner.vertex.number())
        } else {
            let row = std::iter::once(i64::from(corner.vertex.number()))
                .chain(corner.shift[..rank].iter().map(|&s| i64::from(s)));
            Value::Array(row.map(|n| json!(n)).collect())
        }
    };
    Value::Array(corners.iter().map(corner).collect())
}

/// `  "name": [` and one entry a line.
fn list(text: &mut String, name: &str, entries: impl Iterator<Item = Value>) {
    let _ = write!(text, "  {}: [", json!(name));
    for (index, entry) in entries.enumerate() {
        let separator = if index == 0 { "" } else { "," };
        let _ = write!(text, "{separator}\n    {entry}");
    }
    text.push_str("\n  ]");
}
