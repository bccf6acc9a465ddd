//! One function for each further statement that a claim may make about a tiling
//! that passed the hypotheses: angles and Delaunay.

use super::defect::{Angle, Defect, Findings};
use super::model::Model;
use crate::classify::{self, NotTcp, Ridges};
use crate::geometry::{NormalProducts, Scalar, Sign, linear};
use crate::number::enclosure;
use crate::quality::{self, ceiling_to_i64, floor_to_i64};
use crate::tiling::{Facet, Matching, Tiling};
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
    let cosine = SquaredCosine::new(ceiling_to_i64(&scaled_cosine(bound).1), &model.unit);
    for_each_angle(model, |simplex, i, j, products| {
        if cosine.compared_with(products, i, j) != Sign::Greater {
            let angle = angle(model, simplex, (i, j));
            findings.add(Defect::AngleNotBelow {
                angle,
                bound: bound.clone(),
            });
        }
    });
}

/// Every dihedral angle t is more than `bound` degrees: cos t < c for a rational
/// c <= cos(bound).
pub fn check_dihedral_above<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    bound: &Rational,
    findings: &mut Findings,
) {
    let cosine = SquaredCosine::new(floor_to_i64(&scaled_cosine(bound).0), &model.unit);
    for_each_angle(model, |simplex, i, j, products| {
        if cosine.compared_with(products, i, j) != Sign::Less {
            let angle = angle(model, simplex, (i, j));
            findings.add(Defect::AngleNotAbove {
                angle,
                bound: bound.clone(),
            });
        }
    });
}

/// Rounding the cosine to this many binary digits keeps the products small; an
/// angle within about 1e-8 degrees of the bound is not proved to be beyond it.
const COSINE_BITS: u64 = 31;

/// Bounds of the cosine of an angle in degrees, times 2^COSINE_BITS.
fn scaled_cosine(degrees: &Rational) -> (Rational, Rational) {
    let scale = Rational::from(1i64 << COSINE_BITS);
    let (low, high) = enclosure::cos_of_degrees(degrees, &(Rational::from_signeds(1, 4) / &scale));
    (low * &scale, high * &scale)
}

/// sign(c) and c² = n² / 2^(2 COSINE_BITS) for a rational c.
struct SquaredCosine<S> {
    sign: Sign,
    numerator_squared: S,
    denominator_squared: S,
}

impl<S: Scalar> SquaredCosine<S> {
    fn new(numerator: i64, like: &S) -> Self {
        let square = |n: i64| like.integer(n).times(&like.integer(n));
        SquaredCosine {
            sign: numerator.cmp(&0),
            numerator_squared: square(numerator),
            denominator_squared: square(1i64 << COSINE_BITS),
        }
    }

    /// cos t compared with c. Both have a sign; with equal signs the squares decide,
    /// cos² t = <g_i, g_j>² / (<g_i, g_i> <g_j, g_j>).
    fn compared_with(&self, products: &NormalProducts<S>, i: usize, j: usize) -> Sign {
        let product = products.get(i, j);
        let cosine_sign = product.sign().reverse();
        if cosine_sign != self.sign {
            return cosine_sign.cmp(&self.sign);
        }
        let left = product.times(product).times(&self.denominator_squared);
        let right = products
            .get(i, i)
            .times(products.get(j, j))
            .times(&self.numerator_squared);
        match cosine_sign {
            Sign::Less => right.minus(&left).sign(),
            Sign::Equal => Sign::Equal,
            Sign::Greater => left.minus(&right).sign(),
        }
    }
}

/// The circumradius of every simplex is less than `bound` times its shortest edge:
/// R² < bound² |e|² for all its edges e.
pub fn check_radius_edge_below<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    bound: &Rational,
    findings: &mut Findings,
) {
    let field = &model.tiling.frame.field;
    let square = bound * bound;
    let [p, q] = [square.numerator_ref(), square.denominator_ref()]
        .map(|n| (model.from_number)(&field.rational(Rational::from(n))));
    for simplex in 0..model.tiling.len() {
        let shape = model.simplex(simplex);
        let products = shape.normal_products(&model.cogram);
        let (numerator, denominator) = shape.squared_circumradius(&model.gram, &products);
        let (left, right) = (numerator.times(&q), denominator.times(&p));
        let is_below = |edge: &S| right.times(edge).minus(&left).sign() == Sign::Greater;
        if !shape.squared_edges(&model.gram).iter().all(is_below) {
            let squared_ratio = quality::measures(model.tiling, simplex).radius_edge.square;
            findings.add(Defect::RatioNotBelow {
                simplex,
                squared_ratio,
                bound: bound.clone(),
            });
        }
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
    if let Err(reason) = classify::check_tcp(tiling, &Ridges::of(tiling, matching)) {
        findings.add(Defect::NotTcp { reason });
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
