//! Names of Delaunay cells by their combinatorial type.

use crate::delaunay::Cell;
use std::collections::BTreeMap;

/// How many cells have each name.
pub fn polyhedra(cells: &[Cell<3>]) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for cell in cells {
        *counts.entry(name(cell)).or_insert(0) += 1;
    }
    counts
}

/// The name of a cell. Names mean the type of the polyhedron, not its lengths: a cuboid is a
/// cube here.
fn name(cell: &Cell<3>) -> String {
    let corners = cell.corners.len();
    let mut sizes: BTreeMap<usize, usize> = BTreeMap::new();
    for facet in &cell.facets {
        *sizes.entry(facet.len()).or_insert(0) += 1;
    }
    let count = |size: usize| sizes.get(&size).copied().unwrap_or(0);
    let has_only = |sizes: &[usize]| cell.facets.iter().all(|facet| sizes.contains(&facet.len()));
    let degree = |corner: usize| cell.facets.iter().filter(|f| f.contains(&corner)).count();
    let known = match (corners, count(3), count(4)) {
        (4, 4, 0) => Some("tetrahedron"),
        (5, 4, 1) => Some("square pyramid"),
        (5, 6, 0) => Some("triangular bipyramid"),
        (6, 8, 0) if (0..6).all(|corner| degree(corner) == 4) => Some("octahedron"),
        (6, 2, 3) => Some("triangular prism"),
        (8, 0, 6) => Some("cube"),
        (8, 8, 2) if (0..8).all(|corner| degree(corner) == 4) => Some("square antiprism"),
        _ => None,
    };
    if let Some(name) = known.filter(|_| has_only(&[3, 4])) {
        return name.to_owned();
    }
    let faces: Vec<String> = sizes
        .iter()
        .map(|(size, count)| match size {
            3 => format!("{count} triangles"),
            4 => format!("{count} quadrilaterals"),
            size => format!("{count} {size}-gons"),
        })
        .collect();
    format!("polyhedron with {corners} corners and {}", faces.join(", "))
}
