//! The vertices, exactly, and of which tiles they are corners.

use super::subject::Analysis;
use super::tex::Table;
use acutile_core::classify::Star;
use acutile_core::tiling::VertexId;

/// The paragraph and the table of all vertices.
pub fn vertices<const D: usize>(analysis: &Analysis<D>) -> String {
    let (cell, occurs) = match (analysis.rank(), analysis.orbits.elements.len()) {
        (0, 1) => ("", "a tile with this corner"),
        (_, 1) => (
            " up to $\\Lambda$",
            "a tile with this corner up to $\\Lambda$",
        ),
        (0, _) => (
            "",
            "a tile with this corner, or an isometry that maps a corner $c_i$ of a tile to it",
        ),
        _ => (
            " up to $\\Lambda$",
            "a tile with this corner, or an isometry that maps a corner $c_i$ of a tile to it, up to $\\Lambda$",
        ),
    };
    format!(
        "\\acutileparagraph{{Vertices.}} Table~\\ref{{{label}}} lists the vertices{cell} in the order of the certificate. All counting begins at $0$. \
         No two rows have the same point{cell}. The last column has {occurs}, so each vertex occurs.{sites}\n\n{table}",
        sites = match site_letters(analysis) {
            None => "",
            Some(_) =>
                " The column before it has the multiplicity and the Wyckoff letter under $\\Gamma$ \
                        in the standard setting, which no proof uses.",
        },
        label = analysis.label("vertices"),
        table = table(analysis),
    )
}

/// The table of all vertices.
pub fn table<const D: usize>(analysis: &Analysis<D>) -> String {
    let stars: Vec<String> = analysis.stars.iter().map(star_name).collect();
    let letters = site_letters(analysis);
    let row = |vertex: usize| {
        let coordinates: String = analysis
            .tiling
            .vertices
            .vertex(VertexId::at(vertex))
            .iter()
            .map(|x| format!(" & ${}$", analysis.numerals.cell(x)))
            .collect();
        let star = stars
            .get(vertex)
            .map_or(String::new(), |star| format!(" & {star}"));
        let site = letters.map_or(String::new(), |letters| {
            format!(" & {}", letters[vertex].as_deref().unwrap_or_default())
        });
        format!(
            "{vertex}{coordinates}{star}{site} & {}",
            origin(analysis, vertex)
        )
    };
    let (site_column, site_name) = match letters {
        None => ("", ""),
        Some(_) => ("l", " & site"),
    };
    let names: String = (1..=D).map(|i| format!(" & $x_{i}$")).collect();
    let (star_column, star_name) = if stars.is_empty() {
        ("", "")
    } else {
        ("l", " & star")
    };
    Table {
        mark: format!("vertices {}", analysis.subject.slug()),
        columns: &format!("r@{{\\qquad}}{}{star_column}{site_column}l", "l".repeat(D)),
        caption: "Vertices in coordinates of the basis.".to_owned(),
        label: analysis.label("vertices"),
        heading: format!("vertex{names}{star_name}{site_name} & corner of"),
        rows: (0..analysis.tiling.vertices.len()).map(row).collect(),
    }
    .tex()
}

/// The Wyckoff letters, where each vertex has one.
fn site_letters<'a, const D: usize>(analysis: &'a Analysis<D>) -> Option<&'a [Option<String>]> {
    let letters = &analysis.space_group.as_ref()?.letters;
    letters.iter().all(Option::is_some).then_some(letters)
}

fn origin<const D: usize>(analysis: &Analysis<D>, vertex: usize) -> String {
    match analysis.orbits.vertices[vertex] {
        None => String::new(),
        Some(origin) => {
            let tile = analysis.orbits.representatives[origin.representative].tile;
            let map = match origin.element {
                0 => String::new(),
                element => format!("$\\gamma_{{{element}}}$, "),
            };
            format!("{map}$c_{}$ of $T_{{{tile}}}$", origin.corner)
        }
    }
}

/// The name of a star.
pub fn star_name(star: &Star) -> String {
    match star {
        Star::FrankKasper(n) => format!("$Z_{{{n}}}$"),
        Star::Other(n) => format!("${n}$ neighbours"),
        Star::Boundary(n) => format!("${n}$ neighbours, in the boundary"),
    }
}
