//! The symmetry group of a tiling, found exactly: all isometries of the space that map
//! every tile to a tile.
//!
//! Two chambers (see `symbol`) that have the same squared edge lengths determine an isometry f that maps
//! the one to the other. It is a symmetry exactly if both have the same colour in a partition of the
//! chambers. This is the coarsest one that separates edge lengths and boundary and that all s_k respect.
//! Symmetries clearly keep such colours. Conversely let the colours of C and C' agree. Those of s_k(C) and
//! s_k(C') do, too, and f maps s_k(C) to s_k(C'). For k < D this is clear. For k = D, f maps the facet of C
//! to the facet of C', and the tiles across them are congruent and in the same position. So f maps
//! neighbour to neighbour, a boundary facet to a boundary facet, and since all tiles are connected through
//! facets, every tile to a tile.
//!
//! The group acts freely on the chambers, since an isometry that fixes D + 1 points in general position is
//! the identity. So the chambers of one colour, up to the lattice, correspond to the elements of the group
//! up to the lattice. Colours give the orbits of faces.
//!
//! The lattice of the input may be too small, or not invariant under the group. Neither matters here, but
//! then the cosets form no group.

use super::symbol::{Images, Orders, coarsest, edge_index};
use crate::tiling::{Facet, Matching, SimplexId, Tiling};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::{BTreeMap, BTreeSet};

/// x ↦ M x + t in basis coordinates.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Isometry<const D: usize> {
    /// M
    pub linear: [[Number; D]; D],
    /// t; for an element up to the lattice 0 <= t < 1 in the lattice's directions.
    pub translation: [Number; D],
}

/// The symmetry group of a tiling, up to the lattice that the tiling is given with.
#[derive(Clone, Debug)]
pub struct Symmetry<const D: usize> {
    /// The orbit of each simplex; orbits are numbered in the order of first members.
    pub simplices: Vec<usize>,
    /// The orbit of each vertex.
    pub vertices: Vec<usize>,
    /// The orbit of the facet opposite to corner i of simplex s, at s (D+1) + i; a facet
    /// and its mate have the same.
    pub facets: Vec<usize>,
    /// One element of each coset of the lattice, the identity among them.
    pub elements: Vec<Isometry<D>>,
}

impl<const D: usize> Symmetry<D> {
    /// The symmetries of a tiling without defects. `edges` gives the squared edges 01, 02, …, 12, … of
    /// each simplex.
    ///
    /// # Panics
    /// A tiling with a flat simplex, or a matching of another tiling.
    pub fn of(tiling: &Tiling<D>, matching: &Matching<D>, edges: &[Vec<Number>]) -> Self {
        let orders = Orders::of(D);
        // A facet without a mate is glued to itself, and no inner facet is.
        let images = Images::of(tiling, matching, &orders)
            .expect("facets of a proved tiling match, and memory ends before 2^32 chambers");
        let lengths = interned(edges);
        let labels: Vec<Vec<usize>> = (0..tiling.len())
            .flat_map(|simplex| orders.list.iter().map(move |order| (simplex, order)))
            .map(|(simplex, order)| label(matching, &lengths[simplex], simplex, order))
            .collect();
        let colours = coarsest(&labels, &images);
        let chambers = Chambers {
            tiling,
            matching,
            orders: orders.list,
            colours,
        };
        Symmetry {
            simplices: renumbered((0..tiling.len()).map(|s| chambers.least(s, |_| true))),
            vertices: chambers.vertices(),
            facets: chambers.facets(),
            elements: chambers.elements(),
        }
    }

    /// The number of orbits of simplices.
    pub fn orbits(&self) -> usize {
        self.simplices.iter().max().map_or(0, |last| last + 1)
    }

    /// The number of translations among the elements: the index of the given lattice in that of
    /// all translations that keep the tiling.
    pub fn translations(&self) -> usize {
        let one = identity::<D>();
        self.elements.iter().filter(|e| e.linear == one).count()
    }

    /// The order of the point group.
    pub fn point_group_order(&self) -> usize {
        self.elements.len() / self.translations().max(1)
    }

