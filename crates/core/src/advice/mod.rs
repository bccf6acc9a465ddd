//! Possible repairs of a defect: the nearest facet with its distance, overlapping simplices with a common
//! point, a missing simplex, the least move of a vertex.
//!
//! Doubles search; every value in a message is computed or confirmed exactly. Nothing here takes part in
//! a proof or in a refutation: [`crate::checker`] has decided before.

mod hole;
mod motion;
mod nearest;
mod off_face;
mod overlap;
mod place;

pub use hole::Hole;
pub use motion::{Motion, motion};
pub use nearest::Near;
pub use off_face::OffFace;
pub use overlap::{Overlap, common_point, overlap};

use crate::checker::Defect;
use crate::quality::rounded_up;
use crate::tiling::{Corner, Facet, SimplexId, Tiling, match_facets};
use acutile_exact::number::Number;
use malachite::Rational;
use place::Places;
use std::cell::OnceCell;
use std::collections::BTreeMap;

/// One piece of advice about a defect.
#[derive(Clone, Debug, PartialEq)]
pub enum Advice<const D: usize> {
    /// Another facet without a mate lies near.
    Near(Near<D>),
    /// A vertex misses a face of the domain.
    OffFace(OffFace),
    /// The facets around a hole.
    Hole(Hole<D>),
    /// Two simplices with a common inner point.
    Overlap(Overlap<D>),
    /// The volumes sum to a multiple of the volume of the domain.
    Covered {
        /// The sum of the volumes over the volume of the domain.
        ratio: Number,
    },
    /// Moving one corner makes the simplex acute.
    Motion(Motion<D>),
    /// No motion of a single corner makes the simplex acute.
    NoMotion {
        /// The simplex with the angle.
        simplex: SimplexId,
    },
}

/// Gives advice about the defects of one tiling. Data for several pieces of advice is computed once.
pub struct Adviser<'t, const D: usize> {
    tiling: &'t Tiling<D>,
    places: OnceCell<Places<D>>,
    free: OnceCell<Vec<Facet>>,
    holes: OnceCell<BTreeMap<Facet, Hole<D>>>,
}

impl<'t, const D: usize> Adviser<'t, D> {
    /// Ready to advise about `tiling`; nothing is computed yet.
    pub fn new(tiling: &'t Tiling<D>) -> Self {
        Adviser {
            tiling,
            places: OnceCell::new(),
            free: OnceCell::new(),
            holes: OnceCell::new(),
        }
    }

