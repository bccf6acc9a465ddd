//! `acutile show`: describes a tiling, before anything about it is proved.

use super::input::{self, FileArguments, Loaded, Read, is_theorem};
use super::name::InputName;
use super::named::{InputError, Named, NamedFamily};
use super::outcome::Outcome;
use super::output::Output;
use super::record::Record;
use super::show_theorem::{self, Shown};
use super::words::one_line;
use acutile_catalog as catalog;
use acutile_core::family::spans::{Extreme, Spans, spans};
use acutile_core::family::{Family, point_in_words};
use acutile_core::format;
use acutile_core::predicates::Model;
use acutile_core::quality::{
    DihedralAngle, Exact, decimal_range, dihedral_degrees, display_width, exact_ranges, shapes,
    short_number, squared_edges,
};
use acutile_core::statement::counted;
use acutile_core::tiling::{SimplexId, Tiling};
use acutile_core::{with_dimension, with_family};
use acutile_exact::geometry::linear;
use acutile_exact::number::Field;
use acutile_exact::polynomial::Polynomial;
use clap::Args;
use serde_json::{Value, json};

#[derive(Debug, Args)]
pub struct ShowArguments {
    /// A name of the catalogue, a tiling or mesh file, or a point set (CIF too)
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub input: InputName,
    #[command(flatten)]
    pub file: FileArguments,
    /// The parameter of a construction, like 3/7 or sqrt(2)/4: a/e of goldberg-1, goldberg-2 and goldberg-3,
    /// epsilon of two-corners
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// List all shapes instead of the first 20
    #[arg(long)]
    pub all: bool,
    /// Print exact numbers in full. Without it long numbers are printed as decimals; JSON always has exact
    /// numbers
    #[arg(long)]
    pub exact: bool,
}

/// Shapes that are printed without --all.
const SHAPES: usize = 20;

/// How much of a tiling is printed.
#[derive(Clone, Copy)]
struct List {
    /// All shapes.
    all: bool,
    /// Long numbers in full.
    exact: bool,
}

/// Prints counts, lattice, field and shapes.
pub fn run(arguments: &ShowArguments, output: &mut Output) -> Outcome {
    let input = &arguments.input;
    let shown = match shown(arguments, output) {
        Ok(shown) => shown,
        Err(error) => return output.fail(Some(input), &error),
    };
    if output.is_json() {
        output.answer(Record::of(Some(input)).with(shown.data))
    } else {
        shown.lines.iter().for_each(|line| output.line(line))
    }
    Outcome::Done
}

fn shown(arguments: &ShowArguments, output: &mut Output) -> Result<Shown, InputError> {
    let (input, parameter) = (&arguments.input, arguments.param.as_deref());
    if let Some(entry) = catalog::theorem(input) {
        return show_theorem::of_entry(entry).map_err(InputError::from);
    }
    let read = input::read(input, parameter, &arguments.file, output)?;
    if let Some(shown) = of_theorem(input, &read) {
        return shown.map_err(InputError::from);
    }
    match read.loaded(input)? {
        Loaded::Family(named) => Ok(of_family(&named)),
        loaded => {
            let named = loaded.tiling(input, &arguments.file, output)?;
            let is_whole = output.is_json();
            let list = List {
                all: arguments.all || is_whole,
                exact: arguments.exact || is_whole,
            };
            Ok(of_tiling(&named, list))
        }
    }
}

/// The certificate of a theorem.
fn of_theorem(input: &InputName, read: &Read) -> Option<Result<Shown, String>> {
    let Read::Certificate(bytes) = read else {
        return None;
    };
    let cbor = format::to_cbor(bytes).ok()?;
    is_theorem(&cbor).then(|| show_theorem::of_certificate(input, &cbor))
}

fn of_tiling(named: &Named, list: List) -> Shown {
    let mut shown = with_dimension!(&named.tiling, AnyTiling, t => show(t, list));
    let title = format!("{}: {}", named.name, one_line(&named.description));
    shown.lines.insert(0, title);
    shown.data["description"] = json!(named.description);
    shown
}

