//! The tile on the other side of each facet of the representatives, and the reason. Also the powers for the
//! Delaunay condition, and the pairing of all facets for the supplement.

use super::boundary::{boundary_face, faces};
use super::subject::Analysis;
use super::tex::{self, Table, facet_word, sphere_word};
use acutile_core::tiling::{Corner, Facet, Mate, SimplexId};
use acutile_exact::geometry::{Simplex, linear};
use acutile_exact::number::Number;
use std::collections::BTreeSet;

/// The paragraph and the table on facets.
pub fn facets<const D: usize>(analysis: &Analysis<D>) -> String {
    let facet = facet_word(D);
    let isometry = match (analysis.orbits.elements.len(), analysis.rank()) {
        (1, 0) => "a tile $T$",
        (1, _) => "a tile $T$, moved by the lattice vector in the superscript,",
        (_, 0) => "an image $\\gamma T$ of a representative",
        (_, _) => {
            "an image $\\gamma T$ of a representative, moved by the lattice vector in the superscript,"
        }
    };
    let domain = &analysis.tiling.frame.domain;
    let boundary = match (domain.polytope(), domain.is_region()) {
        (Some(_), _) => format!(
            " An entry $\\partial_f$ says that the {facet} lies in face $f$ of the boundary{}",
            faces(analysis)
        ),
        (_, true) => format!(" An entry $\\partial$ says that the {facet} is in the boundary."),
        _ => String::new(),
    };
    format!(
        "\\acutileparagraph{{{name} (F).}} A row of Table~\\ref{{{label}}} is about the {facet} of the tile in the first column that is opposite to its corner $c_i$. \
         On the other side is {isometry} whose corner $j$ is $d$ and whose other corners are those of the {facet}. \
         The last column has $\\det$ with $d$ in the place of $c_i$. It is negative, so $c_i$ and $d$ are on different sides.{boundary}\n\n{table}",
        name = if D == 2 { "Edges" } else { "Facets" },
        label = analysis.label("pairing"),
        table = table(analysis),
    )
}

fn table<const D: usize>(analysis: &Analysis<D>) -> String {
    let rows = analysis.order.iter().flat_map(|&place| {
        let tile = analysis.orbits.representatives[place].tile;
        (0..=D).map(move |i| row(analysis, Facet::new(tile, i)))
    });
    Table {
        mark: format!("pairing {}", analysis.subject.slug()),
        columns: "rrrrrl",
        caption: format!("The tile on the other side of each {}.", facet_word(D)),
        label: analysis.label("pairing"),
        heading: "tile & $i$ & $d$ & other tile & $j$ & $\\det$ with $d$ for $c_i$ $(<0)$"
            .to_owned(),
        rows: rows.collect(),
    }
    .tex()
}

fn row<const D: usize>(analysis: &Analysis<D>, facet: Facet) -> String {
    let start = format!("$T_{{{}}}$ & {}", facet.simplex, facet.opposite);
    match analysis.matching.mate(analysis.tiling, facet) {
        None => format!("{start} & ${}$ & & &", boundary(analysis, facet)),
        Some(mate) => {
            let apex = apex(analysis, &mate);
            let (tile, corner) = analysis.behind(&mate);
            format!(
                "{start} & ${}$ & ${tile}$ & {corner} & ${}$",
                tex::corner(&apex, analysis.rank()),
                analysis
                    .numerals
                    .justified(&exchanged(analysis, facet, &apex)),
            )
        }
    }
}

/// The corner of the other tile that is not in the facet.
fn apex<const D: usize>(analysis: &Analysis<D>, mate: &Mate<D>) -> Corner<D> {
    let corners = analysis.tiling.simplex(mate.facet.simplex);
    corners[usize::from(mate.facet.opposite)].moved(mate.shift)
}

/// The determinant with the apex in the place of the corner opposite to the facet.
fn exchanged<const D: usize>(analysis: &Analysis<D>, facet: Facet, apex: &Corner<D>) -> Number {
    let mut corners = analysis.tiling.simplex(facet.simplex).to_vec();
    corners[usize::from(facet.opposite)] = *apex;
    let points: Vec<[Number; D]> = corners
        .iter()
        .map(|c| analysis.tiling.position(c))
        .collect();
    Simplex::new(&points).determinant
}

fn boundary<const D: usize>(analysis: &Analysis<D>, facet: Facet) -> String {
    match boundary_face(analysis, facet) {
        Some(face) => format!("\\partial_{{{face}}}"),
        None => "\\partial".to_owned(),
    }
}

