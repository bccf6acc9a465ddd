//! `acutile certify` for families: a tiling for each point of a box of parameters.

use super::answer::{Answer, Written, unwritten};
use super::certify_arguments::{CertifyArguments, FamilyArguments};
use super::named::InputError;
use super::outcome::Outcome;
use super::progress::Progress;
use super::prove::encoding;
use super::refutation::{Refuted, SecondLook};
use super::target::Target;
use acutile_core::checker::Options;
use acutile_core::family::free::{self, Free};
use acutile_core::family::maximal::{self, Maximal};
use acutile_core::family::{
    self, AnyFamily, FamilyNotProved, NotProvable, Parameter, ProvedFamily, decimals,
    point_in_words,
};
use acutile_core::refusal;
use acutile_core::tiling::{AnyPointSet, AnyTiling};
use acutile_core::with_family;
use acutile_exact::number::{Number, numbers, parse_rational};
use acutile_exact::polynomial::line::{Extent, Place};
use acutile_exact::polynomial::{End, Side};
use acutile_io::import::crystal::{Interval, Variation};
use malachite::Rational;
use std::borrow::Cow;

/// The input to which options for boxes of parameters may not apply.
#[derive(Clone, Copy, Debug)]
pub enum Subject {
    /// A theorem about all members of a construction.
    Theorem,
    /// A tiling with parameters.
    Family,
    /// A tiling without parameters.
    Tiling,
}

impl FamilyArguments {
    /// Refuses options that would be ignored.
    ///
    /// # Errors
    /// The option, the cause and a way out.
    pub fn check(&self, subject: Subject) -> Result<(), String> {
        let maximal = ("--maximal", self.maximal.is_some());
        let free = ("--free", !self.free.is_empty());
        let within = ("--within-su", self.within_su);
        let (options, reason) = match subject {
            Subject::Theorem => (
                vec![maximal, free, within],
                "this is a theorem about all members, and has no parameters; leave the option out",
            ),
            Subject::Family => (
                vec![free],
                "this is a family already; add parameters to its file, or leave the option out",
            ),
            Subject::Tiling if !free.1 && !within.1 => (
                vec![maximal],
                "this tiling has no parameters; --free with --radius makes some",
            ),
            Subject::Tiling => return Ok(()),
        };
        let ignored = options.into_iter().find(|(_, is_given)| *is_given);
        ignored.map_or(Ok(()), |(option, _)| Err(format!("{option}: {reason}")))
    }

    /// The family of --free; `None` without that option.
    pub fn freed(&self, tiling: &AnyTiling) -> Result<Option<AnyFamily>, String> {
        let Some(radius) = &self.radius else {
            return Ok(None);
        };
        let radius = positive(radius, "--radius")?;
        let free = self.free.iter().map(|word| match word.as_str() {
            "gram" => Ok(Free::Gram),
            _ => word.parse().map(Free::Vertex).map_err(|_| {
                format!("--free {word}: expected the number of a vertex, from 0, or gram")
            }),
        });
        let free: Vec<Free> = free.collect::<Result<_, _>>()?;
        let family = match tiling {
            AnyTiling::Plane(t) => free::family(t, &free, &radius).map(AnyFamily::Plane),
            AnyTiling::Space(t) => free::family(t, &free, &radius).map(AnyFamily::Space),
        };
        family.map(Some).map_err(|error| format!("--free: {error}"))
    }
}

/// The member of a family at a point, values with commas between them; without one in the middle of the box.
/// The words name it.
///
/// # Errors
/// No point of the box.
pub fn member_at(family: &AnyFamily, point: Option<&str>) -> Result<(AnyTiling, String), String> {
    let cuboid = with_family!(family, f => f.cuboid());
    let names = with_family!(family, f => f.names());
    let point = match point {
        None => cuboid.center(),
        Some(text) => {
            let texts: Vec<&str> = text.split(',').collect();
            let point = numbers(&texts).map_err(|error| format!("--at {text}: {error}"))?;
            if point.len() != names.len() {
                let expected = names.join(", ");
                let found = point.len();
                return Err(format!(
                    "--at {text}: {found} values, expected one for each of {expected}"
                ));
            }
            point
        }
    };
    let words = point_in_words(&names, &point);
    if !cuboid.contains(&point) {
        let sides: Vec<String> = cuboid.sides.iter().map(ToString::to_string).collect();
        return Err(format!(
            "--at: {words} is not in the box {}",
            sides.join(" × ")
        ));
    }
    Ok((member(family, &point), words))
}

