//! The shape of a tiling with a boundary: pieces, boundary surfaces, cavities, and places where
//! the boundary is no manifold.
//!
//! Two simplices belong to one piece if a path through common facets leads from one to the other.
//! Boundary facets belong to one surface if a path through ridges of exactly two boundary facets does.
//! A closed surface whose enclosed volume is negative, seen from the simplices, bounds a cavity.
//! Nothing here takes part in the proof that a tiling is valid.

mod surface;
mod union;

pub use surface::{Kind, Surface, facet_corners};
pub use union::Union;

use crate::tiling::{Corner, Facet, Matching, SimplexId, Tiling, VertexId};
use acutile_exact::geometry::{Simplex, linear};
use acutile_exact::number::Number;
use std::collections::{BTreeMap, BTreeSet};

/// The parts of a tiling with a boundary.
#[derive(Clone, Debug)]
pub struct Anatomy<const D: usize> {
    /// The first simplex of each piece, and the number of its simplices.
    pub pieces: Vec<(SimplexId, usize)>,
    /// The surfaces of the boundary.
    pub surfaces: Vec<Surface<D>>,
    /// Ridges with another number of boundary facets than two.
    pub ridges: Vec<(Vec<Corner<D>>, usize)>,
    /// Vertices around which the boundary facets form more than one ring.
    pub vertices: Vec<VertexId>,
}

impl<const D: usize> Anatomy<D> {
    /// The parts of a tiling whose facets are matched.
    pub fn of(tiling: &Tiling<D>, matching: &Matching<D>) -> Self {
        let single = matching.mismatches.iter().filter(|m| m.uses.len() == 1);
        let boundary: Vec<Facet> = single.map(|mismatch| mismatch.uses[0].0).collect();
        let ridges = surface::Ridges::of(tiling, &boundary);
        let mut surfaces = surface::surfaces(tiling, &ridges, &boundary);
        surfaces.sort_by_key(|surface| surface.facets[0]);
        Anatomy {
            pieces: pieces(tiling, matching, |_, _| true),
            surfaces,
            ridges: ridges.singular(),
            vertices: singular_vertices(tiling, &boundary),
        }
    }

    /// The surfaces that bound cavities.
    pub fn cavities(&self) -> impl Iterator<Item = &Surface<D>> {
        let surfaces = self.surfaces.iter();
        surfaces.filter(|surface| surface.kind == Kind::Cavity)
    }

    /// Whether the boundary is a manifold.
    pub fn is_manifold(&self) -> bool {
        self.ridges.is_empty() && self.vertices.is_empty()
    }
}

/// The first simplex of each piece and the number of its simplices. A path in a piece goes from a simplex
/// to one that it `joins`.
pub fn pieces<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    joins: impl Fn(SimplexId, SimplexId) -> bool,
) -> Vec<(SimplexId, usize)> {
    let mut union = Union::new(tiling.len());
    for simplex in tiling.indices() {
        for opposite in 0..=D as u8 {
            if let Some(other) = matching.neighbour(Facet { simplex, opposite })
                && joins(simplex, other.simplex)
            {
                union.join(simplex.index(), other.simplex.index());
            }
        }
    }
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    for simplex in 0..tiling.len() {
        *counts.entry(union.first(simplex)).or_default() += 1;
    }
    let piece = |(first, count)| (SimplexId::at(first), count);
    counts.into_iter().map(piece).collect()
}

/// The volume of each simplex in doubles, in the units of the metric.
pub fn volumes<const D: usize>(tiling: &Tiling<D>) -> Vec<f64> {
    let gram = tiling.frame.gram.each_ref();
    let gram = gram.map(|row| row.each_ref().map(Number::approximate));
    let scale = linear::determinant(&gram).sqrt() / (1..=D).product::<usize>() as f64;
    let vertices: Vec<[f64; D]> = tiling
        .vertices
        .iter()
        .map(|vertex| vertex.each_ref().map(Number::approximate))
        .collect();
    let position = |corner: &Corner<D>| -> [f64; D] {
        let vertex = &vertices[corner.vertex.index()];
        std::array::from_fn(|k| vertex[k] + f64::from(corner.shift[k]))
    };
    let volume = |corners: &[Corner<D>]| {
        let points: Vec<[f64; D]> = corners.iter().map(position).collect();
        scale * Simplex::new(&points).determinant
    };
    tiling.simplices().map(volume).collect()
}

/// Vertices at which the boundary facets fall into several rings, or into parts that only the vertex
/// joins. In the plane a vertex is a ridge.
fn singular_vertices<const D: usize>(tiling: &Tiling<D>, boundary: &[Facet]) -> Vec<VertexId> {
    if D == 2 {
        return Vec::new();
    }
    let mut stars: BTreeMap<VertexId, Vec<Vec<Corner<D>>>> = BTreeMap::new();
    for &facet in boundary {
        let corners = surface::facet_corners(tiling, facet);
        for corner in &corners {
            let others = corners.iter().filter(|other| *other != corner);
            let from_here = others.map(|other| Corner {
                vertex: other.vertex,
                shift: crate::tiling::difference(other.shift, corner.shift),
            });
            stars
                .entry(corner.vertex)
                .or_default()
                .push(from_here.collect());
        }
    }
    let is_singular = |facets: &[Vec<Corner<D>>]| {
        let corners: BTreeSet<&Corner<D>> = facets.iter().flatten().collect();
        let numbers: BTreeMap<&Corner<D>, usize> = corners.into_iter().zip(0..).collect();
        let mut union = Union::new(numbers.len());
        for facet in facets {
            for pair in facet.windows(2) {
                union.join(numbers[&pair[0]], numbers[&pair[1]]);
            }
        }
        (0..numbers.len()).any(|corner| union.first(corner) != 0)
    };
    let stars = stars.into_iter();
    stars
        .filter(|(_, facets)| is_singular(facets))
        .map(|(vertex, _)| vertex)
        .collect()
}
