//! Facet matching: which facet is, up to a lattice vector, which other facet.

use super::buckets::{Buckets, NONE};
use super::dimension::{same, same_value};
use super::facets::{Facet, Mate, Mismatch, origin};
use super::{Corner, FacetId, Tiling, VertexId, difference};
use crate::parallel;
use std::ops::Range;
use std::sync::atomic::AtomicU32;

/// The result of matching.
#[derive(Clone, Debug)]
pub struct Matching<const D: usize> {
    /// For the facet numbered n the number of its mate, or [`NONE`]. The lattice
    /// vector follows from the corners, see [`Matching::mate`].
    mates: Vec<FacetId>,
    /// One entry for each group of facets that does not match.
    pub mismatches: Vec<Mismatch>,
}

/// Not less than any vertex.
const LAST: VertexId = VertexId::new(u32::MAX);

impl<const D: usize> Matching<D> {
    /// The mate of a facet of the tiling that was matched; `None` for a facet
    /// that has no single mate on its other side.
    pub fn mate(&self, tiling: &Tiling<D>, facet: Facet) -> Option<Mate<D>> {
        let other = self.neighbour(facet)?;
        let shift = difference(origin(tiling, facet), origin(tiling, other));
        Some(Mate {
            facet: other,
            shift,
        })
    }

    /// The corner of the mate's simplex opposite to the mate, moved there.
    pub fn apex(&self, tiling: &Tiling<D>, facet: Facet) -> Option<Corner<D>> {
        let mate = self.mate(tiling, facet)?;
        let neighbour = tiling.simplex(mate.facet.simplex);
        Some(neighbour[usize::from(mate.facet.opposite)].moved(mate.shift))
    }

    /// The mate of a facet, up to a lattice vector.
    pub fn neighbour(&self, facet: Facet) -> Option<Facet> {
        match self.mates[facet.id::<D>().index()] {
            NONE => None,
            mate => Some(Facet::numbered::<D>(mate)),
        }
    }
}

/// Matches all facets of `tiling`, each with the only other one that it is a
/// translate of, in time and memory proportional to their number.
///
/// There is one bucket for each vertex. A facet belongs to the bucket of the least vertex among its
/// corners. A bucket is at most as large as the star of its vertex. It is matched as soon as it is
/// full, so few buckets are there at a time if near simplices have near numbers.
///
/// # Panics
/// If there are 2^32 facets or more: 64 GiB of corners.
pub fn match_facets<const D: usize>(tiling: &Tiling<D>) -> Matching<D> {
    match D {
        2 => same_value(match_plane(same(tiling))),
        _ => same_value(match_space(same(tiling))),
    }
}

#[inline(never)]
fn match_plane(tiling: &Tiling<2>) -> Matching<2> {
    matching(tiling)
}

#[inline(never)]
fn match_space(tiling: &Tiling<3>) -> Matching<3> {
    matching(tiling)
}

fn matching<const D: usize>(tiling: &Tiling<D>) -> Matching<D> {
    assert!(tiling.corners.len() < NONE.index(), "too many facets");
    let sizes = bucket_sizes(tiling);
    let mates = vec![NONE.number(); tiling.corners.len()];
    let mates: Vec<AtomicU32> = mates.into_iter().map(AtomicU32::new).collect();
    let part = tiling.corners.len().div_ceil(rayon::current_num_threads());
    let mismatches = parallel::map_slow(&ranges(&sizes, part.max(LEAST_PART)), |vertices| {
        Buckets::new(tiling, &sizes, &mates, vertices.clone()).match_all()
    });
    let mut mismatches = mismatches.concat();
    mismatches.sort_by_key(|mismatch| mismatch.uses[0]);
    Matching {
        mates: mates
            .into_iter()
            .map(|mate| FacetId::new(mate.into_inner()))
            .collect(),
        mismatches,
    }
}

/// The number of facets whose least vertex is v, for each v.
fn bucket_sizes<const D: usize>(tiling: &Tiling<D>) -> Vec<u32> {
    let vertices = tiling.corners.iter().map(|c| c.vertex.index() + 1).max();
    let mut sizes = vec![0; vertices.unwrap_or(0)];
    for corners in tiling.simplices() {
        for vertex in least_vertices(corners) {
            sizes[vertex.index()] += 1;
        }
    }
    sizes
}

/// A core reads all simplices for its part of the buckets. This is the least number of facets that pays.
const LEAST_PART: usize = 1 << 16;

/// All buckets in ranges with about `part` facets each, at least one bucket.
fn ranges(sizes: &[u32], part: usize) -> Vec<Range<usize>> {
    let (mut ranges, mut first, mut facets) = (Vec::new(), 0, 0);
    for (vertex, &size) in sizes.iter().enumerate() {
        facets += size as usize;
        if facets >= part || vertex + 1 == sizes.len() {
            ranges.push(first..vertex + 1);
            (first, facets) = (vertex + 1, 0);
        }
    }
    ranges
}

/// For each corner of a simplex the least vertex of the other corners. It is the least of all, or the
/// second least where the least is left out.
fn least_vertices<const D: usize>(corners: &[Corner<D>]) -> impl Iterator<Item = VertexId> {
    let (mut least, mut second) = ((LAST, 0), LAST);
    for index in 0..=D {
        let corner = &corners[index];
        if corner.vertex < least.0 {
            second = least.0;
            least = (corner.vertex, index);
        } else {
            second = second.min(corner.vertex);
        }
    }
    (0..=D).map(move |index| if index == least.1 { second } else { least.0 })
}
