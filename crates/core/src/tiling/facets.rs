//! Facet matching: which facet is, up to a lattice vector, which other facet.
//!
//! Corners are compared by vertex index and shift, never by coordinates. So no zero test is needed, and a
//! vertex may meet translates of itself.
//!
//! Normal form. Sort the D corners of a facet by (vertex, shift) and move the facet so that the first
//! corner's shift is zero. A common translation keeps the order: corners with the same vertex keep the
//! order of their shifts, and the others are ordered by vertex. So two facets are lattice translates of
//! each other exactly if their normal forms are equal.
//!
//! Side. Take the facet without c_i of a positively oriented simplex with corners c_0 … c_D, its corners in
//! order. The orientation of its normal form is (-1)^i times the parity of the sort. Two simplices that
//! share the facet lie on opposite sides of it exactly when these signs differ.

use super::dimension::{same, same_value};
use super::{Corner, FacetId, SimplexId, Tiling, VertexId, difference};
use crate::parallel;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

/// A facet of a tiling: the one opposite to corner `opposite` of `simplex`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Facet {
    /// Index of the simplex.
    pub simplex: SimplexId,
    /// Index of the corner that is not in the facet, 0 to D.
    pub opposite: u8,
}

/// The mate of a facet: `facet`, moved by the lattice vector `shift`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mate<const D: usize> {
    /// The same corners, seen from the other simplex.
    pub facet: Facet,
    /// The lattice vector that moves it onto the first facet.
    pub shift: [i32; D],
}

/// Facets with the same normal form that are not two with opposite sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The facets and their sides.
    pub uses: Vec<(Facet, bool)>,
}

/// The result of matching.
#[derive(Clone, Debug)]
pub struct Matching<const D: usize> {
    /// For the facet numbered n the number of its mate, or [`NONE`]. The lattice
    /// vector follows from the corners, see [`Matching::mate`].
    mates: Vec<FacetId>,
    /// One entry for each group of facets that does not match.
    pub mismatches: Vec<Mismatch>,
}

/// In the place of a mate: there is none.
const NONE: FacetId = FacetId::new(u32::MAX);

/// Not less than any vertex.
const LAST: VertexId = VertexId::new(u32::MAX);

impl Facet {
    /// The facet of a simplex opposite to one of its corners, 0 to D.
    pub fn new(simplex: SimplexId, opposite: usize) -> Self {
        Facet {
            simplex,
            opposite: opposite as u8,
        }
    }

    /// The facet with a number.
    pub fn numbered<const D: usize>(number: FacetId) -> Self {
        let facets = D as u32 + 1;
        Facet {
            simplex: SimplexId::new(number.number() / facets),
            opposite: (number.number() % facets) as u8,
        }
    }

