//! Which removed sets leave a rest that might triangulate a polyhedron acutely, by counts.
//!
//! K is the set of tetrahedra without a vertex of B. Each of its edges inside has valence 5. Angles at an
//! edge in a flat part of the boundary add up to 180 degrees, so an acute K has at least three there. So
//! every boundary edge of valence 1 or 2 lies in an edge of the polyhedron. These edges form a part of its
//! skeleton, and none of them ends inside a face. Only sets for which they are all of the skeleton are
//! built. So a vertex at which one of them ends excludes a set. There the edge of the polyhedron would
//! continue along edges of valence 3 or more.

use super::remains::{Edge, Remains, number_of};
use acutile_exact::geometry::cell600;
use std::collections::{BTreeMap, BTreeSet};

/// A class of removed sets that leave the same numbers.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rest {
    /// The number of vertices that were removed.
    pub removed: usize,
    /// The number of tetrahedra that remain.
    pub tetrahedra: usize,
    /// The number of triangles in the boundary.
    pub boundary_triangles: usize,
    /// Boundary edges of valence 1, and of valence 2.
    pub ridges: (usize, usize),
    /// The number of vertices at which exactly one of these edges ends.
    pub dead_ends: usize,
    /// The number of vertices at which three or more of these edges meet.
    pub corners: usize,
    /// The parts into which these edges cut the boundary.
    pub faces: usize,
}

impl Rest {
    /// Whether these edges may be all edges of a polyhedron.
    pub fn is_closed(&self) -> bool {
        self.dead_ends == 0
    }
}

/// One removed set of each class, with the number of sets in the class. They are connected sets with vertex
/// 0 and at most `size` vertices. Then comes one of each of their classes with all neighbours. `watch` gets
/// the number of sets, and returns whether to go on.
pub fn rests(
    size: usize,
    watch: &mut dyn FnMut(usize) -> bool,
) -> BTreeMap<Rest, (Vec<usize>, usize)> {
    let cells = cell600::cells();
    let neighbours = neighbours(&cells);
    let mut found = BTreeMap::new();
    let mut sets = BTreeSet::from([vec![0]]);
    let mut count = 0;
    for _ in 0..size {
        for set in &sets {
            count += 1;
            if !watch(count) {
                return found;
            }
            if let Some(rest) = rest(&cells, set) {
                found.entry(rest).or_insert_with(|| (set.clone(), 0)).1 += 1;
            }
        }
        sets = sets
            .iter()
            .flat_map(|set| grown(set, &neighbours))
            .collect();
    }
    let small: Vec<Vec<usize>> = found.values().map(|(set, _)| set.clone()).collect();
    for set in small {
        let larger = BTreeSet::from([with_neighbours(&set, &neighbours), star(&set, &cells)]);
        for set in larger.into_iter().filter(|larger| larger.len() > set.len()) {
            if let Some(rest) = rest(&cells, &set) {
                found.entry(rest).or_insert_with(|| (set, 0)).1 += 1;
            }
        }
    }
    found
}

/// The vertices of all cells that contain a set.
fn star(set: &[usize], cells: &[[usize; 4]]) -> Vec<usize> {
    let around = cells
        .iter()
        .filter(|cell| set.iter().all(|v| cell.contains(v)));
    let all: BTreeSet<usize> = around.flatten().copied().collect();
    all.into_iter().collect()
}

fn with_neighbours(set: &[usize], neighbours: &[BTreeSet<usize>]) -> Vec<usize> {
    let around = set.iter().flat_map(|v| neighbours[*v].iter().copied());
    let all: BTreeSet<usize> = around.chain(set.iter().copied()).collect();
    all.into_iter().collect()
}

fn neighbours(cells: &[[usize; 4]]) -> Vec<BTreeSet<usize>> {
    let vertices = cells.iter().flatten().max().map_or(0, |last| last + 1);
    let mut neighbours = vec![BTreeSet::new(); vertices];
    for cell in cells {
        for a in cell {
            neighbours[*a].extend(cell.iter().filter(|b| *b != a));
        }
    }
    neighbours
}

