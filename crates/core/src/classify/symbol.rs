//! Delaney-Dress symbols: isomorphism of periodic triangulations, decided.
//!
//! A *chamber* of a triangulation is a flag: a vertex, an edge, … and a simplex, each in
//! the next; here a simplex with an order of its corners, the k-face being spanned by the
//! first k + 1. For each k = 0 … D every chamber C has exactly one other chamber s_k(C) that
//! differs in the k-face only. For k < D it exchanges the corners k and k + 1; s_D goes through
//! the facet without the last corner. A triangulation of a simply connected space is
//! determined up to isomorphism by the chambers modulo any group of automorphisms, with the
//! maps s_k and the orders of the products s_j s_k (Dress, Presentations of discrete groups,
//! acting on simply connected manifolds, Adv. Math. 63, 1987; for algorithms Delgado-Friedrichs,
//! Data structures and algorithms for tilings I, Theoret. Comput. Sci. 303, 2003). In a
//! triangulation all orders but the one of s_(D-1) s_D are fixed; that one is the valence
//! of the ridge that the first D - 1 corners span.
//!
//! The *minimal* symbol is the quotient by all automorphisms, orientation reversing ones
//! included. It does not know the lattice that the triangulation was given with, so that two
//! triangulations are isomorphic exactly when their minimal symbols are. It is the image
//! under the coarsest partition of the chambers that separates different labels and that
//! all s_k respect, found by refining the partition by labels: a chamber's new colour is
//! its old one with those of its images. Colours are numbered by rank, and so depend on
//! the set of colours only; in the end each chamber of the quotient has a colour of its own,
//! and the numbering by colour is canonical: isomorphic means equal.

use super::ridges::Ridges;
use crate::tiling::{Domain, Facet, Matching, SimplexId, Tiling};
use acutile_exact::number::Number;
use std::collections::BTreeSet;

/// A minimal symbol, chambers numbered canonically.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol<L, const D: usize> {
    /// What is told of each chamber.
    pub labels: Vec<L>,
    /// The images s_0(C) … s_D(C) of each chamber; D + 1 of them.
    pub images: Vec<Vec<u32>>,
}

impl<L, const D: usize> Symbol<L, D> {
    /// The number of chambers up to automorphism.
    pub fn len(&self) -> usize {
        self.labels.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.labels.is_empty()
    }
}

/// The minimal symbol with the valences as labels: equal exactly for isomorphic tilings.
/// `None` for a domain with boundary.
pub fn combinatorial_symbol<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    ridges: &Ridges<D>,
) -> Option<Symbol<usize, D>> {
    symbol(tiling, matching, |simplex, order| {
        ridges.between(simplex, order[D - 1], order[D]).valence()
    })
}

/// The minimal symbol with valences, and with squared edge lengths in units of the shortest
/// edge, as labels: equal exactly for similar tilings. `edges` gives the squared edges 01, 02,
/// …, 12, … of each simplex.
pub fn metric_symbol<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    ridges: &Ridges<D>,
    edges: impl Fn(SimplexId) -> Vec<Number>,
) -> Option<Symbol<(usize, Vec<Number>), D>> {
    let edges: Vec<Vec<Number>> = tiling.indices().map(edges).collect();
    let shortest = edges.iter().flatten().min()?.inverse()?;
    symbol(tiling, matching, |simplex, order| {
        let lengths = (0..=D)
            .flat_map(|i| (i + 1..=D).map(move |j| (order[i], order[j])))
            .map(|(i, j)| &edges[simplex.index()][edge_index::<D>(i.min(j), i.max(j))] * &shortest)
            .collect();
        let valence = ridges.between(simplex, order[D - 1], order[D]).valence();
        (valence, lengths)
    })
}

/// The place of the edge ij, i < j, in the list 01, 02, …, 0D, 12, …
pub(super) fn edge_index<const D: usize>(i: usize, j: usize) -> usize {
    i * (2 * D + 1 - i) / 2 + (j - i - 1)
}

fn symbol<L: Ord + Clone, const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    label: impl Fn(SimplexId, &[usize]) -> L,
) -> Option<Symbol<L, D>> {
    if tiling.frame.domain != Domain::Space || !matching.mismatches.is_empty() {
        return None;
    }
    let orders = orders::<D>();
    let labels: Vec<L> = tiling
        .indices()
        .flat_map(|simplex| orders.iter().map(move |order| (simplex, order)))
        .map(|(simplex, order)| label(simplex, order))
        .collect();
    let images = images(tiling, matching, &orders)?;
    Some(minimal(labels, &images))
}

