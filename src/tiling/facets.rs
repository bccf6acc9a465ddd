//! Facet matching: which facet is, up to a lattice vector, which other facet.
//!
//! Corners are compared by vertex index and shift, never by coordinates, so that
//! no zero test is needed and a vertex may meet translates of itself.
//!
//! Normal form. Sort the D corners of a facet by (vertex, shift) and move the
//! facet so that the first corner's shift is zero. The order survives a common
//! translation (corners with the same vertex keep the order of their shifts, the
//! others are ordered by vertex), so two facets are lattice translates of each
//! other exactly when their normal forms are equal.
//!
//! Side. In a positively oriented simplex with corners c_0 … c_D the facet without
//! c_i, its corners in order, has the sign (-1)^i times the parity of the sort as
//! orientation of its normal form. Two simplices that share the facet lie on
//! opposite sides of it exactly when these signs differ.

use super::{Corner, Tiling, difference};

/// A facet of a tiling: the one opposite to corner `opposite` of `simplex`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Facet {
    /// Index of the simplex.
    pub simplex: u32,
    /// Index of the corner that is not in the facet, 0 to D.
    pub opposite: u8,
}

/// What lies behind a facet: `facet`, moved by the lattice vector `shift`.
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
    /// For simplex s and corner i the entry `s (D + 1) + i`; `None` for a facet
    /// that has no single mate on its other side.
    pub mates: Vec<Option<Mate<D>>>,
    /// One entry for each group of facets that does not match.
    pub mismatches: Vec<Mismatch>,
}

/// Matches all facets of `tiling`, each with the only other one that it is a
/// translate of, in time n log n.
pub fn match_facets<const D: usize>(tiling: &Tiling<D>) -> Matching<D> {
    let mut entries = sorted_entries(tiling);
    let mut matching = Matching {
        mates: vec![None; entries.len()],
        mismatches: Vec::new(),
    };
    for group in entries.chunk_by_mut(|a, b| a.form == b.form) {
        match group {
            [a, b] if a.side != b.side => matching.pair(a, b),
            _ => matching.mismatches.push(Mismatch::of(group)),
        }
    }
    matching.mismatches.sort_by_key(|mismatch| mismatch.uses[0]);
    matching
}

impl<const D: usize> Matching<D> {
    fn pair(&mut self, a: &Entry<D>, b: &Entry<D>) {
        self.mates[a.index::<D>()] = Some(Mate {
            facet: b.facet,
            shift: difference(a.origin, b.origin),
        });
        self.mates[b.index::<D>()] = Some(Mate {
            facet: a.facet,
            shift: difference(b.origin, a.origin),
        });
    }
}

impl Mismatch {
    fn of<const D: usize>(group: &mut [Entry<D>]) -> Self {
        group.sort_unstable_by_key(|entry| entry.facet);
        Mismatch {
            uses: group
                .iter()
                .map(|entry| (entry.facet, entry.side))
                .collect(),
        }
    }
}

/// A facet beside its normal form.
#[derive(Clone, Copy)]
struct Entry<const D: usize> {
    form: [Corner<D>; D],
    origin: [i32; D],
    facet: Facet,
    side: bool,
}

impl<const D: usize> Entry<D> {
    fn new(simplex: &[Corner<D>], facet: Facet) -> Self {
        let opposite = usize::from(facet.opposite);
        let mut form = std::array::from_fn(|k| simplex[k + usize::from(k >= opposite)]);
        let odd = sort_parity(&mut form);
        let origin = form[0].shift;
        for corner in &mut form {
            corner.shift = difference(corner.shift, origin);
        }
        Entry {
            form,
            origin,
            facet,
            side: odd ^ (opposite % 2 == 1),
        }
    }

    fn index<const E: usize>(&self) -> usize {
        self.facet.simplex as usize * (E + 1) + usize::from(self.facet.opposite)
    }
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

/// All facets, those with the same normal form next to each other.
fn sorted_entries<const D: usize>(tiling: &Tiling<D>) -> Vec<Entry<D>> {
    let mut entries: Vec<Entry<D>> = (0u32..)
        .zip(tiling.simplices())
        .flat_map(|(simplex, corners)| {
            (0..=D as u8).map(move |opposite| Entry::new(corners, Facet { simplex, opposite }))
        })
        .collect();
    entries.sort_unstable_by(|a, b| a.form.cmp(&b.form).then(a.facet.cmp(&b.facet)));
    entries
}
