//! One simplex as the witness lists it.
//!
//! The corners are sorted by vertex and then by shift. Only the last two stand in the order that makes the determinant
//! positive. Shifts are relative to the first corner. So a simplex has one row, up to translation, and the sign of the
//! permutation that sorts it is known without coordinates.

use crate::cbor::Cbor;
use crate::refusal::{Checked, Place};

/// A vertex, moved by a lattice vector. The derived order is that of the format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Corner {
    pub vertex: u32,
    /// The entries from the rank of the lattice on are zero.
    pub shift: [i32; 3],
}

/// The bound for the entries of shifts in a certificate. Sums of three fit 32 bits.
pub(crate) const MOST_SHIFT: u64 = 1 << 29;

impl Corner {
    pub fn seen_from(self, base: Corner) -> Corner {
        let ([x, y, z], [a, b, c]) = (self.shift, base.shift);
        Corner { vertex: self.vertex, shift: [x - a, y - b, z - c] }
    }

    pub fn moved_by(self, base: Corner) -> Corner {
        let ([x, y, z], [a, b, c]) = (self.shift, base.shift);
        Corner { vertex: self.vertex, shift: [x + a, y + b, z + c] }
    }
}

/// The numbers that the shape of rows and facets depends on.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    pub dimension: usize,
    /// The rank of the lattice.
    pub rank: usize,
    /// The number of vertices in the witness.
    pub vertices: u32,
    pub has_sixes: bool,
}

/// A simplex. In the plane the fourth corner is a default and without meaning.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// In the order of the witness: positively oriented.
    pub corners: [Corner; 4],
    /// The corners in sorted order; the last two may be exchanged.
    pub sorted: [Corner; 4],
    pub is_odd: bool,
    /// With `TCP`: bit p says that edge p of the sorted corners has the valence 6.
    pub sixes: u8,
}

impl Shape {
    pub(crate) fn read_row(&self, cbor: &mut Cbor, simplex: u64) -> Checked<Row> {
        let place = Place::Simplex(simplex);
        cbor.array_of(self.dimension + 1 + usize::from(self.has_sixes))?;
        let mut corners = [Corner::default(); 4];
        for corner in corners.iter_mut().take(self.dimension + 1) {
            *corner = self.read_corner(cbor, place)?;
        }
        let [a, b, c, d] = corners;
        let is_space = self.dimension == 3;
        // The corners are sorted but for the last two, different, and seen from the first one.
        let is_start = a < b && a.shift == [0; 3];
        let is_sorted = if is_space { b < c && b < d && c != d } else { a < c && b != c };
        ensure!(is_start && is_sorted, CornerOrder, place);
        let is_odd = if is_space { c > d } else { b > c };
        let sorted = match (is_odd, is_space) {
            (false, _) => corners,
            (true, true) => [a, b, d, c],
            (true, false) => [a, c, b, d],
        };
        let sixes = if self.has_sixes { cbor.small()? } else { 0 };
        let sixes = some!(u8::try_from(sixes).ok().filter(|&s| s < 64), Sixes, place, sixes);
        Ok(Row { corners, sorted, is_odd, sixes })
    }

    /// A facet in the list `boundary`; in the plane the third corner is a default. Its last two corners stand in the
    /// order in which an inner point before them gives a positive orientation.
    pub(crate) fn read_facet(&self, cbor: &mut Cbor, index: u64) -> Checked<[Corner; 3]> {
        let place = Place::Boundary(index);
        cbor.array_of(self.dimension)?;
        let mut corners = [Corner::default(); 3];
        for corner in corners.iter_mut().take(self.dimension) {
            *corner = self.read_corner(cbor, place)?;
        }
        let [a, b, c] = corners;
        let is_sorted = if self.dimension == 3 { a < b && a < c && b != c } else { a != b };
        ensure!(is_sorted && a.shift == [0; 3], CornerOrder, place);
        Ok(corners)
    }

    pub(crate) fn read_corner(&self, cbor: &mut Cbor, place: Place) -> Checked<Corner> {
        let is_array = cbor.is_array()?;
        if is_array {
            cbor.array_of(self.rank + 1)?;
        }
        let index = cbor.small()?;
        let is_vertex = |vertex: &u32| *vertex < self.vertices;
        let vertex = u32::try_from(index).ok().filter(is_vertex);
        let vertex = some!(vertex, VertexRange, place, index);
        let mut shift = [0; 3];
        for entry in shift.iter_mut().take(if is_array { self.rank } else { 0 }) {
            let value = cbor.small()?;
            let is_small = |entry: &i32| u64::from(entry.unsigned_abs()) < MOST_SHIFT;
            let small = i32::try_from(value).ok().filter(is_small);
            *entry = some!(small, ShiftRange, place, value);
        }
        ensure!(is_array == (shift != [0; 3]), Canonical, cbor.place());
        Ok(Corner { vertex, shift })
    }
}
