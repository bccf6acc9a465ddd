//! The article and the data of a system of patches: the theorem, and each tile of the base with its piece. The page puts
//! the pieces together on a tiling of the reader's choice.

use super::article::{Head, field_words};
use super::facts::classes;
use super::html::{escape, fill};
use super::math::math;
use super::mosaics::mosaics;
use super::picture::picture;
use super::theorem::Theorem;
use acutile_core::patches::{System, Tile};
use acutile_exact::number::Number;
use serde_json::{Value, json};
use std::collections::BTreeMap;

const TEMPLATE: &str = include_str!("assets/patches.html");

/// The article number `index` of a page.
pub fn article(index: usize, theorem: &Theorem, system: &System) -> String {
    let pieces: String = (0..)
        .zip(&system.tiles)
        .map(|(number, tile)| piece(theorem, system, number, tile))
        .collect();
    let sections = fill(TEMPLATE, &[("facts", &*facts(system)), ("pieces", &pieces)]);
    let first = system.tiles.first();
    let still = first.map(|tile| still(theorem, system, 0, tile));
    Head::of_theorem(theorem).article(index, &still.unwrap_or_default(), &sections)
}

/// The object `tilings[i]` of the page. Tiles and patches are those of the certificate.
pub fn data(theorem: &Theorem, system: &System) -> Value {
    json!({
        "name": theorem.name,
        "kind": "patches",
        "dimension": 3,
        "sha256": theorem.sha256(),
        "certificate": theorem.json(),
        "generator": system.field.generator().approximate(),
        "mosaics": if system.rank == 1 { mosaics() } else { Value::Null },
        "letters": theorem.letters,
    })
}

fn facts(system: &System) -> String {
    let rows = system.gram.iter().map(|row| {
        let cells = row
            .iter()
            .map(|x| format!("<td>{}</td>", math(&x.to_string())));
        format!("<tr>{}</tr>", cells.collect::<String>())
    });
    let gram = format!(
        "<table class=\"matrix\">{}</table>",
        rows.collect::<String>()
    );
    let base = match system.rank {
        1 => {
            "the plane, tiled edge to edge by moved and turned copies of the tiles; the tilings of space are periodic in the direction of the first basis vector"
        }
        _ => {
            "the line, divided into moved copies of the tiles; the tilings of space are periodic under the first two basis vectors"
        }
    };
    let vertices: usize = system.tiles.iter().map(|t| t.patch.vertices.len()).sum();
    let simplices: usize = system.tiles.iter().map(|t| t.patch.simplices.len()).sum();
    let counts = format!(
        "{} tiles with <span data-verified=\"simplices\">{simplices}</span> tetrahedra and <span data-verified=\"vertices\">{vertices}</span> vertices",
        system.tiles.len()
    );
    let terms = [
        ("Base", base.to_owned()),
        ("Pieces", counts),
        ("Numbers", field_words(&system.field)),
        ("Gram matrix of the basis", gram),
    ];
    let term = |(term, value): &(&str, String)| format!("<dt>{term}</dt><dd>{value}</dd>");
    terms.iter().map(term).collect()
}

fn still(theorem: &Theorem, system: &System, number: usize, tile: &Tile) -> String {
    let piece = system.piece(tile);
    let label = format!(
        "The piece over tile {number} of {}: {} tetrahedra",
        escape(&theorem.name),
        piece.len()
    );
    picture(&piece, &classes(&piece), &label)
}

/// A tile of the base: picture, counts, sides, pyramids, vertices.
fn piece(theorem: &Theorem, system: &System, number: usize, tile: &Tile) -> String {
    let letter = theorem.letters.chars().nth(number);
    let letter = letter.map_or_else(String::new, |letter| format!(", letter {letter}"));
    let shape = match (system.rank, tile.corners.len()) {
        (1, 3) => "a triangle".to_owned(),
        (1, n) => format!("a polygon with {n} sides"),
        _ => "a segment".to_owned(),
    };
    let corners: Vec<String> = tile.corners.iter().map(|point| tuple(point)).collect();
    let patch = &tile.patch;
    let terms = [
        ("Corners in the base", corners.join(", ")),
        ("Sides", sides(system, tile)),
        ("Tetrahedra of the piece", patch.simplices.len().to_string()),
        ("Pyramids in the sides", pyramids(tile)),
    ];
    let term = |(term, value): &(&str, String)| format!("<dt>{term}</dt><dd>{value}</dd>");
    let vertex = |(k, point): (usize, &[Number; 3])| {
        let cells = point
            .iter()
            .map(|x| format!("<td>{}</td>", math(&x.to_string())));
        format!(
            "<tr><th scope=\"row\">{k}</th>{}</tr>",
            cells.collect::<String>()
        )
    };
    let vertices: String = patch.vertices.iter().enumerate().map(vertex).collect();
    format!(
        "<section class=\"piece\"><h4>Tile {number}{letter}: {shape}</h4>{picture}<dl class=\"facts\">{facts}</dl>\
         <details class=\"long\"><summary>Vertices over tile {number}</summary>\
         <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Vertices over tile {number}\"><table><thead><tr><th scope=\"col\">vertex</th>\
         <th scope=\"col\" colspan=\"3\">coordinates</th></tr></thead><tbody>{vertices}</tbody></table></div></details></section>",
        letter = escape(&letter),
        picture = still(theorem, system, number, tile),
        facts = terms.iter().map(term).collect::<String>(),
    )
}

fn tuple(point: &[Number]) -> String {
    let texts: Vec<String> = point.iter().map(|x| math(&x.to_string())).collect();
    match texts.as_slice() {
        [one] => one.clone(),
        _ => format!("({})", texts.join(", ")),
    }
}

/// Class and offset of each side.
fn sides(system: &System, tile: &Tile) -> String {
    let name = |k: usize| match (system.rank, k) {
        (1, k) => format!("side {k}"),
        (_, 0) => "lower end".to_owned(),
        _ => "upper end".to_owned(),
    };
    let pairs = tile.classes.iter().zip(&tile.patch.offsets).enumerate();
    let side = |(k, (class, offset)): (usize, (&i64, &Vec<Number>))| {
        format!("{}: class {class}, offset {}", name(k), tuple(offset))
    };
    pairs.map(side).collect::<Vec<_>>().join("; ")
}

fn pyramids(tile: &Tile) -> String {
    let mut counts = BTreeMap::new();
    for pyramid in &tile.patch.pyramids {
        *counts.entry(pyramid.polygon.len()).or_insert(0usize) += 1;
    }
    let words = counts
        .iter()
        .map(|(corners, count)| format!("{count} over a polygon with {corners} corners"));
    words.collect::<Vec<_>>().join("; ")
}