fn show<const D: usize>(tiling: &Tiling<D>, list: List) -> Shown {
    let frame = &tiling.frame;
    let (rank, vertices) = (frame.rank(), tiling.vertices.len());
    let mut lines = vec![
        format!(
            "dimension {D}, lattice of rank {rank}; {} and {} in a cell",
            counted(vertices, "vertex", "vertices"),
            counted(tiling.len(), "simplex", "simplices")
        ),
        field_in_words(&frame.field),
        "Gram matrix of the basis:".to_owned(),
    ];
    let gram = frame
        .gram
        .each_ref()
        .map(|row| row.each_ref().map(|entry| short_number(entry, list.exact)));
    lines.extend(gram.iter().map(|row| format!("  {}", row.join("  "))));
    let shapes = shapes(tiling);
    let shown = if list.all { shapes.len() } else { SHAPES };
    let mut data = Vec::new();
    for shape in shapes.iter().take(shown) {
        let edges = edges_and_angles(tiling, shape.members[0], list);
        lines.push(format!(
            "{}:",
            counted(shape.members.len(), "simplex", "simplices")
        ));
        lines.push(format!("  {}", edges_in_words(&edges, D)));
        data.push(json!({ "simplices": shape.members.len(), "edges": edges_data(&edges, D) }));
    }
    if shapes.len() > shown {
        let (more, total) = (shapes.len() - shown, shapes.len());
        lines.push(format!(
            "and {more} more of {total} shapes; --all lists them"
        ));
    }
    let data = json!({
        "dimension": D,
        "rank": rank,
        "vertices": vertices,
        "simplices": tiling.len(),
        "field": field_data(&frame.field),
        "gram": gram.map(|row| row.to_vec()).to_vec(),
        "shapes": data,
    });
    Shown { lines, data }
}

fn of_family(named: &NamedFamily) -> Shown {
    let mut shown = with_family!(&named.family, f => show_family(f));
    let title = format!("{}: {}", named.name, one_line(&named.description));
    shown.lines.insert(0, title);
    shown.data["description"] = json!(named.description);
    shown
}

/// Parameters, box, polynomials, and the angles of some members.
fn show_family<const D: usize>(family: &Family<D>) -> Shown {
    let names = family.names();
    let frame = &family.frame;
    let (rank, vertices) = (frame.rank(), family.vertices.len());
    let mut lines = vec![format!(
        "dimension {D}, lattice of rank {rank}; {} and {} in a cell",
        counted(vertices, "vertex", "vertices"),
        counted(family.len(), "simplex", "simplices")
    )];
    let parameters = family.parameters.iter();
    let parameters: Vec<(String, String)> = parameters
        .map(|parameter| (parameter.name.to_string(), parameter.side.to_string()))
        .collect();
    let row = |row: &[Polynomial]| -> Vec<String> { row.iter().map(|p| p.shown(&names)).collect() };
    let indented = |row: &Vec<String>| format!("  {}", row.join(", "));
    let sides = parameters.iter();
    lines.extend(sides.map(|(name, side)| format!("parameter {name} in {side}")));
    lines.push(field_in_words(&frame.field));
    lines.push("Gram matrix of the basis:".to_owned());
    let gram: Vec<Vec<String>> = frame.gram.iter().map(|entries| row(entries)).collect();
    lines.extend(gram.iter().map(indented));
    if let Some(polytope) = frame.domain.polytope() {
        lines.push("vertices of the domain, in the last coordinates:".to_owned());
        let corners = polytope.vertices.iter();
        lines.extend(corners.map(|vertex| indented(&row(vertex))));
    }
    lines.push("vertices:".to_owned());
    let vertices = family.vertices.iter();
    lines.extend(vertices.map(|vertex| indented(&row(vertex))));
    let spans = (names.len() <= MOST_SHOWN).then(|| span_words(&spans(family)));
    let over_box = spans.iter().flatten();
    lines.extend(over_box.map(|(name, low, high)| {
        format!(
            "{name} dihedral angles of the simplices over the box: infimum {low}, supremum {high}"
        )
    }));
    let members = angles_of_members(family);
    lines.extend(members.iter().map(|(place, angles)| match angles {
        Some((low, high)) => format!("dihedral angles at {place}: smallest {low}, largest {high}"),
        None => format!("no simplices at {place}"),
    }));
    let members = members
        .iter()
        .map(|(place, angles)| json!({ "point": place, "dihedral": angles }));
    let parameters = parameters.iter();
    let data = json!({
        "dimension": D,
        "rank": rank,
        "vertices": family.vertices.len(),
        "simplices": family.len(),
        "parameters": parameters.map(|(name, side)| json!({ "name": name, "interval": side })).collect::<Vec<_>>(),
        "field": field_data(&frame.field),
        "gram": gram,
        "members": members.collect::<Vec<_>>(),
        "over_box": spans.map(|spans| spans.iter().map(|(name, low, high)| {
            json!({ "angles": name, "infimum": low, "supremum": high })
        }).collect::<Vec<_>>()),
    });
    Shown { lines, data }
}

