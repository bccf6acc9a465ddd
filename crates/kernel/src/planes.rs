//! Planes that no simplex crosses: each simplex lies in one closed side, of all their translates too.
//!
//! Let c · x = p/q be a plane, and g the greatest common divisor of c · b_1, …, c · b_r. Translates by the lattice are
//! the planes where h(x) = (q c · x - p) / (q g) is an integer. A simplex crosses none of them exactly if its corners
//! have their h between two successive integers. If g is zero there is one plane, where h(x) = q c · x - p is zero.

use crate::claim::{Claim, Plane};
use crate::numbers::Single;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Element, Exact, Ring};
use crate::root::BITS;
use crate::row::Row;
use num_bigint::BigInt;
use num_integer::Integer;
use std::cmp::Ordering::{Greater, Less};

/// Checks the planes of a claim for a row.
pub(crate) fn check_row<const N: usize>(claim: &Claim, numbers: &Single<N>, row: &Row, simplex: u64) -> Checked {
    let (ring, vertices) = (&numbers.large.rules.ring, &numbers.vertices);
    for plane in claim.statements.iter().filter_map(|statement| statement.plane.as_ref()) {
        let step = plane.normal.iter().take(claim.rank()).fold(0, |step: i64, c| step.gcd(c));
        let unit = &plane.denominator * &vertices.denominator * step.max(1);
        // The memory of the numbers below; their products have a price where they are computed.
        ring.work().add(800);
        ring.work().check(Place::Simplex(simplex))?;
        let corners = row.corners.iter().take(claim.dimension + 1);
        let heights = corners.map(|corner| height(plane, ring, &vertices.point(*corner)?, &vertices.denominator));
        let heights = heights.collect::<Checked<Vec<_>>>()?;
        let mut least = heights.first().ok_or(Stop::LARGER)?;
        for height in &heights {
            if ring.compare(height, least)?.decided()? == Less {
                least = height;
            }
        }
        let above = if step == 0 { BigInt::ZERO } else { &unit * (floor(ring, least, &unit)? + 1) };
        let above = ring.long(&above)?;
        let signs = heights.iter().map(|height| ring.compare(height, &above)?.decided());
        let signs = signs.collect::<Checked<Vec<_>>>()?;
        // No corner is above; of a single plane all corners may be.
        let is_uncrossed = !signs.contains(&Greater) || (step == 0 && !signs.contains(&Less));
        ensure!(is_uncrossed, PlaneCrossed, Place::Simplex(simplex));
    }
    Ok(())
}

/// q c · x - p for a point x, times the denominator of its coordinates.
fn height<const N: usize>(
    plane: &Plane,
    ring: &Exact<BigInt, N>,
    point: &[Element<BigInt, N>; 3],
    denominator: &BigInt,
) -> Checked<Element<BigInt, N>> {
    let mut height = ring.element(&[-&plane.offset * denominator])?;
    for (c, x) in plane.normal.iter().zip(point) {
        height = ring.plus(&height, &ring.times(&ring.element(&[&plane.denominator * c])?, x)?)?;
    }
    Ok(height)
}

/// floor(x / unit), by an enclosure of x. That of a rational number has no width.
fn floor<const N: usize>(ring: &Exact<BigInt, N>, x: &Element<BigInt, N>, unit: &BigInt) -> Checked<BigInt> {
    let (low, high) = ring.enclose(x);
    let floor = |end: BigInt| (end >> BITS).div_floor(unit);
    let (low, high) = (floor(low), floor(high));
    if low == high { Ok(low) } else { Err(Stop::LARGER) }
}
