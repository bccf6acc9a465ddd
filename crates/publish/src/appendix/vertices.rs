//! The vertices, exactly, and the symmetry group with the orbits of the simplices.

use super::LONG;
use super::subject::{Analysis, first_and_count};
use super::tex::{Table, corner, counted, list, simplices};
use acutile_core::classify::{Isometry, Star, stars};
use acutile_core::tiling::{AnyTiling, SimplexId, VertexId};
use acutile_exact::number::Number;

/// The table of vertices: all of them, or where they are many the first of each orbit.
pub fn vertices<const D: usize>(analysis: &Analysis<D>) -> String {
    let count = analysis.tiling.vertices.len();
    if count <= LONG {
        return format!(
            "Table~\\ref{{{}}} lists them, in the order of the certificate; all counting begins at $0$.\n\n{}",
            analysis.label("vertices"),
            table(analysis, "vertices", (0..count).collect())
        );
    }
    let first = first_and_count(&analysis.symmetry.vertices);
    let chosen = first.iter().map(|(vertex, _)| *vertex).take(LONG).collect();
    format!(
        "The first vertex of each orbit stands in Table~\\ref{{{}}}, all ${count}$ in the supplement.\n\n{}",
        analysis.label("vertices"),
        table(analysis, "vertex-orbits", chosen)
    )
}

/// All vertices, for the supplement.
pub fn all_vertices<const D: usize>(analysis: &Analysis<D>) -> String {
    table(
        analysis,
        "vertices",
        (0..analysis.tiling.vertices.len()).collect(),
    )
}

fn table<const D: usize>(analysis: &Analysis<D>, mark: &str, chosen: Vec<usize>) -> String {
    let stars = star_names(&analysis.subject.tiling);
    let orbits = &analysis.symmetry.vertices;
    let sizes = first_and_count(orbits);
    let row = |&vertex: &usize| {
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
        let orbit = orbits[vertex];
        format!("{vertex}{coordinates} & {orbit} & {}{star}", sizes[orbit].1)
    };
    let names: String = (1..=D).map(|i| format!(" & $x_{i}$")).collect();
    let (star_column, star_name) = match stars.is_empty() {
        true => ("", ""),
        false => ("l", " & star"),
    };
    let columns = format!("r@{{\\qquad}}{}@{{\\qquad}}rr{star_column}", "l".repeat(D));
    Table {
        mark: format!("{mark} {}", analysis.subject.slug()),
        columns: &columns,
        caption: format!(
            "Vertices {} in coordinates of the basis, their orbits under the symmetry group and the sizes of \
             these.",
            cell(analysis)
        ),
        label: analysis.label("vertices"),
        heading: format!("vertex{names} & orbit & size{star_name}"),
        rows: chosen.iter().map(row).collect(),
    }
    .tex()
}

fn cell<const D: usize>(analysis: &Analysis<D>) -> &'static str {
    match analysis.rank() {
        0 => "",
        _ => "up to $\\Lambda$,",
    }
}

/// The type of each vertex's star in space.
fn star_names(tiling: &AnyTiling) -> Vec<String> {
    let AnyTiling::Space(tiling) = tiling else {
        return Vec::new();
    };
    let name = |star: Star| match star {
        Star::FrankKasper(n) => format!("$Z_{{{n}}}$"),
        Star::Other(n) => format!("${n}$ neighbours"),
        Star::Boundary(n) => format!("${n}$ neighbours, in the boundary"),
    };
    stars(tiling).into_iter().map(name).collect()
}

/// The symmetry group and the table of orbits of simplices.
pub fn symmetry<const D: usize>(analysis: &Analysis<D>) -> String {
    format!(
        "{}{}. There {are} {} and {} of {}; Table~\\ref{{{}}} has one of each orbit. Nothing in the proof \
         rests on the symmetry, it makes the tables short.\n\n{}",
        group(analysis),
        generators(analysis),
        counted(analysis.shapes.len(), "congruence class").replace("classs", "classes"),
        counted(analysis.symmetry.orbits(), "orbit"),
        simplices(D, 2),
        analysis.label("orbits"),
        orbit_table(analysis),
        are = if analysis.shapes.len() == 1 {
            "is"
        } else {
            "are"
        },
    )
}

/// The group and its order.
fn group<const D: usize>(analysis: &Analysis<D>) -> String {
    let symmetry = &analysis.symmetry;
    let order = symmetry.elements.len();
    match (analysis.rank(), symmetry.translations()) {
        (0, _) => format!(
            "The group $\\Gamma$ of the isometries that map the tiling to itself has the order ${order}$"
        ),
        (_, 1) => format!(
            "Let $\\Gamma$ be the group of all isometries that map the tiling to itself. $\\Lambda$ is its subgroup of all \
             translations, and its point group $\\Gamma/\\Lambda$ has the order ${order}$"
        ),
        (_, translations) => format!(
            "Let $\\Gamma$ be the group of all isometries that map the tiling to itself. Its translations form a lattice in \
             which $\\Lambda$ has the index ${translations}$, and its point group has the order ${}$",
            symmetry.point_group_order()
        ),
    }
}

/// A sentence with generators, where the lattice is invariant.
fn generators<const D: usize>(analysis: &Analysis<D>) -> String {
    let generators = analysis.symmetry.generators(analysis.rank());
    let maps: Vec<String> = generators
        .unwrap_or_default()
        .into_iter()
        .map(|element| format!("$({})$", triplet(analysis, element)))
        .collect();
    if maps.is_empty() {
        return String::new();
    }
    let with = match analysis.rank() {
        0 => "",
        _ => "$\\Lambda$ and ",
    };
    format!(
        ". $\\Gamma$ is generated by {with}the {} $({})$ to {}",
        match maps.len() {
            1 => "map that sends",
            _ => "maps that send",
        },
        variables(D).join(",\\,"),
        list(&maps)
    )
}

