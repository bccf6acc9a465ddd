//! Defects in words: which simplex, facet or vertex, what was expected, and the
//! exact value that was found, with a short decimal beside it.

use super::defect::{Angle, ContactKind, Defect};
use super::names::Names;
use crate::advice::moved;
use crate::quality::{decimal_range, short_decimal};
use crate::tiling::{Facet, SimplexId, VertexId};
use acutile_exact::number::Number;

/// One defect of a tiling of dimension D as a sentence, with things called by their `names`.
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
            "{} and {} are in the boundary and meet in the point ({}), expected to meet in common \
             corners and edges only",
            name(a),
            name(b),
            point
                .iter()
                .map(|x| words.exact(x))
                .collect::<Vec<_>>()
                .join(", ")
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
            "{} and {}{} overlap: both have the point ({}) inside",
            of(s),
            of(t),
            moved(shift),
            point
                .iter()
                .map(|x| words.exact(x))
                .collect::<Vec<_>>()
                .join(", ")
        ),
        Defect::NonConforming {
            sides,
            coincident,
            kind,
        } => words.contact(sides, *coincident, *kind),
        Defect::Duplicates { simplices } => format!(
            "{} have the same corners {}, expected each simplex once",
            words.some(simplices),
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
            format!(
                "the boundary is no manifold: {} edges are in another number of boundary facets \
                 than 2 ({}), and at {} vertices the boundary facets form several rings ({})",
                ridges.len(),
                first(ridges.iter().map(ridge).collect()),
                vertices.len(),
                first(vertices.iter().map(|v| names.vertex(v.index())).collect())
            )
        }
        Defect::NotOnSurface { facets } => format!(
            "{} boundary facets are no triangles of the surface: {}",
            facets.len(),
            facets
                .iter()
                .take(8)
                .map(name)
                .collect::<Vec<_>>()
                .join("; ")
        ),
        Defect::NotBoundary { triangles } => format!(
            "{} triangles of the surface are no boundary facets: number {} (from 1) and so on",
            triangles.len(),
            triangles.first().map_or(0, |first| first + 1)
        ),
        Defect::NearMates(near) => format!(
            "{} facets have no mate under the lattice, but nearly: nodes would have to move by at most \
             {:.3e}; --identify with a larger number moves them, --identify 0 takes the gaps as \
             boundary",
            near.facets, near.distance
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
            match *offset == plane.value() {
                true => String::new(),
                false => format!(", moved by a lattice vector to the right side {offset}"),
            },
            words.exact(&sides.0),
            words.exact(&sides.1)
        ),
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

/// Names put together.
struct Words<'t, const D: usize> {
    names: &'t Names<'t>,
}

/// No longer number is written in full, unless that is wanted.
const LONG: usize = 24;

impl<const D: usize> Words<'_, D> {
    /// The exact value, and a decimal where that is shorter to read.
    fn exact(&self, number: &Number) -> String {
        let text = number.to_string();
        if text.parse::<i64>().is_ok() {
            text
        } else if text.len() > LONG && !self.names.is_exact() {
            format!("about {}", short_decimal(number))
        } else {
            format!("{text} (about {})", short_decimal(number))
        }
    }

    /// One side of an interface: how many facets of which simplices with which labels.
    fn side(&self, facets: &[Facet]) -> String {
        let simplices: Vec<SimplexId> = facets.iter().map(|facet| facet.simplex).collect();
        let labels = simplices.iter().filter_map(|s| self.names.label(*s));
        let labels: std::collections::BTreeSet<String> = labels.collect();
        let labels = match labels.is_empty() {
            true => String::new(),
            false => format!(", {}", labels.into_iter().collect::<Vec<_>>().join(", ")),
        };
        let count = match facets.len() {
            1 => "1 facet".to_owned(),
            count => format!("{count} facets"),
        };
        format!("{count} ({}{labels})", self.some(&simplices))
    }

    fn contact(&self, sides: &[Vec<Facet>; 2], coincident: usize, kind: ContactKind) -> String {
        let [a, b] = sides.each_ref().map(|side| self.side(side));
        match kind {
            ContactKind::EqualFacets => format!(
                "{a} lie against {b}: the {coincident} facets are equal, but each side has nodes of \
                 its own; --identify 0 joins them"
            ),
            ContactKind::OtherDiagonals => format!(
                "{a} lie against {b}: the points are equal, but the facets are not (other \
                 diagonals); {coincident} facets are equal"
            ),
            ContactKind::HangingNodes(hanging) => format!(
                "{a} lie against {b}: {hanging} points of one side are no points of the other \
                 (hanging nodes); {coincident} facets are equal"
            ),
            ContactKind::Touching => format!(
                "{a} and {b} touch in a point or along an edge that is no common corner or edge"
            ),
        }
    }

    /// The first few simplices.
    fn some(&self, simplices: &[SimplexId]) -> String {
        const FEW: usize = 8;
        let first = simplices.iter().take(FEW).map(|s| self.names.simplex(*s));
        let rest = (simplices.len() > FEW).then(|| "…".to_owned());
        first.chain(rest).collect::<Vec<_>>().join(", ")
    }

    fn corners(&self, simplex: SimplexId) -> String {
        self.list(simplex, 0..=D)
    }

    fn list(&self, simplex: SimplexId, indices: impl IntoIterator<Item = usize>) -> String {
        let indices = indices.into_iter();
        let texts: Vec<String> = indices.map(|k| self.names.corner(simplex, k)).collect();
        format!("[{}]", texts.join(", "))
    }

    fn mended(&self, simplex: SimplexId) -> String {
        self.list(simplex, (0..D - 1).chain([D, D - 1]))
    }

    fn facet(&self, facet: &Facet) -> String {
        let opposite = usize::from(facet.opposite);
        let simplex = facet.simplex;
        let corners = self.list(simplex, (0..=D).filter(|&k| k != opposite));
        format!(
            "facet {opposite} of {} {corners}",
            self.names.simplex(simplex)
        )
    }

    fn angle(&self, angle: &Angle) -> String {
        let (i, j) = angle.facets;
        let ridge = self.list(angle.simplex, (0..=D).filter(|&k| k != i && k != j));
        format!(
            "the dihedral angle of {} at {ridge}",
            self.names.simplex(angle.simplex)
        )
    }
}
