//! Delaney-Dress symbols: isomorphism of periodic triangulations, decided.
//!
//! A *chamber* of a triangulation is a flag: a vertex, an edge, … and a simplex, each in the next. Here it
//! is a simplex with an order of its corners, of which the first k + 1 span the k-face. For each k = 0 … D
//! every chamber C has exactly one other chamber s_k(C) that differs in the k-face only. For k < D it
//! exchanges the corners k and k + 1; s_D goes through the facet without the last corner. Consider the
//! chambers modulo any group of automorphisms, with the maps s_k and the orders of the products s_j s_k.
//! They determine a triangulation of a simply connected space up to isomorphism (Dress, Presentations of
//! discrete groups, acting on simply connected manifolds, Adv. Math. 63, 1987). For algorithms see
//! Delgado-Friedrichs, Data structures and algorithms for tilings I, Theoret. Comput. Sci. 303, 2003. In a
//! triangulation all orders but the one of s_(D-1) s_D are fixed; that one is the valence of the ridge that
//! the first D - 1 corners span.
//!
//! The *minimal* symbol is the quotient by all automorphisms, orientation reversing ones included. It does
//! not depend on the lattice of the input. So two triangulations are isomorphic exactly if their minimal
//! symbols are. It is the image under the coarsest partition of the chambers that separates different
//! labels and that all s_k respect. The partition by labels is refined: a chamber's new colour is its old
//! one with those of its images. Colours are numbered by rank, and so depend on the set of colours only. In
//! the end each chamber of the quotient has a colour of its own. So the numbering by colour is canonical:
//! isomorphic means equal.

use super::ridges::Ridges;
use crate::parallel;
use crate::proved::hexadecimal;
use crate::tiling::{Corner, Domain, Facet, Matching, Mate, SimplexId, Tiling};
use acutile_exact::number::Number;
use sha2::{Digest, Sha256};

/// A minimal symbol, chambers numbered canonically.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol<L, const D: usize> {
    /// The label of each chamber.
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

impl<const D: usize> Symbol<usize, D> {
    /// The SHA-256, in hexadecimal digits, of the number of chambers, the labels, and the images of each
    /// chamber. Each number has four bytes, the least one first. Isomorphic triangulations have the same.
    pub fn sha256(&self) -> String {
        let labels = self.labels.iter().map(|&label| label as u32);
        let images = self.images.iter().flatten().copied();
        let numbers = std::iter::once(self.len() as u32)
            .chain(labels)
            .chain(images);
        let bytes: Vec<u8> = numbers.flat_map(u32::to_le_bytes).collect();
        hexadecimal(&Sha256::digest(bytes))
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

fn symbol<L: Ord + Clone + Send + Sync, const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    label: impl Fn(SimplexId, &[usize]) -> L + Sync,
) -> Option<Symbol<L, D>> {
    if tiling.frame.domain != Domain::Space || !matching.mismatches.is_empty() {
        return None;
    }
    let orders = Orders::of(D);
    let labels = parallel::by_chunks(tiling.len(), CHUNK, |simplices| {
        let of_simplex = |simplex| orders.list.iter().map(move |order| (simplex, order));
        let chambers = simplices.map(SimplexId::at).flat_map(of_simplex);
        chambers
            .map(|(simplex, order)| label(simplex, order))
            .collect::<Vec<L>>()
    })
    .concat();
    Some(minimal(&labels, &Images::of(tiling, matching, &orders)?))
}

/// The number of simplices, or of chambers, in the work of one thread at a time.
const CHUNK: usize = 1 << 12;

/// All orders of D + 1 corners.
pub(super) struct Orders {
    /// Sorted.
    pub list: Vec<Vec<usize>>,
    /// The number of each order in the list, at its corners as digits of base 4.
    numbers: Vec<u32>,
}

impl Orders {
    /// The orders of the corners of a simplex of dimension D <= 3.
    pub fn of(dimension: usize) -> Self {
        let mut list: Vec<Vec<usize>> = vec![Vec::new()];
        for _ in 0..=dimension {
            list = list
                .into_iter()
                .flat_map(|order| {
                    let free: Vec<usize> = (0..=dimension).filter(|k| !order.contains(k)).collect();
                    free.into_iter().map(move |k| [&order[..], &[k]].concat())
                })
                .collect();
        }
        let mut numbers = vec![0; 1 << (2 * (dimension + 1))];
        for (number, order) in list.iter().enumerate() {
            numbers[place(order.iter().copied())] = number as u32;
        }
        Orders { list, numbers }
    }

