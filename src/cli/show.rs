//! `acutile show`: what a tiling is, before anything about it is proved.

use super::input::{self, FileArguments, Loaded};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::theorem;
use acutile_catalog as catalog;
use acutile_core::family::{Family, point_in_words};
use acutile_core::format;
use acutile_core::predicates::Model;
use acutile_core::quality::{
    DihedralAngle, Exact, decimal_range, dihedral_degrees, display_width, exact_ranges, shapes,
    squared_edges,
};
use acutile_core::tiling::{Frame, SimplexId, Tiling};
use acutile_core::{with_dimension, with_family};
use acutile_exact::geometry::linear;
use acutile_exact::number::{Field, Number};
use acutile_exact::polynomial::Polynomial;
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
    match input::open(
        &arguments.input,
        arguments.param.as_deref(),
        &arguments.file,
        output,
    ) {
        Ok(Loaded::Family(named)) => {
            output.line(format!("{}: {}", named.name, named.description));
            with_family!(&named.family, f => show_family(f, output));
            Outcome::Done
        }
        Ok(loaded) => match loaded.tiling(&arguments.input, &arguments.file, output) {
            Ok(named) => {
                output.line(format!("{}: {}", named.name, named.description));
                with_dimension!(&named.tiling, AnyTiling, t => show(t, arguments.all, output));
                Outcome::Done
            }
            Err(error) => failed(&error, output),
        },
        Err(error) => failed(&error, output),
    }
}

fn failed(error: &InputError, output: &mut Output) -> Outcome {
    output.complain(format!("acutile: {}", error.message));
    error.outcome
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
        output.line(format!("{} simplices:", shape.members.len()));
        output.line(format!("  {}", edges_and_angles(tiling, shape.members[0])));
    }
    if shapes.len() > shown {
        let (more, total) = (shapes.len() - shown, shapes.len());
        output.line(format!(
            "and {more} more of {total} shapes; --all lists them"
        ));
    }
}

/// Parameters, box, polynomials, and the angles of some members.
fn show_family<const D: usize>(family: &Family<D>, output: &mut Output) {
    let names = family.names();
    output.line(format!(
        "dimension {D}, lattice of rank {}; {} vertices and {} simplices in a cell",
        family.frame.rank(),
        family.vertices.len(),
        family.len()
    ));
    for parameter in &family.parameters {
        output.line(format!(
            "parameter {} in {}",
            parameter.name, parameter.side
        ));
    }
    show_field(&family.frame.field, output);
    output.line("Gram matrix of the basis:");
    let row = |row: &[Polynomial]| {
        let entries: Vec<String> = row.iter().map(|p| p.shown(&names)).collect();
        format!("  {}", entries.join(", "))
    };
    family
        .frame
        .gram
        .iter()
        .for_each(|entries| output.line(row(entries)));
    if let Some(polytope) = family.frame.domain.polytope() {
        output.line("vertices of the domain, in the last coordinates:");
        polytope
            .vertices
            .iter()
            .for_each(|vertex| output.line(row(vertex)));
    }
    output.line("vertices:");
    family
        .vertices
        .iter()
        .for_each(|vertex| output.line(row(vertex)));
    let cuboid = family.cuboid();
    let corners = if names.len() <= MOST_SHOWN {
        cuboid.corners()
    } else {
        Vec::new()
    };
    for point in std::iter::once(cuboid.center()).chain(corners) {
        let member = family.at(&point);
        let place = point_in_words(&names, &point);
        match exact_ranges(&Model::new(&member)) {
            Some(ranges) => output.line(format!(
                "dihedral angles at {place}: {} to {}",
                degrees(&ranges.smallest_dihedral.min),
                degrees(&ranges.largest_dihedral.max)
            )),
            None => output.line(format!("no simplices at {place}")),
        }
    }
}

/// Boxes with more sides have too many corners to show.
const MOST_SHOWN: usize = 4;

fn degrees(angle: &DihedralAngle) -> String {
    decimal_range(&angle.enclosure(&display_width()))
}

fn show_field(field: &Field, output: &mut Output) {
    if field.degree() == 1 {
        return output.line("field: the rational numbers");
    }
    let polynomial: Vec<String> = field.polynomial().iter().map(ToString::to_string).collect();
    let (lower, upper) = field.root();
    output.line(format!(
        "field: Q(a), a the root between {lower} and {upper} of the polynomial with \
         coefficients {} (constant first)",
        polynomial.join(", ")
    ));
}

fn show_frame<const D: usize>(frame: &Frame<D>, output: &mut Output) {
    show_field(&frame.field, output);
    output.line("Gram matrix of the basis:");
    for row in &frame.gram {
        let entries: Vec<String> = row.iter().map(Number::to_string).collect();
        output.line(format!("  {}", entries.join("  ")));
    }
}

/// The squared edges of a simplex, in space each with the dihedral angle at it; in the plane the squared
/// edges and the angles opposite to them.
fn edges_and_angles<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> String {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(simplex).normal_products(&cogram);
    let angle = |pair: (usize, usize)| {
        dihedral_degrees(&products, pair, &display_width())
            .map_or_else(|| "none".to_owned(), |degrees| decimal_range(&degrees))
    };
    let edges = squared_edges(tiling, simplex);
    let corners = (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j)));
    let texts: Vec<String> = corners
        .zip(edges)
        .map(|((i, j), edge)| {
            let others: Vec<usize> = (0..=D).filter(|k| *k != i && *k != j).collect();
            match others.as_slice() {
                [k, l] => format!("squared edge {edge} with angle {}", angle((*k, *l))),
                _ => format!("squared edge {edge} opposite to angle {}", angle((i, j))),
            }
        })
        .collect();
    texts.join(", ")
}
