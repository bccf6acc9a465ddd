//! `TCP`: every edge is in 5 or 6 tetrahedra, and no triangle has two edges that are in 6.
//!
//! A row says which of its edges have the valence 6; that is checked here. An edge is *open* while
//! an open facet has it. When it is open no more, the tetrahedra so far around it are closed under
//! passing through facets that have it. In a face-to-face tiling of space the tetrahedra around an
//! edge are one cycle, so these are all of them. Their number is the valence, and the edge can be
//! forgotten. That the rows are a tiling is decided at the end, and nothing is proved before.

use crate::front::Step;
use crate::limits::Work;
use crate::refusal::{Checked, Place};
use crate::row::{Corner, Row};
use crate::table::{Name, Table};
use std::rc::Rc;

/// The ends in sorted order, and the shift from the first to the second: one name for all
/// translates of an edge.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Edge {
    ends: [u32; 2],
    shift: [i32; 3],
}

impl Name for Edge {
    #[inline(always)]
    fn vertex(&self) -> u32 {
        self.ends[0]
    }
}

struct Valence {
    tetrahedra: u64,
    /// The number of open facets that have the edge.
    open: i64,
    is_six: bool,
}

pub(crate) struct Edges {
    open: Table<Edge, Valence>,
}

/// The positions of the ends of the edges among the sorted corners. Opposite ones are p and 5 - p.
const ENDS: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

impl Edges {
    pub(crate) fn new(work: &Rc<Work>) -> Edges {
        Edges {
            open: Table::new(work),
        }
    }

    pub(crate) fn peak(&self) -> usize {
        self.open.peak()
    }

    /// Counts a tetrahedron at its edges and closes those that are open no more.
    #[inline(always)]
    pub(crate) fn step(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked {
        let sixes = row.sixes;
        // Two edges of a tetrahedron are in one triangle unless they are opposite. So those of
        // valence 6 are none, one, or two opposite ones.
        let is_allowed = sixes.count_ones() < 2 || matches!(sixes, 0b100001 | 0b010010 | 0b001100);
        ensure!(is_allowed, TriangleValence, Place::Simplex(simplex));
        let [a, b, c, d] = row.sorted(3);
        let [p, q, r, s] = steps.map(|step| if matches!(step, Step::Opened) { 1 } else { -1 });
        // The facets that have an edge are those opposite to the other two corners.
        let edges = [
            (edge(a, b), r + s),
            (edge(a, c), q + s),
            (edge(a, d), q + r),
            (edge(b, c), p + s),
            (edge(b, d), p + r),
            (edge(c, d), p + q),
        ];
        for (bit, ((name, change), (i, j))) in edges.into_iter().zip(ENDS).enumerate() {
            let is_six = sixes >> bit & 1 == 1;
            let new = || Valence {
                tetrahedra: 0,
                open: 0,
                is_six,
            };
            let agrees = self.open.update(name, new, |valence| {
                valence.tetrahedra += 1;
                valence.open += change;
                valence.is_six == is_six
            });
            // All rows say the same about an edge.
            let place = Place::Edge(simplex, i, j);
            ensure!(agrees == Some(true), EdgeValence, place);
        }
        // Only now, for another edge of this tetrahedron may be a translate.
        for ((name, _), (i, j)) in edges.into_iter().zip(ENDS) {
            if let Some(closed) = self.open.take_if(&name, |valence| valence.open == 0) {
                // The edge has the valence that the rows say.
                let expected = if closed.is_six { 6 } else { 5 };
                let place = Place::Edge(simplex, i, j);
                let found = closed.tetrahedra;
                ensure!(found == expected, EdgeValence, place, found);
            }
        }
        Ok(())
    }
}

#[inline(always)]
fn edge(first: Corner, second: Corner) -> Edge {
    Edge {
        ends: [first.vertex, second.vertex],
        shift: second.seen_from(first).shift,
    }
}
