//! `TCP`: the edges of the tiling are counted, without a coordinate.
//!
//! The valence of an edge is the number of tetrahedra around it. Two edges are
//! translates of one another exactly when they have the same [`Edge`], and no
//! translation but 0 takes an edge to itself, so the valence of an edge is the
//! number of pairs (simplex, edge of it) with its `Edge`.

use super::Refusal;
use super::corners::Corners;
use super::geometry::facet_pairs;
use super::tiling::Tiling;
use crate::certificate::Statement;
use std::collections::HashMap;

/// The normal form of an edge up to lattice translations: its ends sorted by
/// (vertex, shift), v and w, and the shift from the first to the second.
type Edge = (i64, i64, [i64; 3]);

/// In all of three-space, where a place has three shifts.
fn edge(corners: Corners, i: usize, j: usize) -> Edge {
    let (x, y) = (corners.get(i), corners.get(j));
    let (first, second) = if x <= y { (x, y) } else { (y, x) };
    let shift = [1, 2, 3].map(|k| second[k] - first[k]);
    (first[0], second[0], shift)
}

/// How many tetrahedra are around each edge. There are few different shifts, so that
/// an edge is kept with the number of its shift.
#[derive(Default)]
struct Valences {
    shifts: HashMap<[i64; 3], usize>,
    counts: HashMap<(i64, i64, usize), u32>,
}

impl Valences {
    fn new(tiling: &Tiling) -> Result<Valences, Refusal> {
        let mut valences = Valences::default();
        tiling.each_simplex(|_, corners| {
            for (i, j) in facet_pairs(tiling.dimension()) {
                valences.count(edge(corners, i, j));
            }
            Ok(())
        })?;
        Ok(valences)
    }

    fn count(&mut self, (v, w, shift): Edge) {
        let next = self.shifts.len();
        let number = *self.shifts.entry(shift).or_insert(next);
        *self.counts.entry((v, w, number)).or_insert(0) += 1;
    }

    fn of(&self, (v, w, shift): Edge) -> Option<u32> {
        let number = self.shifts.get(&shift)?;
        self.counts.get(&(v, w, *number)).copied()
    }

    fn iter(&self) -> impl Iterator<Item = (Edge, u32)> {
        let mut shifts = vec![[0; 3]; self.shifts.len()];
        for (shift, number) in &self.shifts {
            shifts[*number] = *shift;
        }
        let counts = self.counts.iter();
        counts.map(move |(&(v, w, number), &n)| ((v, w, shifts[number]), n))
    }
}

/// Every edge has the valence 5 or 6.
pub(super) fn check_tcp_edges(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::Tcp) {
        return Ok(());
    }
    let valences = Valences::new(tiling)?;
    let wrong = valences.iter().filter(|(_, n)| !matches!(n, 5 | 6));
    match wrong.min() {
        Some(((v, w, shift), valence)) => Err(Refusal::EdgeValence {
            ends: [&[v, w], &shift[..]].concat(),
            valence: valence as usize,
        }),
        None => Ok(()),
    }
}

/// No triangle has two edges of valence 6.
pub(super) fn check_tcp_triangles(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::Tcp) {
        return Ok(());
    }
    let valences = Valences::new(tiling)?;
    tiling.each_simplex(|simplex, corners| {
        for facet in 0..corners.len() {
            let sixes = facet_pairs(tiling.dimension())
                .filter(|&(i, j)| i != facet && j != facet)
                .filter(|&(i, j)| valences.of(edge(corners, i, j)) == Some(6));
            if sixes.count() > 1 {
                return Err(Refusal::TriangleValence { simplex, facet });
            }
        }
        Ok(())
    })
}
