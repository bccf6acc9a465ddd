//! `acutile search balls`: acute polyhedra in the 600-cell without a ball.

use super::encoding::{Encoding, write_certificate};
use super::integer::integer_in;
use super::interrupt;
use super::outcome::Outcome;
use super::output::Output;
use super::overwriting::check_output;
use super::progress::Progress;
use super::record::Record;
use super::shape::shape;
use acutile_core::quality::{decimal_range, display_width};
use acutile_core::statement::counted;
use acutile_optimize::balls::{Balls, Class, Found, search};
use acutile_optimize::{Goal, Outcome as Optimized, value};
use clap::Args;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

#[derive(Debug, Args)]
pub struct BallArguments {
    /// Remove connected sets of at most N vertices, and such sets with their neighbours or with all cells that contain
    /// them
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = integer_in::<usize>(1..=6))]
    size: usize,
    /// Build only this polyhedron: tetrahedron, cube, octahedron, dodecahedron, icosahedron, prism:N, prism:N,HEIGHT,
    /// or a file with the three coordinates of a corner on each line
    #[arg(long, value_name = "SHAPE|FILE", conflicts_with = "faces")]
    shape: Option<String>,
    /// Build only polyhedra with N faces, of any shape: 4 for a tetrahedron, 5 for a prism, 6 for a cube
    #[arg(long, value_name = "N")]
    faces: Option<usize>,
    /// At most N linear programs for a polyhedron
    #[arg(long, value_name = "N", default_value_t = 100)]
    steps: usize,
    /// End the search after N seconds, with the results so far
    #[arg(long, value_name = "N", default_value_t = 600)]
    seconds: u64,
    /// Write the certificate of the acute polyhedron with the fewest tetrahedra to this file
    /// (`-` for standard output)
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Builds and optimizes, and says what was tried. Declined where nothing is acute.
pub fn run(arguments: &BallArguments, output: &mut Output) -> Outcome {
    let path = arguments.output.as_deref();
    let encoding = check_output(path, "-o", &[]).and_then(|()| Encoding::of(path, None));
    let encoding = match encoding {
        Ok(encoding) => encoding,
        Err(message) => return output.fail_with(None, message),
    };
    if path.is_some() {
        output.document_goes_to(path);
    }
    let target = match arguments.shape.as_deref().map(shape).transpose() {
        Ok(target) => target,
        Err(error) => return output.fail(None, &error),
    };
    let progress = Progress::of("search");
    let stop = interrupt::gently();
    let balls = Balls {
        size: arguments.size,
        // Other polyhedra are not this one.
        faces: target
            .as_ref()
            .map(|target| target.faces.len())
            .or(arguments.faces),
        target,
        steps: arguments.steps,
    };
    let (start, limit) = (Instant::now(), Duration::from_secs(arguments.seconds));
    let (classes, is_interrupted) = search(&balls, &mut |work| {
        progress.step(work);
        !stop.load(Ordering::Relaxed) && start.elapsed() < limit
    });
    drop(progress);
    let acute = classes.iter().filter(|class| class.result.is_acute());
    let best = acute.min_by_key(|class| class.rest.tetrahedra);
    let found = match best.map(|class| &class.result) {
        Some(Found::Optimized(found)) => Some(found),
        _ => None,
    };
    if let (Some(path), Some(found)) = (path, found)
        && let Err(error) = write_certificate(path, encoding, found.proved.certificate(), output)
    {
        return output.fail(None, &error);
    }
    if output.is_json() {
        let record = Record::of(None).with(json!({
            "shape": arguments.shape,
            "classes": classes.iter().map(data).collect::<Vec<_>>(),
            "interrupted": is_interrupted,
        }));
        output.answer(match found {
            Some(found) => record.certificate(path, &found.proved.sha256()),
            None => record,
        });
    } else {
        words(&classes, arguments.shape.as_deref(), is_interrupted, output)
    }
    match best {
        Some(_) => Outcome::Done,
        None => Outcome::Declined,
    }
}