    /// The number of the facet in a tiling of D-space.
    pub fn id<const D: usize>(self) -> FacetId {
        FacetId::new(self.simplex.number() * (D as u32 + 1) + u32::from(self.opposite))
    }
}

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
/// corners, and each bucket is sorted by normal form. A bucket is as large as the star of a vertex.
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
    let buckets = Buckets::of(tiling);
    let unmatched = || AtomicU32::new(NONE.number());
    let mut mates: Vec<AtomicU32> = Vec::new();
    mates.resize_with(tiling.corners.len(), unmatched);
    let mismatches = parallel::map_slow(&buckets.chunks(), |vertices| {
        match_buckets(tiling, &buckets, vertices.clone(), &mates)
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

/// Facets, by number, in the order of their least vertices.
struct Buckets {
    /// Bucket v is the range from `starts[v]` to `starts[v + 1]` of `facets`.
    starts: Vec<u32>,
    facets: Vec<FacetId>,
}

/// The size of a piece of work, in facets.
const CHUNK: usize = 1 << 16;

impl Buckets {
    /// Counting sort. Each of a few parts holds the buckets of a range of vertices
    /// and is filled by one reader of all corners, in order.
    fn of<const D: usize>(tiling: &Tiling<D>) -> Self {
        let vertices = tiling.corners.iter().map(|c| c.vertex.index() + 1).max();
        let mut starts = vec![0u32; vertices.unwrap_or(0) + 1];
        for corners in tiling.simplices() {
            for vertex in least_vertices(corners) {
                starts[vertex.index() + 1] += 1;
            }
        }
        for vertex in 1..starts.len() {
            starts[vertex] += starts[vertex - 1];
        }
        let mut buckets = Buckets {
            facets: vec![FacetId::new(0); tiling.corners.len()],
            starts,
        };
        buckets.fill(tiling);
        buckets
    }

    fn fill<const D: usize>(&mut self, tiling: &Tiling<D>) {
        let size = self
            .facets
            .len()
            .div_ceil(rayon::current_num_threads())
            .max(CHUNK);
        let mut rest = &mut self.facets[..];
        let mut parts = Vec::new();
        for range in ranges(&self.starts, size) {
            let length = self.starts[range.end] - self.starts[range.start];
            let (part, tail) = rest.split_at_mut(length as usize);
            parts.push((range, part));
            rest = tail;
        }
        let starts = &self.starts;
        parts.into_par_iter().for_each(|(vertices, part)| {
            let first = starts[vertices.start];
            let mut next: Vec<u32> = starts[vertices.clone()].iter().map(|s| s - first).collect();
            for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
                for (opposite, vertex) in least_vertices(corners).enumerate() {
                    if vertices.contains(&vertex.index()) {
                        let place = &mut next[vertex.index() - vertices.start];
                        part[*place as usize] = Facet::new(simplex, opposite).id::<D>();
                        *place += 1;
                    }
                }
            }
        });
    }

    fn bucket(&self, vertex: usize) -> &[FacetId] {
        &self.facets[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    fn chunks(&self) -> Vec<Range<usize>> {
        ranges(&self.starts, CHUNK)
    }
}

/// All vertices in ranges with about `size` facets each, at least one vertex.
fn ranges(starts: &[u32], size: usize) -> Vec<Range<usize>> {
    let (mut ranges, mut first) = (Vec::new(), 0);
    for end in 1..starts.len() {
        if (starts[end] - starts[first]) as usize >= size || end + 1 == starts.len() {
            ranges.push(first..end);
            first = end;
        }
    }
    ranges
}

/// For each corner of a simplex the least vertex of the other corners. It is the least of all, or the
/// second least where the least is left out.
fn least_vertices<const D: usize>(corners: &[Corner<D>]) -> impl Iterator<Item = VertexId> {
    let (mut least, mut second) = ((LAST, 0), LAST);
    for (index, corner) in corners.iter().enumerate() {
        if corner.vertex < least.0 {
            second = least.0;
            least = (corner.vertex, index);
        } else {
            second = second.min(corner.vertex);
        }
    }
    (0..=D).map(move |index| if index == least.1 { second } else { least.0 })
}

/// Pairs the facets in the buckets of some vertices; returns those without a pair.
///
/// A bucket is sorted by the next two vertices, in one machine word. Normal forms are made and compared
/// only if these are equal, as they are for mates.
fn match_buckets<const D: usize>(
    tiling: &Tiling<D>,
    buckets: &Buckets,
    vertices: Range<usize>,
    mates: &[AtomicU32],
) -> Vec<Mismatch> {
    let mut mismatches = Vec::new();
    let mut keys: Vec<(u64, FacetId)> = Vec::new();
    let pair = |a: &Entry<D>, b: &Entry<D>| {
        mates[a.number.index()].store(b.number.number(), Ordering::Relaxed);
        mates[b.number.index()].store(a.number.number(), Ordering::Relaxed);
    };
    for vertex in vertices {
        let bucket = buckets.bucket(vertex).iter();
        keys.clear();
        keys.extend(bucket.map(|&n| (next_vertices(tiling, n), n)));
        keys.sort_unstable();
        for alike in keys.chunk_by(|a, b| a.0 == b.0) {
            let entry = |&(_, number): &(u64, FacetId)| Entry::new(tiling, number);
            if let [a, b] = alike
                && let [a, b] = [entry(a), entry(b)]
                && a.is_mate(&b)
            {
                pair(&a, &b);
                continue;
            }
            let mut entries: Vec<Entry<D>> = alike.iter().map(entry).collect();
            entries.sort_unstable();
            for group in entries.chunk_by(|a, b| a.form == b.form) {
                match group {
                    [a, b] if a.is_mate(b) => pair(a, b),
                    _ => mismatches.push(Mismatch::of(group)),
                }
            }
        }
    }
    mismatches
}

/// The second and the third least vertex of a facet in one word, without a branch. It is the
/// same for facets that are translates of each other.
fn next_vertices<const D: usize>(tiling: &Tiling<D>, number: FacetId) -> u64 {
    let Facet { simplex, opposite } = Facet::numbered::<D>(number);
    let mut least = [LAST; 3];
    for (index, corner) in tiling.simplex(simplex).iter().enumerate() {
        let is_opposite = index == usize::from(opposite);
        let mut vertex = if is_opposite { LAST } else { corner.vertex };
        for place in &mut least {
            (*place, vertex) = ((*place).min(vertex), (*place).max(vertex));
        }
    }
    u64::from(least[1].number()) << 32 | u64::from(least[2].number())
}

impl Mismatch {
    /// Of entries with one form, sorted, hence by their numbers.
    fn of<const D: usize>(group: &[Entry<D>]) -> Self {
        let usage = |entry: &Entry<D>| (Facet::numbered::<D>(entry.number), entry.side);
        Mismatch {
            uses: group.iter().map(usage).collect(),
        }
    }
}

/// A facet beside its normal form.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Entry<const D: usize> {
    form: [Corner<D>; D],
    number: FacetId,
    side: bool,
}

impl<const D: usize> Entry<D> {
    /// Whether the other facet is a translate of this one, seen from the other side.
    fn is_mate(&self, other: &Self) -> bool {
        self.form == other.form && self.side != other.side
    }

    fn new(tiling: &Tiling<D>, number: FacetId) -> Self {
        let facet = Facet::numbered::<D>(number);
        let mut form = corners_of(tiling, facet);
        let odd = sort_parity(&mut form);
        let origin = form[0].shift;
        for corner in &mut form {
            corner.shift = difference(corner.shift, origin);
        }
        Entry {
            form,
            number,
            side: odd ^ (facet.opposite % 2 == 1),
        }
    }
}

fn corners_of<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> [Corner<D>; D] {
    let corners = tiling.simplex(facet.simplex);
    let opposite = usize::from(facet.opposite);
    std::array::from_fn(|k| corners[k + usize::from(k >= opposite)])
}

/// The shift of the first corner of a facet in the order of its normal form.
fn origin<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> [i32; D] {
    let corners = corners_of(tiling, facet);
    let mut first = corners[0];
    for corner in &corners[1..] {
        // Vertices are different where it pays to be fast.
        let is_less = if corner.vertex == first.vertex {
            corner.shift < first.shift
        } else {
            corner.vertex < first.vertex
        };
        first = if is_less { *corner } else { first };
    }
    first.shift
}

/// Insertion sort of a few corners; whether the permutation was odd.
fn sort_parity<const D: usize>(corners: &mut [Corner<D>; D]) -> bool {
    let mut odd = false;
    for end in 1..D {
        let mut k = end;
        while k > 0 && corners[k] < corners[k - 1] {
            corners.swap(k, k - 1);
            odd = !odd;
            k -= 1;
        }
    }
    odd
}
