//! The Voronoi neighbours of the points of a set, from its Delaunay cells.
//!
//! Two points are neighbours if their Voronoi cells share a face of dimension 2. That is so exactly if they
//! span an edge of a Delaunay cell. The face has as many edges as there are Delaunay cells around that
//! edge. Cells that are not simplices are not cut, so the answer depends on the points alone.

use crate::delaunay::Cell;
use crate::tiling::{Corner, difference};
use std::collections::BTreeMap;
use std::fmt;

/// How a point is surrounded.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Surroundings {
    /// How many faces of the Voronoi cell have each number of edges.
    pub faces: BTreeMap<usize, usize>,
    /// Whether the Delaunay cells at the point form one of the stars of TCP triangulations.
    pub is_frank_kasper: bool,
}

impl Surroundings {
    /// The number of Voronoi neighbours.
    pub fn neighbours(&self) -> usize {
        self.faces.values().sum()
    }

    /// The numbers of faces with 3, 4, … edges, up to 6 or the most that occurs.
    pub fn voronoi_index(&self) -> Vec<usize> {
        let most = self.faces.keys().max().copied().unwrap_or(0).max(6);
        (3..=most)
            .map(|edges| self.faces.get(&edges).copied().unwrap_or(0))
            .collect()
    }
}

impl fmt::Display for Surroundings {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let index: Vec<String> = self.voronoi_index().iter().map(usize::to_string).collect();
        let kind = if self.is_frank_kasper {
            format!(", Z{}", self.neighbours())
        } else {
            String::new()
        };
        write!(
            f,
            "{} neighbours{kind}, Voronoi index ({})",
            self.neighbours(),
            index.join(",")
        )
    }
}

/// The Delaunay cells at a point: how many lie around each of its edges, and which pairs of edges
/// lie in one triangle.
#[derive(Default)]
struct Star {
    around: BTreeMap<Corner<3>, usize>,
    triangles: Vec<[Corner<3>; 2]>,
    has_polytope: bool,
}

/// The surroundings of each of the points whose Delaunay cells are given.
pub fn surroundings(cells: &[Cell<3>], points: usize) -> Vec<Surroundings> {
    let mut stars: Vec<Star> = Vec::new();
    stars.resize_with(points, Star::default);
    for cell in cells {
        let edges = edges(cell);
        for (i, corner) in cell.corners.iter().enumerate() {
            let seen = |j: usize| Corner {
                vertex: cell.corners[j].vertex,
                shift: difference(cell.corners[j].shift, corner.shift),
            };
            let Some(star) = stars.get_mut(corner.vertex.index()) else {
                continue;
            };
            let others: Vec<Corner<3>> = edges
                .iter()
                .filter(|edge| edge.contains(&i))
                .map(|&[a, b]| seen(if a == i { b } else { a }))
                .collect();
            star.has_polytope |= !cell.is_simplex();
            for (n, other) in others.iter().enumerate() {
                *star.around.entry(*other).or_insert(0) += 1;
                star.triangles
                    .extend(others[..n].iter().map(|before| [*before, *other]));
            }
        }
    }
    stars.iter().map(of_star).collect()
}

/// The edges of a cell: pairs of corners that are all that two or more facets have in common.
fn edges(cell: &Cell<3>) -> Vec<[usize; 2]> {
    let count = cell.corners.len();
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
    pairs
        .filter(|pair| cell.is_simplex() || is_edge(cell, pair))
        .collect()
}

fn is_edge(cell: &Cell<3>, pair: &[usize; 2]) -> bool {
    let facets = || {
        let all = cell.facets.iter();
        all.filter(|facet| pair.iter().all(|corner| facet.contains(corner)))
    };
    let common = |corner: usize| facets().all(|facet| facet.contains(&corner));
    facets().count() >= 2 && (0..cell.corners.len()).filter(|&c| common(c)).count() == 2
}

/// A star is of Frank and Kasper if all its cells are tetrahedra and its edges have valence 5 or 6. No
/// triangle has two edges of valence 6. The module [`super::frank_kasper`] lists the links with these
/// valences.
fn of_star(star: &Star) -> Surroundings {
    let mut faces = BTreeMap::new();
    for count in star.around.values() {
        *faces.entry(*count).or_insert(0) += 1;
    }
    let is_six = |corner: &Corner<3>| star.around.get(corner) == Some(&6);
    let is_frank_kasper = !star.has_polytope
        && !faces.is_empty()
        && faces.keys().all(|edges| matches!(edges, 5 | 6))
        && !star.triangles.iter().any(|pair| pair.iter().all(is_six));
    Surroundings {
        faces,
        is_frank_kasper,
    }
}
