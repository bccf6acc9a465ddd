//! The largest interval around a point in which a family has the required statements, exactly. With several
//! parameters it is a box that cannot grow on any side by a given fraction.
//!
//! The interval or box is not bounded by the family's own box.

use super::candidates::candidates;
use super::cleared::{Convert, to_integer, to_number};
use super::conditions::{Atom, Conditions};
use super::examine::{Examination, NotProvable};
use super::tree::{COST_LIMIT, Effort, Tree, grow};
use super::{Family, FamilyError};
use crate::checker::{self, Options};
use crate::statement::Statement;
use acutile_exact::number::Number;
use acutile_exact::polynomial::line::{Extent, Line, Place};
use acutile_exact::polynomial::{Coefficient, Cuboid, End, Side};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::PowerOf2;
use malachite::rational::rational::arithmetic::traits::SimplestRationalInInterval;

/// The result around a point.
#[derive(Clone, Debug)]
pub enum Maximal {
    /// With one parameter: the exact ends.
    Interval(Extent, Extent),
    /// With several: proved, and no side can be moved out by this fraction of the length.
    Box(Rational),
}

/// Boxes are proved with at most this many leaves.
const LEAVES: usize = 16;

/// The largest interval or box around a point, which has a coordinate for each parameter, and a box to
/// prove. There an end that is no number of the field is replaced by a rational number inside.
///
/// # Errors
/// If the member at the point is refuted, or no box around it is proved.
pub fn maximal<const D: usize>(
    family: &Family<D>,
    point: &[Number],
    options: &Options,
    fraction: &Rational,
) -> Result<(Maximal, Cuboid), NotProvable> {
    if point.len() != family.parameters.len() {
        return Err(NotProvable::Malformed(FamilyError::Point(
            point.len(),
            family.parameters.len(),
        )));
    }
    if family.frame.field.is_rationals() && point.iter().all(Number::is_rational) {
        around(family, point, options, fraction, to_integer)
    } else {
        around(family, point, options, fraction, to_number)
    }
}

fn around<C: Coefficient, const D: usize>(
    family: &Family<D>,
    point: &[Number],
    options: &Options,
    fraction: &Rational,
    convert: Convert<C>,
) -> Result<(Maximal, Cuboid), NotProvable> {
    let member = family.at(point);
    let proof = checker::examine(&member, options, &|_| {});
    let proof = proof.map_err(|findings| NotProvable::Refuted {
        point: point.to_vec(),
        findings,
    })?;
    let examination = Examination::new(family, point, &member, &proof, convert);
    let mut all = vec![examination.of_hypotheses()];
    let required = options.required.iter().filter_map(|r| candidates(r).pop());
    let mut statements: Vec<Statement> = required.collect();
    if statements.is_empty() {
        let angles = [Statement::Acute, Statement::Nonobtuse];
        statements.extend(angles.into_iter().find(|s| proof.statements.contains(s)));
    }
    all.extend(statements.iter().filter_map(|s| examination.conditions(s)));
    match (point, family.parameters.as_slice()) {
        ([point], [parameter]) => {
            let (low, high) = interval(&all, point)?;
            let side = to_prove(&low, &high, point, &parameter.side);
            let sides = vec![side];
            Ok((Maximal::Interval(low, high), Cuboid { sides }))
        }
        _ => {
            let cuboid = grown(&all, point, &family.cuboid(), fraction)?;
            Ok((Maximal::Box(fraction.clone()), cuboid))
        }
    }
}

fn interval<C: Coefficient>(
    all: &[Conditions<C>],
    point: &Number,
) -> Result<(Extent, Extent), NotProvable> {
    let atoms: Vec<&Atom<C>> = all
        .iter()
        .flat_map(|conditions| &conditions.atoms)
        .collect();
    let polynomials: Vec<_> = atoms
        .iter()
        .map(|a| a.polynomial.map(C::to_number))
        .collect();
    let line = Line::new(&polynomials);
    let found = line.maximal(point, |signs| {
        let mut first = 0;
        all.iter().all(|conditions| {
            let signs = &signs[first..];
            first += conditions.atoms.len();
            conditions.hold(|k| conditions.atoms[k].wanted.allows(signs[k]))
        })
    });
    found.ok_or_else(|| NotProvable::Declined("a sign is wrong at the point itself".to_owned()))
}

