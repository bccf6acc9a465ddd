//! `acutile delaunay`: a point set in, the tiling file of its Delaunay
//! triangulation out.

use super::document;
use super::extension;
use super::name::InputName;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_output;
use super::points::{self, PointArguments};
use super::record::Record;
use super::transcribe;
use acutile_catalog as catalog;
use acutile_core::with_dimension;
use acutile_io::export::labelled_tiling_text;
use acutile_io::import::{Content, uncompressed_name};
use acutile_io::mesh::Family;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct DelaunayArguments {
    /// A point-set file or a crystal structure (CIF, POSCAR, extended XYZ, pymatgen JSON; `-` for standard input)
    #[arg(value_name = "FILE", hide_possible_values = true)]
    pub input: InputName,
    #[command(flatten)]
    pub points: PointArguments,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Triangulates the points of a file.
pub fn run(arguments: &DelaunayArguments, output: &mut Output) -> Outcome {
    match write(arguments, output) {
        Ok(()) => output.done(Record::of(Some(&arguments.input))),
        Err(error) => output.fail(Some(&arguments.input), &error),
    }
}

fn write(arguments: &DelaunayArguments, output: &mut Output) -> Result<(), InputError> {
    let path = arguments.output.as_deref();
    output.document_goes_to(path);
    extension::check(path, "a tiling file", &["json"])?;
    let name = &arguments.input;
    check_not_a_name(name)?;
    check_output(path, "-o", std::slice::from_ref(name))?;
    check_not_a_mesh(name)?;
    let document = document::open(name.path(), &arguments.points, output)?;
    let Content::Points(points) = document.content else {
        return Err(format!("{name}: is a tiling file, expected a point-set file").into());
    };
    let file = uncompressed_name(name.path());
    let stem = file.file_stem().map(|stem| stem.to_string_lossy());
    let stem = stem.as_deref().unwrap_or("delaunay");
    let text = with_dimension!(&points, AnyPointSet, p => {
        points::tiling(name, p, &arguments.points)
            .map(|tiling| labelled_tiling_text(&tiling, stem, &document.labels))
    })?;
    write_bytes(path, text.as_bytes(), output)
}

/// The simplices of a mesh or of a certificate are given already.
fn check_not_a_mesh(name: &InputName) -> Result<(), String> {
    match Family::of_path(name.path()) {
        None if transcribe::is_certificate(name) => Err(format!(
            "{name}: a certificate, expected a file of points; `acutile show {name}` describes its tiling"
        )),
        Some(_) => Err(format!(
            "{name}: a mesh, expected a file of points; `acutile certify {name}` proves its elements, \
             with --require delaunay as a Delaunay triangulation"
        )),
        None => Ok(()),
    }
}

/// A construction of the catalogue is triangulated already.
fn check_not_a_name(name: &InputName) -> Result<(), String> {
    if name.path().exists() || catalog::find(name).is_none() {
        return Ok(());
    }
    Err(format!(
        "{name}: a tiling of the catalogue, expected a file of points; `acutile export {name}` writes its tiling file"
    ))
}
