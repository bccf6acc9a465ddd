//! The vertex stars of TCP triangulations, found by exhaustion.
//!
//! The link of a vertex is a triangulated sphere. The valence of an edge at the vertex is the valence of a
//! vertex of the link. So TCP asks for links whose valences are 5 and 6, no two 6-valent vertices adjacent.
//!
//! Bound. Let there be m vertices of valence 6. Euler's formula gives Σ (6 - valence)
//! = 12, hence 12 vertices of valence 5, 12 + m in all and 20 + 2m triangles. Every
//! triangle has at most one 6-valent vertex, so 6m <= 20 + 2m and m <= 5. The
//! search below builds all spheres with these valences and m <= 5, triangle after
//! triangle: its list is complete.

use super::sphere::{Code, Triangle, code};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// How many vertices of valence 5, and at most of valence 6, a link has.
const FIVES: usize = 12;
const MOST_SIXES: usize = 5;

/// The codes of all triangulated spheres with valences 5 and 6 in which no two 6-valent
/// vertices are adjacent, sorted by number of vertices.
pub fn links() -> &'static [Code] {
    static LINKS: LazyLock<Vec<Code>> = LazyLock::new(|| {
        let mut found = BTreeSet::new();
        // Either all vertices have valence 5, or the search may begin at one of valence 6.
        Patch::star(5, 0).complete(&mut found);
        Patch::star(6, MOST_SIXES).complete(&mut found);
        let mut links: Vec<Code> = found.into_iter().collect();
        links.sort_by_key(Code::len);
        links
    });
    &LINKS
}

/// A part of a sphere: triangles, and holes that remain to be filled.
#[derive(Clone)]
struct Patch {
    vertices: Vec<Vertex>,
    triangles: Vec<Triangle>,
    /// Boundary cycles, each with its hole on the left.
    holes: Vec<Vec<usize>>,
    most_sixes: usize,
}

#[derive(Clone)]
struct Vertex {
    valence: usize,
    /// Triangles at the vertex that are still missing.
    missing: usize,
    /// Adjacent vertices, as bits.
    adjacent: u32,
}

impl Patch {
    /// One vertex with no triangle yet, and the first edge to a vertex of valence 5,
    /// as a hole on both sides of the edge.
    fn star(valence: usize, most_sixes: usize) -> Patch {
        let vertex = |valence, other: u32| Vertex {
            valence,
            missing: valence,
            adjacent: 1 << other,
        };
        Patch {
            vertices: vec![vertex(valence, 1), vertex(5, 0)],
            triangles: Vec::new(),
            holes: vec![vec![0, 1]],
            most_sixes,
        }
    }

    /// Adds the codes of all spheres that contain this patch.
    fn complete(&self, found: &mut BTreeSet<Code>) {
        let Some(hole) = self.holes.last() else {
            found.extend(code(&self.triangles));
            return;
        };
        let tightest = (0..hole.len()).min_by_key(|&k| self.vertices[hole[k]].missing);
        let mut turned = hole.clone();
        turned.rotate_left(tightest.unwrap_or(0));
        for valence in [5, 6] {
            self.with_new_vertex(&turned, valence, found);
        }
        for k in 2..turned.len() {
            self.with_old_vertex(&turned, k, found);
        }
    }

    /// The triangle on the first edge of the hole has a new vertex.
    fn with_new_vertex(&self, hole: &[usize], valence: usize, found: &mut BTreeSet<Code>) {
        let count = self
            .vertices
            .iter()
            .filter(|v| v.valence == valence)
            .count();
        let limit = if valence == 5 { FIVES } else { self.most_sixes };
        if count == limit {
            return;
        }
        let mut next = self.clone();
        next.holes.pop();
        let apex = next.vertices.len();
        next.vertices.push(Vertex {
            valence,
            missing: valence,
            adjacent: 0,
        });
        let mut rest = vec![hole[0], apex];
        rest.extend(&hole[1..]);
        next.holes.push(rest);
        next.finish([hole[0], hole[1], apex], found);
    }

    /// The triangle on the first edge of the hole has the hole's vertex k. It cuts the
    /// hole into the parts k … 0 and 1 … k, and a part that is an edge is closed.
    fn with_old_vertex(&self, hole: &[usize], k: usize, found: &mut BTreeSet<Code>) {
        let mut next = self.clone();
        next.holes.pop();
        let left: Vec<usize> = hole[k..].iter().chain(&hole[..1]).copied().collect();
        let right = hole[1..=k].to_vec();
        for part in [left, right] {
            match part[..] {
                // An edge of the boundary.
                [_, _] => {}
                _ => {
                    let (first, last) = (part[0], part[part.len() - 1]);
                    if next.vertices[first].adjacent & (1 << last) != 0 {
                        return;
                    }
                    next.holes.push(part);
                }
            }
        }
        next.finish([hole[0], hole[1], hole[k]], found);
    }

    /// Adds the triangle, and goes on if nothing forbids it.
    fn finish(mut self, triangle: Triangle, found: &mut BTreeSet<Code>) {
        for (vertex, other) in [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)] {
            let (vertex, other) = (triangle[vertex], triangle[other]);
            if self.vertices[vertex].valence == 6 && self.vertices[other].valence == 6 {
                return;
            }
            self.vertices[vertex].adjacent |= 1 << other;
        }
        for vertex in triangle {
            if self.vertices[vertex].missing == 0 {
                return;
            }
            self.vertices[vertex].missing -= 1;
        }
        self.triangles.push(triangle);
        if self.can_be_completed() {
            self.complete(found);
        }
    }

    /// Every place of a vertex on a boundary needs a triangle, a vertex in no boundary
    /// is complete.
    fn can_be_completed(&self) -> bool {
        self.vertices.iter().enumerate().all(|(k, vertex)| {
            let places = self.holes.iter().flatten().filter(|&&v| v == k).count();
            match places {
                0 => vertex.missing == 0,
                _ => vertex.missing >= places,
            }
        })
    }
}
