//! The part of a page about one tiling, as text and tables. It is complete without the page's program.

use super::colour::{hex, part};
use super::data::domain_word;
use super::facts::{Facts, cosine_bounds, cosine_text, degrees, root_text};
use super::histogram::histogram;
use super::html::{escape, fill};
use super::math::math;
use super::picture::picture;
use super::proved::Proved;
use super::theorem::Theorem;
use crate::palette::Colour;
use acutile_core::quality::{DihedralAngle, Measures, Shape, rounded_down, rounded_up};
use acutile_core::tiling::Tiling;
use acutile_exact::number::radical::root;
use acutile_exact::number::{Field, Number};
use malachite::Rational;
use std::collections::BTreeMap;

const TEMPLATE: &str = include_str!("assets/article.html");
const TILING: &str = include_str!("assets/tiling.html");
/// A longer table of vertices has its numbers as text.
const MOST_FORMULAS: usize = 200;
const CLASSES: &str = include_str!("assets/classes.html");

/// The words for a dimension, as a template has them.
pub fn words<const D: usize>() -> [(&'static str, &'static str); 4] {
    match D {
        2 => [
            ("simplices", "triangles"),
            ("angles", "angles"),
            ("volume", "area"),
            ("dimension", "2"),
        ],
        _ => [
            ("simplices", "tetrahedra"),
            ("angles", "dihedral angles"),
            ("volume", "volume"),
            ("dimension", "3"),
        ],
    }
}

/// The article number `index` of a page.
pub fn article<const D: usize>(
    index: usize,
    proved: &Proved,
    tiling: &Tiling<D>,
    facts: &Facts,
) -> String {
    let [(_, simplices), ..] = words::<D>();
    let tables = [
        ("classes", &*classes(facts)),
        ("vertices", &vertices(tiling, facts)),
    ];
    let parts = Parts {
        classes: &facts.class_of,
        facts: summary(tiling, Some(facts)),
        histogram: histogram(facts, simplices),
        sections: fill(CLASSES, &[&tables[..], &words::<D>()].concat()),
    };
    parts.article(index, proved, tiling)
}

/// The parts of an article below its claim.
pub struct Parts<'a> {
    /// The classes by which the still picture is coloured.
    pub classes: &'a [usize],
    pub facts: String,
    pub histogram: String,
    pub sections: String,
}

impl Parts<'_> {
    /// The article number `index` of a page.
    pub fn article<const D: usize>(
        &self,
        index: usize,
        proved: &Proved,
        tiling: &Tiling<D>,
    ) -> String {
        let [(_, simplices), ..] = words::<D>();
        let label = format!(
            "One cell of {}: {} {simplices}",
            escape(&proved.name),
            tiling.len()
        );
        let head = Head {
            name: &proved.name,
            description: &proved.description,
            claim: &proved.in_words(),
            sha256: &proved.sha256(),
            json: proved.json(),
        };
        let own = [
            ("facts", &*self.facts),
            ("histogram", &self.histogram),
            ("sections", &self.sections),
        ];
        let sections = fill(TILING, &[&own[..], &words::<D>()].concat());
        head.article(index, &picture(tiling, self.classes, &label), &sections)
    }
}

/// The beginning of every article about a certificate that the kernel has confirmed.
pub struct Head<'a> {
    pub name: &'a str,
    pub description: &'a str,
    /// The claim in words.
    pub claim: &'a str,
    pub sha256: &'a str,
    pub json: &'a str,
}

impl<'a> Head<'a> {
    /// That of a family or a system of patches.
    pub fn of_theorem(theorem: &'a Theorem) -> Self {
        Head {
            name: &theorem.name,
            description: &theorem.description,
            claim: theorem.claim(),
            sha256: theorem.sha256(),
            json: theorem.json(),
        }
    }

    /// The article number `index` of a page, with a still picture and sections below the claim.
    pub fn article(&self, index: usize, picture: &str, sections: &str) -> String {
        let (claim, statements) = sentences(self.claim);
        fill(
            TEMPLATE,
            &[
                ("index", &index.to_string()),
                ("name", &escape(self.name)),
                ("description", &escape(self.described())),
                ("claim", &claim),
                ("statements", &statements),
                ("sha256", &escape(self.sha256)),
                ("bytes", &self.json.len().to_string()),
                ("cite", &escape(&self.citation())),
                ("picture", picture),
                ("sections", sections),
            ],
        )
    }

    /// The name of a file says nothing about its claim.
    fn described(&self) -> &str {
        match self.description {
            "" => "as a file of this name has it",
            description => description,
        }
    }

    /// An entry of BibTeX for the certificate.
    fn citation(&self) -> String {
        let version = env!("CARGO_PKG_VERSION");
        let special = ['{', '}', '\\', '%', '#', '&', '_', '$'];
        let (name, digest) = (self.name.replace(special, "-"), self.sha256);
        format!(
            "@misc{{acutile-{},\n  author = {{{{the acutile authors}}}},\n  title = {{A certified tiling: {{{name}}}}},\n  \
             note = {{Certificate with the SHA-256 {digest}, verified by acutile {version}}}\n}}",
            &digest[..8.min(digest.len())]
        )
    }
}

