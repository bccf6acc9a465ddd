//! Defects in words: which simplex, facet or vertex, what was expected, and the
//! exact value that was found, with a short decimal beside it.

use super::defect::{Angle, Defect};
use crate::number::Number;
use crate::quality::{decimal_range, short_decimal};
use crate::tiling::{Facet, Tiling};

/// One defect of `tiling` as a sentence.
pub fn describe<const D: usize>(tiling: &Tiling<D>, defect: &Defect) -> String {
    let name = |facet: &Facet| facet_name(tiling, facet);
    match defect {
        Defect::MetricNotPositive { order, minor } => format!(
            "the Gram matrix is not positive definite: its leading {order} x {order} minor is {}, \
             expected a positive number",
            exact(minor)
        ),
        Defect::NoSimplices => "the tiling has no simplices".to_owned(),
        Defect::RepeatedCorner {
            simplex,
            corners: (i, j),
        } => format!(
            "simplex {simplex}: corners {i} and {j} are both {}, expected {} different corners",
            corner(tiling, *simplex, *i),
            D + 1
        ),
        Defect::Flat { simplex } => format!(
            "simplex {simplex} {} is flat: its determinant is 0, expected a positive number",
            corners(tiling, *simplex)
        ),
        Defect::NegativeOrientation {
            simplex,
            determinant,
        } => format!(
            "simplex {simplex} {} is negatively oriented: its determinant is {}, expected a \
             positive number; the order {} mends it (--reorient does)",
            corners(tiling, *simplex),
            exact(determinant),
            mended(tiling, *simplex)
        ),
        Defect::UnmatchedFacet { facet } => {
            format!(
                "{} is used once, expected one more simplex behind it",
                name(facet)
            )
        }
        Defect::SameSide { facets: (a, b) } => {
            format!(
                "{} and {} are the same facet seen from the same side",
                name(a),
                name(b)
            )
        }
        Defect::OverusedFacet { facets } => format!(
            "one facet is used {} times, expected twice: {}",
            facets.len(),
            facets.iter().map(name).collect::<Vec<_>>().join("; ")
        ),
        Defect::VolumeSum { sum, expected } => format!(
            "the volumes of the simplices sum to {} cells, expected {}",
            exact(sum),
            exact(expected)
        ),
        Defect::FaceWithoutPlane { face } => format!(
            "face {face} of the domain: its first vertices lie in no single plane, or the whole \
             domain lies in it"
        ),
        Defect::FaceNotSupporting {
            face,
            vertex,
            value,
        } => format!(
            "face {face} of the domain: vertex {vertex} of the domain has the value {} on its \
             plane, expected zero for its own vertices and a positive number for all others",
            exact(value)
        ),
        Defect::FaceNotConvex { face } => format!(
            "face {face} of the domain: its corners are not in the cyclic order of a convex polygon"
        ),
        Defect::RidgeNotShared { ridge, faces } => format!(
            "the domain's boundary does not close up: the ridge {ridge:?} lies in {faces} faces, \
             expected 2"
        ),
        Defect::VertexOutside {
            vertex,
            face,
            value,
        } => format!(
            "vertex {vertex} lies outside of the domain, behind face {face}: its value there is \
             {}, expected zero or a positive number",
            exact(value)
        ),
        Defect::CoincidentVertices { vertices } => {
            format!("the vertices {vertices:?} are the same point, expected different ones")
        }
        Defect::BoundaryMeets {
            facets: (a, b),
            point,
        } => format!(
            "{} and {} are in the boundary and meet in the point ({}), expected to meet in common \
             corners and edges only",
            name(a),
            name(b),
            point.iter().map(exact).collect::<Vec<_>>().join(", ")
        ),
        Defect::Covered { facet, simplices } => format!(
            "directly outside of {}, which is in the boundary, points are covered {} times, expected \
             none: by simplex {}",
            name(facet),
            simplices.len(),
            some(simplices)
        ),
        Defect::RegionDimension => "a region has dimension 3".to_owned(),
        Defect::DelaunayOfRegion => {
            "Delaunay is not stated of a region, which need not be convex".to_owned()
        }
        Defect::UnusedVertex { vertex } => {
            format!("vertex {vertex} is a corner of no simplex")
        }
        Defect::RightAngle { angle } => {
            format!(
                "{} is a right angle: the product of the normals is 0, expected a negative number",
                angle_name(tiling, angle)
            )
        }
        Defect::ObtuseAngle { angle } => format!(
            "{} is obtuse: {} degrees; the product of the normals is {}, expected {}",
            angle_name(tiling, angle),
            decimal_range(&angle.degrees),
            exact(&angle.product),
            "a negative number (acute) or zero (right)"
        ),
        Defect::AngleNotBelow { angle, bound } => format!(
            "{} is {} degrees (the product of the normals is {}), expected less than {bound}",
            angle_name(tiling, angle),
            decimal_range(&angle.degrees),
            exact(&angle.product)
        ),
        Defect::AngleNotAbove { angle, bound } => format!(
            "{} is {} degrees (the product of the normals is {}), expected more than {bound}",
            angle_name(tiling, angle),
            decimal_range(&angle.degrees),
            exact(&angle.product)
        ),
        Defect::RatioNotBelow {
            simplex,
            squared_ratio,
            bound,
        } => format!(
            "simplex {simplex} {}: the square of its radius-edge ratio is {}, expected less than \
             the square of {bound}",
            corners(tiling, *simplex),
            exact(squared_ratio)
        ),
        Defect::NotTcp { reason } => format!("not tetrahedrally close packed: {reason}"),
        Defect::OnCircumsphere { facet, neighbour } => format!(
            "the corner of simplex {neighbour} behind {} lies on the circumsphere: its power \
             is 0, expected a positive number",
            name(facet)
        ),
        Defect::InsideCircumsphere {
            facet,
            neighbour,
            power,
        } => format!(
            "the corner of simplex {neighbour} behind {} lies inside of the circumsphere: its \
             power times the determinant is {}, expected a positive number",
            name(facet),
            exact(power)
        ),
    }
}

