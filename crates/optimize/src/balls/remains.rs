//! The cells of the 600-cell without a vertex of a set, and their boundary.

use std::collections::{BTreeMap, BTreeSet};

/// Two vertices in order.
pub type Edge = (usize, usize);

/// The cells that remain, where their boundary is a sphere.
pub struct Remains {
    pub cells: Vec<[usize; 4]>,
    /// The triangles of the boundary.
    pub triangles: Vec<[usize; 3]>,
    /// The edges of the boundary, each with its two triangles.
    pub edges: BTreeMap<Edge, [usize; 2]>,
    /// The number of cells at each edge.
    pub valences: BTreeMap<Edge, usize>,
}

impl Remains {
    /// The cells that a set leaves; `None` if the boundary is no sphere.
    pub fn of(cells: &[[usize; 4]], set: &[usize]) -> Option<Self> {
        let mut kept = cells.to_vec();
        kept.retain(|cell| cell.iter().all(|v| !set.contains(v)));
        let mut uses: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        let mut valences: BTreeMap<Edge, usize> = BTreeMap::new();
        for &[a, b, c, d] in &kept {
            for facet in [[b, c, d], [a, c, d], [a, b, d], [a, b, c]] {
                *uses.entry(facet).or_default() += 1;
            }
            for edge in [(a, b), (a, c), (a, d), (b, c), (b, d), (c, d)] {
                *valences.entry(edge).or_default() += 1;
            }
        }
        let once = uses.into_iter().filter(|(_, uses)| *uses == 1);
        let triangles: Vec<[usize; 3]> = once.map(|(facet, _)| facet).collect();
        let mut at_edge: BTreeMap<Edge, Vec<usize>> = BTreeMap::new();
        for (number, [a, b, c]) in triangles.iter().enumerate() {
            for edge in [(*a, *b), (*a, *c), (*b, *c)] {
                at_edge.entry(edge).or_default().push(number);
            }
        }
        let pair = |(edge, triangles): (Edge, Vec<usize>)| Some((edge, triangles.try_into().ok()?));
        let edges: Option<BTreeMap<Edge, [usize; 2]>> = at_edge.into_iter().map(pair).collect();
        let remains = Remains {
            cells: kept,
            triangles,
            edges: edges?,
            valences,
        };
        remains.is_sphere().then_some(remains)
    }

    fn is_sphere(&self) -> bool {
        let euler = self.vertices().len() + self.triangles.len() == self.edges.len() + 2;
        euler && number_of(&self.parts(|_| true)) == 1
    }

    /// The vertices of the boundary.
    pub fn vertices(&self) -> BTreeSet<usize> {
        self.triangles.iter().flatten().copied().collect()
    }

    /// Whether a boundary edge lies in an edge of any acute polyhedron: fewer than three acute angles add up to
    /// less than 180 degrees.
    pub fn is_ridge(&self, edge: &Edge) -> bool {
        self.valences.get(edge).is_some_and(|valence| *valence <= 2)
    }

    pub fn ridges(&self) -> impl Iterator<Item = &Edge> {
        self.edges.keys().filter(|edge| self.is_ridge(edge))
    }

    /// For each triangle the face of the boundary that it lies in. Faces end at ridges.
    pub fn faces(&self) -> Vec<usize> {
        self.parts(|edge| !self.is_ridge(edge))
    }

    /// For each triangle its part of the boundary; parts are connected across the edges that `is_open` allows.
    fn parts(&self, is_open: impl Fn(&Edge) -> bool) -> Vec<usize> {
        let mut part: Vec<usize> = (0..self.triangles.len()).collect();
        for (_, [a, b]) in self.edges.iter().filter(|(edge, _)| is_open(edge)) {
            let (from, to) = (part[*a], part[*b]);
            for p in part.iter_mut().filter(|p| **p == from) {
                *p = to;
            }
        }
        part
    }
}

/// The number of different parts.
pub fn number_of(parts: &[usize]) -> usize {
    parts.iter().collect::<BTreeSet<_>>().len()
}
