//! The definition of TCP: every edge has valence 5 or 6, and no triangle has two
//! 6-valent edges (Sullivan 1999, section 4.1 of the paper).

use super::ridges::{Ridge, Ridges};
use crate::parallel;
use crate::tiling::{Corner, Facet, Matching, SimplexId, Tiling};
use std::fmt;
use std::sync::atomic::{AtomicU8, Ordering};

/// The first thing in which a triangulation is not TCP.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotTcp {
    /// It is no tiling by tetrahedra.
    Dimension,
    /// The domain has a boundary, where valences mean nothing.
    Boundary,
    /// An edge, by its corners, whose valence is neither 5 nor 6.
    Edge {
        /// The names of its two corners.
        corners: String,
        /// The number of tetrahedra around it.
        valence: usize,
    },
    /// A triangle, by its corners, with at least two 6-valent edges.
    Triangle {
        /// The names of its three corners.
        corners: String,
    },
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
/// TCP. No list of edges is made: a walk around each edge goes from one tetrahedron to its mate.
/// The edges are those between the corners (0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3),
/// the first one in the lowest bit.
pub fn six_valent<const D: usize>(tiling: &Tiling<D>, matching: &Matching<D>) -> Option<Vec<u8>> {
    if D != 3 {
        return None;
    }
    let mut valences: Vec<AtomicU8> = Vec::new();
    valences.resize_with(tiling.len() * AT_EDGES.len(), AtomicU8::default);
    // Chunks, so that the first failure ends most of the work.
    let walks = parallel::by_chunks(tiling.len(), CHUNK, |simplices| {
        let mut simplices = simplices.map(SimplexId::at);
        simplices.all(|simplex| walk_around_edges(tiling, matching, simplex, &valences))
    });
    if walks.contains(&false) {
        return None;
    }
    let simplices = valences.chunks_exact(AT_EDGES.len());
    simplices.map(sixes).collect()
}

/// The number of simplices in the work of one thread at a time.
const CHUNK: usize = 1 << 10;

/// The facets that meet in each edge: those opposite to the other two corners.
const AT_EDGES: [(usize, usize); 6] = [(2, 3), (1, 3), (1, 2), (0, 3), (0, 2), (0, 1)];

/// The edges of valence 6, from the valences of a tetrahedron's edges; `None` if a facet has two
/// of them. The facet opposite to corner i has the edges where it meets the others.
fn sixes(valences: &[AtomicU8]) -> Option<u8> {
    let (mut bits, mut in_facet) = (0, [0; 4]);
    for (edge, (i, j)) in AT_EDGES.into_iter().enumerate() {
        if valences[edge].load(Ordering::Relaxed) == 6 {
            bits |= 1 << edge;
            in_facet[i] += 1;
            in_facet[j] += 1;
        }
    }
    in_facet.iter().all(|count| *count < 2).then_some(bits)
}

/// Notes the valences of those edges whose first tetrahedron this is. False if one of them is
/// neither 5 nor 6.
fn walk_around_edges<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    simplex: SimplexId,
    valences: &[AtomicU8],
) -> bool {
    AT_EDGES.into_iter().all(|facets| {
        let mut places = [0; 6];
        match walk(tiling, matching, simplex, facets, &mut places) {
            Walk::HasEarlier => true,
            Walk::Closed(valence @ 5..) => {
                let places = places[..valence].iter();
                places.for_each(|&place| valences[place].store(valence as u8, Ordering::Relaxed));
                true
            }
            _ => false,
        }
    })
}

/// The end of a walk around an edge.
enum Walk {
    /// All tetrahedra around the edge have been visited, as many as this.
    Closed(usize),
    /// One of the tetrahedra comes before the first one; the walk from there counts.
    HasEarlier,
    /// There is a boundary, or there are more than 6.
    Open,
}

/// Visits the tetrahedra around the edge in which two facets meet: each is left through the facet
/// that contains the edge and was not entered. A place is 6 times a tetrahedron and its edge.
fn walk<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    simplex: SimplexId,
    (entered, left): (usize, usize),
    places: &mut [usize; 6],
) -> Walk {
    let (mut here, mut entry, mut exit) = (simplex, entered, left);
    places[0] = place(here, entry, exit);
    for count in 1..=6 {
        let Some(mate) = matching.mate(tiling, Facet::new(here, exit)) else {
            return Walk::Open;
        };
        let (old, next) = (tiling.simplex(here), mate.facet.simplex);
        let mut new = tiling.simplex(next).iter();
        // The corner opposite to the facet of entry is not on the edge, but in the facet of exit. In the
        // next simplex the facet of exit is opposite to it.
        let pivot = old[entry];
        let Some(next_exit) = new.position(|corner| corner.moved(mate.shift) == pivot) else {
            return Walk::Open;
        };
        (here, entry, exit) = (next, usize::from(mate.facet.opposite), next_exit);
        if (here, entry, exit) == (simplex, entered, left) {
            return Walk::Closed(count);
        }
        let next = place(here, entry, exit);
        if next < places[0] {
            return Walk::HasEarlier;
        }
        if let Some(kept) = places.get_mut(count) {
            *kept = next;
        }
    }
    Walk::Open
}

/// The place of the edge in which two facets of a tetrahedron meet.
fn place(simplex: SimplexId, i: usize, j: usize) -> usize {
    let is_edge = |facets: &(usize, usize)| *facets == (i.min(j), i.max(j));
    let edge = AT_EDGES.iter().position(is_edge);
    simplex.index() * AT_EDGES.len() + edge.expect("two different facets meet in an edge")
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
