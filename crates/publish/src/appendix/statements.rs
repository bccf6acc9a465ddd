//! What is claimed beyond tiling and acuteness: bounds of angles and ratios, Delaunay, TCP,
//! each with the numbers that show it.

use super::classes::{cosine_bounds, edge_name, pairs};
use super::columns::width;
use super::facets::delaunay;
use super::rational::interval;
use super::subject::Analysis;
use super::tex::{Table, list};
use super::vertices::star_name;
use acutile_core::quality::{DihedralAngle, Exact, RadiusEdge};
use acutile_core::statement::{Relation, Statement};
use malachite::Rational;
use std::collections::BTreeMap;

/// A paragraph for each statement that has one. The table of powers for Delaunay shows weakly
/// Delaunay, too.
pub fn statements<const D: usize>(analysis: &Analysis<D>) -> String {
    let statements = analysis.subject.statements();
    let is_strict = statements.contains(&Statement::Delaunay)
        || statements.contains(&Statement::LocallyDelaunay);
    let paragraphs = statements.iter().map(|statement| match statement {
        Statement::LargestAngle(Relation::Maximum, angle) => extreme_angle(analysis, angle, true),
        Statement::SmallestAngle(Relation::Minimum, angle) => extreme_angle(analysis, angle, false),
        Statement::RadiusEdge(Relation::Maximum, ratio) => radius_edge(analysis, ratio),
        Statement::Delaunay | Statement::LocallyDelaunay => delaunay(analysis, true),
        Statement::WeaklyDelaunay | Statement::LocallyWeaklyDelaunay if !is_strict => {
            delaunay(analysis, false)
        }
        Statement::Tcp => close_packed(analysis),
        _ => String::new(),
    });
    paragraphs.collect()
}

/// The largest or the smallest angle: where it is, its cosine, and its size in degrees.
fn extreme_angle<const D: usize>(
    analysis: &Analysis<D>,
    angle: &DihedralAngle,
    is_largest: bool,
) -> String {
    let Some((class, (i, j))) = place(analysis, angle) else {
        return String::new();
    };
    let word = if is_largest { "largest" } else { "smallest" };
    let sign = if angle.against_right().is_gt() {
        "-"
    } else {
        ""
    };
    let exact = analysis.numerals.root(&angle.signed_square.abs());
    let bounds = interval(&cosine_bounds(angle));
    let value = match (width(&exact) > WIDE, bounds.starts_with('[')) {
        (true, _) => relation_to(&bounds),
        (false, true) => format!("={sign}{exact}\\in{bounds}"),
        (false, false) => format!("={sign}{exact}"),
    };
    format!(
        "\\acutileparagraph{{The {word} angle}} $\\theta$ (class {class}, {place} {edge}) has $\\cos\\theta{value}$ and, in degrees, $\\theta{degrees}$.\n\n",
        place = if D == 2 { "corner" } else { "edge" },
        edge = edge_name::<D>(i, j),
        degrees = relation_to(&interval(&angle.enclosure(&fine()))),
    )
}

/// `=0.5`, or `\in[…]`.
fn relation_to(bounds: &str) -> String {
    let relation = if bounds.starts_with('[') { "\\in" } else { "=" };
    format!("{relation}{bounds}")
}

/// The first class with this angle, and the facets between which it is in the class's first
/// simplex.
fn place<const D: usize>(
    analysis: &Analysis<D>,
    angle: &DihedralAngle,
) -> Option<(usize, (usize, usize))> {
    let mut classes = analysis.shapes.iter().enumerate();
    classes.find_map(|(class, shape)| {
        let products = analysis.products(shape.members[0]);
        let mut pairs = (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j)));
        let pair = pairs
            .find(|(i, j)| DihedralAngle::between(&products, *i, *j).as_ref() == Some(angle))?;
        Some((class, pair))
    })
}

fn fine() -> Rational {
    Rational::from_signeds(1, 1_000_000_000)
}

