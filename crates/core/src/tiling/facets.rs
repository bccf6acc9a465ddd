//! A facet of a simplex, and its normal form.
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

use super::{Corner, FacetId, SimplexId, Tiling, difference};

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

/// Facets with the same normal form that are not two with opposite sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The facets and their sides.
    pub uses: Vec<(Facet, bool)>,
}

impl Mismatch {
    /// Of entries with one form, sorted, hence by their numbers.
    pub(super) fn of<const D: usize>(group: &[Entry<D>]) -> Self {
        let usage = |entry: &Entry<D>| (Facet::numbered::<D>(entry.number), entry.side);
        Mismatch {
            uses: group.iter().map(usage).collect(),
        }
    }
}

/// A facet beside its normal form.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Entry<const D: usize> {
    pub(super) form: [Corner<D>; D],
    pub(super) number: FacetId,
    pub(super) side: bool,
}

impl<const D: usize> Entry<D> {
    pub(super) fn new(tiling: &Tiling<D>, number: FacetId) -> Self {
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
pub(super) fn origin<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> [i32; D] {
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
