//! `TCP`: every edge is in 5 or 6 tetrahedra, and no triangle has two edges that are in 6.
//!
//! A row says which of its edges have the valence 6; that is checked here. An edge is *open* while
//! an open facet has it. When it is open no more, the tetrahedra so far around it are closed under
//! passing through facets that have it. In a face-to-face tiling of space the tetrahedra around an
//! edge are one cycle, so these are all of them. Their number is the valence, and the edge can be
//! forgotten. That the rows are a tiling is decided at the end, and nothing is proved before.

use crate::front::Step;
use crate::refusal::{Checked, Place};
use crate::row::{Corner, Row};
use crate::table::Table;

/// The ends in sorted order, and the shift from the first to the second: one name for all translates of an edge.
pub(crate) type Edge = ([u32; 2], [i32; 3]);

fn edge(first: Corner, second: Corner) -> Edge {
    ([first.vertex, second.vertex], second.seen_from(first).shift)
}

#[derive(Clone, Copy)]
pub(crate) struct Valence {
    tetrahedra: u64,
    /// The number of open facets that have the edge.
    open: i64,
    is_six: bool,
}

pub(crate) type Edges = Table<Edge, Valence>;

/// The positions of the ends of the edges among the sorted corners. Opposite ones are p and 5 - p.
const ENDS: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

impl Edges {
    /// Counts a tetrahedron at its edges and closes those that are open no more.
    pub(crate) fn step(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked {
        // Two edges of a tetrahedron are in one triangle unless they are opposite. So those of
        // valence 6 are none, one, or two opposite ones.
        let sixes = row.sixes;
        let is_allowed = sixes.count_ones() < 2 || matches!(sixes, 0b100001 | 0b010010 | 0b001100);
        ensure!(is_allowed, TriangleValence, Place::Simplex(simplex));
        let [a, b, c, d] = row.sorted;
        let [p, q, r, s] = steps.map(|step| if matches!(step, Step::Opened) { 1 } else { -1 });
        // The facets that have an edge are those opposite to the other two corners.
        let changes = [r + s, q + s, q + r, p + s, p + r, p + q];
        let names = [edge(a, b), edge(a, c), edge(a, d), edge(b, c), edge(b, d), edge(c, d)];
        let mut closing = [false; 6];
        let items = names.iter().zip(changes).zip(&mut closing).zip(ENDS).enumerate();
        for (bit, (((name, change), is_closing), (i, j))) in items {
            let is_six = sixes >> bit & 1 == 1;
            let agrees = self.with(name.0[0], name, |list, position| {
                let position = position.unwrap_or(list.len());
                if position == list.len() {
                    list.push((*name, Valence { tetrahedra: 0, open: 0, is_six }));
                }
                list.get_mut(position).is_some_and(|(_, valence)| {
                    valence.tetrahedra += 1;
                    valence.open += change;
                    *is_closing = valence.open == 0;
                    valence.is_six == is_six
                })
            })?;
            // All rows say the same about an edge.
            ensure!(agrees, EdgeValence, Place::Edge(simplex, i, j));
        }
        // Only now, for another edge of this tetrahedron may be a translate.
        for ((name, (i, j)), _) in names.into_iter().zip(ENDS).zip(closing).filter(|(_, is_closing)| *is_closing) {
            let closed = self.with(name.0[0], &name, |list, position| {
                let position = position?;
                let is_closed = list.get(position)?.1.open == 0;
                is_closed.then(|| list.swap_remove(position).1)
            })?;
            if let Some(Valence { tetrahedra, is_six, .. }) = closed {
                // The edge has the valence that the rows say.
                let is_right = tetrahedra == if is_six { 6 } else { 5 };
                ensure!(is_right, EdgeValence, Place::Edge(simplex, i, j), tetrahedra);
            }
        }
        Ok(())
    }
}