    fn number(&self, order: impl Iterator<Item = usize>) -> u32 {
        self.numbers[place(order)]
    }
}

/// An order of at most four corners as one number.
fn place(order: impl Iterator<Item = usize>) -> usize {
    order.fold(0, |place, corner| 4 * place + corner)
}

/// The images s_0(C) … s_D(C) of all chambers; chamber number n of the simplex s is s (D+1)! + n. Across a
/// facet without a mate the image is the chamber itself.
pub(super) struct Images {
    /// D + 1 for each chamber, one chamber after the other.
    flat: Vec<u32>,
    /// D + 1
    width: usize,
}

impl Images {
    /// `None` if a facet and its mate do not have the same corners, or for 2^32 chambers and more.
    pub fn of<const D: usize>(
        tiling: &Tiling<D>,
        matching: &Matching<D>,
        orders: &Orders,
    ) -> Option<Self> {
        u32::try_from(tiling.len() * orders.list.len()).ok()?;
        let chunks = parallel::by_chunks(tiling.len(), CHUNK, |simplices| {
            let mut flat = Vec::with_capacity(simplices.len() * orders.list.len() * (D + 1));
            for simplex in simplices.map(SimplexId::at) {
                images_of(tiling, matching, orders, simplex, &mut flat)?;
            }
            Some(flat)
        });
        let flat = chunks.into_iter().collect::<Option<Vec<_>>>()?.concat();
        Some(Images { flat, width: D + 1 })
    }

    fn row(&self, chamber: usize) -> &[u32] {
        &self.flat[chamber * self.width..(chamber + 1) * self.width]
    }
}

/// Appends the images of the chambers of one simplex.
fn images_of<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    orders: &Orders,
    simplex: SimplexId,
    flat: &mut Vec<u32>,
) -> Option<()> {
    let count = orders.list.len() as u32;
    let first = simplex.index() as u32 * count;
    let mut gluings = Vec::with_capacity(D + 1);
    for opposite in 0..=D {
        let facet = Facet::new(simplex, opposite);
        gluings.push(match matching.mate(tiling, facet) {
            Some(mate) => Some(gluing(tiling, facet, &mate)?),
            None => None,
        });
    }
    for (number, order) in (first..).zip(&orders.list) {
        for k in 0..D {
            let exchanged = (0..=D).map(|i| match i {
                i if i == k => order[k + 1],
                i if i == k + 1 => order[k],
                i => order[i],
            });
            flat.push(first + orders.number(exchanged));
        }
        flat.push(match &gluings[order[D]] {
            Some((neighbour, map)) => {
                let carried = orders.number(order.iter().map(|&k| map[k]));
                neighbour.index() as u32 * count + carried
            }
            None => number,
        });
    }
    Some(())
}

/// The simplex across a facet, and for each corner its image. A corner of the facet is its own image, and
/// the corners opposite to the facet are images of each other.
fn gluing<const D: usize>(
    tiling: &Tiling<D>,
    facet: Facet,
    mate: &Mate<D>,
) -> Option<(SimplexId, Vec<usize>)> {
    let neighbour = mate.facet.simplex;
    let there = tiling.simplex(neighbour);
    let place = |(k, corner): (usize, &Corner<D>)| {
        if k == usize::from(facet.opposite) {
            Some(usize::from(mate.facet.opposite))
        } else {
            there
                .iter()
                .position(|other| other.moved(mate.shift) == *corner)
        }
    };
    let corners = tiling.simplex(facet.simplex).iter().enumerate();
    Some((neighbour, corners.map(place).collect::<Option<_>>()?))
}

/// The coarsest partition of the chambers that separates labels and that the maps respect:
/// a colour for each chamber, numbered from zero.
pub(super) fn coarsest<L: Ord + Sync>(labels: &[L], images: &Images) -> Vec<u32> {
    let (mut colours, mut count) = ranks(labels.len(), |chamber| &labels[chamber]);
    loop {
        // A chamber's own colour and those of its images, of which there are at most four.
        let signature = |chamber: usize| {
            let mut signature = [colours[chamber]; 5];
            for (k, &image) in images.row(chamber).iter().enumerate() {
                signature[k + 1] = colours[image as usize];
            }
            signature
        };
        let (finer, finer_count) = ranks(labels.len(), signature);
        if finer_count == count {
            return colours;
        }
        (colours, count) = (finer, finer_count);
    }
}

/// The quotient by the coarsest partition.
fn minimal<L: Ord + Clone + Sync, const D: usize>(labels: &[L], images: &Images) -> Symbol<L, D> {
    let colours = coarsest(labels, images);
    // The last partition is respected: equal colours have equal images.
    let mut chambers: Vec<usize> = Vec::new();
    let mut is_seen = vec![false; colours.len()];
    for (chamber, &colour) in colours.iter().enumerate() {
        if !std::mem::replace(&mut is_seen[colour as usize], true) {
            chambers.push(chamber);
        }
    }
    chambers.sort_by_key(|&chamber| colours[chamber]);
    let image = |chamber: &usize| {
        let row = images.row(*chamber).iter();
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

/// The rank of each of n values among the different values, and the number of these. Periodic tilings have few
/// different values, so these alone are sorted.
fn ranks<T: Ord + Send + Sync>(n: usize, value: impl Fn(usize) -> T + Sync) -> (Vec<u32>, usize) {
    let chunks = parallel::by_chunks(n, CHUNK, |range| {
        let mut values: Vec<T> = range.map(&value).collect();
        values.sort_unstable();
        values.dedup();
        values
    });
    let mut different: Vec<T> = chunks.into_iter().flatten().collect();
    different.sort_unstable();
    different.dedup();
    let rank = |k| different.binary_search(&value(k)).unwrap_or(0) as u32;
    (parallel::map(n, rank), different.len())
}