/// The smallest and the largest dihedral angle in the middle of the box and at its corners.
fn angles_of_members<const D: usize>(
    family: &Family<D>,
) -> Vec<(String, Option<(String, String)>)> {
    let names = family.names();
    let cuboid = family.cuboid();
    let corners = if names.len() <= MOST_SHOWN {
        cuboid.corners()
    } else {
        Vec::new()
    };
    let points = std::iter::once(cuboid.center()).chain(corners);
    points
        .map(|point| {
            let ranges = exact_ranges(&Model::new(&family.at(&point)));
            let angles = ranges.map(|ranges| {
                let (low, high) = (ranges.smallest_dihedral.min, ranges.largest_dihedral.max);
                (degrees(&low), degrees(&high))
            });
            (point_in_words(&names, &point), angles)
        })
        .collect()
}

/// The least and the greatest angles over the box: each is in the enclosure that is printed.
fn span_words(spans: &Spans) -> Vec<(&'static str, String, String)> {
    let degrees = |extreme: &Extreme<DihedralAngle>| match (&extreme.bound, &extreme.seen) {
        (Some(bound), Some(seen)) => {
            let (low, high) = if bound < seen {
                (bound, seen)
            } else {
                (seen, bound)
            };
            let (low, _) = low.enclosure(&display_width());
            let (_, high) = high.enclosure(&display_width());
            decimal_range(&(low, high))
        }
        _ => "not bounded".to_owned(),
    };
    let spans = [
        ("smallest", &spans.smallest_dihedral),
        ("largest", &spans.largest_dihedral),
    ];
    let spans = spans.into_iter();
    spans
        .map(|(name, span)| (name, degrees(&span.infimum), degrees(&span.supremum)))
        .collect()
}

/// Boxes with more sides have too many corners to show.
const MOST_SHOWN: usize = 4;

fn degrees(angle: &DihedralAngle) -> String {
    decimal_range(&angle.enclosure(&display_width()))
}

fn field_in_words(field: &Field) -> String {
    if field.degree() == 1 {
        return "field: the rational numbers".to_owned();
    }
    let polynomial: Vec<String> = field.polynomial().iter().map(ToString::to_string).collect();
    let (lower, upper) = field.root();
    format!(
        "field: Q(a), a the root between {lower} and {upper} of the polynomial with \
         coefficients {} (constant first)",
        polynomial.join(", ")
    )
}

/// `null` for the rational numbers.
fn field_data(field: &Field) -> Value {
    if field.degree() == 1 {
        return Value::Null;
    }
    let polynomial: Vec<String> = field.polynomial().iter().map(ToString::to_string).collect();
    let (lower, upper) = field.root();
    json!({ "polynomial": polynomial, "root": [lower.to_string(), upper.to_string()] })
}

/// The squared edges of a simplex. In space each has the dihedral angle at it, in the plane the angle
/// opposite to it.
fn edges_and_angles<const D: usize>(
    tiling: &Tiling<D>,
    simplex: SimplexId,
    list: List,
) -> Vec<(String, Option<String>)> {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(simplex).normal_products(&cogram);
    let edges = squared_edges(tiling, simplex);
    let corners = (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j)));
    corners
        .zip(edges)
        .map(|((i, j), edge)| {
            let others: Vec<usize> = (0..=D).filter(|k| *k != i && *k != j).collect();
            let pair = match others.as_slice() {
                [k, l] => (*k, *l),
                _ => (i, j),
            };
            let angle = dihedral_degrees(&products, pair, &display_width());
            (
                short_number(&edge, list.exact),
                angle.map(|degrees| decimal_range(&degrees)),
            )
        })
        .collect()
}

fn edges_in_words(edges: &[(String, Option<String>)], dimension: usize) -> String {
    let place = match dimension {
        3 => "with angle",
        _ => "opposite to angle",
    };
    let words = edges.iter().map(|(edge, angle)| {
        let angle = angle.as_deref().unwrap_or("none");
        format!("squared edge {edge} {place} {angle}")
    });
    words.collect::<Vec<_>>().join(", ")
}

fn edges_data(edges: &[(String, Option<String>)], dimension: usize) -> Value {
    let name = match dimension {
        3 => "angle",
        _ => "opposite_angle",
    };
    let edges = edges
        .iter()
        .map(|(edge, angle)| json!({ "squared": edge, name: angle }));
    edges.collect()
}
