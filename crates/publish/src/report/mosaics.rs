//! Tilings of the plane by squares and triangles from the catalogue, in doubles: the page shows the pieces of a
//! system of patches on them.

use acutile_catalog::plane_tiling::{Cyclotomic, POWERS, PlaneTiling, TileCorner, named, sum};
use serde_json::{Value, json};

/// Names of the catalogue, and what they are called.
const MOSAICS: [(&str, &str); 8] = [
    ("32434", "snub square, 3².4.3.4"),
    ("33344", "rows, 3³.4²"),
    ("3", "triangles, 3⁶"),
    ("4", "squares, 4⁴"),
    ("3464", "3.4.6.4 with cut hexagons"),
    ("inflated-3", "triangles, inflated once"),
    ("inflated-4", "squares, inflated once"),
    ("inflated-32434", "snub square, inflated once"),
];

/// For each tiling its name, two lattice vectors, and the corners of the tiles of a cell, counterclockwise.
pub fn mosaics() -> Value {
    let known = MOSAICS
        .iter()
        .filter_map(|(name, label)| Some((label, named(name)?)));
    known
        .filter_map(|(label, plane)| mosaic(label, &plane))
        .collect()
}

/// `None` for a tiling that is none; the catalogue has no such.
fn mosaic(label: &str, plane: &PlaneTiling) -> Option<Value> {
    let stars = plane.stars().ok()?;
    let tiles = (0..).zip(&stars).flat_map(|(vertex, star)| {
        let corners = star.iter();
        corners.filter_map(move |corner| tile(plane, vertex, corner))
    });
    let tiles: Vec<Value> = tiles
        .map(|corners| corners.into_iter().map(position).collect())
        .collect();
    Some(json!({
        "name": label,
        "lattice": plane.lattice.map(position),
        "tiles": tiles,
    }))
}

/// The corners of the tile at a vertex, if this corner is the first one of the tile.
fn tile(plane: &PlaneTiling, vertex: usize, corner: &TileCorner) -> Option<Vec<Cyclotomic>> {
    let indices = plane.indices();
    let sides = if corner.is_square() { 4 } else { 3 };
    let mut corners = vec![plane.vertices[vertex]];
    let mut direction = corner.direction;
    for _ in 1..sides {
        let next = sum(*corners.last()?, POWERS[direction]);
        // The exterior angle.
        direction = (direction + 6 - corner.angle) % 12;
        let index = *indices.get(&plane.residue(next))?;
        if (index, direction) < (vertex, corner.direction) {
            return None;
        }
        corners.push(next);
    }
    Some(corners)
}

/// a + b z + c z² + d z³ in the plane, with z a 12th root of unity.
fn position([a, b, c, d]: Cyclotomic) -> Value {
    let [a, b, c, d] = [a, b, c, d].map(|x| x as f64);
    let root = 3f64.sqrt() / 2.0;
    json!([a + b * root + c / 2.0, b / 2.0 + c * root + d])
}

#[cfg(test)]
mod tests {
    use super::mosaics;

    /// Counted by hand. The vertex of 3^6 has six corners of triangles, and a cell has two triangles. The
    /// snub square tiling has two squares and four triangles in a cell with four vertices. Inflation by 2 +
    /// √3 multiplies areas by 7 + 4√3.
    #[test]
    fn numbers_of_tiles() {
        let value = mosaics();
        let counts: Vec<(usize, usize)> = value
            .as_array()
            .expect("an array")
            .iter()
            .map(|mosaic| {
                let tiles = mosaic["tiles"].as_array().expect("tiles");
                let with = |n| {
                    let sides = tiles.iter().filter_map(|tile| tile.as_array());
                    sides.filter(|tile| tile.len() == n).count()
                };
                (with(3), with(4))
            })
            .collect();
        assert_eq!(counts[..4], [(4, 2), (2, 1), (2, 0), (0, 1)]);
        // (2 √3/4)(7 + 4√3) = 7 √3/2 + 6: 14 triangles, 6 squares. And 1 (7 + 4√3): 16 triangles, 7 squares.
        assert_eq!(counts[5..7], [(14, 6), (16, 7)]);
    }
}
