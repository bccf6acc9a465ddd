//! The zeros of signs that bisection does not decide, exactly: with one parameter they are the only points at which
//! the family may fail.

use super::conditions::{Conditions, Wanted};
use super::{decimals, point_in_words};
use acutile_exact::number::{Field, Number, over_common_denominator};
use acutile_exact::polynomial::line::{Line, Place};
use acutile_exact::polynomial::{Coefficient, Cuboid};
use malachite::Rational;

/// The most zeros that are computed in a part of the box.
const MOST_ZEROS: usize = 8;
/// The most signs of which zeros are computed. The work grows with their pairs, which may have common factors.
const MOST_SIGNS: usize = 32;
/// Fields of roots of longer polynomials take too long.
const MOST_DEGREE: usize = 16;

/// The zeros in a part of the box of the signs that are not proved there, in order. With several parameters zeros are
/// no points, and the list is empty.
pub fn zeros<C: Coefficient>(conditions: &Conditions<C>, cuboid: &Cuboid) -> Vec<Place> {
    let [side] = cuboid.sides.as_slice() else {
        return Vec::new();
    };
    let atoms = conditions.atoms.iter();
    let undecided =
        atoms.filter(|atom| atom.wanted != Wanted::Zero && atom.is_proved_on(cuboid) != Some(true));
    let polynomials: Vec<_> = undecided
        .take(MOST_SIGNS)
        .map(|atom| atom.polynomial.map(C::to_number))
        .collect();
    Line::new(&polynomials).roots(side, MOST_ZEROS)
}

/// A zero as a number, of the field or of an extension of Q; `None` beyond [`MOST_DEGREE`], and for a polynomial that
/// is not rational.
pub fn number(place: &Place) -> Option<Number> {
    let Place::Root {
        polynomial,
        low,
        high,
    } = place
    else {
        return Some(place.enclosure().0.clone());
    };
    if polynomial.len() > MOST_DEGREE + 1 {
        return None;
    }
    let rational = |x: &Number| x.to_rational().cloned();
    let coefficients: Vec<Rational> = polynomial.iter().map(rational).collect::<Option<_>>()?;
    let (integers, _) = over_common_denominator(&coefficients);
    let (_, root) = Field::adjoin_root(&integers, rational(low)?, rational(high)?).ok()?;
    Some(root)
}

/// `t = 1.414213562..., a root of t^2 - 2`
pub fn in_words(names: &[String], place: &Place) -> String {
    let name = names.first().map_or("", String::as_str);
    match (place, place.polynomial()) {
        (Place::Root { low, .. }, Some(polynomial)) => {
            let polynomial = polynomial.shown(names);
            format!("{name} = {}, a root of {polynomial}", decimals(low))
        }
        _ => point_in_words(names, std::slice::from_ref(place.enclosure().0)),
    }
}
