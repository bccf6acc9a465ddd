//! The article and the data of a family: the theorem, parameters, polynomials, the tree, and figures over
//! the box. The page computes members from the polynomials of the certificate.

use super::article::{Head, field_words, words};
use super::data::domain_word;
use super::facts::{classes, types_of_plane, types_of_space};
use super::histogram::{DEGREES_PER_BIN, METRIC, histogram_of};
use super::html::{escape, fill};
use super::math::math;
use super::picture::picture;
use super::theorem::Theorem;
use acutile_core::family::{AnyFamily, Family, Tree, point_in_words};
use acutile_core::quality::{rounded_down, rounded_up};
use acutile_core::statistics::statistics;
use acutile_core::tiling::Tiling;
use acutile_exact::polynomial::Polynomial;
use acutile_paper::table::{Figure, figures_of_family};
use serde_json::{Value, json};

const TEMPLATE: &str = include_str!("assets/family.html");
/// A larger tree is described by its size.
const LEAVES: usize = 16;
/// Digits of figures over the box.
const DIGITS: u64 = 6;

/// The article number `index` of a page, and the object `tilings[index]`.
pub fn of_family(
    index: usize,
    theorem: &Theorem,
    family: &AnyFamily,
    tree: &Tree,
) -> (String, Value) {
    let figures = figures_of_family(family);
    let (text, types, generator) = match family {
        AnyFamily::Plane(family) => {
            let member = family.at(&family.cuboid().center());
            let types = types_of_plane(&member);
            let text = article(index, theorem, family, tree, &member, &types, &figures);
            (text, types, family.frame.field.generator().approximate())
        }
        AnyFamily::Space(family) => {
            let member = family.at(&family.cuboid().center());
            let types = types_of_space(&member);
            let text = article(index, theorem, family, tree, &member, &types, &figures);
            (text, types, family.frame.field.generator().approximate())
        }
    };
    (text, data(theorem, family, &types, generator))
}

/// Coordinates and basis are not here: they are polynomials of the certificate.
fn data(theorem: &Theorem, family: &AnyFamily, types: &[String], generator: f64) -> Value {
    let (dimension, rank, domain) = match family {
        AnyFamily::Plane(family) => (2, family.frame.rank(), domain_word(&family.frame.domain)),
        AnyFamily::Space(family) => (3, family.frame.rank(), domain_word(&family.frame.domain)),
    };
    let mut names: Vec<&String> = types.iter().collect();
    names.sort_by_key(|name| (name.len(), *name));
    names.dedup();
    let number = |name: &String| names.iter().position(|other| *other == name);
    json!({
        "name": theorem.name,
        "kind": "family",
        "dimension": dimension,
        "rank": rank,
        "domain": domain,
        "sha256": theorem.sha256(),
        "certificate": theorem.json(),
        "generator": generator,
        "typeNames": names,
        "types": types.iter().map(number).collect::<Vec<_>>(),
    })
}

fn article<const D: usize>(
    index: usize,
    theorem: &Theorem,
    family: &Family<D>,
    tree: &Tree,
    member: &Tiling<D>,
    types: &[String],
    figures: &[(Option<Figure>, Option<Figure>); 3],
) -> String {
    let [(_, simplices), ..] = words::<D>();
    let point = point_in_words(&family.names(), &family.cuboid().center());
    let label = format!(
        "One cell of {}, {}: {} {simplices}",
        escape(&theorem.name),
        escape(&point),
        member.len()
    );
    let statistics = statistics(member, DEGREES_PER_BIN).expect(METRIC);
    let own = [
        ("facts", &*facts(family, tree, types)),
        ("figures", &self::figures::<D>(figures)),
        ("point", &escape(&point)),
        ("histogram", &histogram_of(&statistics, simplices)),
        ("vertices", &vertices(family, types)),
    ];
    let sections = fill(TEMPLATE, &[&own[..], &words::<D>()].concat());
    Head::of_theorem(theorem).article(index, &picture(member, &classes(member), &label), &sections)
}

/// Parameters, counts, field, metric and tree as a list of terms.
fn facts<const D: usize>(family: &Family<D>, tree: &Tree, types: &[String]) -> String {
    let names = family.names();
    let parameters = family.parameters.iter();
    let parameters: Vec<String> = parameters
        .map(|p| format!("{} in {}", math(&p.name), escape(&p.side.to_string())))
        .collect();
    let counts = format!(
        "<span data-verified=\"vertices\">{}</span> vertices, <span data-verified=\"simplices\">{}</span> {}",
        family.vertices.len(),
        family.len(),
        words::<D>()[0].1
    );
    let mut terms = vec![
        ("Parameters", parameters.join("<br>")),
        ("In one cell", counts),
        (
            "Vertex types, everywhere in the box",
            escape(&counted(types)),
        ),
        ("Numbers", field_words(&family.frame.field)),
        ("Gram matrix of the basis", matrix(family, &names)),
    ];
    if let Some(polytope) = family.frame.domain.polytope() {
        let point = |point: &Vec<Polynomial>| polynomials(point, &names);
        let points: Vec<String> = polytope.vertices.iter().map(point).collect();
        let domain = format!(
            "a {}, whose last {} the convex hull of {}",
            domain_word(&family.frame.domain),
            match D - family.frame.rank() {
                1 => "coordinate fills",
                _ => "coordinates fill",
            },
            points.join(", ")
        );
        terms.push(("Tiled", domain));
    }
    terms.push(("The proof", escape(&tree_words(tree, &names))));
    let term = |(term, value): &(&str, String)| format!("<dt>{term}</dt><dd>{value}</dd>");
    terms.iter().map(term).collect()
}

