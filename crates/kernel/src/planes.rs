//! Planes that no simplex crosses: each simplex lies in one closed side, of all their translates too.
//!
//! Let c · x = p/q be a plane, and g the greatest common divisor of c · b_1, …, c · b_r. Translates by
//! the lattice are the planes where h(x) = (q c · x - p) / (q g) is an integer. A simplex crosses none of them
//! exactly if its corners have their h between two successive integers. If g is zero there is one plane,
//! where h(x) = q c · x - p is zero.

use crate::claim::{Claim, Plane};
use crate::refusal::{Checked, Place};
use crate::ring::{Exact, Ring};
use crate::row::Row;
use crate::vertices::Vertices;
use num_bigint::BigInt;
use num_integer::Integer;
use std::cmp::Ordering::{Equal, Less};

type Integers<const N: usize> = Exact<BigInt, N>;

/// Checks the planes of a claim for a row.
pub(crate) fn check_row<const N: usize>(
    claim: &Claim,
    ring: &Integers<N>,
    vertices: &Vertices,
    row: &Row,
    simplex: u64,
) -> Checked {
    for plane in claim.statements.iter().filter_map(|statement| statement.plane.as_ref()) {
        let step = plane.normal.iter().take(claim.rank()).fold(0, |step: i64, c| step.gcd(c));
        let unit = &plane.denominator * &vertices.denominator * step.max(1);
        let mut ends: Option<(BigInt, BigInt)> = None;
        for corner in row.corners.iter().take(claim.dimension + 1) {
            let height = height(plane, ring, &vertices.point(*corner)?, &vertices.denominator)?;
            let (low, high) = between(ring, &height, &unit, step > 0, Place::Simplex(simplex))?;
            ends = Some(match ends {
                Some((least, most)) => (least.min(low), most.max(high)),
                None => (low, high),
            });
        }
        let is_uncrossed = ends.is_some_and(|(least, most)| most - least <= BigInt::from(1));
        ensure!(is_uncrossed, PlaneCrossed, Place::Simplex(simplex));
    }
    Ok(())
}

/// q c · x - p for a point x, times the denominator of its coordinates.
fn height<const N: usize>(
    plane: &Plane,
    ring: &Integers<N>,
    point: &[<Integers<N> as Ring>::Element; 3],
    denominator: &BigInt,
) -> Checked<<Integers<N> as Ring>::Element> {
    let mut height = ring.element(&[-&plane.offset * denominator])?;
    for (c, x) in plane.normal.iter().zip(point) {
        height = ring.plus(&height, &ring.times(&ring.element(&[&plane.denominator * c])?, x)?)?;
    }
    Ok(height)
}

/// The floor and the ceiling of height / unit; for a single plane the one of -1, 0, 1 that is next to
/// zero on the side of the height, and zero.
fn between<const N: usize>(
    ring: &Integers<N>,
    height: &<Integers<N> as Ring>::Element,
    unit: &BigInt,
    is_periodic: bool,
    place: Place,
) -> Checked<(BigInt, BigInt)> {
    let sign = |k: &BigInt| {
        ring.work().add(k.bits());
        ring.work().check(place)?;
        ring.compare(height, &ring.element(&[unit * k])?)?.decided()
    };
    let (mut low, mut high) = (BigInt::from(-1), BigInt::from(1));
    if !is_periodic {
        let zero = BigInt::ZERO;
        return Ok(match sign(&zero)? {
            Less => (low, zero),
            Equal => (zero.clone(), zero),
            _ => (zero, high),
        });
    }
    while sign(&low)? == Less {
        low *= 2;
    }
    while sign(&high)? != Less {
        high *= 2;
    }
    while &high - &low > BigInt::from(1) {
        let middle = (&low + &high).div_floor(&BigInt::from(2));
        if sign(&middle)? == Less {
            high = middle;
        } else {
            low = middle;
        }
    }
    let is_integer = sign(&low)? == Equal;
    Ok((low.clone(), if is_integer { low } else { high }))
}
