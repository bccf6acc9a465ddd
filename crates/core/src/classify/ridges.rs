//! Ridges: the (D-2)-faces of a tiling up to lattice translation, with the number of simplices around each.
//! They are the edges of a tiling of space, and the vertices of a tiling of the plane.

use crate::tiling::{Corner, Facet, Matching, SimplexId, Tiling, difference};
use malachite::Rational;
use std::collections::BTreeMap;

/// A simplex and the two of its facets between which it fills a wedge.
pub type Wedge = (SimplexId, (usize, usize));

/// An orbit of ridges.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ridge<const D: usize> {
    /// Its D - 1 corners, sorted, the first with shift zero.
    pub corners: Vec<Corner<D>>,
    /// The simplices around it, each with the two of its facets that contain the
    /// ridge. Its length is the valence: lattice translations fix no simplex.
    pub around: Vec<Wedge>,
    /// Whether it lies in a facet without a mate, in the boundary of the domain.
    pub is_boundary: bool,
}

impl<const D: usize> Ridge<D> {
    /// The number of simplices around the ridge.
    pub fn valence(&self) -> usize {
        self.around.len()
    }
}

/// All ridges of a tiling.
#[derive(Clone, Debug)]
pub struct Ridges<const D: usize> {
    /// One for each orbit, sorted by corners.
    pub list: Vec<Ridge<D>>,
    /// For the simplex s and its facets i and j the entry (s (D+1) + i) (D+1) + j:
    /// the index of the ridge in which the facets meet.
    index: Vec<usize>,
}

impl<const D: usize> Ridges<D> {
    /// The ridges of a tiling with this matching of its facets.
    pub fn of(tiling: &Tiling<D>, matching: &Matching<D>) -> Self {
        let mut wedges: Vec<([Corner<D>; 2], Wedge)> =
            Vec::with_capacity(tiling.len() * D * (D + 1) / 2);
        for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
            for (i, j) in pairs(D + 1) {
                wedges.push((normal_form(corners, i, j), (simplex, (i, j))));
            }
        }
        wedges.sort_unstable();
        let mut index = vec![0; tiling.len() * (D + 1) * (D + 1)];
        let mut list = Vec::new();
        for group in wedges.chunk_by(|a, b| a.0 == b.0) {
            let corners = group[0].0[..D - 1].to_vec();
            let around: Vec<Wedge> = group.iter().map(|(_, wedge)| *wedge).collect();
            for &(simplex, (i, j)) in &around {
                index[(simplex.index() * (D + 1) + i) * (D + 1) + j] = list.len();
                index[(simplex.index() * (D + 1) + j) * (D + 1) + i] = list.len();
            }
            let is_boundary = around.iter().any(|&(simplex, (i, j))| {
                [i, j]
                    .iter()
                    .any(|&k| matching.neighbour(Facet::new(simplex, k)).is_none())
            });
            list.push(Ridge {
                corners,
                around,
                is_boundary,
            });
        }
        Ridges { list, index }
    }

    /// The ridge in which two facets of a simplex meet.
    pub fn between(&self, simplex: SimplexId, i: usize, j: usize) -> &Ridge<D> {
        &self.list[self.index[(simplex.index() * (D + 1) + i) * (D + 1) + j]]
    }

    /// The ridges that are not in the boundary.
    pub fn interior(&self) -> impl Iterator<Item = &Ridge<D>> {
        self.list.iter().filter(|ridge| !ridge.is_boundary)
    }

    /// How many interior ridges have each valence.
    pub fn valence_counts(&self) -> BTreeMap<usize, usize> {
        let mut counts = BTreeMap::new();
        for ridge in self.interior() {
            *counts.entry(ridge.valence()).or_insert(0) += 1;
        }
        counts
    }

    /// The mean valence of the interior ridges; `None` if there are none.
    pub fn average_valence(&self) -> Option<Rational> {
        let (sum, count) = self.interior().fold((0u64, 0u64), |(sum, count), ridge| {
            (sum + ridge.valence() as u64, count + 1)
        });
        (count > 0).then(|| Rational::from_unsigneds(sum, count))
    }
}

/// The corners without i and j, sorted, moved so that the first has shift zero: equal
/// for two ridges exactly when they are translates (see `tiling::facets`). The one corner of a ridge in the plane
/// stands twice.
fn normal_form<const D: usize>(simplex: &[Corner<D>], i: usize, j: usize) -> [Corner<D>; 2] {
    let mut rest = (0..=D).filter(|&k| k != i && k != j).map(|k| simplex[k]);
    let first = rest.next().unwrap_or(simplex[0]);
    let mut corners = [first, rest.next().unwrap_or(first)];
    corners.sort_unstable();
    let origin = corners[0].shift;
    corners.map(|corner| Corner {
        shift: difference(corner.shift, origin),
        ..corner
    })
}

/// All i < j < n.
fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j)))
}
