//! A tiling becomes a family in which some coordinates vary around their values.

use super::{Family, FamilyError, Parameter};
use crate::tiling::{Corner, Domain, Frame, Tiling, VertexId, cell_of};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use acutile_exact::polynomial::{End, Polynomial, Side};
use malachite::Rational;

/// The quantity that varies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Free {
    /// The coordinates of a vertex in the basis.
    Vertex(usize),
    /// The entries of the Gram matrix but the first, which fixes the scale.
    Gram,
}

/// The family of all tilings with the same simplices in which the free numbers are at most `radius`
/// away from those of `tiling`. A vertex in the boundary of the domain keeps its place in it: only
/// its coordinates along the lattice vary.
///
/// # Errors
/// If there is no such vertex, or the result is no family.
pub fn family<const D: usize>(
    tiling: &Tiling<D>,
    free: &[Free],
    radius: &Rational,
) -> Result<Family<D>, FamilyError> {
    let constant = |x: &Number| Polynomial::constant(x.clone());
    let gram = &tiling.frame.gram;
    let vertices = tiling.vertices.iter();
    let mut family = Family {
        parameters: Vec::new(),
        frame: Frame {
            field: tiling.frame.field.clone(),
            gram: gram.each_ref().map(|row| row.each_ref().map(constant)),
            domain: tiling.frame.domain.map(constant),
        },
        vertices: vertices
            .map(|vertex| vertex.each_ref().map(constant))
            .collect(),
        corners: tiling.corners.clone(),
    };
    for (k, what) in free.iter().enumerate() {
        match what {
            _ if free[..k].contains(what) => {}
            Free::Gram => free_gram(&mut family, tiling, radius),
            Free::Vertex(vertex) if *vertex >= tiling.vertices.len() => {
                return Err(FamilyError::Vertex(*vertex));
            }
            Free::Vertex(vertex) => free_vertex(&mut family, tiling, *vertex, radius),
        }
    }
    family.check()?;
    Ok(family)
}

/// The family of the triangulations of moving points: `tiling` is one of `points`, which move as the
/// polynomials do. `None` if some vertex of the tiling is no such point.
pub fn over_points(
    tiling: &Tiling<3>,
    points: &[[Number; 3]],
    parameters: Vec<Parameter>,
    gram: [[Polynomial; 3]; 3],
    polynomials: Vec<[Polynomial; 3]>,
) -> Option<Family<3>> {
    let corners = tiling.corners.iter();
    let corners = corners.map(|corner| named(points, &tiling.position(corner)));
    Some(Family {
        parameters,
        frame: Frame {
            field: tiling.frame.field.clone(),
            gram,
            domain: Domain::Space,
        },
        vertices: polynomials,
        corners: corners.collect::<Option<_>>()?,
    })
}

/// The corner at a position: one of the points, moved by a lattice vector of space.
fn named(points: &[[Number; 3]], position: &[Number; 3]) -> Option<Corner<3>> {
    let is_there = |point: &[Number; 3]| {
        let moved = linear::subtract(position, point);
        let shift = cell_of(&moved, 3)?;
        let is_whole = |k: usize| moved[k] == Number::from(Rational::from(shift[k]));
        (0..3).all(is_whole).then_some(shift)
    };
    let mut found = (0..).zip(points);
    found.find_map(|(vertex, point)| Some(Corner::of(vertex).moved(is_there(point)?)))
}

/// A new parameter around a value.
fn parameter<const D: usize>(
    family: &mut Family<D>,
    name: String,
    value: &Number,
    radius: &Rational,
) -> Polynomial {
    let index = family.parameters.len();
    let radius = Number::from(radius.clone());
    family.parameters.push(Parameter {
        name,
        side: Side {
            low: End::closed(value - &radius),
            high: End::closed(value + &radius),
        },
    });
    // Whether there are too many is checked at the end.
    if index < acutile_exact::polynomial::MOST_PARAMETERS {
        Polynomial::parameter(index)
    } else {
        Polynomial::constant(value.clone())
    }
}

fn free_gram<const D: usize>(family: &mut Family<D>, tiling: &Tiling<D>, radius: &Rational) {
    for i in 0..D {
        for j in i..D {
            if (i, j) != (0, 0) {
                let name = format!("g{}{}", i + 1, j + 1);
                let entry = parameter(family, name, &tiling.frame.gram[i][j], radius);
                family.frame.gram[i][j] = entry.clone();
                family.frame.gram[j][i] = entry;
            }
        }
    }
}

fn free_vertex<const D: usize>(
    family: &mut Family<D>,
    tiling: &Tiling<D>,
    vertex: usize,
    radius: &Rational,
) {
    let position = tiling.vertices.vertex(VertexId::at(vertex));
    let free = if is_in_boundary(tiling, &position) {
        tiling.frame.rank()
    } else {
        D
    };
    for (k, letter) in ["x", "y", "z"].iter().enumerate().take(free) {
        let name = format!("{letter}{vertex}");
        family.vertices[vertex][k] = parameter(family, name, &position[k], radius);
    }
}

fn is_in_boundary<const D: usize>(tiling: &Tiling<D>, position: &[Number; D]) -> bool {
    let Some(polytope) = tiling.frame.domain.polytope() else {
        return false;
    };
    let point = tiling.frame.cross_section(position);
    let planes = (0..polytope.faces.len()).filter_map(|face| polytope.plane(face));
    planes.into_iter().any(|plane| plane.value(point).is_zero())
}
