//! The definition of TCP: every edge has valence 5 or 6, and no triangle has two
//! 6-valent edges (Sullivan 1999, section 4.1 of the paper).

use super::ridges::{Ridge, Ridges};
use crate::tiling::{Corner, Matching, Tiling};
use rayon::prelude::*;
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

/// Whether a tiling of space whose hypotheses hold is TCP, without a list of its
/// edges: the tetrahedra around each edge are visited from one to its mate.
pub fn is_tcp<const D: usize>(tiling: &Tiling<D>, matching: &Matching<D>) -> bool {
    D == 3
        && (0..tiling.len())
            .into_par_iter()
            .all(|simplex| is_locally_tcp(tiling, matching, simplex))
}

/// Whether the edges of a tetrahedron have valence 5 or 6 and no facet has two of
/// valence 6. Edges are named by the facets i, j that meet there; the facet opposite
/// to corner i has the edges (i, j) for all j ≠ i.
fn is_locally_tcp<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    simplex: usize,
) -> bool {
    let mut sixes = [0; 4];
    for i in 0..4 {
        for j in i + 1..4 {
            match valence(tiling, matching, simplex, (i, j)) {
                Some(5) => {}
                Some(6) => {
                    sixes[i] += 1;
                    sixes[j] += 1;
                }
                _ => return false,
            }
        }
    }
    sixes.iter().all(|count| *count < 2)
}

/// The number of tetrahedra around the edge in which two facets meet, if it is at
/// most 6: each is left through the facet that contains the edge and was not entered.
fn valence<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    simplex: usize,
    (entered, left): (usize, usize),
) -> Option<usize> {
    let (mut here, mut entry, mut exit) = (simplex, entered, left);
    for count in 1..=6 {
        let mate = matching.mate(tiling, here, exit)?;
        let (old, next) = (tiling.simplex(here), mate.facet.simplex as usize);
        let new = tiling.simplex(next);
        // The corner opposite to the facet of entry is off the edge, but in the facet
        // that is crossed; the next exit is opposite to it.
        let pivot = old[entry];
        let next_exit = new
            .iter()
            .position(|corner| corner.moved(mate.shift) == pivot)?;
        (here, entry, exit) = (next, usize::from(mate.facet.opposite), next_exit);
        if (here, entry, exit) == (simplex, entered, left) {
            return Some(count);
        }
    }
    None
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
