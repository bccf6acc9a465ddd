//! What a page says of one tiling, as text and tables: complete without the page's program.

use super::colour::{colour, hex};
use super::data::domain_word;
use super::facts::{Facts, cosine_bounds, cosine_text, degrees, root_text};
use super::histogram::histogram;
use super::html::{escape, fill};
use super::picture::picture;
use super::proved::Proved;
use acutile_core::quality::{DihedralAngle, Measures, Shape, rounded_down, rounded_up};
use acutile_core::tiling::Tiling;
use acutile_exact::number::{Field, Number};
use malachite::Rational;
use std::collections::BTreeMap;

const TEMPLATE: &str = include_str!("assets/article.html");

/// The article number `index` of a page.
pub fn article<const D: usize>(
    index: usize,
    proved: &Proved,
    tiling: &Tiling<D>,
    facts: &Facts,
) -> String {
    let simplex = if D == 2 { "triangles" } else { "tetrahedra" };
    let name = escape(&proved.name);
    let label = format!("One cell of {name}: {} {simplex}", tiling.len());
    let (claim, statements) = claim(proved);
    fill(
        TEMPLATE,
        &[
            ("index", &index.to_string()),
            ("name", &name),
            ("description", &escape(described(proved))),
            ("claim", &claim),
            ("statements", &statements),
            ("sha256", &escape(&proved.sha256())),
            ("bytes", &proved.json().len().to_string()),
            ("picture", &picture(tiling, &facts.class_of, &label)),
            ("facts", &summary(tiling, facts)),
            ("simplices", simplex),
            ("dimension", &D.to_string()),
            ("angles", if D == 2 { "angles" } else { "dihedral angles" }),
            ("volume", if D == 2 { "area" } else { "volume" }),
            ("histogram", &histogram(facts, simplex)),
            ("classes", &classes(facts)),
            ("vertices", &vertices(tiling, facts)),
        ],
    )
}

/// The claim: the first sentence, and a list of the other statements.
fn claim(proved: &Proved) -> (String, String) {
    let words = proved.in_words();
    let mut sentences = words
        .split("; ")
        .map(|sentence| format!("{}.", capital(sentence)));
    let first = escape(&sentences.next().unwrap_or_default());
    let items = sentences.map(|sentence| format!("<li>{}</li>", escape(&sentence)));
    (first, items.collect())
}

fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// Counts, field and metric as a list of terms.
fn summary<const D: usize>(tiling: &Tiling<D>, facts: &Facts) -> String {
    let frame = &tiling.frame;
    let rows = frame.gram.iter().map(|row| {
        let entries = row
            .iter()
            .map(|x| format!("<td>{}</td>", escape(&x.to_string())));
        format!("<tr>{}</tr>", entries.collect::<String>())
    });
    let gram = format!(
        "<table class=\"matrix\">{}</table>",
        rows.collect::<String>()
    );
    let domain = match (D, domain_word(&frame.domain)) {
        (2, "space") => "the plane",
        (2, "slab") => "a strip",
        (2, "solid") => "a polygon",
        (_, "solid") => "a polyhedron",
        (_, "space") => "three-space",
        (_, "slab") => "a slab",
        (_, word) => word,
    };
    let terms = [
        ("Tiled", escape(domain)),
        ("In one cell", counts(tiling, facts)),
        ("Vertex types", escape(&type_counts(facts))),
        ("Numbers", field_words(&frame.field)),
        ("Gram matrix of the basis", gram),
    ];
    let term = |(term, value): &(&str, String)| format!("<dt>{term}</dt><dd>{value}</dd>");
    terms.iter().map(term).collect()
}

fn counts<const D: usize>(tiling: &Tiling<D>, facts: &Facts) -> String {
    let count = |n: usize, one: &str, many: &str| match n {
        1 => format!("1 {one}"),
        _ => format!("{n} {many}"),
    };
    let simplices = match D {
        2 => count(tiling.len(), "triangle", "triangles"),
        _ => count(tiling.len(), "tetrahedron", "tetrahedra"),
    };
    format!(
        "{}, {simplices} of {}; {}",
        count(tiling.vertices.len(), "vertex", "vertices"),
        count(
            facts.classes.len(),
            "congruence class",
            "congruence classes"
        ),
        match tiling.frame.rank() {
            0 => "no lattice".to_owned(),
            rank => format!("the lattice has rank {rank}"),
        }
    )
}

fn type_counts(facts: &Facts) -> String {
    let mut counts = BTreeMap::new();
    for name in &facts.types {
        *counts.entry((name.len(), name)).or_insert(0) += 1;
    }
    let words = counts
        .iter()
        .map(|((_, name), count)| format!("{count} × {name}"));
    words.collect::<Vec<_>>().join("; ")
}

