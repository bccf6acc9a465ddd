//! Balls removed from the 600-cell: which polyhedra the rest might triangulate acutely.
//!
//! K is the set of tetrahedra without a vertex of B. Each of its edges inside has valence 5. Angles at an edge
//! in a flat part of the boundary add up to 180 degrees, so an acute K has at least three there. So every
//! boundary edge of valence 1 or 2 lies in an edge of the polyhedron: these edges form a part of its skeleton,
//! and none of them ends inside a face. The condition is necessary and not sufficient.

use acutile_exact::geometry::cell600;
use std::collections::{BTreeMap, BTreeSet};

/// A class of removed sets that leave the same numbers.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rest {
    /// The number of vertices that were removed.
    pub removed: usize,
    pub tetrahedra: usize,
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
    /// Whether the necessary condition holds.
    pub fn is_possible(&self) -> bool {
        self.dead_ends == 0
    }
}

/// One removed set of each class, with the number of sets in the class: connected sets with vertex 0 and at
/// most `size` vertices, then one of each of their classes with all neighbours.
pub fn rests(size: usize) -> BTreeMap<Rest, (Vec<usize>, usize)> {
    let cells = cell600::cells();
    let neighbours = neighbours(&cells);
    let mut found = BTreeMap::new();
    let mut sets = BTreeSet::from([vec![0]]);
    for _ in 0..size {
        for set in &sets {
            if let Some(rest) = rest(&cells, set) {
                found.entry(rest).or_insert_with(|| (set.clone(), 0)).1 += 1;
            }
        }
        sets = sets
            .iter()
            .flat_map(|set| grown(set, &neighbours))
            .collect();
    }
    found
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

/// What a set leaves; `None` if its boundary is no sphere.
fn rest(cells: &[[usize; 4]], set: &[usize]) -> Option<Rest> {
    let kept: Vec<[usize; 4]> = cells
        .iter()
        .filter(|cell| cell.iter().all(|v| !set.contains(v)))
        .copied()
        .collect();
    let mut uses: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
    let mut valences: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for cell in &kept {
        for k in 0..4 {
            let facet: Vec<usize> = (0..4).filter(|i| *i != k).map(|i| cell[i]).collect();
            *uses.entry(facet).or_default() += 1;
            for l in k + 1..4 {
                *valences.entry((cell[k], cell[l])).or_default() += 1;
            }
        }
    }
    let triangles: Vec<Vec<usize>> = uses
        .into_iter()
        .filter(|(_, n)| *n == 1)
        .map(|(facet, _)| facet)
        .collect();
    let mut at_edge: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for (number, t) in triangles.iter().enumerate() {
        for edge in [(t[0], t[1]), (t[0], t[2]), (t[1], t[2])] {
            at_edge.entry(edge).or_default().push(number);
        }
    }
    let vertices: BTreeSet<usize> = triangles.iter().flatten().copied().collect();
    let euler = vertices.len() + triangles.len() == at_edge.len() + 2;
    let everywhere = |_: &(usize, usize)| true;
    let is_sphere = euler
        && at_edge.values().all(|pair| pair.len() == 2)
        && parts(&at_edge, triangles.len(), everywhere) == 1;
    if !is_sphere {
        return None;
    }
    let is_ridge = |edge: &(usize, usize)| valences.get(edge).is_some_and(|n| *n <= 2);
    let ridges: Vec<&(usize, usize)> = at_edge.keys().filter(|edge| is_ridge(edge)).collect();
    let of_valence = |n: usize| ridges.iter().filter(|edge| valences[**edge] == n).count();
    let degree = |v: &usize| ridges.iter().filter(|(a, b)| a == v || b == v).count();
    let with_degree =
        |is_wanted: fn(usize) -> bool| vertices.iter().filter(|v| is_wanted(degree(v))).count();
    Some(Rest {
        removed: set.len(),
        tetrahedra: kept.len(),
        boundary_triangles: triangles.len(),
        ridges: (of_valence(1), of_valence(2)),
        dead_ends: with_degree(|n| n == 1),
        corners: with_degree(|n| n >= 3),
        faces: parts(&at_edge, triangles.len(), |edge| !is_ridge(edge)),
    })
}

/// The number of parts of the boundary that are connected across the edges that `is_open` allows.
fn parts(
    at_edge: &BTreeMap<(usize, usize), Vec<usize>>,
    triangles: usize,
    is_open: impl Fn(&(usize, usize)) -> bool,
) -> usize {
    let mut part: Vec<usize> = (0..triangles).collect();
    for (_, pair) in at_edge.iter().filter(|(edge, _)| is_open(edge)) {
        if let [a, b] = pair[..] {
            let (from, to) = (part[a], part[b]);
            part.iter_mut()
                .filter(|p| **p == from)
                .for_each(|p| *p = to);
        }
    }
    part.into_iter().collect::<BTreeSet<_>>().len()
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
        let mut star: Vec<usize> = neighbours(&cells)[0].iter().copied().collect();
        star.push(0);
        let dodecahedron = left(&star);
        assert_eq!(
            (dodecahedron.tetrahedra, dodecahedron.ridges),
            (470, (0, 30))
        );
        assert_eq!((dodecahedron.corners, dodecahedron.faces), (20, 12));
        // Two vertices whose stars have no common vertex leave a boundary of two spheres.
        let is_far = |v: &usize| {
            !star.contains(v) && neighbours(&cells)[*v].iter().all(|w| !star.contains(w))
        };
        let far = (1..120).find(is_far).expect("a vertex");
        assert!(rest(&cells, &[0, far]).is_none());
    }
}