/// The connected sets with one more vertex.
fn grown(set: &[usize], neighbours: &[BTreeSet<usize>]) -> Vec<Vec<usize>> {
    let around: BTreeSet<usize> = set
        .iter()
        .flat_map(|v| neighbours[*v].iter().copied())
        .collect();
    let fresh = around.into_iter().filter(|v| !set.contains(v));
    fresh
        .map(|vertex| {
            let mut grown = set.to_vec();
            grown.push(vertex);
            grown.sort_unstable();
            grown
        })
        .collect()
}

/// The numbers of what a set leaves; `None` if its boundary is no sphere.
fn rest(cells: &[[usize; 4]], set: &[usize]) -> Option<Rest> {
    let remains = Remains::of(cells, set)?;
    let ridges: Vec<&Edge> = remains.ridges().collect();
    let of_valence = |n: usize| {
        let is_of = |edge: &&&Edge| remains.valences[**edge] == n;
        ridges.iter().filter(is_of).count()
    };
    let vertices = remains.vertices();
    let degree = |v: &usize| ridges.iter().filter(|(a, b)| a == v || b == v).count();
    let with_degree =
        |is_wanted: fn(usize) -> bool| vertices.iter().filter(|v| is_wanted(degree(v))).count();
    Some(Rest {
        removed: set.len(),
        tetrahedra: remains.cells.len(),
        boundary_triangles: remains.triangles.len(),
        ridges: (of_valence(1), of_valence(2)),
        dead_ends: with_degree(|n| n == 1),
        corners: with_degree(|n| n >= 3),
        faces: number_of(&remains.faces()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without a vertex: 20 of 600 tetrahedra have it, and its link is an icosahedron. Without a tetrahedron: 543,
    /// and twelve edges of valence two form a tetrahedron with subdivided edges. Without the star of a vertex: 470,
    /// with the edges, corners and faces of a dodecahedron.
    #[test]
    fn known_balls() {
        let cells = cell600::cells();
        let left = |set: &[usize]| rest(&cells, set).expect("a sphere");
        let one = left(&[0]);
        assert_eq!((one.tetrahedra, one.boundary_triangles), (580, 20));
        let tetrahedron = left(&cells[0]);
        assert_eq!((tetrahedron.tetrahedra, tetrahedron.ridges), (543, (0, 12)));
        assert_eq!(
            (
                tetrahedron.corners,
                tetrahedron.faces,
                tetrahedron.dead_ends
            ),
            (4, 4, 0)
        );
        let closed = star(&[0], &cells);
        let dodecahedron = left(&closed);
        assert_eq!(
            (dodecahedron.tetrahedra, dodecahedron.ridges),
            (470, (0, 30))
        );
        assert_eq!((dodecahedron.corners, dodecahedron.faces), (20, 12));
        // Without the two cells at a triangle a prism over a triangle remains: 533 cells, 9 edges, 6
        // corners. Without the five cells at an edge a prism over a pentagon remains: 515 cells, 15 edges,
        // 10 corners.
        let [a, b, c, _] = cells[0];
        for (set, tetrahedra, corners, faces) in
            [(vec![a, b, c], 533, 6, 5), (vec![a, b], 515, 10, 7)]
        {
            let prism = left(&star(&set, &cells));
            assert_eq!((prism.tetrahedra, prism.dead_ends), (tetrahedra, 0));
            assert_eq!((prism.corners, prism.faces), (corners, faces));
        }
        // Two vertices whose stars have no common vertex leave a boundary of two spheres.
        let is_far = |v: &usize| {
            !closed.contains(v) && neighbours(&cells)[*v].iter().all(|w| !closed.contains(w))
        };
        let far = (1..120).find(is_far).expect("a vertex");
        assert!(rest(&cells, &[0, far]).is_none());
    }
}
