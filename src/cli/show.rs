//! `acutile show`: what a tiling is, before anything about it is proved.

use super::input::{self, FileArguments};
use super::outcome::Outcome;
use super::output::Output;
use acutile_core::quality::{decimal_range, dihedral_degrees, display_width, shapes};
use acutile_core::tiling::{Frame, SimplexId, Tiling};
use acutile_core::with_dimension;
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use clap::Args;

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
}

/// Prints counts, lattice, field and shapes.
pub fn run(arguments: &ShowArguments, output: &mut Output) -> Outcome {
    match input::tiling(
        &arguments.input,
        arguments.param.as_deref(),
        &arguments.file,
        output,
    ) {
        Ok(named) => {
            output.line(format!("{}: {}", named.name, named.description));
            with_dimension!(&named.tiling, AnyTiling, t => show(t, output));
            Outcome::Done
        }
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            error.outcome
        }
    }
}

fn show<const D: usize>(tiling: &Tiling<D>, output: &mut Output) {
    output.line(format!(
        "dimension {D}, lattice of rank {}; {} vertices and {} simplices in a cell",
        tiling.frame.rank(),
        tiling.vertices.len(),
        tiling.len()
    ));
    show_frame(&tiling.frame, output);
    for shape in shapes(tiling) {
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
