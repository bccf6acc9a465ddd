//! Lemma 1: the 600-cell, and the 601 deductions that make a labelling of its cells consistent.
//!
//! Its vertices and cells are those of [`acutile_exact::geometry::cell600`].
//!
//! Breadth-first search joins the cells by 599 facets. An edge has five facets; when four of them
//! are known, the fifth one follows. The deductions reach all 1,200 facets.

use super::check::{Check, Verdict};
use acutile_exact::geometry::cell600;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// The part of the proof.
pub const PART: &str = "600-cell";

/// A complex of tetrahedra by their sorted vertices.
pub struct Cells {
    /// The number of vertices.
    pub vertices: usize,
    /// The four vertices of each tetrahedron, by their numbers.
    pub cells: Vec<[usize; 4]>,
}

/// The checks of Lemma 1.
pub fn checks(cells: &Cells) -> Vec<Check> {
    let complex = Complex::of(cells);
    let (edges, facets) = (complex.edges.len(), complex.facets.len());
    let counts = [cells.vertices, edges, facets, cells.cells.len()];
    let degrees = complex.degrees();
    let tree = complex.tree();
    let deduced = complex.deductions(&tree);
    let known = tree.len() + deduced.len();
    let check = |id, statement: &str, holds, found| Check {
        part: PART,
        id,
        place: "section 3, Lemma 1",
        statement: statement.to_owned(),
        verdict: Verdict::of(holds),
        found,
    };
    vec![
        check(
            "counts",
            "the 600-cell has 120 vertices, 720 edges, 1,200 triangles and 600 cells",
            counts == [120, 720, 1200, 600],
            format!("counted: {counts:?}"),
        ),
        check(
            "facets",
            "every triangle lies in exactly two cells",
            complex.facets.values().all(|cells| cells.len() == 2),
            format!("{facets} triangles"),
        ),
        check(
            "edges",
            "the cells at every edge form one cycle of length 5",
            degrees == BTreeSet::from([Some(5)]),
            format!("lengths of the cycles: {degrees:?}"),
        ),
        check(
            "tree",
            "599 triangles join all cells",
            tree.len() == 599 && complex.joins_all(&tree),
            format!("a breadth-first tree of {} triangles", tree.len()),
        ),
        check(
            "deductions",
            "each of the other 601 triangles follows from four known ones at an edge",
            deduced.len() == 601 && known == facets,
            format!("{} deductions; {known} triangles are known", deduced.len()),
        ),
    ]
}

impl Cells {
    /// The boundary of the 600-cell.
    pub fn of_600_cell() -> Cells {
        Cells {
            vertices: cell600::vertices().len(),
            cells: cell600::cells(),
        }
    }
}

/// Three vertices, sorted.
type Facet = [usize; 3];

/// The cells at each facet, and the facets at each edge.
struct Complex {
    cells: Vec<[usize; 4]>,
    facets: BTreeMap<Facet, Vec<usize>>,
    edges: BTreeMap<[usize; 2], BTreeSet<Facet>>,
}

impl Complex {
    fn of(cells: &Cells) -> Complex {
        let mut facets: BTreeMap<Facet, Vec<usize>> = BTreeMap::new();
        let mut edges: BTreeMap<[usize; 2], BTreeSet<Facet>> = BTreeMap::new();
        for (number, cell) in cells.cells.iter().enumerate() {
            for facet in facets_of(cell) {
                facets.entry(facet).or_default().push(number);
                let [a, b, c] = facet;
                for edge in [[a, b], [a, c], [b, c]] {
                    edges.entry(edge).or_default().insert(facet);
                }
            }
        }
        Complex {
            cells: cells.cells.clone(),
            facets,
            edges,
        }
    }

    /// For each edge the number of cells around it, if they form one cycle.
    fn degrees(&self) -> BTreeSet<Option<usize>> {
        let edges = self.edges.values();
        edges
            .map(|facets| {
                let cells = facets.iter().map(|facet| self.facets[facet][..].try_into());
                cycle_length(&cells.collect::<Result<Vec<_>, _>>().ok()?)
            })
            .collect()
    }

    /// The facets of a breadth-first tree from the first cell.
    fn tree(&self) -> BTreeSet<Facet> {
        let mut seen = BTreeSet::from([0]);
        let mut waiting = VecDeque::from([0]);
        let mut tree = BTreeSet::new();
        while let Some(cell) = waiting.pop_front() {
            for facet in facets_of(&self.cells[cell]) {
                for &next in &self.facets[&facet] {
                    if seen.insert(next) {
                        tree.insert(facet);
                        waiting.push_back(next);
                    }
                }
            }
        }
        tree
    }

    /// Whether the facets join all cells.
    fn joins_all(&self, tree: &BTreeSet<Facet>) -> bool {
        let mut reached = BTreeSet::from([0]);
        let mut waiting = vec![0];
        while let Some(cell) = waiting.pop() {
            let facets = facets_of(&self.cells[cell]);
            for facet in facets.iter().filter(|facet| tree.contains(*facet)) {
                let next = self.facets[facet].iter();
                waiting.extend(next.filter(|&&next| reached.insert(next)));
            }
        }
        reached.len() == self.cells.len()
    }

    /// Facets that follow one after the other from the known ones: each lies at an edge of which
    /// every other facet is known.
    fn deductions(&self, known: &BTreeSet<Facet>) -> Vec<Facet> {
        let mut known = known.clone();
        let mut deduced = Vec::new();
        loop {
            let before = deduced.len();
            for facets in self.edges.values() {
                let mut unknown = facets.iter().filter(|facet| !known.contains(*facet));
                if let (Some(&facet), None) = (unknown.next(), unknown.next()) {
                    known.insert(facet);
                    deduced.push(facet);
                }
            }
            if deduced.len() == before {
                return deduced;
            }
        }
    }
}

/// The four facets of a cell with sorted vertices.
fn facets_of(&[a, b, c, d]: &[usize; 4]) -> [Facet; 4] {
    [[b, c, d], [a, c, d], [a, b, d], [a, b, c]]
}

/// The length of the cycle that pairs of neighbours form, if they form one.
fn cycle_length(pairs: &[[usize; 2]]) -> Option<usize> {
    let mut rest = pairs.to_vec();
    let [start, mut at] = rest.pop()?;
    while at != start {
        let next = rest.iter().position(|pair| pair.contains(&at))?;
        let [x, y] = rest.swap_remove(next);
        at = if x == at { y } else { x };
    }
    rest.is_empty().then_some(pairs.len())
}
