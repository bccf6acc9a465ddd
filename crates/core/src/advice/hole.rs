//! Holes: facets without a mate that are connected through their ridges. If one simplex fills a hole, it is
//! found.

use super::place::facet_corners;
use crate::tiling::{Corner, Facet, Tiling, difference};
use acutile_exact::geometry::{Sign, Simplex};
use acutile_exact::number::Number;
use std::collections::{BTreeMap, BTreeSet};

/// Free facets that hang together.
#[derive(Clone, Debug, PartialEq)]
pub struct Hole<const D: usize> {
    /// The facets, in order.
    pub facets: Vec<Facet>,
    /// The corners of the simplex that closes the hole, positively oriented, where one does.
    pub missing: Option<Vec<Corner<D>>>,
}

/// For each free facet its hole.
pub fn holes<const D: usize>(tiling: &Tiling<D>, free: &[Facet]) -> BTreeMap<Facet, Hole<D>> {
    let ridges = Ridges::of(tiling, free);
    let mut holes = BTreeMap::new();
    for &start in free {
        if holes.contains_key(&start) {
            continue;
        }
        let placed = ridges.connected(tiling, start);
        let hole = Hole {
            missing: missing(tiling, &placed),
            facets: placed.keys().copied().collect(),
        };
        holes.extend(placed.keys().map(|facet| (*facet, hole.clone())));
    }
    holes
}

/// The ridges of the free facets up to lattice translations; each use has the facet and the
/// shift of the ridge's first corner.
struct Ridges<const D: usize> {
    uses: BTreeMap<Vec<Corner<D>>, Vec<(Facet, [i32; D])>>,
}

impl<const D: usize> Ridges<D> {
    fn of(tiling: &Tiling<D>, free: &[Facet]) -> Self {
        let mut uses: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for &facet in free {
            for (form, origin) in ridge_forms(&facet_corners(tiling, facet)) {
                uses.entry(form).or_default().push((facet, origin));
            }
        }
        Ridges { uses }
    }

    /// All facets that hang together with `start`, each with the lattice vector that
    /// moves it to where it hangs.
    fn connected(&self, tiling: &Tiling<D>, start: Facet) -> BTreeMap<Facet, [i32; D]> {
        let mut placed = BTreeMap::from([(start, [0; D])]);
        let mut waiting = vec![start];
        while let Some(facet) = waiting.pop() {
            let shift = placed[&facet];
            for (form, origin) in ridge_forms(&facet_corners(tiling, facet)) {
                // A ridge of more than two free facets joins nothing: which belong
                // together is not known.
                let [a, b] = self.uses[&form][..] else {
                    continue;
                };
                let (other, there) = if a.0 == facet { b } else { a };
                if let std::collections::btree_map::Entry::Vacant(entry) = placed.entry(other) {
                    let by = difference(origin, there);
                    entry.insert(std::array::from_fn(|k| shift[k] + by[k]));
                    waiting.push(other);
                }
            }
        }
        placed
    }
}

/// The ridges of a facet in normal form: sorted, the first shift moved to zero; with that shift.
fn ridge_forms<const D: usize>(corners: &[Corner<D>]) -> Vec<(Vec<Corner<D>>, [i32; D])> {
    let mut forms = Vec::with_capacity(D);
    for left_out in 0..corners.len() {
        let mut ridge: Vec<Corner<D>> = corners.to_vec();
        ridge.remove(left_out);
        ridge.sort();
        let origin = ridge.first().map_or([0; D], |corner| corner.shift);
        for corner in &mut ridge {
            corner.shift = difference(corner.shift, origin);
        }
        forms.push((ridge, origin));
    }
    forms
}

/// The simplex with these facets, where they are the D + 1 of one.
fn missing<const D: usize>(
    tiling: &Tiling<D>,
    placed: &BTreeMap<Facet, [i32; D]>,
) -> Option<Vec<Corner<D>>> {
    if placed.len() != D + 1 {
        return None;
    }
    let corners = placed.iter().flat_map(|(facet, shift)| {
        let corners = facet_corners(tiling, *facet).into_iter();
        corners.map(|corner| corner.moved(*shift))
    });
    let distinct: BTreeSet<Corner<D>> = corners.collect();
    let mut simplex: Vec<Corner<D>> = distinct.into_iter().collect();
    if simplex.len() != D + 1 {
        return None;
    }
    let points: Vec<[Number; D]> = simplex.iter().map(|c| tiling.position(c)).collect();
    match Simplex::new(&points).determinant.sign() {
        Sign::Greater => {}
        Sign::Equal => return None,
        Sign::Less => simplex.swap(D - 1, D),
    }
    Some(simplex)
}
