//! The definition of TCP: every edge has valence 5 or 6, and no triangle has two
//! 6-valent edges (Sullivan 1999, section 4.1 of the paper).

use super::ridges::{Ridge, Ridges};
use crate::tiling::{Corner, Tiling};
use std::fmt;

/// The first thing in which a triangulation is not TCP.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotTcp {
    /// The domain has a boundary, where valences mean nothing.
    Boundary,
    /// An edge, by its corners, whose valence is neither 5 nor 6.
    Edge {
        corners: Vec<Corner<3>>,
        valence: usize,
    },
    /// A triangle, by its corners, with at least two 6-valent edges.
    Triangle { corners: [Corner<3>; 3] },
}

/// Whether a tiling of space is TCP.
pub fn check_tcp(tiling: &Tiling<3>, ridges: &Ridges<3>) -> Result<(), NotTcp> {
    if ridges.list.iter().any(|ridge| ridge.is_boundary) {
        return Err(NotTcp::Boundary);
    }
    if let Some(edge) = ridges
        .list
        .iter()
        .find(|edge| !matches!(edge.valence(), 5 | 6))
    {
        return Err(NotTcp::Edge {
            corners: edge.corners.clone(),
            valence: edge.valence(),
        });
    }
    for (simplex, corners) in tiling.simplices().enumerate() {
        for opposite in 0..4 {
            if six_valent_edges(ridges, simplex, opposite) >= 2 {
                let corners = std::array::from_fn(|k| corners[k + usize::from(k >= opposite)]);
                return Err(NotTcp::Triangle { corners });
            }
        }
    }
    Ok(())
}

/// The edges of the facet opposite to a corner lie in the three other facets, too.
fn six_valent_edges(ridges: &Ridges<3>, simplex: usize, opposite: usize) -> usize {
    (0..4)
        .filter(|&other| other != opposite)
        .map(|other| ridges.between(simplex, opposite, other))
        .filter(|edge: &&Ridge<3>| edge.valence() == 6)
        .count()
}

impl fmt::Display for NotTcp {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotTcp::Boundary => write!(f, "it has a boundary"),
            NotTcp::Edge { corners, valence } => {
                write!(f, "the edge {} has valence {valence}", names(corners))
            }
            NotTcp::Triangle { corners } => {
                write!(f, "the triangle {} has two 6-valent edges", names(corners))
            }
        }
    }
}

fn names(corners: &[Corner<3>]) -> String {
    let names: Vec<String> = corners.iter().map(name).collect();
    names.join(", ")
}

/// `3` or `3+(0, 1, -1)`.
fn name(corner: &Corner<3>) -> String {
    match corner.shift {
        [0, 0, 0] => corner.vertex.to_string(),
        [x, y, z] => format!("{}+({x}, {y}, {z})", corner.vertex),
    }
}