fn variables(dimension: usize) -> Vec<String> {
    (1..=dimension).map(|i| format!("x_{i}")).collect()
}

/// An isometry as the International Tables write it, `-x_2+1/2, x_1, x_3`.
fn triplet<const D: usize>(analysis: &Analysis<D>, element: &Isometry<D>) -> String {
    let numerals = &analysis.numerals;
    let line = |i: usize| {
        let mut text = String::new();
        for (j, variable) in variables(D).iter().enumerate() {
            let entry = &element.linear[i][j];
            if !entry.is_zero() {
                text.push_str(&term(&text, &numerals.factor(entry), variable));
            }
        }
        let t = &element.translation[i];
        if !t.is_zero() {
            let t = numerals.number(t);
            let plus = if t.starts_with('-') { "" } else { "+" };
            text.push_str(&format!("{plus}{t}"));
        }
        text
    };
    (0..D).map(line).collect::<Vec<_>>().join(",\\,")
}

/// A coefficient in front of a variable; `(-1)` and `1` are signs.
fn term(before: &str, coefficient: &str, variable: &str) -> String {
    let negative = coefficient
        .strip_prefix("(-")
        .and_then(|rest| rest.strip_suffix(')'))
        .filter(|size| !size[1..].contains(['+', '-']));
    let plus = if before.is_empty() { "" } else { "+" };
    match (coefficient, negative) {
        ("1", _) => format!("{plus}{variable}"),
        (_, Some("1")) => format!("-{variable}"),
        (_, Some(size)) => format!("-{size}{variable}"),
        _ => format!("{plus}{coefficient}{variable}"),
    }
}

/// One row for each orbit, by classes.
fn orbit_table<const D: usize>(analysis: &Analysis<D>) -> String {
    let classes = analysis.class_of();
    let mut orbits: Vec<(usize, SimplexId, usize)> = analysis
        .orbits()
        .into_iter()
        .enumerate()
        .map(|(orbit, (first, count))| (orbit, first, count))
        .collect();
    orbits.sort_by_key(|&(orbit, first, _)| (classes[first.index()], orbit));
    let all = orbits.len();
    orbits.truncate(LONG);
    let row = |&(orbit, first, count): &(usize, SimplexId, usize)| {
        format!(
            "{} & {orbit} & {count} & ${}$ & $T_{{{first}}}$ & {}",
            classes[first.index()],
            determinant(analysis, first),
            corners(analysis, first)
        )
    };
    let omitted = match all > orbits.len() {
        true => format!(
            " The first ${}$ of ${all}$ orbits; all tiles are in the supplement.",
            orbits.len()
        ),
        false => String::new(),
    };
    Table {
        mark: format!("orbits {}", analysis.subject.slug()),
        columns: &format!("rrrll{}", "@{\\quad}r".repeat(D + 1)),
        caption: format!(
            "The {} by congruence classes and orbits: how many {}, the determinant of the edges (${}!$ times the \
             volume in cells), and the corners of the first of each orbit. {}{omitted}",
            simplices(D, 2),
            if analysis.rank() == 0 { "there are" } else { "a cell holds" },
            D,
            notation(analysis),
        ),
        label: analysis.label("orbits"),
        heading: format!("class & orbit & number & $\\det$ & first & \\multicolumn{{{}}}{{c}}{{corners}}", D + 1),
        rows: orbits.iter().map(row).collect(),
    }
    .tex()
}

/// What a corner's superscript means.
fn notation<const D: usize>(analysis: &Analysis<D>) -> &'static str {
    match analysis.rank() {
        0 => "A number is a vertex.",
        1 => "A number is a vertex; $5^{\\bar1}$ is vertex $5$ moved by $-b_1$.",
        2 => "A number is a vertex; $5^{1\\bar1}$ is vertex $5$ moved by $b_1-b_2$.",
        _ => "A number is a vertex; $5^{1\\bar10}$ is vertex $5$ moved by $b_1-b_2$.",
    }
}

pub fn determinant<const D: usize>(analysis: &Analysis<D>, simplex: SimplexId) -> String {
    let determinant: Number = analysis.tiling.shape(simplex).determinant;
    analysis.numerals.cell(&determinant)
}

pub fn corners<const D: usize>(analysis: &Analysis<D>, simplex: SimplexId) -> String {
    let corners: Vec<String> = analysis
        .tiling
        .simplex(simplex)
        .iter()
        .map(|c| format!("${}$", corner(c, analysis.rank())))
        .collect();
    corners.join(" & ")
}

/// All simplices, for the supplement.
pub fn all_simplices<const D: usize>(analysis: &Analysis<D>) -> String {
    let classes = analysis.class_of();
    let orbits = &analysis.symmetry.simplices;
    Table {
        mark: format!("simplices {}", analysis.subject.slug()),
        columns: &format!("rrrl{}", "@{\\quad}r".repeat(D + 1)),
        caption: format!(
            "All {}: class, orbit, determinant, corners. {}",
            simplices(D, 2),
            notation(analysis)
        ),
        label: analysis.label("simplices"),
        heading: format!(
            "& class & orbit & $\\det$ & \\multicolumn{{{}}}{{c}}{{corners}}",
            D + 1
        ),
        rows: analysis
            .tiling
            .indices()
            .map(|simplex| {
                format!(
                    "$T_{{{simplex}}}$ & {} & {} & ${}$ & {}",
                    classes[simplex.index()],
                    orbits[simplex.index()],
                    determinant(analysis, simplex),
                    corners(analysis, simplex)
                )
            })
            .collect(),
    }
    .tex()
}