/// The first few.
fn some(indices: &[usize]) -> String {
    const FEW: usize = 8;
    let first = indices.iter().take(FEW).map(usize::to_string);
    let rest = (indices.len() > FEW).then(|| "…".to_owned());
    first.chain(rest).collect::<Vec<_>>().join(", ")
}

/// The exact value, and a decimal where that is shorter to read.
fn exact(number: &Number) -> String {
    let text = number.to_string();
    if text.parse::<i64>().is_ok() {
        text
    } else {
        format!("{text} (about {})", short_decimal(number))
    }
}

fn corner<const D: usize>(tiling: &Tiling<D>, simplex: usize, index: usize) -> String {
    tiling.simplex(simplex)[index].to_string()
}

fn corners<const D: usize>(tiling: &Tiling<D>, simplex: usize) -> String {
    list(tiling, simplex, 0..=D)
}

fn list<const D: usize>(
    tiling: &Tiling<D>,
    simplex: usize,
    indices: impl IntoIterator<Item = usize>,
) -> String {
    let texts: Vec<String> = indices
        .into_iter()
        .map(|index| corner(tiling, simplex, index))
        .collect();
    format!("[{}]", texts.join(", "))
}

fn mended<const D: usize>(tiling: &Tiling<D>, simplex: usize) -> String {
    list(tiling, simplex, (0..D - 1).chain([D, D - 1]))
}

fn facet_name<const D: usize>(tiling: &Tiling<D>, facet: &Facet) -> String {
    let opposite = usize::from(facet.opposite);
    let simplex = facet.simplex as usize;
    let corners = list(tiling, simplex, (0..=D).filter(|&k| k != opposite));
    format!("facet {opposite} of simplex {simplex} {corners}")
}

fn angle_name<const D: usize>(tiling: &Tiling<D>, angle: &Angle) -> String {
    let (i, j) = angle.facets;
    let ridge = list(tiling, angle.simplex, (0..=D).filter(|&k| k != i && k != j));
    format!("the dihedral angle of simplex {} at {ridge}", angle.simplex)
}
