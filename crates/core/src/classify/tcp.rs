//! The definition of TCP: every edge has valence 5 or 6, and no triangle has two
//! 6-valent edges (Sullivan 1999, section 4.1 of the paper).

use super::ridges::{Ridge, Ridges};
use crate::parallel;
use crate::tiling::{Corner, Facet, Matching, SimplexId, Tiling};
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
    for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
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

/// For each tetrahedron the edges of valence 6, if a tiling of space whose hypotheses hold is
/// TCP; without a list of its edges: the tetrahedra around each edge are visited from one to its
/// mate. The edges are those between the corners (0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3),
/// the first one in the lowest bit.
pub fn six_valent<const D: usize>(tiling: &Tiling<D>, matching: &Matching<D>) -> Option<Vec<u8>> {
    if D != 3 {
        return None;
    }
    // Chunks, so that the first failure ends most of the work.
    let chunks = parallel::by_chunks(tiling.len(), CHUNK, |simplices| {
        let simplices = simplices.map(SimplexId::at);
        simplices
            .map(|simplex| sixes_of(tiling, matching, simplex))
            .collect::<Option<Vec<u8>>>()
    });
    Some(chunks.into_iter().collect::<Option<Vec<_>>>()?.concat())
}

/// The number of simplices in the work of one thread at a time.
const CHUNK: usize = 1 << 10;

/// The facets that meet in each edge: those opposite to the other two corners.
const AT_EDGES: [(usize, usize); 6] = [(2, 3), (1, 3), (1, 2), (0, 3), (0, 2), (0, 1)];

/// The edges of valence 6; `None` if one has another valence than 5 and 6, or a facet has two of
/// valence 6. The facet opposite to corner i has the edges where it meets the others.
fn sixes_of<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    simplex: SimplexId,
) -> Option<u8> {
    let (mut bits, mut in_facet) = (0, [0; 4]);
    for (edge, (i, j)) in AT_EDGES.into_iter().enumerate() {
        match valence(tiling, matching, simplex, (i, j)) {
            Some(5) => {}
            Some(6) => {
                bits |= 1 << edge;
                in_facet[i] += 1;
                in_facet[j] += 1;
            }
            _ => return None,
        }
    }
    in_facet.iter().all(|count| *count < 2).then_some(bits)
}

/// The number of tetrahedra around the edge in which two facets meet, if it is at
/// most 6: each is left through the facet that contains the edge and was not entered.
fn valence<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    simplex: SimplexId,
    (entered, left): (usize, usize),
) -> Option<usize> {
    let (mut here, mut entry, mut exit) = (simplex, entered, left);
    for count in 1..=6 {
        let mate = matching.mate(tiling, Facet::new(here, exit))?;
        let (old, next) = (tiling.simplex(here), mate.facet.simplex);
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
fn six_valent_edges<const D: usize>(
    ridges: &Ridges<D>,
    simplex: SimplexId,
    opposite: usize,
) -> usize {
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
