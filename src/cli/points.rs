//! Point sets: how they are read and triangulated.

use super::integer::integer_in;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::progress::Progress;
use acutile_core::delaunay::{DelaunayError, Ties, triangulate};
use acutile_core::statement::counted;
use acutile_core::tiling::{AnyPointSet, AnyTiling, PointSet, Tiling};
use acutile_core::with_dimension;
use acutile_io::import::cif::{CifOptions, Special, names};
use clap::Args;

/// How a point set is read and triangulated.
#[derive(Clone, Debug, Default, Args)]
pub struct PointArguments {
    /// Cut Delaunay cells with more cospherical vertices than a simplex into simplices, the same way in every
    /// lattice translate. Without it such cells are declined
    #[arg(long)]
    pub triangulate: bool,
    /// The name of a data block of a CIF, or the number of a frame of an XYZ file
    #[arg(long, value_name = "NAME", help_heading = "Crystal structures")]
    pub block: Option<String>,
    /// Replace each decimal of a CIF by the multiple of 1/DENOMINATOR that agrees with all of its digits,
    /// if there is one. Every replacement is printed
    #[arg(long, value_name = "DENOMINATOR", help_heading = "Crystal structures",
          value_parser = integer_in::<u32>(1..=1_000_000))]
    pub snap: Option<u32>,
    /// Move sites of a CIF that lie on a special position within their digits exactly onto it
    #[arg(long, help_heading = "Crystal structures")]
    pub special: bool,
    /// Keep sites near a special position exactly as they are written
    #[arg(long, help_heading = "Crystal structures", conflicts_with = "special")]
    pub as_written: bool,
    /// Read only these sites, by label or element. Repeat the option or use commas; a label with a comma
    /// needs double quotes
    #[arg(
        long,
        value_name = "LABEL,ELEMENT",
        help_heading = "Crystal structures"
    )]
    pub only: Vec<String>,
    /// Leave out these sites, by label or element
    #[arg(
        long,
        value_name = "LABEL,ELEMENT",
        help_heading = "Crystal structures"
    )]
    pub except: Vec<String>,
    /// Ignore occupancies: each site is an atom, and sites at the same place are one atom
    #[arg(long, help_heading = "Crystal structures")]
    pub ignore_occupancy: bool,
    /// Set by `certify --within-su`.
    #[arg(skip)]
    pub within_su: bool,
}

impl PointArguments {
    /// The options of the readers of crystal structures.
    ///
    /// # Errors
    /// A quote without an end in --only or --except.
    pub fn crystal_options(&self) -> Result<CifOptions, String> {
        let special = if self.special {
            Special::Move
        } else if self.as_written {
            Special::AsWritten
        } else {
            Special::Refuse
        };
        Ok(CifOptions {
            block: self.block.clone(),
            snap: self.snap,
            only: names(&self.only).map_err(|problem| format!("--only: {problem}"))?,
            except: names(&self.except).map_err(|problem| format!("--except: {problem}"))?,
            ignore_occupancy: self.ignore_occupancy,
            special,
            within_su: self.within_su,
        })
    }

    /// The options that are given and mean something for crystal structures only.
    pub fn given_for_crystals(&self) -> Option<&'static str> {
        let given = [
            ("--block", self.block.is_some()),
            ("--snap", self.snap.is_some()),
            ("--special", self.special),
            ("--as-written", self.as_written),
            ("--only", !self.only.is_empty()),
            ("--except", !self.except.is_empty()),
            ("--ignore-occupancy", self.ignore_occupancy),
            ("--within-su", self.within_su),
        ];
        given
            .into_iter()
            .find(|(_, given)| *given)
            .map(|(option, _)| option)
    }
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
    let note = format!(
        "a point set with {} in a cell; the tiling is its Delaunay triangulation",
        counted(count, "point", "points")
    );
    output.note(input, &note);
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
    let ties = if arguments.triangulate {
        Ties::Pull
    } else {
        Ties::Refuse
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

/// A set that has several triangulations, or none within the limits, is declined. A set that is not a point
/// set of the frame is bad input.
pub fn outcome_of(error: &DelaunayError) -> Outcome {
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
