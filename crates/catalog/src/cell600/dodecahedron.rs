//! The regular dodecahedron in 470 acute tetrahedra: the 600-cell without the cells that have a vertex
//! adjacent to, or equal to, one vertex.
//!
//! That vertex is the unit 1. The others lie in layers by their real parts. Their imaginary parts are
//! their directions from the centre of the dodecahedron, and each layer has one scale. The first layer
//! that remains has the corners, the second one the centres of the faces.

use super::without;
use crate::CatalogError;
use crate::recipe::fraction;
use acutile_core::tiling::{Domain, Frame, Polytope, Tiling};
use acutile_exact::geometry::cell600::{self, Golden};
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};

/// The real parts of the corners of the dodecahedron and of the centres of its faces, times 2.
const CORNER: Golden = [1, 0];
const CENTER: Golden = [-1, 1];

/// The other layers in the dodecahedron, by their real parts, times 2: scales in 105ths. They come from
/// sequential linear programs in doubles; the largest angle is below 81.41 degrees.
const SCALES: [(Golden, i64); 5] = [
    ([0, 0], 43),
    ([1, -1], 33),
    ([-1, 0], 27),
    ([0, -1], 23),
    ([-2, 0], 0),
];

/// The dodecahedron.
pub fn dodecahedron_470() -> Result<Tiling<3>, CatalogError> {
    let polynomial = [-1, -1, 1].map(Integer::from);
    let (field, phi) = Field::adjoin_root(&polynomial, Rational::from(1), Rational::from(2))?;
    let number = |[a, b]: Golden| &fraction(a.into(), 1) + &(&fraction(b.into(), 1) * &phi);
    let vertices = cell600::vertices();
    // The plane of a face has the distance (2 + φ)/5 of its centre's own imaginary part.
    let flat = &number([2, 1]) * &fraction(1, 5);
    let position = |vertex: usize| {
        let [real, i, j, k] = vertices[vertex];
        let scale = match real {
            CORNER => Some(fraction(1, 1)),
            CENTER => Some(flat.clone()),
            real => SCALES
                .iter()
                .find(|(layer, _)| *layer == real)
                .map(|(_, scale)| fraction(*scale, 105)),
        };
        let scale = scale.ok_or(CatalogError::Degenerate)?;
        Ok([i, j, k].map(|x| &number(x) * &scale))
    };
    let ball: Vec<usize> = (0..vertices.len())
        .filter(|&v| matches!(vertices[v][0], [2, 0] | [0, 1]))
        .collect();
    let tetrahedra: Result<Vec<Vec<_>>, CatalogError> = without(&ball)
        .into_iter()
        .map(|cell| cell.into_iter().map(position).collect())
        .collect();
    let frame = Frame {
        field,
        ..Frame::cubic()
    };
    let hull = hull(&vertices, |corner| {
        position(corner).map(|point| point.to_vec())
    })?;
    Ok(Tiling::from_positions(
        frame.with_domain(Domain::Solid(hull)),
        &tetrahedra?,
    ))
}

/// The polytope of the corners. The corners of a face are the five that are adjacent to its centre.
fn hull(
    vertices: &[[Golden; 4]],
    position: impl Fn(usize) -> Result<Vec<Number>, CatalogError>,
) -> Result<Polytope, CatalogError> {
    let layer = |real: Golden| (0..vertices.len()).filter(move |&v| vertices[v][0] == real);
    let are_adjacent = |v: usize, w: usize| cell600::inner(&vertices[v], &vertices[w]) == [0, 2];
    let corners: Vec<usize> = layer(CORNER).collect();
    let faces = layer(CENTER).map(|center| {
        let near = |k: &usize| are_adjacent(corners[*k], center);
        let mut rest: Vec<usize> = (0..corners.len()).filter(near).collect();
        let mut face: Vec<usize> = rest.pop().into_iter().collect();
        while let Some(next) = rest
            .iter()
            .position(|&k| are_adjacent(corners[k], corners[face[face.len() - 1]]))
        {
            face.push(rest.swap_remove(next));
        }
        face
    });
    let faces = faces.collect();
    let vertices: Result<_, _> = corners.iter().map(|&corner| position(corner)).collect();
    Ok(Polytope {
        vertices: vertices?,
        faces,
    })
}
