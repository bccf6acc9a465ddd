//! Conditions about radius-edge ratios: R²/|e|² for the shortest edge e, against n/d.

use super::cleared::{Cleared, Convert};
use super::conditions::{Alternatives, Atom, Conditions};
use crate::format::Relation;
use crate::quality::RadiusEdge;
use crate::tiling::SimplexId;
use acutile_exact::geometry::RingElement;
use acutile_exact::number::Number;
use acutile_exact::polynomial::{Coefficient, Polynomial};
use malachite::Rational;

/// A bound for the ratio of each simplex.
pub fn add_bound<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    relation: Relation,
    bound: &RadiusEdge,
    convert: Convert<C>,
    conditions: &mut Conditions<C>,
) {
    let is_upper = matches!(
        relation,
        Relation::LessThan | Relation::AtMost | Relation::Maximum
    );
    let is_strict = matches!(relation, Relation::LessThan | Relation::MoreThan);
    let mut attained: Alternatives<C> = Vec::new();
    for simplex in cleared.family.simplices() {
        // b |e|² - R² for all edges e.
        let slacks = slacks(cleared, simplex, bound, convert);
        let beyond = |slack: &Polynomial<C>| {
            if is_upper {
                Atom::strict_if(is_strict, slack.clone())
            } else {
                Atom::strict_if(is_strict, slack.negated())
            }
        };
        // The ratio is less than b if R² < b |e|² for all edges, and more if R² > b |e|² for one.
        if is_upper {
            slacks
                .iter()
                .for_each(|slack| conditions.add(beyond(slack)));
        } else {
            conditions.add_alternatives(slacks.iter().map(|slack| vec![beyond(slack)]).collect());
        }
        let equal = slacks.iter().filter(|slack| slack.is_zero());
        attained.extend(equal.map(|slack| {
            let others = slacks.iter().cloned().map(Atom::nonnegative);
            others.chain([Atom::zero(slack.clone())]).collect()
        }));
    }
    if matches!(relation, Relation::Maximum | Relation::Minimum) {
        if attained.is_empty() {
            conditions.add_impossible()
        } else {
            conditions.add_alternatives(attained)
        }
    }
}

/// n |e|² den - d num for all edges, where R² = num/den.
fn slacks<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    simplex: SimplexId,
    bound: &RadiusEdge,
    convert: Convert<C>,
) -> Vec<Polynomial<C>> {
    let unit = Number::common_denominator([&bound.square].into_iter());
    let unit = Number::from(Rational::from(unit));
    let n = Polynomial::constant(convert(&bound.square * &unit));
    let d = Polynomial::constant(convert(unit));
    let simplex = cleared.simplex(simplex);
    let products = simplex.normal_products(&cleared.cogram);
    let (numerator, denominator) = simplex.squared_circumradius(&cleared.gram, &products);
    let (left, right) = (denominator.times(&n), numerator.times(&d));
    let mut slacks = Vec::new();
    simplex.for_squared_edges(&cleared.gram, |edge| {
        slacks.push(left.times(edge).minus(&right));
    });
    slacks
}
