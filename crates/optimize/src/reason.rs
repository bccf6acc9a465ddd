//! Edges that prove that no motion makes a tiling acute.
//!
//! The dihedral angles at an inner edge add up to 360 degrees. With four of them or fewer one is at least
//! 90. At an edge in a flat part of the boundary, which stays flat, they add up to 180. So if there are one
//!     or two of them, one is at least 90.

use acutile_core::anatomy::facet_corners;
use acutile_core::classify::{Ridge, Ridges};
use acutile_core::tiling::{Corner, Facet, Matching, Tiling};
use acutile_exact::geometry::linear;
use std::fmt;

/// An edge at which some dihedral angle is at least a right angle, wherever the vertices are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reason {
    /// The ends of the edge.
    pub ends: [Corner<3>; 2],
    /// The number of tetrahedra around it.
    pub valence: usize,
    /// Whether it lies inside a face of the boundary, which is kept.
    pub is_boundary: bool,
}

/// All such edges, in order.
pub fn reasons(tiling: &Tiling<3>, matching: &Matching<3>) -> Vec<Reason> {
    let ridges = Ridges::of(tiling, matching);
    let reason = |ridge: &Ridge<3>| {
        let is_bad = if ridge.is_boundary {
            ridge.valence() <= 2 && is_flat(tiling, matching, ridge)
        } else {
            ridge.valence() <= 4
        };
        is_bad.then(|| Reason {
            ends: [ridge.corners[0], ridge.corners[1]],
            valence: ridge.valence(),
            is_boundary: ridge.is_boundary,
        })
    };
    ridges.list.iter().filter_map(reason).collect()
}

/// Whether the boundary facets at an edge lie in one plane, exactly.
fn is_flat(tiling: &Tiling<3>, matching: &Matching<3>, ridge: &Ridge<3>) -> bool {
    let mut normals = Vec::new();
    for (simplex, (i, j)) in &ridge.around {
        for facet in [*i, *j].map(|k| Facet::new(*simplex, k)) {
            if matching.neighbour(facet).is_none() {
                let points: Vec<_> = facet_corners(tiling, facet)
                    .iter()
                    .map(|c| tiling.position(c))
                    .collect();
                let edge = |k: usize| linear::subtract(&points[k], &points[0]);
                normals.push(linear::cross(&edge(1), &edge(2)));
            }
        }
    }
    match &normals[..] {
        [a, b] => linear::cross(a, b).iter().all(|x| x.is_zero()),
        _ => false,
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [a, b] = &self.ends;
        let valence = self.valence;
        if self.is_boundary {
            write!(
                f,
                "edge {a} to {b} lies in a flat part of the boundary and in {valence} simplices only: \
                 their angles there add up to 180 degrees, so one is at least 90"
            )
        } else {
            write!(
                f,
                "edge {a} to {b} lies in {valence} simplices only: their angles there add up to 360 \
                 degrees, so one is at least 90"
            )
        }
    }
}
