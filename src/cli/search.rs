//! `acutile search`: acute slabs over plane tilings, and balls of the 600-cell for polyhedra.

use super::encoding::{Encoding, write_certificate};
use super::integer::integer_in;
use super::interrupt;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::overwriting::check_output;
use super::plane;
use super::progress::Progress;
use super::record::Record;
use super::search_balls::{self, BallArguments};
use acutile_catalog::places::Places;
use acutile_catalog::plane_tiling;
use acutile_core::quality::{decimal_range, display_width};
use acutile_optimize::slabs::{Plane, Tried, slabs};
use acutile_optimize::{Goal, value};
use clap::{Args, Subcommand};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

#[derive(Debug, Args)]
pub struct SearchArguments {
    #[command(subcommand)]
    what: Search,
}

#[derive(Debug, Subcommand)]
enum Search {
    /// Search for slabs: layers of points over a plane tiling, at random heights, are triangulated and optimized
    Slab(SlabArguments),
    /// Search for polyhedra among the cells of the 600-cell that remain without a small connected set of vertices
    Balls(BallArguments),
}

#[derive(Debug, Args)]
struct SlabArguments {
    /// The plane tiling by squares and triangles: triangles, squares, 33344, 32434, 3464, one of these after inflated-,
    /// or a plane-tiling file
    #[arg(long, value_name = "TILING|FILE", default_value = "triangles")]
    over: String,
    /// The number of candidates
    #[arg(long, value_name = "N", default_value_t = 1000)]
    tries: usize,
    /// At most N layers between the boundary and the middle, the middle included
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = integer_in::<usize>(1..=12))]
    layers: usize,
    /// The seed of the heights
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Write the certificate of the best slab to this file (`-` for standard output)
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The side of the plane tiling, in units of length.
const SIDE: i64 = 6;

/// The plane tiling with this name, or of this file.
fn plane(name: &str) -> Result<Plane, InputError> {
    let path = Path::new(name);
    let tiling = match name {
        "triangles" => plane_tiling::triangles(),
        "squares" => plane_tiling::squares(),
        _ if path.exists() || name.contains(['/', '.']) => plane::read(path)?,
        _ => plane_tiling::named(name).ok_or_else(|| {
            format!(
                "--over: found {name}, expected triangles, squares, 33344, 32434, 3464, \
                 one of these after inflated-, or a plane-tiling file"
            )
        })?,
    };
    let Places { field, gram, kinds } = tiling
        .places(SIDE)
        .map_err(|error| format!("{name}: {error}"))?;
    let classes = kinds
        .into_iter()
        .map(|(kind, places)| (kind.to_owned(), places));
    Ok(Plane {
        name: name.to_owned(),
        field,
        gram,
        classes: classes.collect(),
    })
}

/// Searches, and says how much was tried. Declined where no acute slab was found.
pub fn run(arguments: &SearchArguments, output: &mut Output) -> Outcome {
    match &arguments.what {
        Search::Slab(slab) => search_slabs(slab, output),
        Search::Balls(balls) => search_balls::run(balls, output),
    }
}

fn search_slabs(arguments: &SlabArguments, output: &mut Output) -> Outcome {
    let path = arguments.output.as_deref();
    let encoding = check_output(path, "-o", &[]).and_then(|()| Encoding::of(path, None));
    let encoding = match encoding {
        Ok(encoding) => encoding,
        Err(message) => return output.fail_with(None, message),
    };
    if path.is_some() {
        output.document_goes_to(path);
    }
    let SlabArguments {
        over,
        tries,
        layers,
        seed,
        ..
    } = arguments;
    let plane = match plane(over) {
        Ok(plane) => plane,
        Err(error) => return output.fail(None, &error),
    };
    let progress = Progress::of("search");
    let stop = interrupt::gently();
    let tried = slabs(&plane, *tries, *layers, *seed, &mut |count| {
        progress.step(&format!("candidate {count} of {tries}"));
        !stop.load(Ordering::Relaxed)
    });
    drop(progress);
    let sha256 = tried.best.as_ref().map(|(_, best)| best.proved.sha256());
    if let (Some((_, best)), Some(path)) = (&tried.best, path)
        && let Err(error) = write_certificate(path, encoding, best.proved.certificate(), output)
    {
        return output.fail(None, &error);
    }
    if output.is_json() {
        let record = Record::of(None).with(slab_data(over, &tried));
        output.answer(match sha256 {
            Some(sha256) => record.certificate(path, &sha256),
            None => record,
        });
    } else {
        slab_words(&tried, output)
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
    output.say(format!(
        "{candidates} candidates: {cospherical} have cospherical points, {unusable} give no slab otherwise, \
         {hopeless} can never be acute, {optimized} \
         optimized, {acute} of these acute"
    ));
    match (&tried.best, angle(tried)) {
        (Some((words, best)), Some(angle)) => output.say(format!(
            "best: largest dihedral angle {angle}, {} tetrahedra, layers {words}; proved, sha256 {}",
            best.tiling.len(),
            best.proved.sha256()
        )),
        _ => output.say("no slab was found"),
    }
}

fn slab_data(over: &str, tried: &Tried) -> Value {
    json!({
        "over": over,
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
        })),
    })
}
