//! `acutile draw`: figures for print.

use super::extension::{self, Format};
use super::family::member_at;
use super::input::{self, FileArguments, Loaded};
use super::integer::integer_in;
use super::name::InputName;
use super::named::{InputError, Named};
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_output;
use super::progress::Progress;
use super::record::Record;
use acutile_core::tiling::AnyTiling;
use acutile_exact::number::{Number, parse_rational};
use acutile_publish::draw::pdf::pdf;
use acutile_publish::draw::png::png;
use acutile_publish::draw::svg::svg;
use acutile_publish::draw::tikz::tikz;
use acutile_publish::draw::{self, DrawError, Drawing, Figure, Options, foam};
use clap::{Args, ValueEnum};
use malachite::Rational;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct DrawArguments {
    /// A name of the catalogue, or a tiling or mesh file
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub input: InputName,
    /// The kind of figure. The default is cell, and for a tiling of the plane it is plane
    #[arg(long, value_enum)]
    pub figure: Option<FigureName>,
    /// The parameter of a construction (see acutile show --help)
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// The point of a family's box: a value for each parameter, separated by commas. The default is the
    /// middle of the box
    #[arg(long, value_name = "POINT", allow_hyphen_values = true)]
    pub at: Option<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// The vertex of --figure star, counted from 0; without it vertex 0
    #[arg(long, value_name = "N")]
    pub vertex: Option<usize>,
    /// The direction to the eye: x along the first lattice vector, z up
    #[arg(long, value_name = "X,Y,Z", default_value = "4,-9,5", value_parser = direction, allow_hyphen_values = true)]
    pub view: Direction,
    /// The output format. The default is that of the file name, or svg
    #[arg(long, value_enum)]
    pub format: Option<DrawFormat>,
    /// With --format tikz: write a complete document instead of a fragment for \input
    #[arg(long)]
    pub standalone: bool,
    /// The width in millimetres, 20 to 1000. The default is the width of a journal column
    #[arg(long, value_name = "MM", default_value_t = 84, value_parser = integer_in::<u16>(20..=1000))]
    pub width: u16,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Cartesian coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Direction(pub [f64; 3]);

/// The kinds of figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FigureName {
    /// One simplex of each congruence class, with its angles
    Classes,
    /// The tetrahedra of a cell, and the cell
    Cell,
    /// The tetrahedra at a vertex
    Star,
    /// The Voronoi cells of the vertices, one of each kind; with --format obj or stl all
    Foam,
    /// The neighbours of the vertices as a polyhedron, one of each kind
    Coordination,
    /// The slab in its eight steps
    Steps,
    /// A tiling of the plane, or the square/triangle tiling under a structure with its dots
    Plane,
}

/// How a figure is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DrawFormat {
    Svg,
    Tikz,
    /// With its font, so that it looks the same everywhere
    Pdf,
    /// 300 dots per inch, on white
    Png,
    /// The cells of --figure foam as polygons
    Obj,
    /// The cells of --figure foam as triangles
    Stl,
}

impl FigureName {
    fn figure(self) -> Figure {
        match self {
            FigureName::Classes => Figure::Classes,
            FigureName::Cell => Figure::Cell,
            FigureName::Star => Figure::Star,
            FigureName::Foam => Figure::Foam,
            FigureName::Coordination => Figure::Coordination,
            FigureName::Steps => Figure::Steps,
            FigureName::Plane => Figure::Plane,
        }
    }
}

fn direction(text: &str) -> Result<Direction, String> {
    let expected = || "expected three numbers like 4,-9,5, not all 0".to_owned();
    let entries = text.split(',').map(|entry| parse_rational(entry.trim()));
    let entries: Vec<Rational> = entries.collect::<Result<_, _>>().map_err(|_| expected())?;
    let entries: [Rational; 3] = entries.try_into().map_err(|_| expected())?;
    if entries.iter().all(|x| *x == 0) {
        return Err(expected());
    }
    Ok(Direction(entries.map(|x| Number::from(x).approximate())))
}

/// Writes the figure.
pub fn run(arguments: &DrawArguments, output: &mut Output) -> Outcome {
    output.document_goes_to(arguments.output.as_deref());
    match write(arguments, output) {
        Ok(()) => output.done(Record::of(Some(&arguments.input))),
        Err(error) => output.fail(Some(&arguments.input), &error),
    }
}