/// The claim: the first sentence, and a list of the other statements.
fn sentences(words: &str) -> (String, String) {
    let mut sentences = words
        .split("; ")
        .map(|sentence| format!("{}.", capital(sentence)));
    let first = escape(&sentences.next().unwrap_or_default());
    let items = sentences.map(|sentence| format!("<li data-sentence>{}</li>", escape(&sentence)));
    (first, items.collect())
}

fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// Counts, field and metric as a list of terms.
pub fn summary<const D: usize>(tiling: &Tiling<D>, facts: Option<&Facts>) -> String {
    let frame = &tiling.frame;
    let rows = frame.gram.iter().map(|row| {
        let entries = row
            .iter()
            .map(|x| format!("<td>{}</td>", math(&x.to_string())));
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
        (
            "Vertex types",
            facts.map_or_else(String::new, |facts| escape(&type_counts(facts))),
        ),
        ("Numbers", field_words(&frame.field)),
        ("Gram matrix of the basis", gram),
    ];
    let term = |(term, value): &(&str, String)| format!("<dt>{term}</dt><dd>{value}</dd>");
    let shown = terms.iter().filter(|(_, value)| !value.is_empty());
    shown.map(term).collect()
}

/// The numbers that a verifier finds, too, are marked, so that the page can compare them.
fn counts<const D: usize>(tiling: &Tiling<D>, facts: Option<&Facts>) -> String {
    let marked = |what: &str, n: usize, one: &str, many: &str| {
        let word = if n == 1 { one } else { many };
        format!("<span data-verified=\"{what}\">{n}</span> {word}")
    };
    let simplices = match D {
        2 => marked("simplices", tiling.len(), "triangle", "triangles"),
        _ => marked("simplices", tiling.len(), "tetrahedron", "tetrahedra"),
    };
    let classes = facts.map(|facts| match facts.classes.len() {
        1 => " of 1 congruence class".to_owned(),
        n => format!(" of {n} congruence classes"),
    });
    format!(
        "{}, {simplices}{}; {}",
        marked("vertices", tiling.vertices.len(), "vertex", "vertices"),
        classes.unwrap_or_default(),
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
pub fn field_words(field: &Field) -> String {
    if field.is_rationals() {
        return "rational".to_owned();
    }
    let coefficients = field.polynomial().iter().map(Rational::from);
    let (low, high) = field.root();
    let root = match field.polynomial() {
        [c, zero, _] if *zero == 0 && low >= 0 => format!(", a = {}", root(&Rational::from(-c))),
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
    let palette = facts.palette();
    let row = |(number, (shape, measures)): (usize, &(Shape, Measures))| {
        let cell = &facts.cells[shape.members[0].index()];
        let edges = shape
            .squared_edges
            .iter()
            .map(|square| math(&square.to_string()));
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
            swatch(palette.colour(number)),
            number,
            shape.members.len(),
            edges.collect::<Vec<_>>().join(", "),
            math(&facts.numbers.values[cell.volume].to_string()),
            math(&root_text(&measures.radius_edge.square)),
            angle_list(measures),
            largest.unwrap_or_default(),
        )
    };
    facts.classes.iter().enumerate().map(row).collect()
}

/// `√(5/12) ∈ [0.645497, 0.645498]`, or a rational cosine alone.
fn cosine_with_bounds(angle: &DihedralAngle) -> String {
    let (low, high) = cosine_bounds(angle);
    let text = math(&cosine_text(angle));
    if low == high {
        text
    } else {
        format!(
            "{text} ∈ [{}, {}]",
            rounded_down(&low, 6),
            rounded_up(&high, 6)
        )
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

/// A square in a colour.
fn swatch(colour: Colour) -> String {
    format!(
        "<svg class=\"swatch\" viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect width=\"1\" height=\"1\" \
         fill=\"{}\"/></svg>",
        hex(part(colour))
    )
}

/// Degrees to three digits: rounded outward, or the value itself.
fn angle_text((low, high): &(Rational, Rational)) -> String {
    let (down, up) = (rounded_down(low, 3), rounded_up(high, 3));
    if down == up {
        format!("{}°", down.trim_end_matches('0').trim_end_matches('.'))
    } else {
        format!("{down}…\u{2060}°")
    }
}

/// The rows of the table of vertices.
fn vertices<const D: usize>(tiling: &Tiling<D>, facts: &Facts) -> String {
    // Markup makes a long table ten times as long.
    let shown = if tiling.vertices.len() <= MOST_FORMULAS {
        math
    } else {
        escape
    };
    let row = |(index, vertex): (usize, [Number; D])| {
        let coordinates = vertex
            .iter()
            .map(|x| format!("<td>{}</td>", shown(&x.to_string())));
        format!(
            "<tr><th scope=\"row\">{index}</th><td>{}</td>{}</tr>",
            escape(&facts.types[index]),
            coordinates.collect::<String>()
        )
    };
    tiling.vertices.iter().enumerate().map(row).collect()
}
