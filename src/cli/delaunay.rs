//! `acutile delaunay`: a point set in, the tiling file of its Delaunay
//! triangulation out.

use super::document;
use super::extension;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::points::{self, PointArguments};
use acutile_catalog as catalog;
use acutile_core::with_dimension;
use acutile_io::export::labelled_tiling_text;
use acutile_io::import::{Content, uncompressed_name};
use clap::Args;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct DelaunayArguments {
    /// A point-set file or a crystal structure (CIF, POSCAR, extended XYZ, pymatgen JSON; `-` for standard input)
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[command(flatten)]
    pub points: PointArguments,
    /// Write the tiling file here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

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
    extension::check(arguments.output.as_deref(), "a tiling file", &["json"])?;
    check_not_a_name(&arguments.file)?;
    let document = document::open(&arguments.file, &arguments.points, output)?;
    let name = arguments.file.display().to_string();
    let Content::Points(points) = document.content else {
        return Err(format!("{name}: is a tiling file, expected a point-set file").into());
    };
    let file = uncompressed_name(&arguments.file);
    let stem = file.file_stem().map(|stem| stem.to_string_lossy());
    let stem = stem.as_deref().unwrap_or("delaunay");
    with_dimension!(&points, AnyPointSet, p => {
        points::tiling(&name, p, &arguments.points)
            .map(|tiling| labelled_tiling_text(&tiling, stem, &document.labels))
    })
}

/// A construction of the catalogue is triangulated already.
fn check_not_a_name(path: &Path) -> Result<(), String> {
    match path
        .to_str()
        .filter(|_| !path.exists())
        .and_then(catalog::find)
    {
        None => Ok(()),
        Some(_) => Err(format!(
            "{0}: a tiling of the catalogue, expected a file of points; `acutile export {0}` writes its tiling file",
            path.display()
        )),
    }
}