/// The interval as a side of a box.
fn to_prove(low: &Extent, high: &Extent, point: &Number, given: &Side) -> Side {
    let one = Number::from(Rational::from(1));
    Side {
        low: match low {
            Extent::Unbounded if given.low.value < *point => given.low.clone(),
            Extent::Unbounded => End::closed(point - &one),
            Extent::At { place, is_open } => match place {
                Place::Number(value) => End {
                    value: value.clone(),
                    is_open: *is_open,
                },
                Place::Root { high, .. } => End::closed(between(high, point)),
            },
        },
        high: match high {
            Extent::Unbounded if given.high.value > *point => given.high.clone(),
            Extent::Unbounded => End::closed(point + &one),
            Extent::At { place, is_open } => match place {
                Place::Number(value) => End {
                    value: value.clone(),
                    is_open: *is_open,
                },
                Place::Root { low, .. } => End::closed(between(low, point)),
            },
        },
    }
}

/// A short rational number beside an end, a millionth of the way to the point.
fn between(end: &Number, point: &Number) -> Number {
    let (near, _) = end.enclosure(&Rational::power_of_2(-80i64));
    let (target, _) = point.enclosure(&Rational::power_of_2(-80i64));
    let far = &near + (&target - &near) * Rational::from_signeds(1, 1_000_000);
    let nearer = &near + (&target - &near) * Rational::from_signeds(1, 10_000_000);
    let (low, high) = if far < nearer {
        (far, nearer)
    } else {
        (nearer, far)
    };
    Number::from(Rational::simplest_rational_in_closed_interval(&low, &high))
}

/// A proved box around the point that is grown side by side.
fn grown<C: Coefficient>(
    all: &[Conditions<C>],
    point: &[Number],
    given: &Cuboid,
    fraction: &Rational,
) -> Result<Cuboid, NotProvable> {
    let holds = |cuboid: &Cuboid| {
        let mut conditions = all.iter();
        let effort = Effort {
            leaves: LEAVES,
            cost: COST_LIMIT / 4,
            report: &|_, _| {},
        };
        conditions.all(|c| grow(c, cuboid, &Tree::Leaf, &effort).is_ok())
    };
    let mut cuboid = first(point, given, holds)?;
    let fraction = Number::from(fraction.clone());
    let mut has_grown = true;
    let mut rounds = 0;
    while has_grown && rounds < ROUNDS {
        has_grown = false;
        rounds += 1;
        for axis in 0..cuboid.sides.len() {
            for is_high in [false, true] {
                let mut step = &cuboid.sides[axis].length() * &fraction;
                loop {
                    let wider = moved(&cuboid, axis, is_high, &step);
                    if !holds(&wider) {
                        break;
                    }
                    has_grown = true;
                    cuboid = wider;
                    // Other sides come before this one has grown much.
                    if step
                        > cuboid.sides[axis].length() * Number::from(Rational::from_signeds(1, 4))
                    {
                        break;
                    }
                    step = &step + &step;
                }
            }
        }
    }
    if has_grown {
        Err(NotProvable::Declined(format!(
            "the box grows without end; {ROUNDS} rounds were made"
        )))
    } else {
        Ok(cuboid)
    }
}

/// Rounds of growth.
const ROUNDS: usize = 60;
/// Halvings of the first box.
const HALVINGS: usize = 40;

/// A small box around the point, in the proportions of the given one.
fn first(
    point: &[Number],
    given: &Cuboid,
    holds: impl Fn(&Cuboid) -> bool,
) -> Result<Cuboid, NotProvable> {
    let mut scale = Rational::from_signeds(1, 16);
    for _ in 0..HALVINGS {
        let factor = Number::from(scale.clone());
        let sides = point.iter().zip(&given.sides).map(|(x, side)| {
            let reach = side.length() * &factor;
            Side {
                low: End::closed(x - &reach),
                high: End::closed(x + &reach),
            }
        });
        let cuboid = Cuboid {
            sides: sides.collect(),
        };
        if holds(&cuboid) {
            return Ok(cuboid);
        }
        scale >>= 1u32;
    }
    Err(NotProvable::Declined(
        "no box around the point is proved: a sign vanishes there".to_owned(),
    ))
}

/// A side of the box moved out by about this much: to a short number.
fn moved(cuboid: &Cuboid, axis: usize, is_high: bool, step: &Number) -> Cuboid {
    let mut moved = cuboid.clone();
    let side = &mut moved.sides[axis];
    let slack = Number::from(Rational::from_signeds(17, 16));
    let (end, ends) = if is_high {
        (&mut side.high, [step.clone(), step * &slack])
    } else {
        (&mut side.low, [-step, -(step * &slack)])
    };
    let [near, far] = ends.map(|step| &end.value + &step);
    let (low, high) = if near < far { (near, far) } else { (far, near) };
    end.value = match (low.to_rational(), high.to_rational()) {
        (Some(low), Some(high)) => {
            Number::from(Rational::simplest_rational_in_closed_interval(low, high))
        }
        _ => low,
    };
    moved
}