/// All orders of D + 1 corners, sorted.
pub(super) fn orders<const D: usize>() -> Vec<Vec<usize>> {
    let mut orders: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..=D {
        orders = orders
            .into_iter()
            .flat_map(|order| {
                let free: Vec<usize> = (0..=D).filter(|k| !order.contains(k)).collect();
                free.into_iter().map(move |k| [&order[..], &[k]].concat())
            })
            .collect();
    }
    orders
}

/// The images s_0(C) … s_D(C) of all chambers; chamber number n of the simplex s is
/// s (D+1)! + n. Behind a facet without a mate is the chamber itself.
pub(super) fn images<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    orders: &[Vec<usize>],
) -> Option<Vec<Vec<u32>>> {
    let number = |order: &[usize]| orders.binary_search_by(|other| other[..].cmp(order)).ok();
    let mut images = Vec::with_capacity(tiling.len() * orders.len());
    for simplex in tiling.indices() {
        let gluings: Vec<Option<(SimplexId, Vec<usize>)>> = (0..=D)
            .map(|opposite| gluing(tiling, matching, Facet::new(simplex, opposite)))
            .collect();
        for order in orders {
            let mut row = Vec::with_capacity(D + 1);
            for k in 0..D {
                let mut exchanged = order.clone();
                exchanged.swap(k, k + 1);
                row.push((simplex.index() * orders.len() + number(&exchanged)?) as u32);
            }
            row.push(match &gluings[order[D]] {
                Some((neighbour, map)) => {
                    let carried: Vec<usize> = order.iter().map(|&k| map[k]).collect();
                    (neighbour.index() * orders.len() + number(&carried)?) as u32
                }
                None => images.len() as u32,
            });
            images.push(row);
        }
    }
    Some(images)
}

/// The simplex behind a facet, and for each corner the one that takes its place: the
/// same corner in the facet, and the corners opposite to it for each other.
fn gluing<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    facet: Facet,
) -> Option<(SimplexId, Vec<usize>)> {
    let mate = matching.mate(tiling, facet)?;
    let neighbour = mate.facet.simplex;
    let there = tiling.simplex(neighbour);
    let place =
        |(k, corner): (usize, &crate::tiling::Corner<D>)| match k == usize::from(facet.opposite) {
            true => Some(usize::from(mate.facet.opposite)),
            false => there
                .iter()
                .position(|other| other.moved(mate.shift) == *corner),
        };
    let map = tiling
        .simplex(facet.simplex)
        .iter()
        .enumerate()
        .map(place)
        .collect::<Option<_>>()?;
    Some((neighbour, map))
}

/// The coarsest partition of the chambers that separates labels and that the maps respect:
/// a colour for each chamber, numbered from zero.
pub(super) fn coarsest<L: Ord>(labels: &[L], images: &[Vec<u32>]) -> Vec<u32> {
    let (mut colours, mut count) = ranks(labels);
    loop {
        let signatures: Vec<Vec<u32>> = images
            .iter()
            .zip(&colours)
            .map(|(row, colour)| {
                let images = row.iter().map(|&image| colours[image as usize]);
                std::iter::once(*colour).chain(images).collect()
            })
            .collect();
        let (finer, finer_count) = ranks(&signatures);
        if finer_count == count {
            return colours;
        }
        (colours, count) = (finer, finer_count);
    }
}

/// The quotient by the coarsest partition.
fn minimal<L: Ord + Clone, const D: usize>(labels: Vec<L>, images: &[Vec<u32>]) -> Symbol<L, D> {
    let colours = coarsest(&labels, images);
    // The last partition is respected: equal colours have equal images.
    let mut chambers: Vec<usize> = (0..labels.len()).collect();
    chambers.sort_by_key(|&chamber| colours[chamber]);
    chambers.dedup_by_key(|chamber| colours[*chamber]);
    let image = |chamber: &usize| {
        let row = images[*chamber].iter();
        row.map(|&image| colours[image as usize]).collect()
    };
    Symbol {
        labels: chambers
            .iter()
            .map(|&chamber| labels[chamber].clone())
            .collect(),
        images: chambers.iter().map(image).collect(),
    }
}

/// The rank of each value among the different values, and their number.
fn ranks<T: Ord>(values: &[T]) -> (Vec<u32>, usize) {
    let different: BTreeSet<&T> = values.iter().collect();
    let sorted: Vec<&T> = different.into_iter().collect();
    let rank = |value: &T| sorted.binary_search(&value).unwrap_or(0) as u32;
    (values.iter().map(rank).collect(), sorted.len())
}
