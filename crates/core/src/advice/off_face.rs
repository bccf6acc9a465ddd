//! Vertices that miss a face of the domain by a little.

use super::place::facet_corners;
use super::root;
use crate::tiling::{Facet, Plane, Tiling, VertexId};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::CheckedSqrt;
use std::fmt;

/// A vertex near a face.
#[derive(Clone, Debug, PartialEq)]
pub struct OffFace {
    /// The vertex, by its index.
    pub vertex: VertexId,
    /// The face's plane as an equation, `x = 1`.
    pub plane: String,
    /// The square of the distance from the plane.
    pub squared_distance: Number,
}

/// A facet is probably meant to lie in a face if its corners are near to the plane of the face. Near means
/// less than this part of its longest edge.
const NEAR: f64 = 0.1;

/// The vertices of a facet that keep it from lying in a face of the domain; none where no face is near.
pub fn of_facet<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> Vec<OffFace> {
    let Some(polytope) = tiling.frame.domain.polytope() else {
        return Vec::new();
    };
    let corners = facet_corners(tiling, facet);
    let points: Vec<[Number; D]> = corners.iter().map(|c| tiling.position(c)).collect();
    let lengths = points
        .iter()
        .flat_map(|a| points.iter().map(move |b| (a, b)));
    let square = |(a, b)| linear::square(&tiling.frame.gram, &linear::subtract::<_, D>(a, b));
    let longest = lengths.map(square).max().unwrap_or_else(Number::zero);
    let of_face = |face: usize| -> Option<Vec<OffFace>> {
        let all: Option<Vec<OffFace>> = corners
            .iter()
            .map(|corner| of_vertex(tiling, corner.vertex.index(), face))
            .collect();
        let off: Vec<OffFace> = all?
            .into_iter()
            .filter(|off| !off.squared_distance.is_zero())
            .collect();
        let limit = NEAR * NEAR * longest.approximate();
        let is_near = off
            .iter()
            .all(|off| off.squared_distance.approximate() < limit);
        (is_near && !off.is_empty()).then_some(off)
    };
    let farthest = |off: &Vec<OffFace>| {
        let squares = off.iter().map(|off| off.squared_distance.approximate());
        squares.fold(0.0, f64::max)
    };
    let found = (0..polytope.faces.len()).filter_map(of_face);
    found
        .min_by(|a, b| farthest(a).total_cmp(&farthest(b)))
        .unwrap_or_default()
}

/// How far a vertex is from the plane of a face; `None` if the face has no plane.
pub fn of_vertex<const D: usize>(
    tiling: &Tiling<D>,
    vertex: usize,
    face: usize,
) -> Option<OffFace> {
    let plane = tiling.frame.domain.polytope()?.plane(face)?;
    let rank = tiling.frame.rank();
    let vertex = VertexId::at(vertex);
    let value = plane.value(tiling.frame.cross_section(&tiling.vertices.vertex(vertex)));
    // The distance is |value| over the length of the covector, which the adjugate of G measures.
    let covector: [Number; D] = std::array::from_fn(|k| match k.checked_sub(rank) {
        Some(k) => plane.normal()[k].clone(),
        None => Number::zero(),
    });
    let gram = &tiling.frame.gram;
    let square = linear::square(&linear::cofactors(gram), &covector);
    let squared_distance = (&value * &value * linear::determinant(gram)).divide(&square)?;
    Some(OffFace {
        vertex,
        plane: equation(&plane, rank),
        squared_distance,
    })
}

/// `x = 1`, or `x + 2 y = 3`: the first coefficient is made 1.
fn equation(plane: &Plane, rank: usize) -> String {
    let names = ["x", "y", "z"];
    let normal = plane.normal();
    let Some(scale) = normal.iter().find_map(Number::inverse) else {
        return String::new();
    };
    let one = Number::from(Rational::from(1));
    let terms = names[rank..]
        .iter()
        .zip(normal)
        .filter(|(_, n)| !n.is_zero());
    let term = |(name, n): (&&str, &Number)| {
        let factor = n * &scale;
        if factor == one {
            (*name).to_owned()
        } else {
            format!("({factor}) {name}")
        }
    };
    let left: Vec<String> = terms.map(term).collect();
    format!("{} = {}", left.join(" + "), plane.offset() * &scale)
}

/// `vertex 331 is 1/1000 off the face x = 1`
impl fmt::Display for OffFace {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let exact = self
            .squared_distance
            .to_rational()
            .and_then(CheckedSqrt::checked_sqrt);
        let distance = match exact {
            Some(distance) => distance.to_string(),
            None => format!("about {}", root(&self.squared_distance)),
        };
        write!(
            f,
            "vertex {} is {distance} off the face {}",
            self.vertex, self.plane
        )
    }
}
