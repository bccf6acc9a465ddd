//! `acutile new`: a commented starting example of each kind of file that is read.
//!
//! The files stand in `examples/` beside this one, and are accepted as they are.

use super::extension;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_replaceable;
use super::record::Record;
use clap::Args;
use clap::ValueEnum;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct NewArguments {
    /// The kind of file
    #[arg(value_enum)]
    pub kind: Kind,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Replace an existing file, even if it was edited
    #[arg(long)]
    pub force: bool,
}

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// A tiling of space by tetrahedra
    Tiling,
    /// A tiling of the plane by triangles
    Plane,
    /// A tiling of a slab between two parallel planes
    Slab,
    /// A tiling of an infinite prism
    Prism,
    /// A tiling of a convex polyhedron
    Solid,
    /// A bounded mesh: a region that is the union of its tetrahedra
    Region,
    /// A point set, which stands for its Delaunay triangulation
    PointSet,
    /// A tiling whose coordinates are square roots and other algebraic numbers
    SquareRoot,
    /// A tiling of the plane by squares and triangles, for square-triangle:FILE and z-c15:FILE
    SquareTriangle,
    /// A crystallographic information file
    Cif,
}

impl Kind {
    /// The text of the example.
    fn example(self) -> &'static str {
        match self {
            Kind::Tiling => include_str!("examples/tiling.json"),
            Kind::Plane => include_str!("examples/plane.json"),
            Kind::Slab => include_str!("examples/slab.json"),
            Kind::Prism => include_str!("examples/prism.json"),
            Kind::Solid => include_str!("examples/solid.json"),
            Kind::Region => include_str!("examples/region.json"),
            Kind::PointSet => include_str!("examples/point-set.json"),
            Kind::SquareRoot => include_str!("examples/square-root.json"),
            Kind::SquareTriangle => include_str!("examples/square-triangle.json"),
            Kind::Cif => include_str!("examples/cif.cif"),
        }
    }
}

/// Writes the example of a kind.
pub fn run(arguments: &NewArguments, output: &mut Output) -> Outcome {
    match write(arguments, output) {
        Ok(()) => output.done(Record::of(None)),
        Err(error) => output.fail(None, &error),
    }
}

fn write(arguments: &NewArguments, output: &mut Output) -> Result<(), InputError> {
    let path = arguments.output.as_deref();
    output.document_goes_to(path);
    match arguments.kind {
        Kind::Cif => extension::check(path, "a crystal structure", &["cif", "txt"]),
        _ => extension::check(path, "an input file", &["json"]),
    }?;
    if let Some(path) = path.filter(|path| path.is_file()) {
        let is_own = |found: &[u8]| {
            Kind::value_variants()
                .iter()
                .any(|kind| kind.example().as_bytes() == found)
        };
        check_replaceable(path, is_own, arguments.force)?;
    }
    write_bytes(path, arguments.kind.example().as_bytes(), output)
}
