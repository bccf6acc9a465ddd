//! One simplex as the witness lists it.
//!
//! The corners are sorted by vertex and then by shift. Only the last two stand in the order that
//! makes the determinant positive. Shifts are relative to the first corner. So a simplex has one
//! row, up to translation, and the sign of the permutation that sorts it is known without
//! coordinates.

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
const MOST_SHIFT: u64 = 1 << 29;

impl Corner {
    #[inline(always)]
    pub fn seen_from(self, base: Corner) -> Corner {
        let ([x, y, z], [a, b, c]) = (self.shift, base.shift);
        Corner {
            vertex: self.vertex,
            shift: [x - a, y - b, z - c],
        }
    }

    #[inline(always)]
    pub fn moved_by(self, base: Corner) -> Corner {
        let ([x, y, z], [a, b, c]) = (self.shift, base.shift);
        Corner {
            vertex: self.vertex,
            shift: [x + a, y + b, z + c],
        }
    }

    #[inline(always)]
    pub(crate) fn is_shifted(&self) -> bool {
        self.shift != [0; 3]
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
    /// The last two corners must be exchanged to sort them.
    pub is_odd: bool,
    /// With `TCP`: bit p says that edge p of the sorted corners has the valence 6.
    pub sixes: u8,
}

impl Shape {
    #[inline(always)]
    pub(crate) fn read_row(&self, cbor: &mut Cbor, simplex: u64) -> Checked<Row> {
        let place = Place::Simplex(simplex);
        let length = if self.dimension == 3 { 4 } else { 3 };
        cbor.array_of(length + u64::from(self.has_sixes))?;
        let a = self.read_corner(cbor, place)?;
        let b = self.read_corner(cbor, place)?;
        let c = self.read_corner(cbor, place)?;
        let mut d = Corner::default();
        if self.dimension == 3 {
            d = self.read_corner(cbor, place)?;
        }
        // The corners are sorted but for the last two, different, and seen from the first one.
        let is_odd = if self.dimension == 3 { c > d } else { b > c };
        let is_sorted = if self.dimension == 3 {
            a < b && b < c && b < d && c != d
        } else {
            a < b && a < c && b != c
        };
        ensure!(is_sorted && !a.is_shifted(), CornerOrder, place);
        let sixes = if self.has_sixes { cbor.small()? } else { 0 };
        let bits = u8::try_from(sixes).ok().filter(|&bits| bits < 64);
        ensure!(bits.is_some(), Sixes, place, sixes);
        Ok(Row {
            corners: [a, b, c, d],
            is_odd,
            sixes: bits.unwrap_or(0),
        })
    }

    /// A facet in the list `boundary`; in the plane the third corner is a default. Its last two
    /// corners stand in the order in which an inner point before them gives a positive
    /// orientation.
    pub(crate) fn read_facet(&self, cbor: &mut Cbor, index: u64) -> Checked<[Corner; 3]> {
        let place = Place::Boundary(index);
        cbor.array_of(if self.dimension == 3 { 3 } else { 2 })?;
        let a = self.read_corner(cbor, place)?;
        let b = self.read_corner(cbor, place)?;
        let mut c = Corner::default();
        if self.dimension == 3 {
            c = self.read_corner(cbor, place)?;
        }
        let is_sorted = if self.dimension == 3 {
            a < b && a < c && b != c
        } else {
            a != b
        };
        ensure!(is_sorted && !a.is_shifted(), CornerOrder, place);
        Ok([a, b, c])
    }

    #[inline(always)]
    fn read_corner(&self, cbor: &mut Cbor, place: Place) -> Checked<Corner> {
        let mut corner = Corner::default();
        let is_array = cbor.is_array()?;
        if is_array {
            cbor.array_of(if self.rank == 3 {
                4
            } else {
                self.rank_length()
            })?;
        }
        let index = cbor.small()?;
        let vertex = u32::try_from(index).ok().filter(|&v| v < self.vertices);
        ensure!(vertex.is_some(), VertexRange, place, index);
        corner.vertex = vertex.unwrap_or(0);
        if is_array {
            for entry in corner.shift.iter_mut().take(self.rank) {
                let value = cbor.small()?;
                let is_small = value.unsigned_abs() < MOST_SHIFT;
                ensure!(is_small, ShiftRange, place, value);
                *entry = i32::try_from(value).unwrap_or(0);
            }
            ensure!(corner.is_shifted(), Canonical, cbor.place());
        }
        Ok(corner)
    }

    fn rank_length(&self) -> u64 {
        u64::try_from(self.rank + 1).unwrap_or(u64::MAX)
    }
}

impl Row {
    /// The corners in sorted order.
    #[inline(always)]
    pub fn sorted(&self, dimension: usize) -> [Corner; 4] {
        let [a, b, c, d] = self.corners;
        match (self.is_odd, dimension) {
            (true, 2) => [a, c, b, d],
            (true, _) => [a, b, d, c],
            (false, _) => [a, b, c, d],
        }
    }
}
