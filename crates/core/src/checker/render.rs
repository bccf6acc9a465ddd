//! Defects in words: the simplex, facet or vertex, the expected value, and the
//! exact value that was found, with a short decimal beside it.

use super::defect::Defect;
use super::names::Names;
use super::words::Words;
use crate::advice::moved;
use crate::quality::decimal_range;
use crate::statement::counted;
use crate::tiling::{CELL_LIMIT, Facet, SimplexId, VertexId};

/// One defect of a tiling of dimension D as a sentence, with the `names` of simplices and vertices.
pub fn describe<const D: usize>(names: &Names, defect: &Defect) -> String {
    let words = Words::<D> { names };
    let name = |facet: &Facet| words.facet(facet);
    let of = |simplex: &SimplexId| names.simplex(*simplex);
    match defect {
        Defect::MetricNotPositive { order, minor } => format!(
            "the Gram matrix is not positive definite: its leading {order} x {order} minor is {}, \
             expected a positive number",
            words.exact(minor)
        ),
        Defect::NoSimplices => "the tiling has no simplices".to_owned(),
        Defect::RepeatedCorner {
            simplex,
            corners: (i, j),
        } => format!(
            "{}: corners {i} and {j} are both {}, expected {} different corners",
            of(simplex),
            names.corner(*simplex, *i),
            D + 1
        ),
        Defect::Flat { simplex } => format!(
            "{} {} is flat: its determinant is 0, expected a positive number",
            of(simplex),
            words.corners(*simplex)
        ),
        Defect::NegativeOrientation {
            simplex,
            determinant,
        } => format!(
            "{} {} is negatively oriented: its determinant is {}, expected a \
             positive number; the order {} mends it (--reorient does)",
            of(simplex),
            words.corners(*simplex),
            words.exact(determinant),
            words.mended(*simplex)
        ),
        Defect::UnmatchedFacet { facet } => {
            format!(
                "{} is used once, expected one more simplex on its other side",
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
            words.exact(sum),
            words.exact(expected)
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
            words.exact(value)
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
            "{} lies outside of the domain, behind face {face}: its value there is {}, expected \
             zero or a positive number",
            names.vertex(*vertex),
            words.exact(value)
        ),
        Defect::CoincidentVertices { vertices } => {
            let list: Vec<String> = vertices.iter().map(|v| names.vertex(*v)).collect();
            format!(
                "{} are the same point, expected different ones",
                list.join(", ")
            )
        }
        Defect::BoundaryMeets {
            facets: (a, b),
            point,
        } => format!(
            "{} and {} are in the boundary and meet in the point {}, expected to meet in common \
             corners and edges only",
            name(a),
            name(b),
            words.point(point)
        ),
        Defect::Covered { facet, simplices } => format!(
            "directly outside of {}, which is in the boundary, points are covered by {}, expected \
             nothing there",
            name(facet),
            words.some(simplices)
        ),
        Defect::Overlap {
            simplices: (s, t),
            shift,
            point,
        } => format!(
            "{} and {}{} overlap: both have the point {} inside",
            of(s),
            of(t),
            moved(shift),
            words.point(point)
        ),
        Defect::NonConforming {
            sides,
            coincident,
            kind,
        } => words.contact(sides, *coincident, *kind),
        Defect::Duplicates { simplices } => format!(
            "{} have the same corners {}, expected each simplex once",
            words.some_with_labels(simplices),
            words.corners(simplices[0])
        ),
        Defect::NotConnected { firsts } => format!(
            "the simplices fall into {} pieces that have no common facet, expected one; they \
             begin with {}",
            firsts.len(),
            words.some(firsts)
        ),
        Defect::Cavity { facets } => format!(
            "{} facets bound a cavity, expected none; it is next to {}",
            facets.len(),
            words.some(&defect.simplices())
        ),
        Defect::NotManifold { ridges, vertices } => {
            let ridge = |ridge: &Vec<VertexId>| {
                let names = ridge.iter().map(|v| names.vertex(v.index()));
                format!("[{}]", names.collect::<Vec<_>>().join(", "))
            };
            let first = |list: Vec<String>| {
                let rest = if list.len() > 8 { ", …" } else { "" };
                format!("{}{rest}", list[..list.len().min(8)].join(", "))
            };
            let (one, many, facets) = match D {
                2 => ("vertex is", "vertices are", "edges"),
                _ => ("edge is", "edges are", "facets"),
            };
            let mut places = Vec::new();
            if !ridges.is_empty() {
                places.push(format!(
                    "{} in another number of boundary {facets} than 2 ({})",
                    counted(ridges.len(), one, many),
                    first(ridges.iter().map(ridge).collect())
                ));
            }
            if !vertices.is_empty() {
                places.push(format!(
                    "at {} the boundary {facets} form several rings ({})",
                    counted(vertices.len(), "vertex", "vertices"),
                    first(vertices.iter().map(|v| names.vertex(v.index())).collect())
                ));
            }
            format!("the boundary is no manifold: {}", places.join("; "))
        }
        Defect::NotOnSurface { facets } => format!(
            "{} of the surface: {}",
            counted(
                facets.len(),
                "boundary facet is no triangle",
                "boundary facets are no triangles"
            ),
            facets
                .iter()
                .take(8)
                .map(name)
                .collect::<Vec<_>>()
                .join("; ")
        ),
        Defect::NotBoundary { triangles } => format!(
            "{}: number {}{} (from 1)",
            counted(
                triangles.len(),
                "triangle of the surface is no boundary facet",
                "triangles of the surface are no boundary facets"
            ),
            triangles.first().map_or(0, |first| first + 1),
            if triangles.len() > 1 {
                " and so on"
            } else {
                ""
            }
        ),
        Defect::NearMates(near) => format!(
            "{} no mate under the lattice, but nearly: nodes would have to move by at most \
             {:.3e}; --identify with a larger number moves them, --identify 0 takes the gaps as \
             boundary",
            counted(near.facets, "facet has", "facets have"),
            near.distance
        ),
        Defect::VertexFar { vertex } => format!(
            "{} is more than {CELL_LIMIT} lattice vectors away from the origin, which is not decided; \
             move the tiling by a lattice vector",
            names.vertex(*vertex)
        ),
        Defect::BoundaryWork { limit } => format!(
            "the boundary has too many facets close to each other: more than the limit of {limit} pairs \
             would have to be compared"
        ),
        Defect::NoBoundary => "the region has no boundary: every facet has a mate; expected the \
                               domain \"space\""
            .to_owned(),
        Defect::UnusedVertex { vertex } => {
            format!("{} is a corner of no simplex", names.vertex(*vertex))
        }
        Defect::RightAngle { angle } => {
            format!(
                "{} is a right angle: the product of the normals is 0, expected a negative number",
                words.angle(angle)
            )
        }
        Defect::ObtuseAngle { angle } => format!(
            "{} is obtuse: {} degrees; the product of the normals is {}, expected {}",
            words.angle(angle),
            decimal_range(&angle.degrees),
            words.exact(&angle.product),
            "a negative number (acute) or zero (right)"
        ),
        Defect::AngleNotBelow { angle, bound } => format!(
            "{} is {} degrees (the product of the normals is {}), expected less than {bound}",
            words.angle(angle),
            decimal_range(&angle.degrees),
            words.exact(&angle.product)
        ),
        Defect::AngleNotAbove { angle, bound } => format!(
            "{} is {} degrees (the product of the normals is {}), expected more than {bound}",
            words.angle(angle),
            decimal_range(&angle.degrees),
            words.exact(&angle.product)
        ),
        Defect::RatioNotBelow {
            simplex,
            squared_ratio,
            bound,
        } => format!(
            "{} {}: the square of its radius-edge ratio is {}, expected less than \
             the square of {bound}",
            of(simplex),
            words.corners(*simplex),
            words.exact(squared_ratio)
        ),
        Defect::PlaneBeyond { plane, dimension } => format!(
            "{plane} has a coordinate that dimension {dimension} does not have, expected x1 to \
             x{dimension}"
        ),
        Defect::PlaneCrossed {
            simplex,
            plane,
            offset,
            sides,
        } => format!(
            "{} {} crosses {plane}{}: at two of its corners the left side is {} and {}, expected \
             no corner on one side of {offset} and no other one on the other side",
            of(simplex),
            words.corners(*simplex),
            if *offset == plane.value() {
                String::new()
            } else {
                format!(", moved by a lattice vector to the right side {offset}")
            },
            words.exact(&sides.0),
            words.exact(&sides.1)
        ),
        Defect::NoneInside => {
            "no neighbour's corner is inside of a circumsphere, expected one; require \
             weakly-delaunay, which holds"
                .to_owned()
        }
        Defect::NotTcp { reason } => format!("not tetrahedrally close packed: {reason}"),
        Defect::OnCircumsphere { facet, neighbour } => format!(
            "the corner of {} behind {} lies on the circumsphere: its power \
             is 0, expected a positive number",
            of(neighbour),
            name(facet)
        ),
        Defect::InsideCircumsphere {
            facet,
            neighbour,
            power,
        } => format!(
            "the corner of {} behind {} lies inside of the circumsphere: its \
             power times the determinant is {}, expected a positive number",
            of(neighbour),
            name(facet),
            words.exact(power)
        ),
    }
}
