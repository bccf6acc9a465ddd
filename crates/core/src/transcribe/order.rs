//! The order of the rows and the numbers of the vertices.
//!
//! A reader of the rows keeps the facets that one simplex has so far. Few facets are open at a
//! time if neighbours stand near to each other. The given order is kept if it is good; else the
//! simplices are sorted along a space-filling curve through the cell. Vertices are numbered as
//! they occur. Open facets are found by their first vertex, so a vertex of very many simplices
//! gets a late number. Doubles propose an order, and every order is right.

use super::curve;
use crate::parallel;
use crate::tiling::coordinates::Form;
use crate::tiling::{CELL_LIMIT, Corner, Facet, Matching, SimplexId, Tiling, VertexId, cell_of};
use acutile_exact::number::Number;
use rayon::prelude::*;

/// How the simplices and vertices of a tiling are written.
#[derive(Clone, Debug)]
pub struct Order<const D: usize> {
    /// The simplices, in the order of the rows.
    pub rows: Vec<SimplexId>,
    /// The vertices, in the order of their numbers.
    pub vertices: Vec<VertexId>,
    /// For each vertex of the tiling its number.
    pub numbers: Vec<u32>,
    /// For each vertex of the tiling the cell of the lattice in which it lies, unless all are in
    /// the first one.
    cells: Vec<[i32; D]>,
}

/// A vertex of more simplices is numbered after all others.
const HEAVY: u32 = 256;

impl<const D: usize> Order<D> {
    /// The order for a tiling whose facets are matched.
    pub fn of(tiling: &Tiling<D>, matching: &Matching<D>) -> Self {
        let rows = rows(tiling, matching);
        let (vertices, numbers) = numbering(tiling, &rows);
        Order {
            rows,
            vertices,
            numbers,
            cells: cells(tiling),
        }
    }

    /// The cell of the lattice in which a vertex of the tiling lies.
    #[inline]
    pub fn cell(&self, vertex: VertexId) -> [i32; D] {
        match self.cells.get(vertex.index()) {
            Some(cell) => *cell,
            None => [0; D],
        }
    }
}

/// The cells of all vertices; nothing if all are zero. They make shifts small. A vertex beyond the
/// limit of cells gets the cell zero, which is correct, too.
fn cells<const D: usize>(tiling: &Tiling<D>) -> Vec<[i32; D]> {
    let rank = tiling.frame.rank();
    if rank == 0 {
        return Vec::new();
    }
    let cells: Vec<[i32; D]> = match tiling.vertices.form() {
        Form::Integers {
            numerators,
            denominator,
        } => {
            let cell = |x: &[i64; D]| -> [i32; D] {
                let floors = x.map(|x| x.div_euclid(*denominator));
                let mut directions = floors[..rank].iter();
                if directions.any(|x| x.unsigned_abs() > CELL_LIMIT as u64) {
                    return [0; D];
                }
                std::array::from_fn(|k| if k < rank { floors[k] as i32 } else { 0 })
            };
            numerators.iter().map(cell).collect()
        }
        _ => {
            let cell = |vertex: usize| -> [i32; D] {
                cell_of(&tiling.vertices.vertex(VertexId::at(vertex)), rank).unwrap_or([0; D])
            };
            parallel::map(tiling.vertices.len(), cell)
        }
    };
    if cells.iter().all(|cell| *cell == [0; D]) {
        Vec::new()
    } else {
        cells
    }
}

/// Numbers along the rows. A vertex that no simplex has comes last.
fn numbering<const D: usize>(tiling: &Tiling<D>, rows: &[SimplexId]) -> (Vec<VertexId>, Vec<u32>) {
    const NONE: u32 = u32::MAX;
    let mut uses = vec![0u32; tiling.vertices.len()];
    for corner in &tiling.corners {
        uses[corner.vertex.index()] += 1;
    }
    let is_heavy = |vertex: VertexId| uses[vertex.index()] > HEAVY;
    let mut numbers = vec![NONE; tiling.vertices.len()];
    let mut vertices = Vec::with_capacity(numbers.len());
    for heavy in [false, true] {
        for row in rows {
            for vertex in in_order(tiling.simplex(*row)) {
                let number = &mut numbers[vertex.index()];
                if *number == NONE && is_heavy(vertex) == heavy {
                    *number = vertices.len() as u32;
                    vertices.push(vertex);
                }
            }
        }
        if uses.iter().all(|uses| *uses <= HEAVY) {
            break;
        }
    }
    for vertex in 0..numbers.len() {
        if numbers[vertex] == NONE {
            numbers[vertex] = vertices.len() as u32;
            vertices.push(VertexId::at(vertex));
        }
    }
    (vertices, numbers)
}

