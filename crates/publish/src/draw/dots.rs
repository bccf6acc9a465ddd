//! Section 4.1: the square/triangle tiling under a TCP structure, with dots for the vertices of the
//! structure. Black dots are at heights 4k - 1, white ones at 4k + 1, and the tiling's vertices at 4k and
//! 4k + 2.

use super::drawing::{BLACK, Drawing, GREY, Item, Layout, Panel, Place, Stroke, WHITE};
use super::{DrawError, Options};
use acutile_catalog::plane_tiling::{Cyclotomic, POWERS, PlaneTiling, named, scaled, sum};
use std::collections::{BTreeSet, HashMap};

/// The figure: the tiles of several cells, and one cell outlined.
pub fn dots(name: &str, options: &Options) -> Result<Drawing, DrawError> {
    let plane = under(name).ok_or(DrawError::NoPlane)?;
    let around = match plane.vertices.len() {
        0..=4 => -1..2,
        5..=12 => 0..2,
        _ => 0..1,
    };
    let cell = tiles(&plane)?;
    let shifts = around
        .clone()
        .flat_map(|i| around.clone().map(move |j| [i, j]));
    let copies = |by: [i64; 2]| {
        cell.iter()
            .map(|tile| moved(tile, &plane, by))
            .collect::<Vec<Tile>>()
    };
    let tiles: Vec<Tile> = shifts.flat_map(copies).collect();
    let mut items = sides(&tiles);
    items.extend(outline(&plane));
    items.extend(marks(&plane, &tiles)?);
    let panel = Panel {
        items,
        caption: String::new(),
    };
    let layout = Layout {
        width: options.width,
        columns: 1,
        margin: 2.0,
        has_one_scale: true,
        legend: vec![
            (BLACK, "height 4k \u{2212} 1".to_owned()),
            (WHITE, "height 4k + 1".to_owned()),
            (GREY, "heights 4k, 4k + 2".to_owned()),
        ],
    };
    Ok(layout.arrange(&format!("{name}: plane tiling"), &[panel]))
}

/// The plane tiling of a construction of the catalogue.
fn under(name: &str) -> Option<PlaneTiling> {
    match name {
        "z" => named("3"),
        "a15" => named("4"),
        "sigma" => named("32434"),
        "h" => named("33344"),
        _ => named(name.strip_prefix("square-triangle")?.get(1..)?),
    }
}

/// A square or a triangle: its corners in positive order.
type Tile = Vec<Cyclotomic>;

/// All tiles of a cell, with their centres in the parallelogram. A triangle's sides have directions k, k + 4, k + 8, and a square's k,
/// k + 3, k + 6, k + 9. So one corner of each begins with a small direction.
fn tiles(plane: &PlaneTiling) -> Result<Vec<Tile>, DrawError> {
    let mut tiles = Vec::new();
    for (&vertex, star) in plane.vertices.iter().zip(&plane.stars()?) {
        for corner in star {
            let (sides, turn) = if corner.is_square() { (4, 3) } else { (3, 4) };
            if corner.direction < turn {
                let directions = (0..sides - 1).map(|side| corner.direction + side * turn);
                let mut tile = vec![vertex];
                tile.extend(directions.scan(vertex, |at, k| {
                    *at = sum(*at, POWERS[k]);
                    Some(*at)
                }));
                let by = place_of_centre(plane, &tile).map(|x| -(x + 1e-9).floor() as i64);
                tiles.push(moved(&tile, plane, by));
            }
        }
    }
    Ok(tiles)
}

fn moved(tile: &[Cyclotomic], plane: &PlaneTiling, [i, j]: [i64; 2]) -> Tile {
    let [a, b] = plane.lattice;
    let by = sum(scaled(a, i), scaled(b, j));
    tile.iter().map(|&corner| sum(corner, by)).collect()
}

