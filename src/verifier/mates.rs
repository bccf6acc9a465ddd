//! Each facet is paired with one that is the same set and lies on the other side.
//!
//! The mates are hints: that they pair the facets rightly is checked here, by
//! places alone, without a coordinate.

use super::Refusal;
use super::tiling::Tiling;
use crate::certificate::{Mate, Place};

/// A mate taken apart: the facet opposite to corner `facet` of `simplex`,
/// moved by `shift`.
pub(super) struct Target<'c> {
    simplex: usize,
    facet: usize,
    pub(super) shift: &'c [i64],
}

impl<'c> Target<'c> {
    /// The corner behind the mate, not yet moved.
    pub(super) fn corner(&self, tiling: &Tiling<'c>) -> &'c Place {
        &tiling.simplices()[self.simplex][self.facet]
    }
}

/// The row of a facet as it stands; [`super::shape`] has checked lengths and ranges.
fn row<'c>(tiling: &Tiling<'c>, simplex: usize, facet: usize) -> &'c [i64] {
    let Mate(entries) = &tiling.certificate.witness.mates[simplex][facet];
    entries
}

/// The mate of a facet that is not in the boundary.
pub(super) fn mate<'c>(tiling: &Tiling<'c>, simplex: usize, facet: usize) -> Option<Target<'c>> {
    match row(tiling, simplex, facet) {
        [simplex, facet, shift @ ..] => Some(Target {
            simplex: *simplex as usize,
            facet: *facet as usize,
            shift,
        }),
        _ => None,
    }
}

/// The face of the domain in which a facet of the boundary lies.
pub(super) fn face(tiling: &Tiling, simplex: usize, facet: usize) -> Option<usize> {
    match row(tiling, simplex, facet) {
        [face] => Some(*face as usize),
        _ => None,
    }
}

/// Calls `check` for each facet that has a mate.
fn each_facet<'c>(
    tiling: &Tiling<'c>,
    check: impl Fn(usize, usize, Target<'c>) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    for simplex in 0..tiling.simplices().len() {
        for facet in 0..=tiling.dimension() {
            if let Some(target) = mate(tiling, simplex, facet) {
                check(simplex, facet, target)?;
            }
        }
    }
    Ok(())
}

/// mate(s, i) = (t, j, u) implies mate(t, j) = (s, i, -u): the mates are an
/// involution of the facets of all translates but those in the boundary. It has no fixed point, because
/// a facet and its mate lie on different sides.
pub(super) fn check_mates_mutual(tiling: &Tiling) -> Result<(), Refusal> {
    each_facet(tiling, |simplex, facet, target| {
        let back = row(tiling, target.simplex, target.facet);
        let negated = target.shift.iter().map(|entry| -entry);
        let expected: Vec<i64> = [simplex as i64, facet as i64]
            .into_iter()
            .chain(negated)
            .collect();
        match back == expected {
            true => Ok(()),
            false => Err(Refusal::MateNotMutual {
                simplex,
                facet,
                back: back.to_vec(),
            }),
        }
    })
}

/// mate(s, i) = (t, j, u) implies that the corners of t but the j-th, moved by u,
/// are the corners of s but the i-th, as sets of places: the two facets are one
/// set of points. And the two simplices lie on different sides of it.
///
/// Let f_1, …, f_D be the corners of s but x_i, in order, and f'_1, …, f'_D
/// those of the moved t but x'_j, with f'_k = f_π(k). Moving x_i to the front
/// takes i transpositions, and det > 0 for s, so (x_i, f_1, …, f_D) has the
/// orientation (-1)^i. Likewise (x'_j, f'_1, …, f'_D) has the orientation
/// (-1)^j, and (x'_j, f_1, …, f_D) has (-1)^j sgn π. The points x_i and x'_j lie
/// on different sides of the plane of f_1, …, f_D exactly when (x_i, f) and
/// (x'_j, f) have different orientations: (-1)^i (-1)^j sgn π = -1.
pub(super) fn check_mates_meet(tiling: &Tiling) -> Result<(), Refusal> {
    each_facet(tiling, |simplex, facet, target| {
        let mate = || row(tiling, simplex, facet).to_vec();
        let positions =
            matching(tiling, simplex, facet, &target).map_err(|missing| Refusal::MateCorners {
                simplex,
                facet,
                mate: mate(),
                missing,
            })?;
        match (facet + target.facet + inversions(&positions)) % 2 {
            1 => Ok(()),
            _ => Err(Refusal::MateSide {
                simplex,
                facet,
                mate: mate(),
            }),
        }
    })
}

/// π: for each corner of t but the j-th, moved by u, where it stands among the
/// corners of s but the i-th; or the first one that is not among them, or the
/// second of two at the same place.
fn matching(
    tiling: &Tiling,
    simplex: usize,
    facet: usize,
    target: &Target,
) -> Result<Vec<usize>, Vec<i64>> {
    let mine = corners_of_facet(tiling, simplex, facet);
    let theirs = corners_of_facet(tiling, target.simplex, target.facet);
    let mut positions = Vec::with_capacity(mine.len());
    for place in theirs {
        let equal = |other: &&Place| is_moved(other, place, target.shift);
        match mine.iter().position(equal) {
            Some(position) if !positions.contains(&position) => positions.push(position),
            _ => return Err(place.0.clone()),
        }
    }
    Ok(positions)
}

pub(super) fn corners_of_facet<'c>(
    tiling: &Tiling<'c>,
    simplex: usize,
    facet: usize,
) -> Vec<&'c Place> {
    let corners = tiling.simplices()[simplex].iter().enumerate();
    corners
        .filter(|(corner, _)| *corner != facet)
        .map(|(_, place)| place)
        .collect()
}

/// place = other + shift
fn is_moved(place: &Place, other: &Place, shift: &[i64]) -> bool {
    let moved = other.0[1..].iter().zip(shift).map(|(entry, by)| entry + by);
    place.0[0] == other.0[0] && place.0[1..].iter().copied().eq(moved)
}

fn inversions(positions: &[usize]) -> usize {
    let pairs = (0..positions.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    pairs.filter(|&(i, j)| positions[i] > positions[j]).count()
}
