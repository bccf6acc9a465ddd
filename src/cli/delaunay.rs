//! `acutile delaunay`: a point set in, the tiling file of its Delaunay
//! triangulation out.

use super::args::DelaunayArguments;
use super::export::write_text;
use super::output::Output;
use super::progress::Progress;
use super::{Outcome, input};
use crate::delaunay::{DelaunayError, Ties, triangulate};
use crate::export::tiling_text;
use crate::tiling::PointSet;
use crate::with_dimension;

/// Triangulates the points of a file.
pub fn run(arguments: &DelaunayArguments, output: &mut Output) -> Outcome {
    let points = match input::points(&arguments.file) {
        Ok(points) => points,
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            return error.outcome;
        }
    };
    with_dimension!(&points, AnyPointSet, p => write(p, arguments, output))
}

fn write<const D: usize>(
    points: &PointSet<D>,
    arguments: &DelaunayArguments,
    output: &mut Output,
) -> Outcome {
    let name = arguments.file.display().to_string();
    let ties = if arguments.triangulate {
        Ties::Pull
    } else {
        Ties::Refuse
    };
    let progress = Progress::of(&name);
    progress.step("Delaunay triangulation");
    let tiling = match triangulate(points, ties) {
        Ok(tiling) => tiling,
        Err(error) => {
            drop(progress);
            output.complain(format!("acutile: {name}: {error}"));
            return outcome_of(&error);
        }
    };
    let stem = arguments
        .file
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned());
    let text = tiling_text(&tiling, stem.as_deref().unwrap_or("delaunay"));
    drop(progress);
    write_text(arguments.output.as_deref(), &text, output)
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
