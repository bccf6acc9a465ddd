//! One function for each further statement that a claim may make about a tiling
//! that passed the hypotheses: angles and Delaunay.

use super::defect::{Angle, Defect};
use super::findings::Findings;
use crate::classify::{self, NotTcp, Ridges};
use crate::predicates::{AnglesAgainst, InSphere, Model, Prepared, RadiusAgainst, Shape};
use crate::quality::{self, DihedralAngle, compare_with_degrees};
use crate::tiling::{Facet, Matching, SimplexId, Tiling};
use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::{Number, enclosure};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::PowerOf2;
use std::cmp::Ordering;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// The reason why each simplex has its angles here. Statements are decided after the orientations, and simplices that
/// fail a statement are sought only among those that are not flat.
const NOT_FLAT: &str = "the simplices that were found to be flat are no part of this";

/// Every dihedral angle is acute: <g_i, g_j> < 0 for all facets i ≠ j.
pub fn check_acute<const D: usize>(model: &Model<D>, findings: &mut Findings) {
    let shape = model.prepare(Shape);
    for &simplex in &model.shapes().not_acute {
        let (_, signs) = shape.signs(simplex).split_first();
        for (index, pair) in pairs(D).enumerate() {
            let evidence = || angle(model.tiling, simplex, pair);
            match signs.get(index) {
                Sign::Less => {}
                Sign::Equal => {
                    findings.add_with("right-angle", || Defect::RightAngle { angle: evidence() })
                }
                Sign::Greater => {
                    findings.add_with("obtuse-angle", || Defect::ObtuseAngle { angle: evidence() })
                }
            }
        }
    }
}

/// No dihedral angle is obtuse: <g_i, g_j> <= 0 for all facets i ≠ j.
pub fn check_nonobtuse<const D: usize>(model: &Model<D>, findings: &mut Findings) {
    let shape = model.prepare(Shape);
    for &simplex in &model.shapes().obtuse {
        let (_, signs) = shape.signs(simplex).split_first();
        for (_, pair) in (0..).zip(pairs(D)).filter(|(k, _)| signs.get(*k).is_gt()) {
            findings.add_with("obtuse-angle", || Defect::ObtuseAngle {
                angle: angle(model.tiling, simplex, pair),
            });
        }
    }
}

/// The dihedral angles that are not less than `bound` degrees.
pub fn list_not_below<const D: usize>(model: &Model<D>, bound: &Rational, findings: &mut Findings) {
    let (low, high) = enclosure::cos_of_degrees(bound, &cosine_width());
    // cos t <= high is necessary for t >= bound, and cos t <= low is sufficient.
    let [needed, enough] = [high, low].map(|c| model.prepare(against(&c)));
    for simplex in needed.failing(|signs| signs.all_positive()) {
        let (needed, enough) = (needed.signs(simplex), enough.signs(simplex));
        for (k, pair) in pairs(D).enumerate().filter(|(k, _)| needed.get(*k).is_le()) {
            let exact = || compare(model.tiling, simplex, pair, bound) != Ordering::Less;
            if enough.get(k).is_le() || exact() {
                findings.add_with("angle-not-below", || Defect::AngleNotBelow {
                    angle: angle(model.tiling, simplex, pair),
                    bound: bound.clone(),
                });
            }
        }
    }
}

/// The dihedral angles that are not more than `bound` degrees.
pub fn list_not_above<const D: usize>(model: &Model<D>, bound: &Rational, findings: &mut Findings) {
    let (low, high) = enclosure::cos_of_degrees(bound, &cosine_width());
    // cos t >= low is necessary for t <= bound, and cos t >= high is sufficient.
    let [needed, enough] = [low, high].map(|c| model.prepare(against(&c)));
    for simplex in needed.failing(|signs| signs.all_negative()) {
        let (needed, enough) = (needed.signs(simplex), enough.signs(simplex));
        for (k, pair) in pairs(D).enumerate().filter(|(k, _)| needed.get(*k).is_ge()) {
            let exact = || compare(model.tiling, simplex, pair, bound) != Ordering::Greater;
            if enough.get(k).is_ge() || exact() {
                findings.add_with("angle-not-above", || Defect::AngleNotAbove {
                    angle: angle(model.tiling, simplex, pair),
                    bound: bound.clone(),
                });
            }
        }
    }
}

/// The width of the enclosures that sort most angles.
fn cosine_width() -> Rational {
    Rational::power_of_2(-60i64)
}

/// Angles compared with the one that has this cosine.
fn against(cosine: &Rational) -> AnglesAgainst {
    AnglesAgainst::new(&DihedralAngle::of_cosine(cosine).signed_square)
}

/// A dihedral angle compared with a bound in degrees.
fn compare<const D: usize>(
    tiling: &Tiling<D>,
    simplex: SimplexId,
    (i, j): (usize, usize),
    bound: &Rational,
) -> Ordering {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(simplex).normal_products(&cogram);
    let angle = DihedralAngle::between(&products, i, j).expect(NOT_FLAT);
    compare_with_degrees(&angle, bound)
}

