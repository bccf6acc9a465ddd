//! `acutile delaunay`: a point set in, the tiling file of its Delaunay
//! triangulation out. Other commands take point sets through [`of_points`].

use super::Outcome;
use super::args::{DelaunayArguments, PointArguments};
use super::export::write_text;
use super::input::{self, InputError};
use super::output::Output;
use super::progress::Progress;
use acutile_core::delaunay::{DelaunayError, Ties, triangulate};
use acutile_core::tiling::{AnyPointSet, AnyTiling, PointSet, Tiling};
use acutile_core::with_dimension;
use acutile_io::export::tiling_text;
use acutile_io::import::uncompressed_name;

/// Triangulates the points of a file.
pub fn run(arguments: &DelaunayArguments, output: &mut Output) -> Outcome {
    match text(arguments, output) {
        Ok(text) => write_text(arguments.output.as_deref(), &text, output),
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            error.outcome
        }
    }
}

fn text(arguments: &DelaunayArguments, output: &mut Output) -> Result<String, InputError> {
    let points = input::points(&arguments.file, &arguments.points, output)?;
    let name = arguments.file.display().to_string();
    let file = uncompressed_name(&arguments.file);
    let stem = file.file_stem().map(|stem| stem.to_string_lossy());
    let stem = stem.as_deref().unwrap_or("delaunay");
    with_dimension!(&points, AnyPointSet, p => {
        tiling(&name, p, &arguments.points).map(|tiling| tiling_text(&tiling, stem))
    })
}

/// The triangulation of the point set of an input that may be a tiling as well, and a
/// line that says so.
///
/// # Errors
/// A message that names the input.
pub fn of_points(
    input: &str,
    points: &AnyPointSet,
    arguments: &PointArguments,
    output: &mut Output,
) -> Result<AnyTiling, InputError> {
    let count = with_dimension!(points, AnyPointSet, p => p.points.len());
    output.complain(format!(
        "{input}: a point set with {count} points in a cell; the tiling is its Delaunay triangulation"
    ));
    match points {
        AnyPointSet::Plane(points) => tiling(input, points, arguments).map(AnyTiling::Plane),
        AnyPointSet::Space(points) => tiling(input, points, arguments).map(AnyTiling::Space),
    }
}

fn tiling<const D: usize>(
    name: &str,
    points: &PointSet<D>,
    arguments: &PointArguments,
) -> Result<Tiling<D>, InputError> {
    let ties = match arguments.triangulate {
        true => Ties::Pull,
        false => Ties::Refuse,
    };
    let progress = Progress::of(name);
    progress.step("Delaunay triangulation");
    triangulate(points, ties).map_err(|error| {
        let advice = match error {
            DelaunayError::Cospherical(_) => "\n  --triangulate cuts them",
            _ => "",
        };
        InputError {
            message: format!("{name}: {error}{advice}"),
            outcome: outcome_of(&error),
        }
    })
}

/// A set that has several triangulations, or none within the limits, is declined;
/// one that is not a point set of the frame is bad input.
fn outcome_of(error: &DelaunayError) -> Outcome {
    match error {
        DelaunayError::Empty
        | DelaunayError::NotSymmetric
        | DelaunayError::NotPositiveDefinite
        | DelaunayError::Coincident(..) => Outcome::Failed,
        DelaunayError::TooSkewed
        | DelaunayError::TooElongated
        | DelaunayError::Cospherical(_)
        | DelaunayError::TooManyCospherical(_)
        | DelaunayError::Uncertified => Outcome::Declined,
    }
}
