//! The definition of TCP: every edge has valence 5 or 6, and no triangle has two
//! 6-valent edges (Sullivan 1999, section 4.1 of the paper).

use super::ridges::{Ridge, Ridges};
use crate::tiling::{Corner, Tiling};
use std::fmt;

/// The first thing in which a triangulation is not TCP.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotTcp {
    /// It is no tiling by tetrahedra.
    Dimension,
    /// The domain has a boundary, where valences mean nothing.
    Boundary,
    /// An edge, by its corners, whose valence is neither 5 nor 6.
    Edge { corners: String, valence: usize },
    /// A triangle, by its corners, with at least two 6-valent edges.
    Triangle { corners: String },
}

/// Whether a tiling of space is TCP.
pub fn check_tcp<const D: usize>(tiling: &Tiling<D>, ridges: &Ridges<D>) -> Result<(), NotTcp> {
    if D != 3 {
        return Err(NotTcp::Dimension);
    }
    if ridges.list.iter().any(|ridge| ridge.is_boundary) {
        return Err(NotTcp::Boundary);
    }
    if let Some(edge) = ridges
        .list
        .iter()
        .find(|edge| !matches!(edge.valence(), 5 | 6))
    {
        return Err(NotTcp::Edge {
            corners: names(&edge.corners),
            valence: edge.valence(),
        });
    }
    for (simplex, corners) in tiling.simplices().enumerate() {
        for opposite in 0..4 {
            if six_valent_edges(ridges, simplex, opposite) >= 2 {
                let mut facet = corners.to_vec();
                facet.remove(opposite);
                return Err(NotTcp::Triangle {
                    corners: names(&facet),
                });
            }
        }
    }
    Ok(())
}

/// The edges of the facet opposite to a corner lie in the three other facets, too.
fn six_valent_edges<const D: usize>(ridges: &Ridges<D>, simplex: usize, opposite: usize) -> usize {
    (0..4)
        .filter(|&other| other != opposite)
        .map(|other| ridges.between(simplex, opposite, other))
        .filter(|edge: &&Ridge<D>| edge.valence() == 6)
        .count()
}

impl fmt::Display for NotTcp {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotTcp::Dimension => write!(f, "it is not a tiling by tetrahedra"),
            NotTcp::Boundary => write!(f, "it has a boundary"),
            NotTcp::Edge { corners, valence } => {
                write!(f, "the edge {corners} has valence {valence}")
            }
            NotTcp::Triangle { corners } => {
                write!(f, "the triangle {corners} has two 6-valent edges")
            }
        }
    }
}

fn names<const D: usize>(corners: &[Corner<D>]) -> String {
    let names: Vec<String> = corners.iter().map(ToString::to_string).collect();
    names.join(", ")
}