    /// The advice about a defect of this tiling.
    pub fn advice(&self, defect: &Defect) -> Vec<Advice<D>> {
        match defect {
            Defect::UnmatchedFacet { facet } => self.about_unmatched(*facet),
            Defect::VertexOutside { vertex, face, .. } => {
                let off = off_face::of_vertex(self.tiling, *vertex, *face);
                off.map(Advice::OffFace).into_iter().collect()
            }
            Defect::SameSide { facets: (a, b) } => self.about_pair(*a, *b),
            Defect::OverusedFacet { facets } => self.about_overused(facets),
            Defect::BoundaryMeets { facets: (a, b), .. } => {
                self.about_overlap(a.simplex, &[b.simplex])
            }
            Defect::Covered { facet, simplices } => self.about_overlap(facet.simplex, simplices),
            Defect::VolumeSum { sum, expected } => self.about_volume(sum, expected),
            Defect::RightAngle { angle } | Defect::ObtuseAngle { angle } => {
                self.about_angle(angle.simplex).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    fn about_unmatched(&self, facet: Facet) -> Vec<Advice<D>> {
        let off = off_face::of_facet(self.tiling, facet);
        if !off.is_empty() {
            return off.into_iter().map(Advice::OffFace).collect();
        }
        let hole = self.holes().get(&facet).cloned();
        let is_filled = hole.as_ref().is_some_and(|hole| hole.missing.is_some());
        // Where one simplex is missing, no facet is off.
        let near = (!is_filled)
            .then(|| nearest::nearest(self.tiling, self.places(), facet, self.free()))
            .flatten();
        let overlap = overlap::partner(self.tiling, self.places(), facet.simplex);
        let advice = [
            near.map(Advice::Near),
            hole.map(Advice::Hole),
            overlap.map(Advice::Overlap),
        ];
        advice.into_iter().flatten().collect()
    }

    fn about_pair(&self, a: Facet, b: Facet) -> Vec<Advice<D>> {
        let overlap = overlap::behind_common_facet(self.tiling, a, b);
        overlap.map(Advice::Overlap).into_iter().collect()
    }

    fn about_overused(&self, facets: &[Facet]) -> Vec<Advice<D>> {
        let pairs = (0..facets.len()).flat_map(|i| (0..i).map(move |j| (facets[j], facets[i])));
        pairs
            .flat_map(|(a, b)| self.about_pair(a, b))
            .take(1)
            .collect()
    }

    /// The first of `others` that overlaps with a simplex, in the same place.
    fn about_overlap(&self, simplex: SimplexId, others: &[SimplexId]) -> Vec<Advice<D>> {
        let overlap = |other: &SimplexId| overlap::overlap(self.tiling, (simplex, *other), [0; D]);
        let found = others
            .iter()
            .filter(|other| **other != simplex)
            .find_map(overlap);
        found.map(Advice::Overlap).into_iter().collect()
    }

    fn about_volume(&self, sum: &Number, expected: &Number) -> Vec<Advice<D>> {
        let Some(ratio) = sum.divide(expected) else {
            return Vec::new();
        };
        let overlap = (sum > expected)
            .then(|| overlap::partner(self.tiling, self.places(), SimplexId::new(0)))
            .flatten();
        std::iter::once(Advice::Covered { ratio })
            .chain(overlap.map(Advice::Overlap))
            .collect()
    }

    fn about_angle(&self, simplex: SimplexId) -> Option<Advice<D>> {
        if !motion::is_possible(self.tiling, simplex) {
            return Some(Advice::NoMotion { simplex });
        }
        motion(self.tiling, simplex).map(Advice::Motion)
    }

    fn places(&self) -> &Places<D> {
        self.places.get_or_init(|| Places::of(self.tiling))
    }

    /// The facets that have no simplex on their other side.
    fn free(&self) -> &[Facet] {
        self.free.get_or_init(|| {
            let mismatches = match_facets(self.tiling).mismatches;
            let single = mismatches
                .iter()
                .filter(|mismatch| mismatch.uses.len() == 1);
            single.map(|mismatch| mismatch.uses[0].0).collect()
        })
    }

    fn holes(&self) -> &BTreeMap<Facet, Hole<D>> {
        self.holes
            .get_or_init(|| hole::holes(self.tiling, self.free()))
    }
}

impl<const D: usize> Advice<D> {
    /// The advice as a sentence; the functions write a corner, the name of a simplex, a point.
    pub fn in_words(
        &self,
        corner: &dyn Fn(&Corner<D>) -> String,
        simplex: &dyn Fn(SimplexId) -> String,
        point: &dyn Fn(&[Number; D]) -> String,
    ) -> String {
        let corners = |list: &[Corner<D>]| list.iter().map(corner).collect::<Vec<_>>().join(", ");
        match self {
            Advice::Near(near) if near.squared_distance == Number::zero() => format!(
                "the free facet [{}] of {} is at the same place: its vertices are doubled",
                corners(&near.corners),
                simplex(near.facet.simplex),
            ),
            Advice::Near(near) => format!(
                "the nearest free facet is [{}] of {}; it misses by a distance whose square is {}, about {}",
                corners(&near.corners),
                simplex(near.facet.simplex),
                near.squared_distance,
                root(&near.squared_distance),
            ),
            Advice::OffFace(off) => off.to_string(),
            Advice::Hole(hole) => match &hole.missing {
                Some(missing) => format!(
                    "the hole on its other side is one simplex: adding [{}] closes it",
                    corners(missing)
                ),
                None => format!("{} free facets hang together around it", hole.facets.len()),
            },
            Advice::Overlap(overlap) => format!(
                "{} and {}{} overlap: both have the point {} inside",
                simplex(overlap.simplices.0),
                simplex(overlap.simplices.1),
                moved(&overlap.shift),
                point(&overlap.point),
            ),
            Advice::Covered { ratio } => {
                format!(
                    "the volumes are {ratio} times what they should be{}",
                    times(ratio)
                )
            }
            Advice::Motion(motion) => format!(
                "moving corner {} of {} to {}, by at most {}, makes this simplex acute",
                corner(&motion.corner),
                simplex(motion.simplex),
                point(&motion.target),
                rounded_up(&motion.distance, 6),
            ),
            Advice::NoMotion { simplex: index } => format!(
                "no motion of a single corner makes {} acute, for none of its facets is acute",
                simplex(*index)
            ),
        }
    }
}

/// The meaning of a ratio of volumes that is a whole number.
fn times(ratio: &Number) -> String {
    match ratio.to_rational() {
        Some(value) if *value > 1 && *value.denominator_ref() == 1u32 => {
            format!(": every point is covered {value} times if all facets match")
        }
        _ => String::new(),
    }
}

/// ` moved by (1, 0, 0) lattice vectors`, or nothing.
pub(crate) fn moved(shift: &[i32]) -> String {
    if shift.iter().all(|&s| s == 0) {
        String::new()
    } else {
        let shift: Vec<String> = shift.iter().map(ToString::to_string).collect();
        format!(" moved by ({}) lattice vectors", shift.join(", "))
    }
}

/// A decimal upper bound of a square root.
pub(crate) fn root(square: &Number) -> String {
    let width = Rational::from_signeds(1, 10_000_000_000_000i64);
    rounded_up(&square.enclosure_of_root(&width).1, 9)
}