fn words(classes: &[Class], shape: Option<&str>, is_interrupted: bool, output: &mut Output) {
    let other = match shape {
        Some(shape) => format!("have not the edges of {shape}"),
        None => "are no polyhedra with three faces at each corner".to_owned(),
    };
    for class in classes {
        let rest = &class.rest;
        let set: Vec<String> = class.removed.iter().map(ToString::to_string).collect();
        output.say(format!(
            "{} without {} [{}] ({}); edges of valence 1 and 2: {} and {}, {}, {}, {}: {}",
            counted(rest.tetrahedra, "tetrahedron", "tetrahedra"),
            counted(rest.removed, "vertex", "vertices"),
            set.join(", "),
            counted(class.sets, "such set", "such sets"),
            rest.ridges.0,
            rest.ridges.1,
            counted(rest.corners, "corner", "corners"),
            counted(rest.faces, "face", "faces"),
            counted(rest.dead_ends, "dead end", "dead ends"),
            in_words(&class.result),
        ));
    }
    let count = |is_counted: fn(&Found) -> bool| {
        classes
            .iter()
            .filter(|class| is_counted(&class.result))
            .count()
    };
    output.say(format!(
        "{} classes: {} have a dead end, {} {other}, {} overlap where they are placed, {} optimized, \
         {} of these acute, {} with another number of faces than was asked for, {} not tried before the search ended",
        classes.len(),
        count(|found| matches!(found, Found::DeadEnd)),
        count(|found| matches!(found, Found::NoPolyhedron)),
        count(|found| matches!(found, Found::Overlap(_))),
        count(|found| matches!(found, Found::Optimized(_))),
        count(Found::is_acute),
        count(|found| matches!(found, Found::OtherFaces)),
        count(|found| matches!(found, Found::NotTried)),
    ));
    if is_interrupted {
        output.say("the search ended before it was complete");
    }
    let is_passed = |class: &Class| matches!(class.result, Found::DeadEnd | Found::OtherFaces);
    let faces = faces_that_occur(classes);
    if !faces.is_empty() && classes.iter().all(is_passed) {
        output.say(format!(
            "nothing was tried; the numbers of faces that occur are {}",
            faces.join(", ")
        ));
    }
}

/// The numbers of faces of the sets that were passed over for them.
fn faces_that_occur(classes: &[Class]) -> Vec<String> {
    let passed = classes
        .iter()
        .filter(|class| matches!(class.result, Found::OtherFaces));
    let faces: BTreeSet<usize> = passed.map(|class| class.rest.faces).collect();
    faces.iter().map(ToString::to_string).collect()
}

fn in_words(found: &Found) -> String {
    match found {
        Found::DeadEnd => {
            "the edges of valence 1 and 2 are not all edges of a polyhedron".to_owned()
        }
        Found::OtherFaces => "another number of faces than was asked for".to_owned(),
        Found::NotTried => "not tried before the search ended".to_owned(),
        Found::NoPolyhedron => "not the edges of the polyhedron".to_owned(),
        Found::Overlap(1) => "the tetrahedra overlap where they are placed".to_owned(),
        Found::Overlap(placements) => {
            format!("the tetrahedra overlap in each of {placements} placements")
        }
        Found::Optimized(outcome) => {
            let verdict = if found.is_acute() {
                "acute"
            } else {
                "not acute"
            };
            format!(
                "{verdict}, largest dihedral angle {}, proved, sha256 {}",
                angle(outcome),
                outcome.proved.sha256()
            )
        }
    }
}

fn angle(outcome: &Optimized) -> String {
    let value = value(outcome.proved.statements(), Goal::MaxDihedral);
    value.map_or(String::new(), |value| {
        decimal_range(&value.enclosure(&display_width()))
    })
}

fn data(class: &Class) -> Value {
    let rest = &class.rest;
    let (result, optimized) = match &class.result {
        Found::DeadEnd => ("dead end", None),
        Found::OtherFaces => ("another number of faces", None),
        Found::NotTried => ("not tried", None),
        Found::NoPolyhedron => ("another polyhedron", None),
        Found::Overlap(_) => ("overlap", None),
        Found::Optimized(outcome) => ("optimized", Some(outcome)),
    };
    json!({
        "removed": class.removed,
        "sets": class.sets,
        "tetrahedra": rest.tetrahedra,
        "boundary_triangles": rest.boundary_triangles,
        "edges_of_valence_1": rest.ridges.0,
        "edges_of_valence_2": rest.ridges.1,
        "dead_ends": rest.dead_ends,
        "corners": rest.corners,
        "faces": rest.faces,
        "result": result,
        "acute": class.result.is_acute(),
        "largest_dihedral": optimized.map(|outcome| angle(outcome)),
        "sha256": optimized.map(|outcome| outcome.proved.sha256()),
    })
}
