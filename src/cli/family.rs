//! `acutile certify` for families: a tiling for each point of a box of parameters.

use super::answer::{Answer, Written};
use super::certify::{CertifyArguments, encoding, options};
use super::encoding::Encoding;
use super::progress::Progress;
use super::refutation::{Refuted, SHOWN};
use super::second::SecondLook;
use super::target::Target;
use acutile_core::checker::Options;
use acutile_core::family::free::{self, Free};
use acutile_core::family::maximal::{self, Maximal};
use acutile_core::family::{
    self, AnyFamily, FamilyNotProved, NotProvable, ProvedFamily, point_in_words,
};
use acutile_core::format::print;
use acutile_core::quality::rounded_down;
use acutile_core::refusal;
use acutile_core::tiling::AnyTiling;
use acutile_core::with_family;
use acutile_exact::number::{Number, numbers, parse_rational};
use acutile_exact::polynomial::line::{Extent, Place};
use clap::Args;
use malachite::Rational;

/// Options for boxes of parameters.
#[derive(Debug, Args)]
pub struct FamilyArguments {
    /// Prove the largest interval around this point, or with several parameters a box that cannot
    /// grow on any side by more than --fraction of its length: a value for each parameter, with
    /// commas between them. The statements are those of --require, or acute or nonobtuse
    #[arg(long, value_name = "POINT", allow_hyphen_values = true)]
    pub maximal: Option<String>,
    /// The fraction for --maximal with several parameters
    #[arg(long, value_name = "FRACTION", default_value = "1/16")]
    pub fraction: String,
    /// Let the coordinates of these vertices vary, or the Gram matrix (gram), each by at most
    /// --radius
    #[arg(long, value_name = "VERTEX|gram", num_args = 1.., requires = "radius")]
    pub free: Vec<String>,
    /// How far the numbers of --free may vary, in the units of the basis
    #[arg(long, value_name = "RADIUS", requires = "free")]
    pub radius: Option<String>,
}

impl FamilyArguments {
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

fn positive(text: &str, option: &str) -> Result<Rational, String> {
    match parse_rational(text) {
        Ok(value) if value > 0 => Ok(value),
        Ok(value) => Err(format!("{option} {value}: expected a positive number")),
        Err(error) => Err(format!("{option} {text}: {error}")),
    }
}

/// Proves or refutes; `notes` gets what else is to be said.
pub fn prove(
    family: &AnyFamily,
    input: &str,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
) -> Answer {
    let options = options(arguments);
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
                return refused(
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
        Err(error) => refused(family, input, error, notes, arguments),
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
    let point =
        numbers(&texts).map_err(|error| Grown::Failed(format!("--maximal {point}: {error}")))?;
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
                let (below, _) = low.enclosure(&Rational::from_signeds(1, 1_000_000_000_000i64));
                let text = format!("{}...", rounded_down(&below, 9));
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
    let bytes = match (encoding(target, arguments), target) {
        (_, Target::Nowhere) => Vec::new(),
        (Encoding::Cbor, _) => proved.certificate().to_vec(),
        (Encoding::Json, _) => match print::to_json(proved.certificate()) {
            Ok(json) => json,
            Err(error) => return Answer::Failed(error.to_string()),
        },
    };
    Answer::Proved {
        verified: proved.into_verified(),
        certificate: Written::Bytes(bytes),
    }
}

fn refused(
    family: &AnyFamily,
    input: &str,
    error: FamilyNotProved,
    notes: &[String],
    arguments: &CertifyArguments,
) -> Answer {
    let names = with_family!(family, f => f.names());
    match error {
        FamilyNotProved::Prover(NotProvable::Malformed(error)) => {
            Answer::Failed(format!("{input}: {error}"))
        }
        FamilyNotProved::Prover(NotProvable::Declined(reason)) => {
            Answer::Declined(format!("{input}: {reason}"))
        }
        FamilyNotProved::Prover(NotProvable::Refuted { point, findings }) => {
            Answer::Refuted(Box::new(Refuted {
                tiling: member(family, &point),
                point: Some(point_in_words(&names, &point)),
                origin: None,
                notes: notes.to_vec(),
                findings,
                second: SecondLook::default(),
                is_exact: arguments.exact,
                shown: arguments.max_defects.unwrap_or(SHOWN),
            }))
        }
        FamilyNotProved::Unconfirmed(refusal) => Answer::Declined(format!(
            "{input}: the kernel does not confirm the certificate: {}",
            refusal::in_words(&refusal)
        )),
    }
}

fn member(family: &AnyFamily, point: &[Number]) -> AnyTiling {
    match family {
        AnyFamily::Plane(family) => AnyTiling::Plane(family.at(point)),
        AnyFamily::Space(family) => AnyTiling::Space(family.at(point)),
    }
}
