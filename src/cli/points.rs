//! Point sets: how they are read and triangulated.

use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use acutile_core::delaunay::{DelaunayError, Ties, triangulate};
use acutile_core::tiling::{AnyPointSet, AnyTiling, PointSet, Tiling};
use acutile_core::with_dimension;
use clap::Args;

/// How a point set is read and triangulated.
#[derive(Debug, Default, Args)]
pub struct PointArguments {
    /// Cut Delaunay cells with cospherical vertices into simplices, the same way
    /// in every lattice translate, instead of refusing
    #[arg(long)]
    pub triangulate: bool,
    /// The data block of a CIF that has several
    #[arg(long, value_name = "NAME", help_heading = "CIF")]
    pub block: Option<String>,
    /// Replace each decimal of a CIF by the multiple of 1/DENOMINATOR that agrees with all of its
    /// digits, if there is one; every replacement is printed
    #[arg(long, value_name = "DENOMINATOR", help_heading = "CIF",
          value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub snap: Option<u32>,
    /// The sites of a CIF that are taken
    #[arg(
        long,
        value_name = "LABEL,LABEL",
        help_heading = "CIF",
        value_delimiter = ','
    )]
    pub only: Vec<String>,
    /// Take sites of a CIF as atoms whatever their occupancy, and those at one place as one
    #[arg(long, help_heading = "CIF")]
    pub ignore_occupancy: bool,
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

pub fn tiling<const D: usize>(
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
