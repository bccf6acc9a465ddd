//! `acutile search`: acute slabs over plane tilings, and balls of the 600-cell for polyhedra.

use super::interrupt;
use super::outcome::Outcome;
use super::output::{Output, write_file};
use super::progress::Progress;
use acutile_core::format::print;
use acutile_core::quality::{decimal_range, display_width};
use acutile_optimize::balls::{Rest, rests};
use acutile_optimize::slabs::{PLANES, Plane, Tried, slabs};
use acutile_optimize::{Goal, value};
use clap::{Args, Subcommand};
use serde_json::{Value, json};
use std::path::PathBuf;
use std::sync::atomic::Ordering;

#[derive(Debug, Args)]
pub struct SearchArguments {
    #[command(subcommand)]
    what: Search,
}

#[derive(Debug, Subcommand)]
enum Search {
    /// Slabs between layers of points over a plane tiling, at random heights, optimized
    Slab(SlabArguments),
    /// What the 600-cell leaves without small connected sets of vertices, and whether a polyhedron might be
    /// triangulated by it acutely
    Balls(BallArguments),
}

#[derive(Debug, Args)]
struct SlabArguments {
    /// The plane tiling: triangles or squares
    #[arg(long, value_name = "TILING", default_value = "triangles", value_parser = plane)]
    over: &'static Plane,
    /// How many candidates
    #[arg(long, value_name = "N", default_value_t = 1000)]
    tries: usize,
    /// At most N layers between the boundary and the middle, the middle included
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(1..=12))]
    layers: usize,
    /// The seed of the heights
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Write the certificate of the best slab to this file
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// One JSON object
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
struct BallArguments {
    /// Remove at most N vertices
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(1..=6))]
    size: usize,
    /// One JSON object
    #[arg(long)]
    json: bool,
}

fn plane(name: &str) -> Result<&'static Plane, String> {
    let names: Vec<&str> = PLANES.iter().map(|plane| plane.name).collect();
    let found = PLANES.iter().find(|plane| plane.name == name);
    found.ok_or_else(|| format!("found {name}, expected {}", names.join(" or ")))
}

/// Searches, and says how much was tried. Declined where no acute slab was found.
pub fn run(arguments: &SearchArguments, output: &mut Output) -> Outcome {
    match &arguments.what {
        Search::Slab(slab) => search_slabs(slab, output),
        Search::Balls(balls) => search_balls(balls, output),
    }
}

fn search_slabs(arguments: &SlabArguments, output: &mut Output) -> Outcome {
    let progress = Progress::of("search");
    let stop = interrupt::gently();
    let SlabArguments {
        over,
        tries,
        layers,
        seed,
        ..
    } = arguments;
    let tried = slabs(over, *tries, *layers, *seed, &mut |count| {
        progress.step(&format!("candidate {count} of {tries}"));
        !stop.load(Ordering::Relaxed)
    });
    drop(progress);
    let written = tried
        .best
        .as_ref()
        .zip(arguments.output.as_ref())
        .map(|((_, best), path)| {
            let cbor = best.proved.certificate();
            let is_cbor = path
                .extension()
                .is_some_and(|e| e.eq_ignore_ascii_case("cbor"));
            let bytes = match is_cbor {
                true => cbor.to_vec(),
                false => print::to_json(cbor).map_err(|error| error.to_string())?,
            };
            write_file(path, &bytes)
                .map_err(|error| format!("{}: cannot be written: {error}", path.display()))
        });
    if let Some(Err(message)) = written {
        output.complain(format!("acutile: {message}"));
        return Outcome::Failed;
    }
    match arguments.json {
        true => output.line(slab_data(&tried)),
        false => slab_words(&tried, output),
    }
    match tried.acute {
        0 => Outcome::Declined,
        _ => Outcome::Done,
    }
}

fn angle(tried: &Tried) -> Option<String> {
    let (_, best) = tried.best.as_ref()?;
    let value = value(best.proved.statements(), Goal::MaxDihedral)?;
    Some(decimal_range(&value.enclosure(&display_width())))
}

fn slab_words(tried: &Tried, output: &mut Output) {
    let Tried {
        candidates,
        cospherical,
        unusable,
        hopeless,
        optimized,
        acute,
        ..
    } = tried;
    output.line(format!(
        "{candidates} candidates: {cospherical} have cospherical points, {unusable} give no slab otherwise, \
         {hopeless} can never be acute, {optimized} \
         optimized, {acute} of these acute"
    ));
    match (&tried.best, angle(tried)) {
        (Some((words, best)), Some(angle)) => output.line(format!(
            "best: largest dihedral angle {angle}, {} tetrahedra, layers {words}; proved, sha256 {}",
            best.tiling.len(),
            best.proved.sha256()
        )),
        _ => output.line("no slab was found"),
    }
}

fn slab_data(tried: &Tried) -> Value {
    json!({
        "candidates": tried.candidates,
        "cospherical": tried.cospherical,
        "no_slab": tried.unusable,
        "never_acute": tried.hopeless,
        "optimized": tried.optimized,
        "acute": tried.acute,
        "interrupted": tried.is_interrupted,
        "best": tried.best.as_ref().map(|(words, best)| json!({
            "layers": words,
            "tetrahedra": best.tiling.len(),
            "largest_dihedral": angle(tried),
            "sha256": best.proved.sha256(),
        })),
    })
}

fn search_balls(arguments: &BallArguments, output: &mut Output) -> Outcome {
    let progress = Progress::of("search");
    progress.step("balls of the 600-cell");
    let found = rests(arguments.size);
    drop(progress);
    if arguments.json {
        let rows = found
            .iter()
            .map(|(rest, (set, count))| ball_data(rest, set, *count));
        output.line(json!({ "rests": rows.collect::<Vec<_>>() }));
        return Outcome::Done;
    }
    for (rest, (set, count)) in &found {
        let set: Vec<String> = set.iter().map(ToString::to_string).collect();
        let verdict = match rest.is_possible() {
            true => "possible",
            false => "never acute",
        };
        output.line(format!(
            "{verdict}: {} tetrahedra without {} vertices [{}] ({count} such sets); edges of valence 1 and 2: \
             {} and {}, {} corners, {} faces, {} dead ends",
            rest.tetrahedra,
            rest.removed,
            set.join(", "),
            rest.ridges.0,
            rest.ridges.1,
            rest.corners,
            rest.faces,
            rest.dead_ends,
        ));
    }
    output.line("possible: no count forbids an acute polyhedron; none is constructed here");
    Outcome::Done
}

fn ball_data(rest: &Rest, set: &[usize], count: usize) -> Value {
    json!({
        "removed": set,
        "sets": count,
        "tetrahedra": rest.tetrahedra,
        "boundary_triangles": rest.boundary_triangles,
        "edges_of_valence_1": rest.ridges.0,
        "edges_of_valence_2": rest.ridges.1,
        "dead_ends": rest.dead_ends,
        "corners": rest.corners,
        "faces": rest.faces,
        "possible": rest.is_possible(),
    })
}
