//! One function for each hypothesis of the theorem in docs/soundness.md.
//!
//! Each takes the tiling with its denominators cleared, adds defects to the
//! findings, and decides nothing else.

use super::defect::Defect;
use super::findings::Findings;
use crate::predicates::{Model, Orientation};
use crate::tiling::{Frame, SimplexId, Tiling};
use acutile_exact::geometry::{RingElement, Sign, linear};
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeSet;

/// Hypothesis M. The Gram matrix is positive definite: by Sylvester's criterion,
/// all leading principal minors are positive.
pub fn check_metric<const D: usize>(frame: &Frame<D>, findings: &mut Findings) {
    for order in 1..=D {
        let minor = leading_minor(&frame.gram, order);
        if minor.sign() != Sign::Greater {
            return findings.add(Defect::MetricNotPositive { order, minor });
        }
    }
}

/// The determinant of the upper left block: that of the matrix whose further rows
/// and columns are replaced by those of the identity.
fn leading_minor<const D: usize>(gram: &[[Number; D]; D], order: usize) -> Number {
    let block: [[Number; D]; D] = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i.max(j) < order {
                gram[i][j].clone()
            } else {
                gram[i][j].integer(i64::from(i == j))
            }
        })
    });
    linear::determinant(&block)
}

/// Hypothesis C. There are simplices; each has D + 1 different corners; every
/// vertex is a corner of one.
pub fn check_corners<const D: usize>(tiling: &Tiling<D>, findings: &mut Findings) {
    if tiling.is_empty() {
        findings.add(Defect::NoSimplices);
    }
    let mut used = vec![false; tiling.vertices.len()];
    for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
        for (i, corner) in corners.iter().enumerate() {
            used[corner.vertex.index()] = true;
            if let Some(j) = corners[..i].iter().position(|other| other == corner) {
                findings.add(Defect::RepeatedCorner {
                    simplex,
                    corners: (j, i),
                });
            }
        }
    }
    for (vertex, _) in used.iter().enumerate().filter(|(_, used)| !**used) {
        findings.add(Defect::UnusedVertex { vertex });
    }
}

/// Hypothesis O. Every simplex is positively oriented, hence not flat:
/// det (c_1 - c_0, …, c_D - c_0) > 0. A simplex with a repeated corner has been
/// reported already. Gives the simplices that are flat or negative.
pub fn check_orientation<const D: usize>(model: &Model<D>, findings: &mut Findings) -> Unsided {
    let orientation = model.prepare(Orientation);
    let mut unsided = Unsided::default();
    for &simplex in &model.shapes().not_positive {
        if has_repeated_corner(model.tiling.simplex(simplex)) {
            continue;
        }
        match orientation.signs(simplex).get(0) {
            Sign::Equal => {
                unsided.flat.insert(simplex);
                findings.add(Defect::Flat { simplex });
            }
            _ => {
                unsided.negative.insert(simplex);
                findings.add_with("negative-orientation", || Defect::NegativeOrientation {
                    simplex,
                    determinant: determinant(model.tiling, simplex),
                });
            }
        }
    }
    unsided
}

/// Simplices that lie on the wrong side of their facets, or on none. Other defects follow from
/// that, and are their consequences.
#[derive(Clone, Debug, Default)]
pub struct Unsided {
    /// The simplices of volume zero.
    pub flat: BTreeSet<SimplexId>,
    /// The negatively oriented simplices.
    pub negative: BTreeSet<SimplexId>,
}

impl Unsided {
    /// Whether two simplices on the same side of a facet are on different ones after negative
    /// simplices are turned, or one is flat and on no side.
    pub(super) fn explains(&self, a: SimplexId, b: SimplexId) -> bool {
        let [a_turned, b_turned] = [a, b].map(|s| self.negative.contains(&s));
        a_turned != b_turned || self.flat.contains(&a) || self.flat.contains(&b)
    }
}

fn has_repeated_corner<T: PartialEq>(corners: &[T]) -> bool {
    (1..corners.len()).any(|i| corners[..i].contains(&corners[i]))
}

/// D! times the signed volume of a simplex, in units of the cell.
pub fn determinant<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> Number {
    tiling.shape(simplex).determinant
}

/// Hypothesis V. The volumes sum to the volume of the domain per cell, coordinates
/// in the basis: Σ det (c_1 - c_0, …, c_D - c_0) = D! vol_k(P), where P is the polytope of
/// the domain, a point for all of space. A region has no other volume than this sum.
pub fn check_volume<const D: usize>(model: &Model<D>, findings: &mut Findings) {
    check_volume_beside(model, &Unsided::default(), findings);
}

/// The same for a tiling with negative simplices. A sum that is right after they are turned is a
/// consequence.
pub(super) fn check_volume_beside<const D: usize>(
    model: &Model<D>,
    unsided: &Unsided,
    findings: &mut Findings,
) {
    if model.tiling.frame.domain.is_region() {
        return;
    }
    // 1 / n!
    let share = |n: usize| {
        let factorial = (1..=n as u64).product::<u64>();
        Number::from(Rational::from_unsigneds(1, factorial))
    };
    let sum = model.sum_of_determinants() * share(D);
    let expected = match model.tiling.frame.domain.polytope() {
        None => Number::from(Rational::from(1)),
        Some(polytope) => polytope.scaled_volume() * share(polytope.dimension()),
    };
    if sum == expected {
        return;
    }
    let negative = unsided.negative.iter();
    let negative = negative.fold(Number::zero(), |sum, &simplex| {
        &sum + &determinant(model.tiling, simplex)
    });
    let two = Number::from(Rational::from(2));
    if &sum - &(negative * two * share(D)) == expected {
        findings.add_consequence("volume-sum", 1)
    } else {
        findings.add(Defect::VolumeSum { sum, expected })
    }
}