/// The simplices whose circumradius is not less than `bound` times the shortest edge: not
/// R² < bound² |e|² for all edges e.
pub fn list_not_below_ratio<const D: usize>(
    model: &Model<D>,
    bound: &Rational,
    findings: &mut Findings,
) {
    let square = Number::from(bound * bound);
    let radii = model.prepare(RadiusAgainst::new(&square));
    for simplex in radii.failing(|signs| signs.all_positive()) {
        findings.add_with("ratio-not-below", || Defect::RatioNotBelow {
            simplex,
            squared_ratio: quality::measures(model.tiling, simplex)
                .expect(NOT_FLAT)
                .radius_edge
                .square,
            bound: bound.clone(),
        });
    }
}

/// Tetrahedrally close packed: every edge is in 5 or 6 tetrahedra, and no triangle has
/// two edges that are in 6. Only for all of three-space.
pub fn check_tcp<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    findings: &mut Findings,
) {
    if D != 3 {
        return findings.add(Defect::NotTcp {
            reason: NotTcp::Dimension,
        });
    }
    if classify::six_valent(tiling, matching).is_some() {
        return;
    }
    findings.add_with("not-tcp", || {
        let reason = classify::check_tcp(tiling, &Ridges::of(tiling, matching));
        Defect::NotTcp {
            // It fails, for the two agree on tilings.
            reason: reason.err().unwrap_or(NotTcp::Dimension),
        }
    });
}

/// The pairs i < j of facets, in the order of the values of [`Angles`].
fn pairs(dimension: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=dimension).flat_map(move |i| (i + 1..=dimension).map(move |j| (i, j)))
}

/// The exact evidence about one angle, in the units of the tiling's own numbers.
fn angle<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId, facets: (usize, usize)) -> Angle {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(simplex).normal_products(&cogram);
    Angle {
        simplex,
        facets,
        product: products.get(facets.0, facets.1).clone(),
        degrees: quality::dihedral_degrees(&products, facets, &quality::display_width())
            .expect(NOT_FLAT),
    }
}

/// Local Delaunay property: across every facet the neighbour's opposite corner
/// lies outside of the circumsphere (on it is allowed in the weak form). For a
/// tiling this implies the global one (docs/soundness.md).
pub fn check_delaunay<const D: usize>(
    model: &Model<D>,
    matching: &Matching<D>,
    weak: bool,
    findings: &mut Findings,
) {
    let tiling = model.tiling;
    let spheres = model.prepare(InSphere);
    for simplex in suspects(matching, &spheres, weak) {
        for facet in (0..=D).map(|k| Facet::new(simplex, k)) {
            let Some(apex) = matching.apex(tiling, facet) else {
                continue;
            };
            match spheres.signs_with(simplex, &apex).get(0) {
                Sign::Greater => {}
                Sign::Equal if weak => {}
                sign => add_sphere(tiling, matching, facet, sign, findings),
            }
        }
    }
}

/// Whether the local Delaunay property holds in its strict form, in its weak form, or in neither
/// (`None`): one pass over all pairs.
pub(super) fn is_strictly_delaunay<const D: usize>(
    model: &Model<D>,
    matching: &Matching<D>,
) -> Option<bool> {
    let touches = AtomicBool::new(false);
    let failing = model
        .prepare(InSphere)
        .failing_pairs(matching, |_, _, sign| {
            if sign == Sign::Equal {
                touches.store(true, Relaxed);
            }
            sign != Sign::Less
        });
    failing.is_empty().then(|| !touches.into_inner())
}

/// The simplices, in order, that fail with a neighbour, and their neighbours.
fn suspects<const D: usize>(
    matching: &Matching<D>,
    spheres: &Prepared<InSphere, D>,
    weak: bool,
) -> Vec<SimplexId> {
    let is_right = |_, _, sign| sign == Sign::Greater || weak && sign == Sign::Equal;
    let mut suspects = spheres.failing_pairs(matching, is_right);
    for k in 0..suspects.len() {
        let behind = |opposite| matching.neighbour(Facet::new(suspects[k], opposite));
        let neighbours: Vec<SimplexId> = (0..=D)
            .filter_map(behind)
            .map(|mate| mate.simplex)
            .collect();
        suspects.extend(neighbours);
    }
    suspects.sort_unstable();
    suspects.dedup();
    suspects
}

fn add_sphere<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    facet: Facet,
    sign: Sign,
    findings: &mut Findings,
) {
    let Some(mate) = matching.neighbour(facet) else {
        return;
    };
    let (simplex, neighbour) = (facet.simplex, mate.simplex);
    if sign == Sign::Equal {
        return findings.add(Defect::OnCircumsphere { facet, neighbour });
    }
    findings.add_with("inside-circumsphere", || {
        let apex = matching.apex(tiling, facet);
        let origin = &tiling.simplex(simplex)[0];
        let position = tiling.position(&apex.unwrap_or(*origin));
        let offset = linear::subtract(&position, &tiling.position(origin));
        Defect::InsideCircumsphere {
            facet,
            neighbour,
            power: tiling.shape(simplex).power(&tiling.frame.gram, &offset),
        }
    });
}