fn counted(types: &[String]) -> String {
    let mut sorted: Vec<&String> = types.iter().collect();
    sorted.sort_by_key(|name| (name.len(), *name));
    let equal = sorted.chunk_by(|a, b| a == b);
    let words: Vec<String> = equal
        .map(|group| format!("{} × {}", group.len(), group[0]))
        .collect();
    words.join("; ")
}

fn matrix<const D: usize>(family: &Family<D>, names: &[String]) -> String {
    let rows = family.frame.gram.iter().map(|row| {
        let cells = row
            .iter()
            .map(|p| format!("<td>{}</td>", math(&p.shown(names))));
        format!("<tr>{}</tr>", cells.collect::<String>())
    });
    format!(
        "<table class=\"matrix\">{}</table>",
        rows.collect::<String>()
    )
}

fn polynomials(point: &[Polynomial], names: &[String]) -> String {
    let texts: Vec<String> = point.iter().map(|p| math(&p.shown(names))).collect();
    format!("({})", texts.join(", "))
}

/// How the box is cut, as nested brackets where these are short.
fn tree_words(tree: &Tree, names: &[String]) -> String {
    match tree.leaves() {
        1 => "The box is not cut: the signs of all polynomials hold on the whole box.".to_owned(),
        leaves if leaves <= LEAVES => format!(
            "The box is cut into {leaves} parts, as {} says: t(A, B) halves the interval of t, A is its lower half and B its upper half, \
             and a dot is a part on which all signs hold.",
            nested(tree, names)
        ),
        leaves => format!(
            "The box is cut into {leaves} parts by halving intervals, at most {} times one after the other; on each part all signs hold.",
            tree.depth()
        ),
    }
}

fn nested(tree: &Tree, names: &[String]) -> String {
    match tree {
        Tree::Leaf => "·".to_owned(),
        Tree::Halves(axis, halves) => {
            let [low, high] = halves.each_ref().map(|half| nested(half, names));
            format!("{}({low}, {high})", names[*axis])
        }
    }
}

/// The rows of the table of infima and suprema.
fn figures<const D: usize>(figures: &[(Option<Figure>, Option<Figure>); 3]) -> String {
    let angle = if D == 2 { "angle" } else { "dihedral angle" };
    let names = [
        "radius-edge ratio".to_owned(),
        format!("smallest {angle}"),
        format!("largest {angle}"),
    ];
    let row = |k: usize| {
        let (name, (low, high)) = (&names[k], &figures[k]);
        let unit = if k == 0 { "" } else { "°" };
        let cell = |figure: &Option<Figure>| {
            let text = figure.as_ref().map(|figure| enclosure(figure, unit));
            format!("<td>{}</td>", text.unwrap_or_else(|| "–".to_owned()))
        };
        format!(
            "<tr><th scope=\"row\">{name}</th>{}{}</tr>",
            cell(low),
            cell(high)
        )
    };
    (0..names.len()).map(row).collect()
}

/// `78.463040…°`, or both bounds where they differ.
fn enclosure(figure: &Figure, unit: &str) -> String {
    let (low, high) = &figure.bounds;
    let [low, high] = [rounded_down(low, DIGITS), rounded_up(high, DIGITS)];
    let decimal = if low == high {
        format!("{low}{unit}")
    } else {
        format!("between {low}{unit} and {high}{unit}")
    };
    let form = figure
        .closed_form
        .as_ref()
        .filter(|form| form.chars().count() <= 20);
    match form.map(|form| math(form)) {
        Some(form) if form.starts_with("<math") => format!("{form}, {decimal}"),
        _ => decimal,
    }
}

/// The rows of the table of vertices.
fn vertices<const D: usize>(family: &Family<D>, types: &[String]) -> String {
    let names = family.names();
    let row = |(index, vertex): (usize, &[Polynomial; D])| {
        let cells = vertex
            .iter()
            .map(|p| format!("<td>{}</td>", math(&p.shown(&names))));
        format!(
            "<tr><th scope=\"row\">{index}</th><td>{}</td>{}</tr>",
            escape(&types[index]),
            cells.collect::<String>()
        )
    };
    family.vertices.iter().enumerate().map(row).collect()
}
