//! Each facet is paired with one that is the same set and lies on the other side.
//!
//! The mates are hints: that they pair the facets rightly is checked here, by
//! places alone, without a coordinate. The simplices are gone through in order. A facet
//! whose mate is later is kept open until that comes; so what is held is the front
//! between the simplices that have been and those that come.

use super::Refusal;
use super::cbor::Lists;
use super::corners::Corners;
use super::tiling::Tiling;
use std::collections::HashMap;

/// A facet: the number of its simplex, and of the corner opposite to it.
pub(super) type Facet = (usize, usize);

/// The mate in an entry of a row that is not in the boundary, and how it is moved.
fn mate(entry: &[i64]) -> Option<(Facet, &[i64])> {
    match entry {
        [simplex, facet, shift @ ..] => Some(((*simplex as usize, *facet as usize), shift)),
        _ => None,
    }
}

/// The face of the domain in which a facet of the boundary lies.
pub(super) fn face(entry: &[i64]) -> Option<usize> {
    match entry {
        [face] => Some(*face as usize),
        _ => None,
    }
}

/// Whether a facet lies in the boundary.
pub(super) fn is_boundary(entry: &[i64]) -> bool {
    mate(entry).is_none()
}

/// Two facets that are each other's mates. The second one, moved by `shift`, is the first, which
/// is in the same simplex or in an earlier one.
pub(super) struct Pair<'p> {
    pub(super) first: Facet,
    pub(super) second: Facet,
    /// The corners of the two simplices.
    pub(super) corners: (Corners<'p>, Corners<'p>),
    pub(super) shift: &'p [i64],
}

/// The facets whose mates are in simplices that have not come, with the entry of the
/// mate and the corners of the simplex; and those whose mates have another mate.
#[derive(Default)]
struct Front {
    open: HashMap<Facet, Box<[i64]>>,
    unpaired: Vec<Facet>,
}

impl Front {
    fn open(&mut self, facet: Facet, mate: &[i64], corners: Corners) {
        let kept = [mate, corners.entries()].concat();
        self.open.insert(facet, kept.into_boxed_slice());
    }

    /// Takes out a facet, if it is open and has this mate.
    fn close(&mut self, facet: Facet, mate: &[i64]) -> Option<Box<[i64]>> {
        match self.open.get(&facet)?.starts_with(mate) {
            true => self.open.remove(&facet),
            false => None,
        }
    }

    /// Goes over the facets of the next simplex, and calls `visit` for each pair that is
    /// complete: each once, also where both facets are here.
    fn advance(
        &mut self,
        simplex: usize,
        corners: Corners,
        mates: &Lists,
        mut visit: impl FnMut(&Pair),
    ) {
        for (facet, own) in mates.iter().enumerate() {
            let second = (simplex, facet);
            let Some((first, shift)) = mate(own) else {
                continue;
            };
            if first.0 > simplex {
                self.open(second, own, corners);
                continue;
            }
            let expected = entry(second, shift);
            let kept;
            let of_first = if first.0 < simplex {
                kept = self.close(first, &expected);
                kept.as_deref().map(|kept| corners.like(&kept[own.len()..]))
            } else {
                (mates.get(first.1) == expected).then_some(corners)
            };
            match of_first {
                None => self.unpaired.push(second),
                Some(of_first) if first <= second => visit(&Pair {
                    first,
                    second,
                    corners: (of_first, corners),
                    shift: &expected[2..],
                }),
                Some(_) => {}
            }
        }
    }

    /// The first facet whose mate has another mate: here it is the mate of none.
    fn first_unpaired(self) -> Option<Facet> {
        self.unpaired.into_iter().chain(self.open.into_keys()).min()
    }
}

/// The entry of a facet of which `facet`, moved by -`shift`, is the mate.
fn entry((simplex, facet): Facet, shift: &[i64]) -> Vec<i64> {
    let negated = shift.iter().map(|entry| -entry);
    let name = [simplex as i64, facet as i64];
    name.into_iter().chain(negated).collect()
}