/// `Q(a), where a is the root of a^2 - 3 between 1 and 2: √3`.
fn field_words(field: &Field) -> String {
    if field.is_rationals() {
        return "rational".to_owned();
    }
    let coefficients = field.polynomial().iter().map(Rational::from);
    let (low, high) = field.root();
    let root = match field.polynomial() {
        [c, zero, _] if *zero == 0 && low >= 0 => format!(", a = √{}", -c),
        _ => String::new(),
    };
    escape(&format!(
        "in Q(a), a ≈ {:.6} the root between {low} and {high} of {}{root}",
        field.generator().approximate(),
        polynomial(coefficients)
    ))
}

/// `1 - 3 a + a^2` from the constant term up.
fn polynomial(coefficients: impl Iterator<Item = Rational>) -> String {
    let mut text = String::new();
    for (power, c) in coefficients.enumerate().filter(|(_, c)| *c != 0) {
        let sign = match (c < 0, text.is_empty()) {
            (true, true) => "-",
            (true, false) => " - ",
            (false, true) => "",
            (false, false) => " + ",
        };
        let size = if c < 0 { -c } else { c };
        text += sign;
        text += &match (power, size == 1) {
            (0, _) => size.to_string(),
            (1, true) => "a".to_owned(),
            (1, false) => format!("{size} a"),
            (_, true) => format!("a^{power}"),
            (_, false) => format!("{size} a^{power}"),
        };
    }
    text
}

/// The rows of the table of congruence classes.
fn classes(facts: &Facts) -> String {
    let row = |(number, (shape, measures)): (usize, &(Shape, Measures))| {
        let cell = &facts.cells[shape.members[0].index()];
        let edges = shape.squared_edges.iter().map(Number::to_string);
        let largest = measures.angles.last().map(|angle| {
            format!(
                "{}<br><small>cos = {}</small>",
                angle_text(&degrees(angle)),
                cosine_with_bounds(angle)
            )
        });
        format!(
            "<tr><th scope=\"row\">{}{}</th><td>{}</td><td>{}</td>\
             <td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            swatch(number),
            number,
            shape.members.len(),
            escape(&edges.collect::<Vec<_>>().join(", ")),
            escape(&facts.numbers.values[cell.volume].to_string()),
            escape(&root_text(&measures.radius_edge.square)),
            angle_list(measures),
            largest.unwrap_or_default(),
        )
    };
    facts.classes.iter().enumerate().map(row).collect()
}

/// `√(5/12) ∈ [0.645497, 0.645498]`, or a rational cosine alone.
fn cosine_with_bounds(angle: &DihedralAngle) -> String {
    let (low, high) = cosine_bounds(angle);
    let text = escape(&cosine_text(angle));
    match low == high {
        true => text,
        false => format!(
            "{text} ∈ [{}, {}]",
            rounded_down(&low, 6),
            rounded_up(&high, 6)
        ),
    }
}

/// The angles by size, equal ones together: `60° ×2, 75.522…° ×4`.
fn angle_list(measures: &Measures) -> String {
    let equal = measures.angles.chunk_by(|a, b| a == b);
    let words = equal.map(|angles| match angles.len() {
        1 => angle_text(&degrees(&angles[0])),
        n => format!("{}\u{a0}×{n}", angle_text(&degrees(&angles[0]))),
    });
    words.collect::<Vec<_>>().join(", ")
}

/// A square in the colour of a class.
fn swatch(class: usize) -> String {
    format!(
        "<svg class=\"swatch\" viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect width=\"1\" height=\"1\" \
         fill=\"{}\"/></svg>",
        hex(colour(class))
    )
}

/// Degrees to three digits: rounded outward, or the value itself.
fn angle_text((low, high): &(Rational, Rational)) -> String {
    let (down, up) = (rounded_down(low, 3), rounded_up(high, 3));
    match down == up {
        true => format!("{}°", down.trim_end_matches('0').trim_end_matches('.')),
        false => format!("{down}…\u{2060}°"),
    }
}

/// The rows of the table of vertices.
fn vertices<const D: usize>(tiling: &Tiling<D>, facts: &Facts) -> String {
    let row = |(index, vertex): (usize, [Number; D])| {
        let coordinates = vertex
            .iter()
            .map(|x| format!("<td>{}</td>", escape(&x.to_string())));
        format!(
            "<tr><th scope=\"row\">{index}</th><td>{}</td>{}</tr>",
            escape(&facts.types[index]),
            coordinates.collect::<String>()
        )
    };
    tiling.vertices.iter().enumerate().map(row).collect()
}

/// What a file is called says nothing of what it proves.
fn described(proved: &Proved) -> &str {
    match proved.description.as_str() {
        "" => "as a file of this name has it",
        description => description,
    }
}