/// The vertices of a simplex, the least first. A row lists its last two corners in the order that
/// makes it positive. The numbers must not depend on that order: otherwise the tiling of a
/// certificate would get another certificate.
fn in_order<const D: usize>(corners: &[Corner<D>]) -> impl Iterator<Item = VertexId> {
    let mut vertices = [VertexId::new(u32::MAX); 4];
    for (vertex, corner) in vertices.iter_mut().zip(corners) {
        *vertex = corner.vertex;
    }
    vertices.sort_unstable();
    vertices.into_iter().take(D + 1)
}

/// The given order is good if at most this times n^((D-1)/D) facets are open.
const GOOD: u128 = 4;

fn rows<const D: usize>(tiling: &Tiling<D>, matching: &Matching<D>) -> Vec<SimplexId> {
    let given: Vec<SimplexId> = tiling.indices().collect();
    let open = most_open(matching, &given);
    let n = given.len() as u128;
    let exponent = D as u32;
    if u128::from(open).pow(exponent) <= GOOD.pow(exponent) * n.pow(exponent - 1) {
        return given;
    }
    let sorted = along_curve(tiling);
    if most_open(matching, &sorted) < open {
        sorted
    } else {
        given
    }
}

/// The largest number of facets that are open after a row.
fn most_open<const D: usize>(matching: &Matching<D>, rows: &[SimplexId]) -> u32 {
    let mut places = vec![0u32; rows.len()];
    for (place, row) in rows.iter().enumerate() {
        places[row.index()] = place as u32;
    }
    let (mut open, mut most) = (0u32, 0);
    for (place, row) in rows.iter().enumerate() {
        for opposite in 0..=D {
            let Some(mate) = matching.neighbour(Facet::new(*row, opposite)) else {
                continue;
            };
            let other = places[mate.simplex.index()] as usize;
            // A neighbour of itself opens and closes in the same row.
            if other > place {
                open += 1;
            } else if other < place {
                open -= 1;
            }
        }
        most = most.max(open);
    }
    most
}

/// Added to coordinates before they are rounded down. Centroids often have round coordinates, where
/// rounding errors would decide. Then the tiling of a certificate could get another certificate.
const GENERIC: f64 = 0.000_317_81;

/// The simplices sorted by the places of their centroids on a space-filling curve. In the
/// directions of the lattice the places in the cell count.
fn along_curve<const D: usize>(tiling: &Tiling<D>) -> Vec<SimplexId> {
    let points = doubles(tiling);
    let rank = tiling.frame.rank();
    let centroid = |simplex: usize| -> [f64; D] {
        let corners = tiling.simplex(SimplexId::at(simplex));
        std::array::from_fn(|k| {
            let sum = corners.iter().fold(0.0, |sum, corner| {
                sum + points[corner.vertex.index()][k] + f64::from(corner.shift[k])
            });
            let mean = sum / (D as f64 + 1.0) + GENERIC;
            if k < rank { mean - mean.floor() } else { mean }
        })
    };
    let centroids = parallel::map(tiling.len(), centroid);
    let mut keys: Vec<(u64, SimplexId)> = places(tiling, &centroids)
        .into_iter()
        .map(curve::index)
        .zip(tiling.indices())
        .collect();
    keys.par_sort_unstable();
    keys.into_iter().map(|(_, simplex)| simplex).collect()
}

/// The same for the grid, whose cells have the length 1.
const ABOVE: f64 = 0.37;

/// The cells of a grid in which points lie; its cells are about cubes.
fn places<const D: usize>(tiling: &Tiling<D>, points: &[[f64; D]]) -> Vec<[u32; D]> {
    let lengths: [f64; D] =
        std::array::from_fn(|k| Number::approximate(&tiling.frame.gram[k][k]).sqrt());
    let entries = |k: usize| points.iter().map(move |x| x[k]);
    let low: [f64; D] = std::array::from_fn(|k| entries(k).fold(f64::INFINITY, f64::min));
    let high: [f64; D] = std::array::from_fn(|k| entries(k).fold(f64::NEG_INFINITY, f64::max));
    let extents = (0..D).map(|k| (high[k] - low[k]) * lengths[k]);
    let cells = f64::from(1u32 << curve::BITS) / extents.fold(0.0, f64::max);
    let last = (1u32 << curve::BITS) - 1;
    let place = |x: &[f64; D]| -> [u32; D] {
        // A conversion of a double saturates.
        std::array::from_fn(|k| (((x[k] - low[k]) * lengths[k] * cells + ABOVE) as u32).min(last))
    };
    points.iter().map(place).collect()
}

/// The vertices in doubles.
fn doubles<const D: usize>(tiling: &Tiling<D>) -> Vec<[f64; D]> {
    match tiling.vertices.form() {
        Form::Integers {
            numerators,
            denominator,
        } => {
            let scale = *denominator as f64;
            let double = |x: &[i64; D]| x.map(|n| n as f64 / scale);
            numerators.iter().map(double).collect()
        }
        Form::Doubles(points) => points.clone(),
        Form::Numbers(points) => {
            let double = |x: &[Number; D]| x.each_ref().map(Number::approximate);
            parallel::map(points.len(), |k| double(&points[k]))
        }
    }
}
