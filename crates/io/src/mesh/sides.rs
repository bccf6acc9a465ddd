//! The domain of a periodic mesh: all of space, a slab, or a region with a boundary.
//! Also the facets on its sides that have no mate.
//!
//! A facet without a mate is *on the sides*, and should have a mate, in two cases. A lattice vector
//! other than zero moves each of its corners exactly onto a node of the mesh. Or a periodic link of the
//! file has all of its corners: the file says that they have images. All other facets without a mate
//! are boundary.
//!
//! A boundary facet *nearly has a mate* if it would have one after nodes were moved by a thousandth of the
//! shortest edge. Then nobody knows whether the gap is meant, and the mesh is neither proved nor
//! refuted. Doubles find such facets; no verdict on the mesh depends on them.

use super::snap::Move;
use acutile_core::checker::{NearMates, Sides};
use acutile_core::tiling::{Corner, Domain, Facet, Matching, Tiling, VertexId, match_facets};
use std::collections::{BTreeSet, HashMap};

/// What is asked about a mesh.
pub struct Question<'a, const D: usize> {
    /// The mesh as a tiling of a region.
    pub tiling: &'a Tiling<D>,
    /// Whether all corners of a facet belong to one periodic link of the file.
    pub is_linked: &'a dyn Fn(Facet) -> bool,
    /// The tiling after nodes have been moved onto images of others by at most a distance; none if
    /// nearness is not asked for.
    pub moved: &'a dyn Fn(f64) -> Option<(Tiling<D>, Vec<Move>)>,
}

/// The domain of a tiling that is a region as yet, and its sides.
pub fn sides<const D: usize>(question: &Question<D>) -> (Domain, Sides) {
    let tiling = question.tiling;
    let free = free_facets(&match_facets(tiling));
    let domain = |domain| (domain, Sides::default());
    let rank = tiling.frame.rank();
    if rank == D && free.is_empty() {
        return domain(Domain::Space);
    }
    if rank + 1 == D
        && let Some(slab) = slab(tiling, &free)
    {
        return domain(slab);
    }
    let mut facets = exact_sides(tiling, &free);
    let linked = free.iter().filter(|facet| (question.is_linked)(**facet));
    facets.extend(linked.copied());
    let boundary: Vec<Facet> = free
        .iter()
        .filter(|f| !facets.contains(f))
        .copied()
        .collect();
    let near = near_mates(question, &boundary);
    (Domain::Region(rank), Sides { facets, near })
}

/// How many boundary facets nearly have a mate.
fn near_mates<const D: usize>(question: &Question<D>, boundary: &[Facet]) -> Option<NearMates> {
    let tolerance = thousandth(question.tiling)?;
    let (moved, moves) = (question.moved)(tolerance)?;
    let facets = matched_across(&moved, boundary).len();
    let distances = moves.iter().map(|m| m.distance);
    (facets > 0).then(|| NearMates {
        facets,
        distance: distances.fold(0.0, f64::max),
    })
}

fn free_facets<const D: usize>(matching: &Matching<D>) -> Vec<Facet> {
    let single = matching.mismatches.iter().filter(|m| m.uses.len() == 1);
    single.map(|mismatch| mismatch.uses[0].0).collect()
}

fn corners<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> impl Iterator<Item = &Corner<D>> {
    let corners = tiling.simplex(facet.simplex).iter().enumerate();
    corners
        .filter(move |(k, _)| *k != usize::from(facet.opposite))
        .map(|(_, corner)| corner)
}

/// The slab between the lowest and the highest vertex, if the free facets lie in its two sides.
fn slab<const D: usize>(tiling: &Tiling<D>, free: &[Facet]) -> Option<Domain> {
    use acutile_core::tiling::Polytope;
    let heights: Vec<_> = tiling.vertices.iter().map(|v| v[D - 1].clone()).collect();
    let (low, high) = (heights.iter().min()?, heights.iter().max()?);
    let is_side = |facet: &Facet| {
        let all_at = |height: &acutile_exact::number::Number| {
            corners(tiling, *facet).all(|corner| heights[corner.vertex.index()] == *height)
        };
        all_at(low) || all_at(high)
    };
    let is_slab = low != high && free.iter().all(is_side);
    is_slab.then(|| Domain::Slab(Polytope::interval(low.clone(), high.clone())))
}

/// The free facets all of whose corners a lattice vector moves onto nodes.
fn exact_sides<const D: usize>(tiling: &Tiling<D>, free: &[Facet]) -> BTreeSet<Facet> {
    let mut shifts: HashMap<VertexId, BTreeSet<[i32; D]>> = HashMap::new();
    for corner in &tiling.corners {
        shifts
            .entry(corner.vertex)
            .or_default()
            .insert(corner.shift);
    }
    let has = |corner: Corner<D>| {
        shifts
            .get(&corner.vertex)
            .is_some_and(|shifts| shifts.contains(&corner.shift))
    };
    let is_side = |facet: &Facet| {
        let Some(first) = corners(tiling, *facet).next() else {
            return false;
        };
        let images = shifts.get(&first.vertex).into_iter().flatten();
        let steps = images.map(|shift| acutile_core::tiling::difference(*shift, first.shift));
        steps
            .filter(|step| *step != [0; D])
            .any(|step| corners(tiling, *facet).all(|corner| has(corner.moved(step))))
    };
    free.iter().copied().filter(is_side).collect()
}

/// A thousandth of the shortest edge, about; nothing for a mesh with edges of length zero.
fn thousandth<const D: usize>(tiling: &Tiling<D>) -> Option<f64> {
    let gram = tiling
        .frame
        .gram
        .each_ref()
        .map(|row| row.each_ref().map(|x| x.approximate()));
    let vertices: Vec<[f64; D]> = tiling
        .vertices
        .iter()
        .map(|v| v.each_ref().map(|x| x.approximate()))
        .collect();
    let at = |corner: &Corner<D>| -> [f64; D] {
        std::array::from_fn(|k| vertices[corner.vertex.index()][k] + f64::from(corner.shift[k]))
    };
    let mut shortest = f64::INFINITY;
    for simplex in tiling.simplices() {
        for (i, a) in simplex.iter().enumerate() {
            for b in &simplex[..i] {
                let (a, b) = (at(a), at(b));
                let step: [f64; D] = std::array::from_fn(|k| a[k] - b[k]);
                let square: f64 = (0..D)
                    .flat_map(|i| (0..D).map(move |j| (i, j)))
                    .map(|(i, j)| gram[i][j] * step[i] * step[j])
                    .sum();
                shortest = shortest.min(square);
            }
        }
    }
    let tolerance = shortest.sqrt() / 1000.0;
    (tolerance.is_finite() && tolerance > 0.0).then_some(tolerance)
}

/// The facets among these that have a mate moved by a lattice vector.
fn matched_across<const D: usize>(tiling: &Tiling<D>, free: &[Facet]) -> Vec<Facet> {
    let matching = match_facets(tiling);
    let is_matched = |facet: &Facet| {
        let mate = matching.mate(tiling, *facet);
        mate.is_some_and(|mate| mate.shift != [0; D])
    };
    free.iter().copied().filter(is_matched).collect()
}
