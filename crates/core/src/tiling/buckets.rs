//! The facets with one least vertex, and pairs among them.

use super::facets::{Entry, Facet, Mismatch};
use super::{Corner, FacetId, SimplexId, Tiling};
use std::hint::select_unpredictable;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

/// In the place of a mate: there is none.
pub(super) const NONE: FacetId = FacetId::new(u32::MAX);

/// A facet in its bucket.
#[derive(Clone, Copy)]
struct Use {
    /// The vertices of the normal form without the least one.
    key: u64,
    /// The shifts of the normal form and the side, or [`FAR`].
    form: u32,
    number: FacetId,
}

/// Stands for shifts that are too large for 32 bits.
const FAR: u32 = u32::MAX;

/// Exchanges that sort four numbers.
const NETWORK: [(usize, usize); 5] = [(0, 1), (2, 3), (0, 2), (1, 3), (1, 2)];

/// The facets of a simplex, each with the vertex of its bucket. In the plane the last one is no facet.
#[inline(always)]
fn uses<const D: usize>(corners: &[Corner<D>], simplex: SimplexId) -> [(u32, Use); 4] {
    // A corner is one word: the vertex, the shift in 15 bits, the place in the row.
    let (mut words, mut is_far, mut is_odd) = ([u64::MAX; 4], false, false);
    for place in 0..=D {
        let Corner { vertex, shift } = corners[place];
        let shift = near(shift);
        is_far |= shift.is_none();
        let shift = u64::from(shift.unwrap_or_default());
        words[place] = u64::from(vertex.number()) << 32 | shift << 2 | place as u64;
    }
    for (i, j) in NETWORK {
        let (x, y) = (words[i], words[j]);
        is_odd ^= y < x;
        (words[i], words[j]) = (x.min(y), x.max(y));
    }
    let vertex = |word: u64| word >> 32;
    let shift = |word: u64| word as u32 >> 2;
    let first = Facet::new(simplex, 0).id::<D>().number();
    let without = |left_out: usize| {
        let corner = |k: usize| words[k + usize::from(k >= left_out)];
        let (mut key, mut form) = (0, 0);
        for k in 1..D {
            key = key << 32 | vertex(corner(k));
            // A difference of entries is from -15 to 15.
            form = form << 15 | (shift(corner(k)) + (16 << 10 | 16 << 5 | 16) - shift(corner(0)));
        }
        let side = u32::from(is_odd) ^ (left_out as u32 & 1);
        let opposite = (words[left_out] & 3) as u32;
        let facet = Use {
            key,
            form: if is_far { FAR } else { form << 1 | side },
            number: FacetId::new(first + opposite),
        };
        (vertex(corner(0)) as u32, facet)
    };
    [0, 1, 2, if D == 3 { 3 } else { 0 }].map(without)
}

/// A shift in 15 bits, in the same order, if its entries are small.
fn near<const D: usize>(shift: [i32; D]) -> Option<u32> {
    let (mut word, mut all) = (0, 0);
    for entry in shift {
        let entry = entry.wrapping_add(8) as u32;
        (word, all) = (word << 5 | entry, all | entry);
    }
    (all < 16).then_some(word)
}

/// The buckets of some vertices. A bucket is there from its first facet to its last one.
pub(super) struct Buckets<'t, const D: usize> {
    tiling: &'t Tiling<D>,
    mates: &'t [AtomicU32],
    /// The first of the vertices.
    first: u32,
    /// One for each of the vertices.
    stars: Vec<Star>,
    buckets: Vec<Vec<Use>>,
    /// Numbers of empty buckets.
    free: Vec<u32>,
    mismatches: Vec<Mismatch>,
}

/// What is known of a vertex.
struct Star {
    /// The number of facets in its bucket, in the end.
    size: u32,
    /// The number of its bucket, or [`CLOSED`].
    bucket: u32,
}

/// In the place of a number: the vertex has no bucket now.
const CLOSED: u32 = u32::MAX;

/// The most facets of a bucket that are compared one by one.
const FEW: usize = 128;