/// The refusal of --within-su for other inputs.
pub const NO_UNCERTAINTIES: &str = "--within-su is for a CIF, whose numbers have standard uncertainties; --free takes other tilings";

/// The family of --within-su: the Delaunay triangulation of a CIF whose numbers vary.
///
/// # Errors
/// Why there is none, without the name of the input.
pub fn within_su(
    tiling: &AnyTiling,
    points: &AnyPointSet,
    variation: &Variation,
) -> Result<AnyFamily, String> {
    let (AnyTiling::Space(tiling), AnyPointSet::Space(points)) = (tiling, points) else {
        return Err(NO_UNCERTAINTIES.to_owned());
    };
    let parameter = |interval: &Interval| Parameter {
        name: interval.name.clone(),
        side: Side {
            low: End::closed(Number::from(interval.low.clone())),
            high: End::closed(Number::from(interval.high.clone())),
        },
    };
    let parameters = variation.intervals.iter().map(parameter).collect();
    let (gram, moved) = (variation.gram.clone(), variation.points.clone());
    let family = free::over_points(tiling, &points.points, parameters, gram, moved);
    let family = family.ok_or("--within-su: a vertex is none of the points")?;
    family
        .check()
        .map_err(|error| format!("--within-su: {error}"))?;
    Ok(AnyFamily::Space(family))
}

fn positive(text: &str, option: &str) -> Result<Rational, String> {
    match parse_rational(text) {
        Ok(value) if value > 0 => Ok(value),
        Ok(value) => Err(format!("{option} {value}: expected a positive number")),
        Err(error) => Err(format!(
            "{option} {text}: {error}; expected a positive number like 1/100"
        )),
    }
}

/// Proves or refutes; `notes` gets what else is to be said.
pub fn prove(
    family: &AnyFamily,
    input: &str,
    target: &Target,
    (arguments, options): (&CertifyArguments, Options),
    notes: &mut Vec<String>,
) -> Answer {
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    let largest = match &arguments.family.maximal {
        None => None,
        Some(point) => match grown(family, point, arguments, &options) {
            Ok((family, words)) => {
                notes.push(words);
                Some(family)
            }
            Err(Grown::Failed(message)) => return Answer::Failed(format!("{input}: {message}")),
            Err(Grown::Prover(error)) => {
                return unproved(
                    family,
                    input,
                    FamilyNotProved::Prover(error),
                    notes,
                    arguments,
                );
            }
        },
    };
    let family = largest.as_ref().unwrap_or(family);
    let proved = with_family!(family, f => family::prove(f, &options, &step));
    match proved {
        Ok(proved) => answer(proved, target, arguments, notes),
        Err(error) => unproved(family, input, error, notes, arguments),
    }
}

/// Why there is no largest box.
enum Grown {
    Failed(String),
    Prover(NotProvable),
}

/// The family over the largest box around a point, and what it is in words.
fn grown(
    family: &AnyFamily,
    point: &str,
    arguments: &CertifyArguments,
    options: &Options,
) -> Result<(AnyFamily, String), Grown> {
    let texts: Vec<&str> = point.split(',').collect();
    let point = numbers(&texts).map_err(|error| {
        let expected = "expected a number for each parameter, with commas between them";
        Grown::Failed(format!("--maximal {point}: {error}; {expected}"))
    })?;
    let fraction = positive(&arguments.family.fraction, "--fraction").map_err(Grown::Failed)?;
    let found = with_family!(family, f => maximal::maximal(f, &point, options, &fraction));
    let (maximal, cuboid) = found.map_err(Grown::Prover)?;
    let names = with_family!(family, f => f.names());
    let words = match maximal {
        Maximal::Interval(low, high) => format!(
            "the largest interval around the point: {}",
            interval_in_words(&names, &low, &high)
        ),
        Maximal::Box(fraction) => {
            format!("no side of the box can be moved out by {fraction} of its length and be proved")
        }
    };
    let family = match family {
        AnyFamily::Plane(f) => AnyFamily::Plane(f.with_box(&cuboid)),
        AnyFamily::Space(f) => AnyFamily::Space(f.with_box(&cuboid)),
    };
    Ok((family, words))
}

