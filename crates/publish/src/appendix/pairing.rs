//! The pairing of the facets: by orbits where they are few, all of it for the supplement.

use super::LONG;
use super::subject::Analysis;
use super::tex::{self, Table, simplices};
use acutile_core::tiling::{Facet, SimplexId};

/// The paragraph and table of the pairing, for one simplex of each orbit.
pub fn pairing<const D: usize>(analysis: &Analysis<D>) -> String {
    let orbits = analysis.orbits();
    let rows: Vec<String> = orbits
        .iter()
        .take(LONG)
        .map(|&(first, _)| row(analysis, first))
        .collect();
    let moved = match analysis.rank() {
        0 => "",
        _ => ", moved by the lattice vector in the superscript",
    };
    let boundary = match analysis.tiling.frame.domain.polytope() {
        None => String::new(),
        Some(_) => format!(
            " An entry $\\partial_f$ says that the facet lies in face $f$ of the boundary{}",
            faces(analysis)
        ),
    };
    format!(
        "\\acutileparagraph{{Facets.}} The entry $t_j$ in column $i$ of the row of $T_s$ says that the facet of $T_s$ opposite to its corner $i$ is the facet \
         of $T_t$ opposite to its corner $j${moved}: the same corners, and the two tiles on opposite sides.{boundary} Table~\\ref{{{label}}} has \
         the rows for one tile of each orbit; the whole pairing, ${total}$ facets, is in the supplement.\n\n{table}",
        label = analysis.label("pairing"),
        total = analysis.tiling.len() * (D + 1),
        table = table(
            analysis,
            "pairing",
            "pairing",
            format!(
                "What is behind each facet of one of the {} of each orbit.",
                simplices(D, 2)
            ),
            rows
        ),
    )
}

/// Which face is which.
fn faces<const D: usize>(analysis: &Analysis<D>) -> String {
    let Some(polytope) = analysis.tiling.frame.domain.polytope() else {
        return String::new();
    };
    let numerals = &analysis.numerals;
    let point = |v: &usize| {
        let entries: Vec<String> = polytope.vertices[*v]
            .iter()
            .map(|x| numerals.inline(x))
            .collect();
        match entries.as_slice() {
            [height] => format!("$x_{D}={height}$"),
            _ => format!("$({})$", entries.join(",\\,")),
        }
    };
    let faces: Vec<String> = polytope
        .faces
        .iter()
        .enumerate()
        .map(|(index, face)| {
            let points: Vec<String> = face.iter().map(point).collect();
            format!("face ${index}$: {}", points.join(", "))
        })
        .collect();
    format!(" ({}).", faces.join("; "))
}

/// The pairing of all facets, for the supplement.
pub fn all_facets<const D: usize>(analysis: &Analysis<D>) -> String {
    let rows = analysis
        .tiling
        .indices()
        .map(|simplex| row(analysis, simplex))
        .collect();
    table(
        analysis,
        "mates",
        "mates",
        "What is behind each facet.".to_owned(),
        rows,
    )
}

fn table<const D: usize>(
    analysis: &Analysis<D>,
    mark: &str,
    label: &str,
    caption: String,
    rows: Vec<String>,
) -> String {
    let names: Vec<String> = (0..=D).map(|i| format!("facet ${i}$")).collect();
    Table {
        mark: format!("{mark} {}", analysis.subject.slug()),
        columns: &format!("r{}", "@{\\quad}r".repeat(D + 1)),
        caption,
        label: analysis.label(label),
        heading: format!("& {}", names.join(" & ")),
        rows,
    }
    .tex()
}

fn row<const D: usize>(analysis: &Analysis<D>, simplex: SimplexId) -> String {
    let mates: Vec<String> = (0..=D)
        .map(|i| format!("${}$", behind(analysis, Facet::new(simplex, i))))
        .collect();
    format!("$T_{{{simplex}}}$ & {}", mates.join(" & "))
}

/// What is behind a facet, in math mode.
pub fn behind<const D: usize>(analysis: &Analysis<D>, facet: Facet) -> String {
    match analysis.matching.mate(analysis.tiling, facet) {
        Some(mate) => tex::mate(&mate, analysis.rank()),
        None => match boundary_face(analysis, facet) {
            Some(face) => format!("\\partial_{{{face}}}"),
            None => "\\partial".to_owned(),
        },
    }
}

/// The face of the domain in whose plane all corners of a facet lie.
fn boundary_face<const D: usize>(analysis: &Analysis<D>, facet: Facet) -> Option<usize> {
    let tiling = analysis.tiling;
    let polytope = tiling.frame.domain.polytope()?;
    let points: Vec<_> = tiling
        .simplex(facet.simplex)
        .iter()
        .enumerate()
        .filter(|(k, _)| *k != usize::from(facet.opposite))
        .map(|(_, corner)| tiling.position(corner))
        .collect();
    (0..polytope.faces.len()).find(|&face| {
        polytope.plane(face).is_some_and(|plane| {
            points
                .iter()
                .all(|point| plane.value(tiling.frame.cross_section(point)).is_zero())
        })
    })
}
