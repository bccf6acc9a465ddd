//! C14, Z and the slab with the numbers for which the largest dihedral angle is small.
//!
//! The numbers come from `acutile optimize`, rounded to multiples of the stated fractions.
//! Nothing depends on how they were found. The positions are those of the space groups:
//!
//! | structure | group | orbits |
//! |---|---|---|
//! | C14 | P6₃/mmc | 2a (0, 0, 0); 4f (1/3, 2/3, z); 6h (x, 2x, 1/4) |
//! | Z | P6/mmm | 2e (0, 0, z); 2d (1/3, 2/3, 1/2); 3f (1/2, 0, 0) |

use super::CatalogError;
use super::recipe::fraction;
use super::slab::{Layers, of_layers};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{Frame, PointSet, Tiling};
use acutile_exact::number::{Field, Number};

type Built = Result<Tiling<3>, CatalogError>;

/// Coordinates are multiples of 1 over this.
const UNIT: i64 = 10_000_000;

/// C14 with (c/a)² = 2105193/800000: below 74.1478 degrees.
pub fn c14_best() -> Built {
    const Z: i64 = 591_490;
    const X: i64 = 8_311_006;
    let free = |n: i64| fraction(n, UNIT);
    let part = |n: i64, of: i64| fraction(n, of);
    let at_axis = |first: i64, height: Number| [part(first, 3), part(3 - first, 3), height];
    let mut points = vec![
        [part(0, 1), part(0, 1), part(0, 1)],
        [part(0, 1), part(0, 1), part(1, 2)],
        at_axis(1, free(Z)),
        at_axis(2, free(-Z)),
        at_axis(2, &part(1, 2) + &free(Z)),
        at_axis(1, &part(1, 2) - &free(Z)),
    ];
    for (sign, height) in [(1, 1), (-1, 3)] {
        let ring = [[1, 2], [-2, -1], [1, -1]];
        points.extend(ring.map(|[x, y]| [free(sign * x * X), free(sign * y * X), part(height, 4)]));
    }
    hexagonal(points, fraction(2_105_193, 800_000))
}

/// Z with (c/a)² = 2045593/1600000: below 75.69 degrees.
pub fn z_best() -> Built {
    const Z: i64 = 2_482_563;
    let point = |[x, y, z]: [i64; 3]| [x, y, z].map(|n| fraction(n, 6));
    let mut points: Vec<[Number; 3]> = [[2, 4, 3], [4, 2, 3], [3, 0, 0], [0, 3, 0], [3, 3, 0]]
        .map(point)
        .to_vec();
    points.extend([Z, -Z].map(|z| [fraction(0, 1), fraction(0, 1), fraction(z, UNIT)]));
    hexagonal(points, fraction(2_045_593, 1_600_000))
}

/// The slab of height 71/5 over a grid with the squared side 949386/25000: below 77.34 degrees.
pub fn slab_best() -> Tiling<3> {
    of_layers(&Layers {
        square: fraction(949_386, 25_000),
        apex: fraction(3_850_347, 1_000_000),
        bump: fraction(5_353_476, 1_000_000),
        middle: fraction(71, 10),
    })
}

/// The Delaunay triangulation in the lattice with a = b = 1, an angle of 120 degrees, and c² = `square`.
fn hexagonal(points: Vec<[Number; 3]>, square: Number) -> Built {
    let zero = Number::zero;
    let half = fraction(-1, 2);
    let one = fraction(1, 1);
    let gram = [
        [one.clone(), half.clone(), zero()],
        [half, one, zero()],
        [zero(), zero(), square],
    ];
    let frame = Frame::space(Field::rationals(), gram);
    Ok(triangulate(&PointSet { frame, points }, Ties::Refuse)?)
}
