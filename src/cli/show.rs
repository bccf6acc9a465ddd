//! `acutile show`: what a tiling is, before anything about it is proved.

use super::input::{self, FileArguments};
use super::outcome::Outcome;
use super::output::Output;
use super::theorem;
use acutile_catalog as catalog;
use acutile_core::format;
use acutile_core::quality::{decimal_range, dihedral_degrees, display_width, shapes};
use acutile_core::tiling::{Frame, SimplexId, Tiling};
use acutile_core::with_dimension;
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use acutile_io::import::{BYTE_LIMIT, read_bytes};
use clap::Args;
use std::path::Path;

#[derive(Debug, Args)]
pub struct ShowArguments {
    /// A name of the catalogue, a tiling or mesh file, or a point set (CIF too)
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    #[command(flatten)]
    pub file: FileArguments,
    /// The number that the construction depends on, like 3/7 or sqrt(2)/4: a/e of
    /// goldberg-1, -2 and -3, epsilon of two-corners
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// List all shapes, and not only the first 20
    #[arg(long)]
    pub all: bool,
}

/// Shapes that are printed without --all.
const SHAPES: usize = 20;

/// Prints counts, lattice, field and shapes.
pub fn run(arguments: &ShowArguments, output: &mut Output) -> Outcome {
    if let Some(shown) = show_theorem(&arguments.input, output) {
        return match shown {
            Ok(()) => Outcome::Done,
            Err(message) => {
                output.complain(format!("acutile: {message}"));
                Outcome::Failed
            }
        };
    }
    match input::tiling(
        &arguments.input,
        arguments.param.as_deref(),
        &arguments.file,
        output,
    ) {
        Ok(named) => {
            output.line(format!("{}: {}", named.name, named.description));
            with_dimension!(&named.tiling, AnyTiling, t => show(t, arguments.all, output));
            Outcome::Done
        }
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            error.outcome
        }
    }
}

/// A theorem of the catalogue, or a certificate of one.
fn show_theorem(input: &str, output: &mut Output) -> Option<Result<(), String>> {
    if let Some(entry) = catalog::theorem(input) {
        return Some(theorem::show_entry(entry, output));
    }
    let path = Path::new(input);
    if !path.is_file() {
        return None;
    }
    let bytes = read_bytes(path, BYTE_LIMIT).ok()?;
    format::recognise(&bytes)?;
    let cbor = format::to_cbor(&bytes).ok()?;
    theorem::is_theorem(&cbor).then(|| theorem::show_certificate(input, &cbor, output))
}

fn show<const D: usize>(tiling: &Tiling<D>, all: bool, output: &mut Output) {
    output.line(format!(
        "dimension {D}, lattice of rank {}; {} vertices and {} simplices in a cell",
        tiling.frame.rank(),
        tiling.vertices.len(),
        tiling.len()
    ));
    show_frame(&tiling.frame, output);
    let shapes = shapes(tiling);
    let shown = if all { shapes.len() } else { SHAPES };
    for shape in shapes.iter().take(shown) {
        let edges: Vec<String> = shape.squared_edges.iter().map(Number::to_string).collect();
        output.line(format!(
            "{} simplices with squared edges {}",
            shape.members.len(),
            edges.join(", ")
        ));
        output.line(format!(
            "  dihedral angles {}",
            angles(tiling, shape.members[0]).join(", ")
        ));
    }
    if shapes.len() > shown {
        let (more, total) = (shapes.len() - shown, shapes.len());
        output.line(format!(
            "and {more} more of {total} shapes; --all lists them"
        ));
    }
}

fn show_frame<const D: usize>(frame: &Frame<D>, output: &mut Output) {
    if frame.field.degree() == 1 {
        output.line("field: the rational numbers");
    } else {
        let polynomial: Vec<String> = frame
            .field
            .polynomial()
            .iter()
            .map(ToString::to_string)
            .collect();
        let (lower, upper) = frame.field.root();
        output.line(format!(
            "field: Q(a), a the root between {lower} and {upper} of the polynomial with \
             coefficients {} (constant first)",
            polynomial.join(", ")
        ));
    }
    output.line("Gram matrix of the basis:");
    for row in &frame.gram {
        let entries: Vec<String> = row.iter().map(Number::to_string).collect();
        output.line(format!("  {}", entries.join("  ")));
    }
}

/// The dihedral angles of a simplex in degrees, in the order of its pairs of facets.
fn angles<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> Vec<String> {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(simplex).normal_products(&cogram);
    products
        .pairs()
        .map(|(i, j, _)| {
            dihedral_degrees(&products, (i, j), &display_width())
                .map_or_else(|| "none".to_owned(), |degrees| decimal_range(&degrees))
        })
        .collect()
}