impl<'t, const D: usize> Buckets<'t, D> {
    /// The sizes are those of the buckets of all vertices.
    pub(super) fn new(
        tiling: &'t Tiling<D>,
        sizes: &[u32],
        mates: &'t [AtomicU32],
        vertices: Range<usize>,
    ) -> Self {
        let star = |&size: &u32| Star {
            size,
            bucket: CLOSED,
        };
        Buckets {
            tiling,
            mates,
            first: vertices.start as u32,
            stars: sizes[vertices].iter().map(star).collect(),
            buckets: Vec::new(),
            free: Vec::new(),
            mismatches: Vec::new(),
        }
    }

    /// Pairs the facets of all buckets; returns those without a pair.
    pub(super) fn match_all(mut self) -> Vec<Mismatch> {
        for (simplex, corners) in self.tiling.indices().zip(self.tiling.simplices()) {
            let [a, b, c, d] = uses(corners, simplex);
            self.add(a);
            self.add(b);
            self.add(c);
            if D == 3 {
                self.add(d);
            }
        }
        self.mismatches
    }

    #[inline(always)]
    fn add(&mut self, (vertex, facet): (u32, Use)) {
        let Some(star) = self.stars.get_mut(vertex.wrapping_sub(self.first) as usize) else {
            return;
        };
        if star.bucket == CLOSED {
            star.bucket = self.free.pop().unwrap_or_else(|| {
                self.buckets.push(Vec::with_capacity(star.size as usize));
                self.buckets.len() as u32 - 1
            });
        }
        let bucket = &mut self.buckets[star.bucket as usize];
        bucket.push(facet);
        if bucket.len() == star.size as usize {
            let number = std::mem::replace(&mut star.bucket, CLOSED);
            self.close(number);
        }
    }

    #[inline(never)]
    fn close(&mut self, number: u32) {
        let mut bucket = std::mem::take(&mut self.buckets[number as usize]);
        if bucket.len() > FEW || !self.pair_all(&bucket) {
            self.pair_some(&mut bucket);
        }
        bucket.clear();
        self.buckets[number as usize] = bucket;
        self.free.push(number);
    }

    /// Pairs the few facets of a bucket. False if there is one without a single mate, or with a large shift.
    ///
    /// Half of the facets are the first ones with their key. There is no branch for this, which
    /// processors would guess wrong. Such a facet is its own mate until another one comes.
    fn pair_all(&self, bucket: &[Use]) -> bool {
        // For a hash of keys one more than the place of the last facet.
        let mut places = [0u8; 256];
        let (mut pairs, mut is_paired) = (0, true);
        for (k, facet) in bucket.iter().enumerate() {
            let hash = (facet.key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 56) as usize;
            let place = usize::from(places[hash]);
            let mut j = select_unpredictable(place == 0, k, place.wrapping_sub(1));
            places[hash] = k as u8 + 1;
            if bucket[j].key != facet.key {
                let earlier = &bucket[..k];
                j = earlier
                    .iter()
                    .rposition(|other| other.key == facet.key)
                    .unwrap_or(k);
            }
            let (other, is_first) = (&bucket[j], j == k);
            let is_alone =
                self.mates[other.number.index()].load(Ordering::Relaxed) == other.number.number();
            // The last bit is the side.
            let is_mate = (facet.form != FAR) & (facet.form ^ 1 == other.form);
            is_paired &= is_first | is_alone & is_mate;
            pairs += usize::from(!is_first);
            self.pair(facet.number, other.number);
        }
        is_paired && 2 * pairs == bucket.len()
    }

    fn pair(&self, a: FacetId, b: FacetId) {
        self.mates[a.index()].store(b.number(), Ordering::Relaxed);
        self.mates[b.index()].store(a.number(), Ordering::Relaxed);
    }

    /// Pairs what can be paired, by normal forms.
    fn pair_some(&mut self, bucket: &mut [Use]) {
        bucket.sort_unstable_by_key(|facet| (facet.key, facet.number));
        for alike in bucket.chunk_by(|a, b| a.key == b.key) {
            let entries = alike
                .iter()
                .map(|facet| Entry::new(self.tiling, facet.number));
            let mut entries: Vec<Entry<D>> = entries.collect();
            entries.sort_unstable();
            for group in entries.chunk_by(|a, b| a.form == b.form) {
                match group {
                    [a, b] if a.side != b.side => self.pair(a.number, b.number),
                    _ => {
                        for facet in group {
                            self.mates[facet.number.index()]
                                .store(NONE.number(), Ordering::Relaxed);
                        }
                        self.mismatches.push(Mismatch::of(group));
                    }
                }
            }
        }
    }
}
