//! One function for each further statement that a claim may make about a tiling
//! that passed the hypotheses: angles and Delaunay.

use super::defect::{Angle, Defect, Findings};
use super::model::Model;
use crate::geometry::{NormalProducts, Scalar, Sign, linear};
use crate::number::enclosure;
use crate::quality;
use crate::tiling::{Facet, Matching};
use malachite::Rational;

/// Every dihedral angle is acute: <g_i, g_j> < 0 for all facets i ≠ j.
pub fn check_acute<S: Scalar, const D: usize>(model: &Model<S, D>, findings: &mut Findings) {
    for_each_angle(model, |simplex, i, j, products| {
        match products.get(i, j).sign() {
            Sign::Less => {}
            Sign::Equal => {
                findings.add(Defect::RightAngle {
                    angle: angle(model, simplex, (i, j)),
                });
            }
            Sign::Greater => {
                findings.add(Defect::ObtuseAngle {
                    angle: angle(model, simplex, (i, j)),
                });
            }
        }
    });
}

/// No dihedral angle is obtuse: <g_i, g_j> <= 0 for all facets i ≠ j.
pub fn check_nonobtuse<S: Scalar, const D: usize>(model: &Model<S, D>, findings: &mut Findings) {
    for_each_angle(model, |simplex, i, j, products| {
        if products.get(i, j).sign() == Sign::Greater {
            findings.add(Defect::ObtuseAngle {
                angle: angle(model, simplex, (i, j)),
            });
        }
    });
}

/// Every dihedral angle t is less than `bound` degrees. With a rational
/// c >= cos(bound) it suffices that cos t > c, where
/// cos t = -<g_i, g_j> / (|g_i| |g_j|).
pub fn check_dihedral_below<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    bound: &Rational,
    findings: &mut Findings,
) {
    let cosine = CosineBound::new(bound, &model.unit);
    for_each_angle(model, |simplex, i, j, products| {
        if !cosine.is_exceeded(products, i, j) {
            let angle = angle(model, simplex, (i, j));
            findings.add(Defect::AngleNotBelow {
                angle,
                bound: bound.clone(),
            });
        }
    });
}

/// Rounding the cosine up to this many binary digits keeps the products small; an
/// angle within about 1e-8 degrees of the bound is not proved to be below it.
const COSINE_BITS: u64 = 31;

/// sign(c) and c² = n² / 2^(2 COSINE_BITS) for a rational c >= cos(bound).
struct CosineBound<S> {
    sign: Sign,
    numerator_squared: S,
    denominator_squared: S,
}

impl<S: Scalar> CosineBound<S> {
    fn new(bound: &Rational, like: &S) -> Self {
        let denominator = 1i64 << COSINE_BITS;
        let width = Rational::from_signeds(1, 4 * denominator);
        let (_, upper) = enclosure::cos_of_degrees(bound, &width);
        let numerator = quality::ceiling_to_i64(&(upper * Rational::from(denominator)));
        let square = |n: i64| like.integer(n).times(&like.integer(n));
        CosineBound {
            sign: numerator.cmp(&0),
            numerator_squared: square(numerator),
            denominator_squared: square(denominator),
        }
    }

    /// Whether cos t > c. Both sides have a sign; with equal signs the squares
    /// decide, cos² t = <g_i, g_j>² / (<g_i, g_i> <g_j, g_j>).
    fn is_exceeded(&self, products: &NormalProducts<S>, i: usize, j: usize) -> bool {
        let product = products.get(i, j);
        let cosine_sign = product.sign().reverse();
        if cosine_sign != self.sign {
            return cosine_sign > self.sign;
        }
        let left = product.times(product).times(&self.denominator_squared);
        let right = products
            .get(i, i)
            .times(products.get(j, j))
            .times(&self.numerator_squared);
        match cosine_sign {
            Sign::Greater => left.minus(&right).sign() == Sign::Greater,
            Sign::Less => left.minus(&right).sign() == Sign::Less,
            Sign::Equal => false,
        }
    }
}

/// Calls `visit` with every simplex, every pair of its facets, and its products.
fn for_each_angle<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    mut visit: impl FnMut(usize, usize, usize, &NormalProducts<S>),
) {
    for simplex in 0..model.tiling.len() {
        let products = model.simplex(simplex).normal_products(&model.cogram);
        for i in 0..=D {
            for j in i + 1..=D {
                visit(simplex, i, j, &products);
            }
        }
    }
}

/// The exact evidence about one angle, in the units of the tiling's own numbers.
fn angle<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    simplex: usize,
    facets: (usize, usize),
) -> Angle {
    let cogram = linear::cofactors(&model.tiling.frame.gram);
    let products = model.tiling.shape(simplex).normal_products(&cogram);
    Angle {
        simplex,
        facets,
        product: products.get(facets.0, facets.1).clone(),
        degrees: quality::dihedral_degrees(&products, facets, &quality::display_width()),
    }
}

/// Local Delaunay property: behind every facet the neighbour's opposite corner
/// lies outside of the circumsphere (on it is allowed in the weak form). For a
/// tiling this implies the global one (docs/soundness.md).
pub fn check_delaunay<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    matching: &Matching<D>,
    weak: bool,
    findings: &mut Findings,
) {
    for simplex in 0..model.tiling.len() {
        let shape = model.simplex(simplex);
        let corners = model.tiling.simplex(simplex);
        let origin = model.position(&corners[0]);
        for opposite in 0..=D {
            let Some(mate) = &matching.mates[simplex * (D + 1) + opposite] else {
                continue;
            };
            let neighbour = mate.facet.simplex as usize;
            let apex =
                model.tiling.simplex(neighbour)[usize::from(mate.facet.opposite)].moved(mate.shift);
            let offset = linear::subtract(&model.position(&apex), &origin);
            let facet = Facet {
                simplex: simplex as u32,
                opposite: opposite as u8,
            };
            match shape.power(&model.gram, &offset).sign() {
                Sign::Greater => {}
                Sign::Equal if weak => {}
                Sign::Equal => findings.add(Defect::OnCircumsphere { facet, neighbour }),
                Sign::Less => {
                    let tiling = model.tiling;
                    let position = tiling.position(&apex);
                    let offset = linear::subtract(&position, &tiling.position(&corners[0]));
                    let power = tiling.shape(simplex).power(&tiling.frame.gram, &offset);
                    findings.add(Defect::InsideCircumsphere {
                        facet,
                        neighbour,
                        power,
                    });
                }
            }
        }
    }
}
