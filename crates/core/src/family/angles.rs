//! Conditions about dihedral angles.
//!
//! The angle between the facets i and j has cos t = p/√q with p = -<g_i, g_j> and
//! q = <g_i, g_i> <g_j, g_j> > 0. The bound has the cosine s √(n/d) with s = -1, 0 or 1.

use super::cleared::{Cleared, Convert};
use super::conditions::{Alternatives, Atom, Conditions, both};
use crate::format::Relation;
use crate::quality::DihedralAngle;
use crate::tiling::SimplexId;
use acutile_exact::geometry::{RingElement, Sign};
use acutile_exact::number::Number;
use acutile_exact::polynomial::{Coefficient, Polynomial};
use malachite::Rational;

/// p and q of an angle.
#[derive(Clone, Debug)]
pub struct Cosine<C> {
    p: Polynomial<C>,
    q: Polynomial<C>,
}

/// The bound: s, n and d.
#[derive(Clone, Debug)]
pub struct Bound<C> {
    sign: Sign,
    n: Polynomial<C>,
    d: Polynomial<C>,
}

impl<C: Coefficient> Bound<C> {
    /// The bound that is this angle.
    pub fn of(angle: &DihedralAngle, convert: Convert<C>) -> Self {
        let square = angle.signed_square.abs();
        let unit = Number::from(Rational::from(Number::common_denominator(
            [&square].into_iter(),
        )));
        Bound {
            sign: angle.signed_square.sign(),
            n: Polynomial::constant(convert(&square * &unit)),
            d: Polynomial::constant(convert(unit)),
        }
    }

    fn negated(&self) -> Self {
        Bound {
            sign: self.sign.reverse(),
            ..self.clone()
        }
    }
}

impl<C: Coefficient> Cosine<C> {
    fn negated(&self) -> Self {
        Cosine {
            p: self.p.negated(),
            q: self.q.clone(),
        }
    }

    /// p² d - n q
    fn excess(&self, bound: &Bound<C>) -> Polynomial<C> {
        let square = self.p.times(&self.p).times(&bound.d);
        square.minus(&self.q.times(&bound.n))
    }

    /// cos t is larger than the bound, or at least it is: the angle is smaller, or at most.
    fn is_above(&self, bound: &Bound<C>, is_strict: bool) -> Alternatives<C> {
        let p = || self.p.clone();
        match bound.sign {
            Sign::Equal => vec![vec![Atom::strict_if(is_strict, p())]],
            Sign::Greater => vec![vec![
                Atom::positive(p()),
                Atom::strict_if(is_strict, self.excess(bound)),
            ]],
            Sign::Less => vec![
                vec![Atom::nonnegative(p())],
                vec![
                    Atom::nonnegative(p().negated()),
                    Atom::strict_if(is_strict, self.excess(bound).negated()),
                ],
            ],
        }
    }

    fn is_below(&self, bound: &Bound<C>, is_strict: bool) -> Alternatives<C> {
        self.negated().is_above(&bound.negated(), is_strict)
    }

    /// cos t is the bound at every point; `None` if it is not.
    fn is_equal(&self, bound: &Bound<C>) -> Option<Vec<Atom<C>>> {
        match bound.sign {
            Sign::Equal => self.p.is_zero().then(|| vec![Atom::zero(self.p.clone())]),
            sign => {
                let p = if sign == Sign::Less {
                    self.p.negated()
                } else {
                    self.p.clone()
                };
                let excess = self.excess(bound);
                excess
                    .is_zero()
                    .then(|| vec![Atom::positive(p), Atom::zero(excess)])
            }
        }
    }
}

/// The angles of all simplices.
pub fn of_simplices<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
) -> Vec<Vec<Cosine<C>>> {
    let angles = |simplex: SimplexId| {
        let products = cleared.simplex(simplex).normal_products(&cleared.cogram);
        let cosine = |(i, j, product): (usize, usize, &Polynomial<C>)| Cosine {
            p: product.negated(),
            q: products.get(i, i).times(products.get(j, j)),
        };
        products.pairs().map(cosine).collect()
    };
    cleared.family.simplices().map(angles).collect()
}

/// Acute, or nonobtuse.
pub fn add_acute<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    is_strict: bool,
    conditions: &mut Conditions<C>,
) {
    for simplex in cleared.family.simplices() {
        let products = cleared.simplex(simplex).normal_products(&cleared.cogram);
        products.for_pairs(|_, _, product| {
            conditions.add(Atom::strict_if(is_strict, product.negated()));
        });
    }
}

/// A bound for the largest angle of each simplex, or for the smallest.
pub fn add_bound<C: Coefficient>(
    angles: &[Vec<Cosine<C>>],
    is_largest: bool,
    relation: Relation,
    bound: &Bound<C>,
    conditions: &mut Conditions<C>,
) {
    let is_upper = matches!(
        relation,
        Relation::LessThan | Relation::AtMost | Relation::Maximum
    );
    let is_strict = matches!(relation, Relation::LessThan | Relation::MoreThan);
    let compare = |angle: &Cosine<C>| {
        if is_upper {
            angle.is_above(bound, is_strict)
        } else {
            angle.is_below(bound, is_strict)
        }
    };
    for simplex in angles {
        // All angles are at most B exactly if the largest is; one is exactly if the smallest is.
        let each = simplex.iter().map(compare);
        if is_upper == is_largest {
            each.for_each(|alternatives| conditions.add_alternatives(alternatives));
        } else {
            conditions.add_alternatives(each.flatten().collect());
        }
    }
    if matches!(relation, Relation::Maximum | Relation::Minimum) {
        let attained = angles
            .iter()
            .flat_map(|s| attained(s, is_largest, is_upper, bound));
        let attained: Alternatives<C> = attained.collect();
        if attained.is_empty() {
            conditions.add_impossible()
        } else {
            conditions.add_alternatives(attained)
        }
    }
}

/// The largest or smallest angle of a simplex is the bound: one is, and no other is beyond. Where
/// the bound holds for all angles of all simplices, nothing is beyond.
fn attained<C: Coefficient>(
    simplex: &[Cosine<C>],
    is_largest: bool,
    is_upper: bool,
    bound: &Bound<C>,
) -> Alternatives<C> {
    let equal: Alternatives<C> = simplex.iter().filter_map(|a| a.is_equal(bound)).collect();
    if equal.is_empty() || is_largest == is_upper {
        return equal;
    }
    let all = simplex.iter().try_fold(equal, |all, angle| {
        both(
            &all,
            &if is_largest {
                angle.is_above(bound, false)
            } else {
                angle.is_below(bound, false)
            },
        )
    });
    all.unwrap_or_default()
}