    /// The elements that map a lattice of this rank to itself, the identity first. They form a group
    /// up to the lattice.
    pub fn keeping_lattice(&self, rank: usize) -> Vec<Isometry<D>> {
        let one = Isometry::identity();
        let kept = self.elements.iter().filter(|e| e.keeps_lattice(rank));
        let others = kept.filter(|e| **e != one).cloned();
        std::iter::once(one.clone()).chain(others).collect()
    }
}

/// The places of few elements of a group that, with the lattice, generate it.
pub fn generators<const D: usize>(group: &[Isometry<D>], rank: usize) -> Vec<usize> {
    let mut chosen: Vec<&Isometry<D>> = Vec::new();
    let mut places = Vec::new();
    let mut generated = vec![Isometry::identity()];
    for (place, element) in group.iter().enumerate() {
        if generated.binary_search(element).is_err() {
            chosen.push(element);
            places.push(place);
            generated = closure(&chosen, rank);
        }
    }
    places
}

/// All products of some isometries up to the lattice, sorted.
fn closure<const D: usize>(generators: &[&Isometry<D>], rank: usize) -> Vec<Isometry<D>> {
    let mut found = std::collections::BTreeSet::from([Isometry::identity()]);
    let mut fresh = vec![Isometry::identity()];
    while let Some(element) = fresh.pop() {
        for generator in generators {
            let product = generator.after(&element).reduced(rank);
            if found.insert(product.clone()) {
                fresh.push(product);
            }
        }
    }
    found.into_iter().collect()
}

impl<const D: usize> Isometry<D> {
    /// x ↦ x
    pub fn identity() -> Self {
        Isometry {
            linear: identity(),
            translation: std::array::from_fn(|_| Number::zero()),
        }
    }

    /// x ↦ self(first(x))
    pub fn after(&self, first: &Isometry<D>) -> Self {
        let column = |j: usize| std::array::from_fn(|k| first.linear[k][j].clone());
        let moved = linear::apply(&self.linear, &first.translation);
        Isometry {
            linear: std::array::from_fn(|i| {
                std::array::from_fn(|j| linear::dot(&self.linear[i], &column(j)))
            }),
            translation: std::array::from_fn(|i| &moved[i] + &self.translation[i]),
        }
    }

    /// Whether the images of b_1, …, b_rank are in the lattice that these span. An isometry with this
    /// property maps the lattice onto itself, since it keeps the volume of a cell.
    pub fn keeps_lattice(&self, rank: usize) -> bool {
        let entries = (0..D).flat_map(|i| (0..rank).map(move |j| (i, j)));
        entries.into_iter().all(|(i, j)| {
            let entry = self.linear[i][j].to_rational();
            entry.is_some_and(|x| *x.denominator_ref() == 1u32 && (i < rank || *x == 0))
        })
    }

    /// The image of a point.
    pub fn image(&self, point: &[Number; D]) -> [Number; D] {
        let turned = linear::apply(&self.linear, point);
        std::array::from_fn(|i| &turned[i] + &self.translation[i])
    }

    /// The isometry with the translation moved into 0 <= t < 1 by lattice vectors.
    pub fn reduced(mut self, rank: usize) -> Self {
        for entry in &mut self.translation[..rank] {
            *entry = &*entry - &Number::from(Rational::from(entry.floor()));
        }
        self
    }
}

fn identity<const D: usize>() -> [[Number; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| Number::from(Rational::from(u8::from(i == j)))))
}

/// The squared edges, each length by its rank among the different ones.
fn interned(edges: &[Vec<Number>]) -> Vec<Vec<usize>> {
    let lengths: BTreeSet<&Number> = edges.iter().flatten().collect();
    let ranks: BTreeMap<&Number, usize> = lengths.into_iter().zip(0..).collect();
    let rank_of = |edge: &Number| ranks[edge];
    edges
        .iter()
        .map(|edges| edges.iter().map(rank_of).collect())
        .collect()
}

/// The label of a chamber: whether its last facet is in the boundary, and its lengths.
fn label<const D: usize>(
    matching: &Matching<D>,
    lengths: &[usize],
    simplex: usize,
    order: &[usize],
) -> Vec<usize> {
    let facet = Facet::new(SimplexId::at(simplex), order[D]);
    let is_boundary = matching.neighbour(facet).is_none();
    let pairs = (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (order[i], order[j])));
    std::iter::once(usize::from(is_boundary))
        .chain(pairs.map(|(i, j)| lengths[edge_index::<D>(i.min(j), i.max(j))]))
        .collect()
}