/// Calls `judge` for the pairs, and gives the refusal of the pair whose first facet is the first. Without
/// any, gives the first facet whose mate has another mate.
pub(super) fn each_pair(
    tiling: &Tiling,
    mut judge: impl FnMut(&Pair) -> Result<(), Refusal>,
) -> Result<Option<Facet>, Refusal> {
    let mut front = Front::default();
    let mut refused: Option<(Facet, Refusal)> = None;
    tiling.each_row(|simplex, corners, mates| {
        front.advance(simplex, corners, mates, |pair| {
            let is_first = |(first, _): &(Facet, Refusal)| pair.first < *first;
            if refused.as_ref().is_none_or(is_first) {
                let refusal = judge(pair).err();
                refused = refusal
                    .map(|refusal| (pair.first, refusal))
                    .or(refused.take());
            }
        });
        Ok(())
    })?;
    match refused {
        Some((_, refusal)) => Err(refusal),
        None => Ok(front.first_unpaired()),
    }
}

/// mate(s, i) = (t, j, u) implies mate(t, j) = (s, i, -u): the mates are an
/// involution of the facets of all translates but those in the boundary. It has no fixed point, because
/// a facet and its mate lie on different sides.
pub(super) fn check_mates_mutual(tiling: &Tiling) -> Result<(), Refusal> {
    let Some(first @ (simplex, facet)) = each_pair(tiling, |_| Ok(()))? else {
        return Ok(());
    };
    let own = entry_of(tiling, first)?;
    let second = mate(&own).map_or(first, |(second, _)| second);
    Err(Refusal::MateNotMutual {
        simplex,
        facet,
        back: entry_of(tiling, second)?,
    })
}

/// The entry of a facet in the table of mates, for a refusal.
fn entry_of(tiling: &Tiling, (simplex, facet): Facet) -> Result<Vec<i64>, Refusal> {
    let mut found = Vec::new();
    tiling.certificate.witness.mates.each(|s, row| {
        if s == simplex {
            found = row.iter().nth(facet).unwrap_or_default().to_vec();
        }
        Ok(())
    })?;
    Ok(found)
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
///
/// Both conditions are the same seen from either facet of a pair.
pub(super) fn check_mates_meet(tiling: &Tiling) -> Result<(), Refusal> {
    let check = |pair: &Pair| {
        let (simplex, facet) = pair.first;
        let (t, j) = pair.second;
        let mate = || [&[t as i64, j as i64], pair.shift].concat();
        let positions = matching(pair).map_err(|missing| Refusal::MateCorners {
            simplex,
            facet,
            mate: mate(),
            missing,
        })?;
        match (facet + j + inversions(&positions)) % 2 {
            1 => Ok(()),
            _ => Err(Refusal::MateSide {
                simplex,
                facet,
                mate: mate(),
            }),
        }
    };
    each_pair(tiling, check).map(drop)
}

/// π: for each corner of t but the j-th, moved by u, where it stands among the
/// corners of s but the i-th; or the first one that is not among them, or the
/// second of two at the same place.
fn matching(pair: &Pair) -> Result<Vec<usize>, Vec<i64>> {
    let mut positions = Vec::with_capacity(4);
    for place in pair.corners.1.without(pair.second.1) {
        let mut mine = pair.corners.0.without(pair.first.1);
        match mine.position(|own| is_moved(own, place, pair.shift)) {
            Some(position) if !positions.contains(&position) => positions.push(position),
            _ => return Err(place.to_vec()),
        }
    }
    Ok(positions)
}

/// place = other + shift
fn is_moved(place: &[i64], other: &[i64], shift: &[i64]) -> bool {
    let moved = other[1..].iter().zip(shift).map(|(entry, by)| entry + by);
    place[0] == other[0] && place[1..].iter().copied().eq(moved)
}

fn inversions(positions: &[usize]) -> usize {
    let pairs = (0..positions.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    pairs.filter(|&(i, j)| positions[i] > positions[j]).count()
}
