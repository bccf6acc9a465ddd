//! `TCP`: the edges of the tiling are counted, without a coordinate.
//!
//! The valence of an edge is the number of tetrahedra around it. Two edges are
//! translates of one another exactly when they have the same [`Edge`], and no
//! translation but 0 takes an edge to itself, so the valence of an edge is the
//! number of pairs (simplex, edge of it) with its `Edge`.

use super::Refusal;
use super::geometry::facet_pairs;
use super::tiling::Tiling;
use crate::certificate::{Place, Statement};
use std::collections::BTreeMap;

/// The normal form of an edge up to lattice translations: its ends sorted by
/// (vertex, shift), v and w, and the shift from the first to the second.
type Edge = (i64, i64, Vec<i64>);

fn edge(x: &Place, y: &Place) -> Edge {
    let (first, second) = match x.0 <= y.0 {
        true => (&x.0, &y.0),
        false => (&y.0, &x.0),
    };
    let shift = first[1..].iter().zip(&second[1..]).map(|(s, t)| t - s);
    (first[0], second[0], shift.collect())
}

fn valences(tiling: &Tiling) -> BTreeMap<Edge, usize> {
    let mut count = BTreeMap::new();
    for corners in tiling.simplices() {
        for (i, j) in facet_pairs(tiling.dimension()) {
            *count.entry(edge(&corners[i], &corners[j])).or_insert(0) += 1;
        }
    }
    count
}

/// Every edge has the valence 5 or 6.
pub(super) fn check_tcp_edges(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::Tcp) {
        return Ok(());
    }
    let valences = valences(tiling).into_iter();
    match valences.into_iter().find(|(_, n)| !matches!(n, 5 | 6)) {
        Some(((v, w, shift), valence)) => Err(Refusal::EdgeValence {
            ends: [&[v, w], shift.as_slice()].concat(),
            valence,
        }),
        None => Ok(()),
    }
}

/// No triangle has two edges of valence 6.
pub(super) fn check_tcp_triangles(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::Tcp) {
        return Ok(());
    }
    let valences = valences(tiling);
    for (simplex, corners) in tiling.simplices().iter().enumerate() {
        for facet in 0..corners.len() {
            let sixes = facet_pairs(tiling.dimension())
                .filter(|&(i, j)| i != facet && j != facet)
                .filter(|&(i, j)| valences.get(&edge(&corners[i], &corners[j])) == Some(&6));
            if sixes.count() > 1 {
                return Err(Refusal::TriangleValence { simplex, facet });
            }
        }
    }
    Ok(())
}
