//! Where the vertices of the prisms lie: one row for each orbit of the symmetry.
//!
//! The numbers come from sequential linear programs in doubles that make the largest dihedral angle small,
//! rounded to multiples of 1/[`UNIT`](super::tables::UNIT). Nothing depends on how they were found.

/// An orbit of vertices by one of them, in the mirror plane of a side or near it.
pub struct Orbit {
    /// The ranks of its inner products with the ring and with the two apices.
    pub place: &'static [i8],
    /// Its distance from the axis towards the side, whose own distance is 1.
    pub outward: Outward,
    /// Along the side, in steps from one neighbouring direction to the other.
    pub sideways: i64,
    pub height: i64,
}

/// A distance from the axis towards a side, negative on the other side of the axis.
#[derive(Clone, Copy)]
pub enum Outward {
    /// In units.
    Part(i64),
    /// At the edge opposite to the side.
    Corner,
}
use Outward::{Corner, Part};

const fn orbit(place: &'static [i8], outward: Outward, sideways: i64, height: i64) -> Orbit {
    Orbit {
        place,
        outward,
        sideways,
        height,
    }
}

/// Half the height of the prism over a triangle.
pub const TRIANGLE_HEIGHT: i64 = 88296;

/// Over a triangle: largest angle below 85.07 degrees.
pub const TRIANGLE: &[Orbit] = &[
    orbit(&[2, 3, 3, 3, 2], Corner, 0, 88296),
    orbit(&[3, 2, 2, 3, 1], Part(96000), 0, 88296),
    orbit(&[3, 2, 1, 2, 2], Part(96000), 21231, 0),
    orbit(&[1, 2, 2, 3, 0], Part(-33391), 0, 88296),
    orbit(&[0, 2, 2, 1, 1], Part(-63296), 0, 0),
    orbit(&[2, 1, 0, 2, 0], Part(42656), 16784, 37235),
    orbit(&[2, 0, 0, 1, 0], Part(50451), 0, 21466),
    orbit(&[1, 0, 0, 2, -1], Part(29649), 0, 42762),
    orbit(&[1, 0, -1, 0, 0], Part(35668), 12664, 0),
    orbit(&[0, 0, 0, 2, -2], Part(0), 0, 42457),
    orbit(&[-1, 0, 0, 1, -2], Part(-18266), 0, 34348),
    orbit(&[-2, 0, 0, 0, -1], Part(-29228), 0, 12089),
    orbit(&[0, -1, -2, 0, -2], Part(19482), 5594, 15440),
    orbit(&[0, -2, -2, -1, -1], Part(23894), 0, 0),
    orbit(&[-1, -2, -2, 0, -3], Part(7827), 0, 22546),
    orbit(&[-1, -2, -3, -2, -2], Part(13465), 5542, 0),
    orbit(&[-3, -2, -2, -1, -3], Part(-13037), 0, 13218),
    orbit(&[-2, -3, -3, -2, -3], Part(10042), 0, 6632),
    orbit(&[-3, -3, -3, -2, -4], Part(0), 0, 7547),
    orbit(&[-4, -3, -3, -3, -3], Part(-5625), 0, 0),
];

/// Half the height of the prism over a pentagon.
pub const PENTAGON_HEIGHT: i64 = 117193;

/// Over a pentagon: below 83.11 degrees.
pub const PENTAGON: &[Orbit] = &[
    orbit(&[1, 2, 3, 3, 2, 3, 2], Corner, 0, 117193),
    orbit(&[0, 1, 3, 3, 1, 2, 2], Corner, 0, 0),
    orbit(&[3, 2, 0, 0, 2, 2, 1], Part(96000), 0, 31187),
    orbit(&[2, 2, 2, 2, 2, 3, 1], Part(0), 0, 117193),
    orbit(&[-1, 0, 2, 2, 0, 1, 0], Part(-56173), 0, 28536),
    orbit(&[2, 1, 0, 0, 1, 2, 0], Part(38678), 0, 56456),
    orbit(&[2, 1, -1, -2, 0, 0, 0], Part(50236), 9526, 0),
    orbit(&[1, 0, -2, -2, 0, 0, -1], Part(40061), 0, 19652),
    orbit(&[0, 0, 0, 0, 0, 1, -1], Part(0), 0, 49922),
    orbit(&[-2, -1, 0, 0, -1, 0, -2], Part(-19140), 0, 31555),
    orbit(&[-3, -2, 0, 0, -2, -1, -2], Part(-24662), 0, 11339),
    orbit(&[0, -1, -3, -3, -1, -2, -2], Part(23496), 0, 0),
    orbit(&[-1, -2, -3, -3, -2, -2, -3], Part(13776), 0, 15229),
    orbit(&[-2, -2, -2, -2, -2, -1, -3], Part(0), 0, 22465),
    orbit(&[-4, -3, -2, -2, -3, -3, -3], Part(-8691), 0, 0),
    orbit(&[-3, -3, -3, -3, -3, -3, -4], Part(0), 0, 4498),
];