/// The coordinates of a tile's centre in the lattice vectors.
fn place_of_centre(plane: &PlaneTiling, tile: &[Cyclotomic]) -> [f64; 2] {
    let cross = |x: Place, y: Place| x[0] * y[1] - x[1] * y[0];
    let [a, b] = plane.lattice.map(|x| cartesian(x, 1.0));
    let centre = tile.iter().fold([0; 4], |x, &corner| sum(x, corner));
    let centre = cartesian(centre, tile.len() as f64);
    [cross(centre, b), cross(a, centre)].map(|x| x / cross(a, b))
}

/// The sides of all tiles, each once.
fn sides(tiles: &[Tile]) -> Vec<Item> {
    let pairs = tiles.iter().flat_map(|tile| {
        let next = tile.iter().cycle().skip(1);
        tile.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)])
    });
    let pairs: BTreeSet<[Cyclotomic; 2]> = pairs.collect();
    let line = |ends: [Cyclotomic; 2]| Item::Line {
        ends: ends.map(|x| cartesian(x, 1.0)),
        stroke: Stroke::Edge,
    };
    pairs.into_iter().map(line).collect()
}

/// The parallelogram of the lattice.
fn outline(plane: &PlaneTiling) -> Vec<Item> {
    let [a, b] = plane.lattice;
    let corners = [[0; 4], a, sum(a, b), b].map(|x| cartesian(x, 1.0));
    (0..4)
        .map(|k| Item::Line {
            ends: [corners[k], corners[(k + 1) % 4]],
            stroke: Stroke::Outline,
        })
        .collect()
}

/// The dots of the tiles and their corners. The places where a tile may have dots are gone
/// through, and the points of the structure tell which are there and at which height.
fn marks(plane: &PlaneTiling, tiles: &[Tile]) -> Result<Vec<Item>, DrawError> {
    let finer = PlaneTiling {
        lattice: plane.lattice.map(|x| scaled(x, SCALE)),
        vertices: Vec::new(),
    };
    let points = plane.points()?;
    let low = points.iter().filter(|(_, height)| *height != 2);
    let heights: HashMap<Cyclotomic, i64> = low
        .map(|&(place, height)| (finer.residue(place), height))
        .collect();
    let places: BTreeSet<Cyclotomic> = tiles.iter().flat_map(|tile| candidates(tile)).collect();
    let mark = |place: Cyclotomic| {
        let height = *heights.get(&finer.residue(place))?;
        Some(Item::Dot {
            at: cartesian(place, SCALE as f64),
            radius: if height == 0 { 0.5 } else { 0.8 },
            fill: match height {
                0 => GREY,
                ..0 => BLACK,
                _ => WHITE,
            },
        })
    };
    Ok(places.into_iter().filter_map(mark).collect())
}

/// The number of parts of a side that points of a structure are multiples of.
const SCALE: i64 = 12;

/// The corners, the middles of the sides, and the centre of a triangle. In a square also the middles,
/// moved inwards by a quarter of the side.
fn candidates(tile: &[Cyclotomic]) -> Vec<Cyclotomic> {
    let n = tile.len();
    let combination = |weights: &[(usize, i64)]| {
        let terms = weights
            .iter()
            .map(|&(k, weight)| scaled(tile[k % n], weight));
        terms.fold([0; 4], sum)
    };
    let mut places = Vec::new();
    for k in 0..n {
        places.push(combination(&[(k, 12)]));
        places.push(combination(&[(k, 6), (k + 1, 6)]));
        if n == 4 {
            // 3/4 (p + q)/2 + 1/4 (r + s)/2 in twelfths of a half: 9 and 3 of 24.
            let doubled = combination(&[(k, 9), (k + 1, 9), (k + 2, 3), (k + 3, 3)]);
            places.push(doubled.map(|x| x / 2));
        }
    }
    if n == 3 {
        places.push(combination(&[(0, 4), (1, 4), (2, 4)]));
    }
    places
}

/// z = (√3 + i)/2, z² = (1 + i √3)/2, z³ = i; divided by `scale`.
fn cartesian(x: Cyclotomic, scale: f64) -> Place {
    let [a, b, c, d] = x.map(|entry| entry as f64 / scale);
    let root = 3f64.sqrt();
    [a + (b * root + c) / 2.0, d + (b + c * root) / 2.0]
}
