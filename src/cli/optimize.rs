//! `acutile optimize`: better angles for a tiling, proved.

use super::encoding::Encoding;
use super::files::{Staged, is_standard, unwritten};
use super::input;
use super::interrupt;
use super::named::InputError;
use super::optimize_arguments::{OptimizeArguments, SymmetryName};
use super::optimized::Report;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_not_an_input;
use super::progress::Progress;
use super::proved as proof;
use super::record::Record;
use super::refutation::names;
use acutile_catalog as catalog;
use acutile_core::advice::{Advice, Adviser};
use acutile_core::proved::NotProved;
use acutile_core::statement::Statement;
use acutile_core::tiling::{AnyTiling, Tiling, match_facets};
use acutile_io::mesh::Origin;
use acutile_optimize::{Failure, Freedom, Goal, Group, Options, optimize, prove_local, reasons};
use serde_json::json;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::Ordering;

/// Searches, and writes the best result. Declined where nothing better was found, or where the goal is
/// not reached.
pub fn run(arguments: &OptimizeArguments, output: &mut Output) -> Outcome {
    if arguments.output.is_some() {
        output.document_goes_to(arguments.output.as_deref());
    }
    match answer(arguments, output) {
        Ok(outcome) => outcome,
        Err(error) => output.fail(Some(&arguments.input), &error),
    }
}

fn answer(arguments: &OptimizeArguments, output: &mut Output) -> Result<Outcome, InputError> {
    let input = &arguments.input;
    let named = input::tiling(input, arguments.param.as_deref(), &arguments.file, output)?;
    if !named.curved.is_empty() {
        let curved = named.curved.len();
        return Err(
            format!("{input}: found {curved} curved elements, expected straight ones").into(),
        );
    }
    let AnyTiling::Space(mut tiling) = named.tiling else {
        return Err(format!("{input}: found a tiling of the plane, expected one of space").into());
    };
    if arguments.reorient && catalog::find(input).is_some() {
        let words = "--reorient is for a tiling or mesh file, which this is not";
        return Err(format!("{input}: {words}").into());
    }
    if arguments.reorient {
        tiling.orient();
    }
    let keep = match &arguments.symmetry {
        SymmetryName::List => return Ok(list(input, &tiling, output)),
        SymmetryName::Keep(keep) => keep.clone(),
    };
    let goal = arguments.goal.goal();
    let options = Options {
        goal,
        keep,
        freedom: Freedom {
            lattice: !arguments.fixed_lattice,
            boundary: !arguments.fixed_boundary,
        },
        denominator: arguments.denominator,
        restarts: arguments.restarts,
        seed: arguments.seed,
        steps: arguments.steps,
        limits: arguments.limits.limits(),
        sides: named.sides,
    };
    let place = Place::of(arguments)?;
    let found = search(input, &tiling, named.origin.as_ref(), &options)?;
    let why = match goal {
        Goal::Acute | Goal::MaxDihedral => reasons(&found.tiling, &match_facets(&found.tiling)),
        _ => Vec::new(),
    };
    if let Some(place) = place {
        place.write(found.proved.certificate(), output)?;
    }
    let is_acute = found.proved.statements().contains(&Statement::Acute);
    let local = arguments.prove_local.then(|| prove_local(&found, &options));
    // A local optimum has nothing better near it.
    let is_reached = match (&local, goal) {
        (Some(local), _) => local.is_ok(),
        (None, Goal::Acute) => is_acute,
        (None, _) => found.is_better,
    };
    let result = Report {
        arguments,
        found: &found,
        reasons: why,
        is_acute,
        local,
    };
    result.tell(output);
    Ok(if is_reached {
        Outcome::Done
    } else {
        Outcome::Declined
    })
}

/// The search, with a line for the current value; Ctrl-C ends it with the best so far.
fn search(
    input: &str,
    tiling: &Tiling<3>,
    origin: Option<&Origin>,
    options: &Options,
) -> Result<acutile_optimize::Outcome, InputError> {
    let progress = Progress::of(input);
    progress.step("the start is proved");
    let stop = interrupt::gently();
    let mut count = 0u64;
    let found = optimize(tiling, options, &mut |value| {
        count += 1;
        progress.step(&format!("step {count}: {value:.6}"));
        !stop.load(Ordering::Relaxed)
    });
    found.map_err(|failure| match failure {
        Failure::Start(error) => InputError {
            message: format!("{input}: the start is no tiling: {}", of_start(&error, tiling, origin)),
            outcome: proof::outcome(&error),
        },
        Failure::NoElement(error) => InputError::from(format!(
            "{input}: --symmetry: found element {}, expected less than {}; --symmetry list prints the elements",
            error.place, error.count
        )),
    })
}

/// Why the start is no tiling: each vertex that misses a face of the domain, then the first defect.
fn of_start(error: &NotProved, tiling: &Tiling<3>, origin: Option<&Origin>) -> String {
    let mut words = Vec::new();
    if let NotProved::Refuted(findings) = error {
        let adviser = Adviser::new(tiling);
        let advice = findings
            .kept()
            .iter()
            .flat_map(|defect| adviser.advice(defect));
        for piece in advice {
            let Advice::OffFace(off) = piece else {
                continue;
            };
            let sentence = off.to_string();
            if !words.contains(&sentence) {
                words.push(sentence);
            }
        }
    }
    words.push(error.in_words_with::<3>(&names(tiling, origin, false)));
    words.join("; ")
}

/// The isometries with their places.
fn list(input: &str, tiling: &Tiling<3>, output: &mut Output) -> Outcome {
    let group = Group::of(tiling, &match_facets(tiling));
    let rows = group.elements.iter().map(|element| {
        let isometry = &element.isometry;
        [0, 1, 2].map(|i| {
            let terms = isometry.linear[i].each_ref().map(ToString::to_string);
            format!("({}) + {}", terms.join(", "), isometry.translation[i])
        })
    });
    let rows: Vec<[String; 3]> = rows.collect();
    if output.is_json() {
        output.answer(Record::of(Some(input)).member("symmetries", json!(rows)));
        return Outcome::Done;
    }
    for (place, row) in rows.iter().enumerate() {
        output.line(format!("{place}: {}", row.join("; ")));
    }
    Outcome::Done
}

/// The place of the certificate, found before the search, so that hours of work are not lost.
struct Place<'a> {
    path: &'a Path,
    encoding: Encoding,
    /// `None` for standard output, a device or a pipe.
    staged: Option<Staged>,
}

impl<'a> Place<'a> {
    /// The place that is asked for.
    fn of(arguments: &'a OptimizeArguments) -> Result<Option<Self>, InputError> {
        let Some(path) = arguments.output.as_deref() else {
            return Ok(None);
        };
        let encoding = Encoding::of(Some(path), arguments.format)?;
        check_not_an_input(Some(path), "-o", std::slice::from_ref(&arguments.input))?;
        let staged = if is_standard(path) {
            None
        } else {
            Staged::new(path).map_err(|error| unwritten(path, &error))?
        };
        Ok(Some(Place {
            path,
            encoding,
            staged,
        }))
    }

    /// Writes a certificate there.
    fn write(self, cbor: &[u8], output: &mut Output) -> Result<(), InputError> {
        let bytes = self.encoding.encode(cbor);
        let bytes = bytes.map_err(|error| format!("the certificate: {error}"))?;
        let Some(staged) = self.staged else {
            return write_bytes(Some(self.path), &bytes, output);
        };
        let written = staged.file().write_all(&bytes);
        written
            .and_then(|()| staged.persist())
            .map_err(|error| unwritten(self.path, &error))
    }
}