/// Keys to numbers in the order of first occurrence.
fn renumbered(keys: impl Iterator<Item = u32>) -> Vec<usize> {
    let mut numbers = BTreeMap::new();
    keys.map(|key| {
        let fresh = numbers.len();
        *numbers.entry(key).or_insert(fresh)
    })
    .collect()
}

struct Chambers<'t, const D: usize> {
    tiling: &'t Tiling<D>,
    matching: &'t Matching<D>,
    orders: Vec<Vec<usize>>,
    colours: Vec<u32>,
}

impl<const D: usize> Chambers<'_, D> {
    /// The least colour among the chambers of a simplex whose order is as asked. The colours of
    /// the chambers at a face determine its orbit, so the least one does. The orders are all
    /// permutations, and each question is about a prefix of one, so some order is asked for.
    fn least(&self, simplex: usize, is_asked: impl Fn(&[usize]) -> bool) -> u32 {
        let of_simplex = &self.colours[simplex * self.orders.len()..];
        let asked = self.orders.iter().zip(of_simplex);
        let colours = asked.filter(|(order, _)| is_asked(order)).map(|(_, c)| *c);
        colours
            .min()
            .expect("each question is about a prefix or the end of some order")
    }

    fn vertices(&self) -> Vec<usize> {
        let mut least = vec![u32::MAX; self.tiling.vertices.len()];
        for (simplex, corners) in self.tiling.simplices().enumerate() {
            for (k, corner) in corners.iter().enumerate() {
                let colour = self.least(simplex, |order| order[0] == k);
                let least = &mut least[corner.vertex.index()];
                *least = colour.min(*least);
            }
        }
        renumbered(least.into_iter())
    }

    fn facets(&self) -> Vec<usize> {
        let half = |facet: Facet| {
            let opposite = usize::from(facet.opposite);
            self.least(facet.simplex.index(), |order| order[D] == opposite)
        };
        renumbered(self.tiling.facets().map(|facet| {
            let here = half(facet);
            let behind = self.matching.neighbour(facet);
            behind.map_or(here, |there| here.min(half(there)))
        }))
    }

    fn elements(&self) -> Vec<Isometry<D>> {
        let Some(first) = self.colours.first() else {
            return Vec::new();
        };
        let rank = self.tiling.frame.rank();
        let same = self.colours.iter().enumerate().filter(|(_, c)| *c == first);
        let mut elements: Vec<Isometry<D>> = same
            .map(|(chamber, _)| self.isometry(chamber).reduced(rank))
            .collect();
        elements.sort();
        elements
    }

    /// The affine map from chamber 0 to another. With edges e_i and gradients g_i of
    /// the one, d its determinant, and edges f_i of the other, x = Σ (g_i · x) e_i / d
    /// goes to Σ (g_i · x) f_i / d.
    fn isometry(&self, chamber: usize) -> Isometry<D> {
        let order = &self.orders[chamber % self.orders.len()];
        let from = self.tiling.shape(SimplexId::new(0));
        let target = self
            .tiling
            .simplex(SimplexId::at(chamber / self.orders.len()));
        let images: Vec<[Number; D]> = order
            .iter()
            .map(|&k| self.tiling.position(&target[k]))
            .collect();
        let inverse = from
            .determinant
            .inverse()
            .expect("no simplex of a proved tiling is flat");
        let edges: Vec<[Number; D]> = images[1..]
            .iter()
            .map(|image| linear::subtract(image, &images[0]))
            .collect();
        let linear: [[Number; D]; D] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let terms = edges.iter().zip(&from.gradients);
                let sum = terms.fold(Number::zero(), |sum, (f, g)| sum + &f[i] * &g[j]);
                sum * &inverse
            })
        });
        let origin = self
            .tiling
            .position(&self.tiling.simplex(SimplexId::new(0))[0]);
        Isometry {
            translation: linear::subtract(&images[0], &linear::apply(&linear, &origin)),
            linear,
        }
    }
}
