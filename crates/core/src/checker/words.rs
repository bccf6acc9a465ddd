//! Parts of sentences about defects: numbers, points, simplices, facets and angles by their names.

use super::defect::{Angle, ContactKind};
use super::names::Names;
use crate::quality::short_decimal;
use crate::statement::counted;
use crate::tiling::{Facet, SimplexId};
use acutile_exact::number::Number;

/// Names put together.
pub(super) struct Words<'t, const D: usize> {
    pub names: &'t Names<'t>,
}

/// No longer number is written in full, unless that is wanted.
const LONG: usize = 24;

impl<const D: usize> Words<'_, D> {
    /// The exact value, and a decimal where that is shorter to read.
    pub fn exact(&self, number: &Number) -> String {
        let text = number.to_string();
        if text.parse::<i64>().is_ok() {
            text
        } else if text.len() > LONG && !self.names.is_exact() {
            format!("about {}", short_decimal(number))
        } else {
            format!("{text} (about {})", short_decimal(number))
        }
    }

    /// A point in the coordinates of the file if there is one, else in those of the basis.
    pub fn point(&self, point: &[Number]) -> String {
        let in_file = self.names.point(point);
        let point = in_file.as_deref().unwrap_or(point);
        let coordinates: Vec<String> = point.iter().map(|x| self.exact(x)).collect();
        format!("({})", coordinates.join(", "))
    }

    /// One side of an interface: how many facets of which simplices with which labels.
    pub fn side(&self, facets: &[Facet]) -> String {
        let mut simplices: Vec<SimplexId> = facets.iter().map(|facet| facet.simplex).collect();
        simplices.dedup();
        let labels = simplices.iter().filter_map(|s| self.names.label(*s));
        let labels: std::collections::BTreeSet<String> = labels.collect();
        let labels = if labels.is_empty() {
            String::new()
        } else {
            format!(", {}", labels.into_iter().collect::<Vec<_>>().join(", "))
        };
        let count = counted(facets.len(), "facet", "facets");
        format!("{count} ({}{labels})", self.some(&simplices))
    }

    pub fn contact(&self, sides: &[Vec<Facet>; 2], coincident: usize, kind: ContactKind) -> String {
        let [a, b] = sides.each_ref().map(|side| self.side(side));
        let lie = if sides[0].len() == 1 { "lies" } else { "lie" };
        let against = format!("{a} {lie} against {b}");
        let equal = counted(coincident, "facet is equal to one", "facets are equal");
        let all = match coincident {
            1 => "the facets are equal".to_owned(),
            n => format!("the {n} facets are equal"),
        };
        match kind {
            ContactKind::EqualFacets => format!(
                "{against}: {all}, but each side has nodes of its own; --identify 0 joins them"
            ),
            ContactKind::OtherDiagonals => format!(
                "{against}: the points are equal, but the facets are not (other diagonals); \
                 {equal}"
            ),
            ContactKind::HangingNodes(hanging) => format!(
                "{against}: {} of the other (hanging nodes); {equal}",
                counted(
                    hanging,
                    "point of one side is no point",
                    "points of one side are no points"
                )
            ),
            ContactKind::Touching => format!(
                "{a} and {b} touch in points or along edges that are no common corners or edges"
            ),
        }
    }

    /// The first few simplices.
    pub fn some(&self, simplices: &[SimplexId]) -> String {
        self.first(simplices, |simplex| self.names.simplex(simplex))
    }

    /// The same, each with its label.
    pub fn some_with_labels(&self, simplices: &[SimplexId]) -> String {
        self.first(simplices, |simplex| {
            let name = self.names.simplex(simplex);
            match self.names.label(simplex) {
                Some(label) => format!("{name} with {label}"),
                None => name,
            }
        })
    }

    fn first(&self, simplices: &[SimplexId], name: impl Fn(SimplexId) -> String) -> String {
        const FEW: usize = 8;
        let first = simplices.iter().take(FEW).map(|s| name(*s));
        let rest = (simplices.len() > FEW).then(|| "…".to_owned());
        first.chain(rest).collect::<Vec<_>>().join(", ")
    }

    pub fn corners(&self, simplex: SimplexId) -> String {
        self.list(simplex, 0..=D)
    }

    fn list(&self, simplex: SimplexId, indices: impl IntoIterator<Item = usize>) -> String {
        let indices = indices.into_iter();
        let texts: Vec<String> = indices.map(|k| self.names.corner(simplex, k)).collect();
        format!("[{}]", texts.join(", "))
    }

    pub fn mended(&self, simplex: SimplexId) -> String {
        self.list(simplex, (0..D - 1).chain([D, D - 1]))
    }

    pub fn facet(&self, facet: &Facet) -> String {
        let opposite = usize::from(facet.opposite);
        let simplex = facet.simplex;
        let corners = self.list(simplex, (0..=D).filter(|&k| k != opposite));
        format!(
            "facet {opposite} of {} {corners}",
            self.names.simplex(simplex)
        )
    }

    pub fn angle(&self, angle: &Angle) -> String {
        let (i, j) = angle.facets;
        let ridge = self.list(angle.simplex, (0..=D).filter(|&k| k != i && k != j));
        format!(
            "the dihedral angle of {} at {ridge}",
            self.names.simplex(angle.simplex)
        )
    }
}