/// The largest ratio of circumradius and shortest edge, by its square.
fn radius_edge<const D: usize>(analysis: &Analysis<D>, largest: &RadiusEdge) -> String {
    let exact = analysis.numerals.inline(&largest.square);
    let value = if width(&exact) > WIDE {
        format!("\\in{}", analysis.numerals.enclosed(&largest.square))
    } else {
        format!("={exact}")
    };
    format!(
        "\\acutileparagraph{{Circumradii.}} With the squared edges $l$ and the cofactors $C$ of $M=(\\langle e_i,e_j\\rangle)$ the squared circumradius is $\\sum_{{i,j}} \
         l_{{0i}}C_{{ij}}l_{{0j}}/(4\\det M)$. For the largest ratio $\\sigma$ of circumradius and shortest edge, $\\sigma^2{value}$. Approximately, $\\sigma{}$.\n\n",
        relation_to(&interval(&largest.enclosure(&fine()))),
    )
}

/// An exact number with more letters gives place to a decimal enclosure in a table.
const WIDE: usize = 30;

/// Valences of edges, and stars of vertices.
fn close_packed<const D: usize>(analysis: &Analysis<D>) -> String {
    let valences: Vec<String> = analysis
        .ridges
        .valence_counts()
        .iter()
        .map(|(valence, count)| format!("${count}$ are in ${valence}$ tetrahedra"))
        .collect();
    let stars: Vec<String> = star_counts(analysis)
        .iter()
        .map(|(star, count)| format!("${count}$ of type {star}"))
        .collect();
    format!(
        "\\acutileparagraph{{Tetrahedrally close packed.}} Table~\\ref{{{label}}} has the number of tetrahedra around each edge of the representatives, counted by going \
         from tile to tile in Table~\\ref{{{facets}}}. It is $5$ or $6$, and no two edges with $6$ have a corner in common, so no triangle has two. Up to $\\Lambda$ there are ${count}$ edges. Of these {valences}. \
         So the tiling is tetrahedrally close packed as defined by Sullivan~\\cite{{Sullivan1999}}. It follows that each vertex has one of the four stars of Frank and Kasper~\\cite{{FrankKasper1958}}, with $12$, $14$, $15$ or $16$ neighbours \
         and as many edges of valence six as exceed $12$. A cell has {stars}.\n\n{table}",
        label = analysis.label("valences"),
        facets = analysis.label("pairing"),
        count = analysis.ridges.list.len(),
        valences = list(&valences),
        stars = list(&stars),
        table = valence_table(analysis),
    )
}

/// The valences of the edges of the representatives.
fn valence_table<const D: usize>(analysis: &Analysis<D>) -> String {
    let pairs = pairs::<D>();
    let row = |&place: &usize| {
        let tile = analysis.orbits.representatives[place].tile;
        let cells: String = pairs
            .iter()
            .map(|&(a, b)| {
                let facets: Vec<usize> = (0..=D).filter(|k| *k != a && *k != b).collect();
                let ridge = analysis.ridges.between(tile, facets[0], facets[1]);
                format!(" & {}", ridge.valence())
            })
            .collect();
        format!("$T_{{{tile}}}${cells}")
    };
    let heads: String = pairs.iter().map(|(i, j)| format!(" & ${i}{j}$")).collect();
    Table {
        mark: format!("valences {}", analysis.subject.slug()),
        columns: &format!("r{}", "r".repeat(pairs.len())),
        caption: "The number of tetrahedra around each edge, by the numbers of its corners."
            .to_owned(),
        label: analysis.label("valences"),
        heading: format!("tile{heads}"),
        rows: analysis.order.iter().map(row).collect(),
    }
    .tex()
}

fn star_counts<const D: usize>(analysis: &Analysis<D>) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for star in &analysis.stars {
        *counts.entry(star_name(star)).or_insert(0) += 1;
    }
    counts
}
