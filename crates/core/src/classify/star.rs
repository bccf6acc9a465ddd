//! The types of the vertices of a tiling of space by their links.

use super::sphere::Triangle;
use crate::parallel;
use crate::tiling::{Corner, Tiling, difference};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The type of a vertex star.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Star {
    /// One of the stars of TCP triangulations, with this many neighbours: 12, 14, 15 or
    /// 16. (The link is that very sphere, not only one with as many vertices.)
    FrankKasper(usize),
    /// Another star with this many neighbours.
    Other(usize),
    /// A vertex in the boundary of the domain, with this many neighbours.
    Boundary(usize),
}

impl fmt::Display for Star {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Star::FrankKasper(n) => write!(f, "Z{n}"),
            Star::Other(n) => write!(f, "{n} neighbours"),
            Star::Boundary(n) => write!(f, "boundary, {n} neighbours"),
        }
    }
}

/// The star of every vertex.
pub fn stars(tiling: &Tiling<3>) -> Vec<Star> {
    let mut links: Vec<Vec<[Corner<3>; 3]>> = vec![Vec::new(); tiling.vertices.len()];
    for corners in tiling.simplices() {
        for (apex, corner) in corners.iter().enumerate() {
            links[corner.vertex.index()].push(link_triangle(corners, apex));
        }
    }
    parallel::map(links.len(), |vertex| star(&links[vertex]))
}

/// The facet opposite to a corner, moved with that corner to shift zero. Take the corners of the facet in
/// order for odd k, and with two exchanged for even k. Then in a positively oriented tetrahedron the facet
/// has the positive sense, seen from corner k. All that matters is that this sense is the same for all
/// tetrahedra.
fn link_triangle(corners: &[Corner<3>], apex: usize) -> [Corner<3>; 3] {
    let mut triangle = std::array::from_fn(|k| {
        let corner = corners[k + usize::from(k >= apex)];
        Corner {
            vertex: corner.vertex,
            shift: difference(corner.shift, corners[apex].shift),
        }
    });
    if apex % 2 == 1 {
        triangle.swap(1, 2);
    }
    triangle
}

fn star(link: &[[Corner<3>; 3]]) -> Star {
    let mut number = BTreeMap::new();
    for &corner in link.iter().flatten() {
        let fresh = number.len();
        number.entry(corner).or_insert(fresh);
    }
    let triangles: Vec<Triangle> = link
        .iter()
        .map(|triangle| triangle.map(|corner| number[&corner]))
        .collect();
    let neighbours = number.len();
    if !is_closed(&triangles) {
        return Star::Boundary(neighbours);
    }
    if is_frank_kasper(&triangles, neighbours) {
        Star::FrankKasper(neighbours)
    } else {
        Star::Other(neighbours)
    }
}

/// Whether a closed link is a sphere whose vertices have valences 5 and 6, those of valence 6 not adjacent. By the
/// exhaustive search of [`frank_kasper`](super::frank_kasper) there are four of these, with 12, 14, 15 and 16 vertices.
fn is_frank_kasper(triangles: &[Triangle], vertices: usize) -> bool {
    let mut around = vec![Vec::new(); vertices];
    for &[a, b, c] in triangles {
        for (apex, side) in [(a, (b, c)), (b, (c, a)), (c, (a, b))] {
            around[apex].push(side);
        }
    }
    let is_six = |vertex: usize| around[vertex].len() == 6;
    let has_apart_sixes = |[a, b, c]: &Triangle| {
        [(a, b), (b, c), (c, a)]
            .iter()
            .all(|(a, b)| !(is_six(**a) && is_six(**b)))
    };
    // Euler's formula, and one cycle of triangles around each vertex: a sphere if it is connected, as two
    // spheres have twice the Euler characteristic.
    triangles.len() + 4 == 2 * vertices
        && around
            .iter()
            .all(|sides| matches!(sides.len(), 5 | 6) && is_cycle(sides))
        && triangles.iter().all(has_apart_sixes)
}

/// Whether directed edges make one cycle.
fn is_cycle(edges: &[(usize, usize)]) -> bool {
    let Some(&(first, mut last)) = edges.first() else {
        return false;
    };
    let mut length = 1;
    while last != first && length < edges.len() {
        let Some(&(_, next)) = edges.iter().find(|(from, _)| *from == last) else {
            return false;
        };
        (last, length) = (next, length + 1);
    }
    last == first && length == edges.len()
}

/// Whether each edge of a triangle is, in the other direction, one of another triangle.
fn is_closed(triangles: &[Triangle]) -> bool {
    let edges = |&[a, b, c]: &Triangle| [(a, b), (b, c), (c, a)];
    let directed: BTreeSet<(usize, usize)> = triangles.iter().flat_map(edges).collect();
    directed
        .iter()
        .all(|&(from, to)| directed.contains(&(to, from)))
}