fn write(arguments: &DrawArguments, output: &mut Output) -> Result<(), InputError> {
    let path = arguments.output.as_deref();
    check_output(path, "-o", std::slice::from_ref(&arguments.input))?;
    let format = extension::format(path, arguments.format, &FORMATS)?;
    if arguments.standalone && format != DrawFormat::Tikz {
        return Err("--standalone is for --format tikz".to_owned().into());
    }
    if arguments.vertex.is_some() && arguments.figure != Some(FigureName::Star) {
        return Err("--vertex is for --figure star".to_owned().into());
    }
    let input = &arguments.input;
    let named = subject(arguments, output)?;
    let (name, tiling) = (&named.name, &named.tiling);
    let bytes = match format {
        DrawFormat::Obj | DrawFormat::Stl => solids(arguments, format, name, tiling)?.into_bytes(),
        _ => {
            let progress = Progress::of(name);
            progress.step("draw");
            let figure = figure(arguments.figure, tiling);
            let drawing = draw::draw(name, tiling, figure, &options(arguments))
                .map_err(|error| no_figure(input, &error))?;
            encoded(&drawing, format, arguments.standalone)
                .map_err(|error| no_figure(input, &error))?
        }
    };
    write_bytes(path, &bytes, output)
}

/// A drawing in a format for drawings.
fn encoded(
    drawing: &Drawing,
    format: DrawFormat,
    is_standalone: bool,
) -> Result<Vec<u8>, DrawError> {
    match format {
        DrawFormat::Tikz => Ok(tikz(drawing, is_standalone).into_bytes()),
        DrawFormat::Pdf => pdf(drawing),
        DrawFormat::Png => png(drawing),
        DrawFormat::Svg | DrawFormat::Obj | DrawFormat::Stl => Ok(svg(drawing).into_bytes()),
    }
}

/// The tiling of the input; of a family the member at --at.
fn subject(arguments: &DrawArguments, output: &mut Output) -> Result<Named, InputError> {
    let (input, parameter) = (&arguments.input, arguments.param.as_deref());
    let family = match input::open(input, parameter, &arguments.file, output)? {
        Loaded::Family(family) => family,
        _ if arguments.at.is_some() => {
            return Err(format!("{input}: --at is for a family, which this is not").into());
        }
        loaded => return loaded.tiling(input, &arguments.file, output),
    };
    let (tiling, point) = member_at(&family.family, arguments.at.as_deref())
        .map_err(|message| format!("{input}: {message}"))?;
    output.note(input, &format!("the member at {point}"));
    Ok(Named::of(&family.name, family.description, tiling))
}

const FORMATS: [Format<DrawFormat>; 6] = [
    (DrawFormat::Svg, "SVG", &["svg"]),
    (DrawFormat::Tikz, "TikZ", &["tex", "tikz", "pgf", "ltx"]),
    (DrawFormat::Pdf, "PDF", &["pdf"]),
    (DrawFormat::Png, "PNG", &["png"]),
    (DrawFormat::Obj, "OBJ", &["obj"]),
    (DrawFormat::Stl, "STL", &["stl"]),
];

fn no_figure(input: &str, error: &DrawError) -> InputError {
    InputError {
        message: format!("{input}: {error}"),
        outcome: if error.is_limit() {
            Outcome::Declined
        } else {
            Outcome::Failed
        },
    }
}

/// The cells of a foam as OBJ or STL.
fn solids(
    arguments: &DrawArguments,
    format: DrawFormat,
    name: &str,
    tiling: &AnyTiling,
) -> Result<String, InputError> {
    let text = match (arguments.figure, tiling) {
        (Some(FigureName::Foam), AnyTiling::Space(tiling)) => {
            foam::foam(tiling).and_then(|cells| match format {
                DrawFormat::Obj => foam::obj(name, tiling, &cells),
                _ => foam::stl(tiling, &cells),
            })
        }
        (Some(FigureName::Foam), AnyTiling::Plane(_)) => Err(DrawError::NotSolid),
        _ => {
            let message = "--format obj and stl are for --figure foam";
            return Err(message.to_owned().into());
        }
    };
    text.map_err(|error| no_figure(&arguments.input, &error))
}

fn figure(asked: Option<FigureName>, tiling: &AnyTiling) -> Figure {
    match (asked, tiling) {
        (Some(name), _) => name.figure(),
        (None, AnyTiling::Plane(_)) => Figure::Plane,
        (None, AnyTiling::Space(_)) => Figure::Cell,
    }
}

fn options(arguments: &DrawArguments) -> Options {
    Options {
        direction: arguments.view.0,
        vertex: arguments.vertex.unwrap_or(0),
        width: f64::from(arguments.width),
    }
}