/// The powers of the apexes, one row for each pair of a facet and its mate.
pub fn delaunay<const D: usize>(analysis: &Analysis<D>, is_strict: bool) -> String {
    let sphere = sphere_word(D);
    let facet = facet_word(D);
    let rows = power_rows(analysis);
    if rows.is_empty() {
        return format!(
            "\\acutileparagraph{{Delaunay.}} All {facet}s are in the boundary, so nothing is to be checked.\n\n"
        );
    }
    let is_region = analysis.tiling.frame.domain.is_region();
    let (relation, sign, position) = if is_strict {
        ("positive", "$(>0)$", "outside of")
    } else {
        ("nonnegative", "$(\\ge0)$", "not inside of")
    };
    let reason = if is_region {
        format!(
            "At each {facet} that two tiles share, the corner $d$ of Table~\\ref{{{}}} is {position} the {sphere}",
            analysis.label("pairing")
        )
    } else {
        format!(
            "By Theorem~\\ref{{acutile:delaunay}} it suffices that for each {facet} the corner $d$ of Table~\\ref{{{}}} is {position} the {sphere}",
            analysis.label("pairing")
        )
    };
    format!(
        "\\acutileparagraph{{Delaunay.}} {reason}: that its power $\\pi(d)=|d-z|^2-\\rho^2$, for the centre $z$ and the radius $\\rho$, is {relation}. \
         With $d-c_0=\\sum_k\\lambda_k(c_k-c_0)$ it is $|d-c_0|^2-\\sum_k\\lambda_k|c_k-c_0|^2$. \
         A {facet} is left out if it is listed for the other tile, which suffices by Lemma~\\ref{{acutile:sides}}.\n\n{}",
        Table {
            mark: format!("delaunay {}", analysis.subject.slug()),
            columns: "rrrl",
            caption: format!("The power of the corner on the other side of each {facet}."),
            label: analysis.label("delaunay"),
            heading: format!("tile & $i$ & $d$ & $\\pi(d)$ {sign}"),
            rows,
        }
        .tex()
    )
}

/// A row for each facet, unless there is one for the same facet of the representative on its other
/// side.
fn power_rows<const D: usize>(analysis: &Analysis<D>) -> Vec<String> {
    let mut listed = BTreeSet::new();
    let mut rows = Vec::new();
    for &place in &analysis.order {
        let tile = analysis.orbits.representatives[place].tile;
        for facet in (0..=D).map(|i| Facet::new(tile, i)) {
            let Some(mate) = analysis.matching.mate(analysis.tiling, facet) else {
                continue;
            };
            let image = &analysis.orbits.images[mate.facet.simplex.index()];
            let other = image.corners[usize::from(mate.facet.opposite)];
            if !listed.contains(&(image.representative, other)) {
                listed.insert((place, usize::from(facet.opposite)));
                rows.extend(power_row(analysis, facet, &mate));
            }
        }
    }
    rows
}

fn power_row<const D: usize>(
    analysis: &Analysis<D>,
    facet: Facet,
    mate: &Mate<D>,
) -> Option<String> {
    let apex = apex(analysis, mate);
    Some(format!(
        "$T_{{{}}}$ & {} & ${}$ & ${}$",
        facet.simplex,
        facet.opposite,
        tex::corner(&apex, analysis.rank()),
        analysis.numerals.justified(&power(analysis, facet, &apex)?),
    ))
}

/// The power of a corner with respect to the circumsphere of a facet's simplex.
fn power<const D: usize>(analysis: &Analysis<D>, facet: Facet, apex: &Corner<D>) -> Option<Number> {
    let tiling = analysis.tiling;
    let origin = tiling.position(&tiling.simplex(facet.simplex)[0]);
    let offset = linear::subtract(&tiling.position(apex), &origin);
    let shape = tiling.shape(facet.simplex);
    shape
        .power(&tiling.frame.gram, &offset)
        .divide(&shape.determinant)
}

/// The pairing of all facets, for the supplement.
pub fn all_facets<const D: usize>(analysis: &Analysis<D>) -> String {
    let cell = |facet: Facet| match analysis.matching.mate(analysis.tiling, facet) {
        Some(mate) => format!(" & ${}$", tex::mate(&mate, analysis.rank())),
        None => format!(" & ${}$", boundary(analysis, facet)),
    };
    let row = |simplex: SimplexId| {
        let cells: String = (0..=D).map(|i| cell(Facet::new(simplex, i))).collect();
        format!("$T_{{{simplex}}}${cells}")
    };
    let names: String = (0..=D).map(|i| format!(" & $i={i}$")).collect();
    Table {
        mark: format!("mates {}", analysis.subject.slug()),
        columns: &format!("r{}", "@{\\quad}r".repeat(D + 1)),
        caption: format!(
            "The other side of each {0}: $t_j$ is the {0} of $T_t$ opposite to its corner $j$.",
            facet_word(D)
        ),
        label: analysis.label("mates"),
        heading: names,
        rows: analysis.tiling.indices().map(row).collect(),
    }
    .tex()
}