/// `s in [2/3, 1)`; an end that is no number of the field by its polynomial.
fn interval_in_words(names: &[String], low: &Extent, high: &Extent) -> String {
    let end = |extent: &Extent, infinite: &str| match extent {
        Extent::Unbounded => (infinite.to_owned(), true, String::new()),
        Extent::At { place, is_open } => match (place, place.polynomial()) {
            (Place::Number(value), _) => (value.to_string(), *is_open, String::new()),
            (Place::Root { low, .. }, polynomial) => {
                let text = decimals(low);
                let polynomial = polynomial.map_or(String::new(), |p| p.shown(names));
                let root = format!("; {text} is a root of {polynomial}");
                (text, *is_open, root)
            }
        },
    };
    let (low, low_open, low_root) = end(low, "-infinity");
    let (high, high_open, high_root) = end(high, "infinity");
    let left = if low_open { '(' } else { '[' };
    let right = if high_open { ')' } else { ']' };
    let name = names.first().map_or("", String::as_str);
    format!("{name} in {left}{low}, {high}{right}{low_root}{high_root}")
}

fn answer(
    proved: ProvedFamily,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
) -> Answer {
    let leaves = proved.tree().leaves();
    if leaves > 1 {
        notes.push(format!("the box is cut into {leaves} parts"));
    }
    let bytes = encoding(target, arguments).encode(proved.certificate());
    let bytes = match bytes.map(Cow::into_owned) {
        Ok(bytes) => bytes,
        Err(error) => return unwritten(target, &error),
    };
    Answer::Proved {
        verified: proved.into_verified(),
        certificate: Written::Bytes(bytes),
    }
}

/// The answer about a family that is not proved.
fn unproved(
    family: &AnyFamily,
    input: &str,
    error: FamilyNotProved,
    notes: &[String],
    arguments: &CertifyArguments,
) -> Answer {
    match refuted(family, input, error) {
        Ok(refuted) => Answer::Refuted(Box::new(Refuted {
            notes: notes.to_vec(),
            is_exact: arguments.exact,
            shown: arguments.max_defects,
            ..refuted
        })),
        Err(error) => error.into(),
    }
}

/// The member by which a family is refuted.
///
/// # Errors
/// Where it is not proved for another reason, a message that names the input.
pub fn refuted(
    family: &AnyFamily,
    input: &str,
    error: FamilyNotProved,
) -> Result<Refuted, InputError> {
    let (reason, outcome) = match error {
        FamilyNotProved::Prover(NotProvable::Refuted { point, findings }) => {
            let names = with_family!(family, f => f.names());
            return Ok(Refuted {
                tiling: member(family, &point),
                point: Some(point_in_words(&names, &point)),
                origin: None,
                notes: Vec::new(),
                findings,
                second: SecondLook::default(),
                is_exact: false,
                shown: None,
            });
        }
        FamilyNotProved::Prover(NotProvable::Malformed(error)) => {
            (error.to_string(), Outcome::Failed)
        }
        FamilyNotProved::Prover(NotProvable::Declined(reason)) => {
            (reason.to_string(), Outcome::Declined)
        }
        FamilyNotProved::Unconfirmed(refusal) => {
            let words = refusal::in_words(&refusal);
            let message = format!("the kernel does not confirm the certificate: {words}");
            (message, Outcome::Declined)
        }
    };
    let message = format!("{input}: {reason}");
    Err(InputError { message, outcome })
}

fn member(family: &AnyFamily, point: &[Number]) -> AnyTiling {
    match family {
        AnyFamily::Plane(family) => AnyTiling::Plane(family.at(point)),
        AnyFamily::Space(family) => AnyTiling::Space(family.at(point)),
    }
}
