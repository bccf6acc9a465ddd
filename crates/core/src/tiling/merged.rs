//! Vertices at the same point, made one.

use super::{Corner, Tiling, VertexId};
use acutile_exact::number::Number;
use std::collections::BTreeMap;

/// The tiling with one vertex for each point, and how many vertices it has fewer. Points are compared
/// in their places, not up to the lattice.
pub fn merged<const D: usize>(tiling: &Tiling<D>) -> (Tiling<D>, usize) {
    let mut indices: BTreeMap<[Number; D], VertexId> = BTreeMap::new();
    let mut kept = Vec::new();
    let renumbered: Vec<VertexId> = tiling
        .vertices
        .iter()
        .map(|point| {
            *indices.entry(point.clone()).or_insert_with(|| {
                kept.push(point);
                VertexId::at(kept.len() - 1)
            })
        })
        .collect();
    let fewer = tiling.vertices.len() - kept.len();
    let corner = |corner: &Corner<D>| Corner {
        vertex: renumbered[corner.vertex.index()],
        shift: corner.shift,
    };
    let tiling = Tiling {
        frame: tiling.frame.clone(),
        vertices: kept.into(),
        corners: tiling.corners.iter().map(corner).collect(),
    };
    (tiling, fewer)
}
