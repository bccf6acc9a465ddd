//! `acutile draw`: figures for print.

use super::extension::{self, Format};
use super::input::{self, FileArguments};
use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::progress::Progress;
use acutile_core::tiling::AnyTiling;
use acutile_exact::number::{Number, parse_rational};
use acutile_publish::draw::svg::svg;
use acutile_publish::draw::tikz::tikz;
use acutile_publish::draw::{self, DrawError, Figure, Options, foam};
use clap::{Args, ValueEnum};
use malachite::Rational;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct DrawArguments {
    /// A name of the catalogue, or a tiling or mesh file
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    /// What is drawn; the cell where nothing is said, in the plane the tiling
    #[arg(long, value_enum)]
    pub figure: Option<FigureName>,
    /// The number that the construction depends on (see acutile show)
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// The vertex of the star, counted from 0
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub vertex: usize,
    /// How far exploded tetrahedra move out, in parts of their distance from the middle
    #[arg(long, value_name = "PART", default_value = "1", value_parser = part)]
    pub apart: Rational,
    /// The direction to the eye: x along the first lattice vector, z up
    #[arg(long, value_name = "X,Y,Z", default_value = "4,-9,5", value_parser = direction, allow_hyphen_values = true)]
    pub view: Direction,
    /// How it is written; svg where neither this nor the name of the file says it
    #[arg(long, value_enum)]
    pub format: Option<DrawFormat>,
    /// With --format tikz: a document of its own, not a fragment to \input
    #[arg(long)]
    pub standalone: bool,
    /// The width in millimetres, 20 to 1000; a journal column where nothing is said
    #[arg(long, value_name = "MM", default_value_t = 84, value_parser = clap::value_parser!(u16).range(20..=1000))]
    pub width: u16,
    /// Write here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Cartesian coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Direction(pub [f64; 3]);

/// The kinds of figures.
#[derive(Clone, Copy, Debug, ValueEnum)]
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
    /// The tetrahedra of a cell, moved apart
    Exploded,
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
            FigureName::Exploded => Figure::Exploded,
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

fn part(text: &str) -> Result<Rational, String> {
    match parse_rational(text) {
        Ok(part) if (Rational::from(0)..=Rational::from(100)).contains(&part) => Ok(part),
        _ => Err("expected a number from 0 to 100".to_owned()),
    }
}

/// Writes the figure.
pub fn run(arguments: &DrawArguments, output: &mut Output) -> Outcome {
    let path = arguments.output.as_deref();
    let format = match extension::format(path, arguments.format, &FORMATS) {
        Ok(format) => format,
        Err(message) => {
            output.complain(format!("acutile: {message}"));
            return Outcome::Failed;
        }
    };
    if arguments.standalone && format != DrawFormat::Tikz {
        output.complain("acutile: --standalone is for --format tikz");
        return Outcome::Failed;
    }
    let input = &arguments.input;
    let named = match input::tiling(input, arguments.param.as_deref(), &arguments.file, output) {
        Ok(named) => named,
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            return error.outcome;
        }
    };
    if let DrawFormat::Obj | DrawFormat::Stl = format {
        return solids(arguments, format, &named.name, &named.tiling, output);
    }
    let progress = Progress::of(&named.name);
    progress.step("draw");
    let figure = figure(arguments.figure, &named.tiling);
    let drawing = draw::draw(&named.name, &named.tiling, figure, &options(arguments));
    drop(progress);
    let drawing = match drawing {
        Ok(drawing) => drawing,
        Err(error) => return no_figure(input, &error, output),
    };
    let text = match format {
        DrawFormat::Svg => svg(&drawing),
        _ => tikz(&drawing, arguments.standalone),
    };
    write_text(path, &text, output)
}

const FORMATS: [Format<DrawFormat>; 4] = [
    (DrawFormat::Svg, "SVG", &["svg"]),
    (DrawFormat::Tikz, "TikZ", &["tex", "tikz", "pgf", "ltx"]),
    (DrawFormat::Obj, "OBJ", &["obj"]),
    (DrawFormat::Stl, "STL", &["stl"]),
];

fn no_figure(input: &str, error: &DrawError, output: &mut Output) -> Outcome {
    output.complain(format!("acutile: {input}: {error}"));
    match error.is_limit() {
        true => Outcome::Declined,
        false => Outcome::Failed,
    }
}

/// The cells of a foam as OBJ or STL.
fn solids(
    arguments: &DrawArguments,
    format: DrawFormat,
    name: &str,
    tiling: &AnyTiling,
    output: &mut Output,
) -> Outcome {
    let text = match (arguments.figure, tiling) {
        (Some(FigureName::Foam), AnyTiling::Space(tiling)) => {
            foam::foam(tiling).and_then(|cells| match format {
                DrawFormat::Obj => foam::obj(name, tiling, &cells),
                _ => foam::stl(tiling, &cells),
            })
        }
        (Some(FigureName::Foam), AnyTiling::Plane(_)) => Err(DrawError::NotSolid),
        _ => {
            output.complain("acutile: --format obj and stl are for --figure foam");
            return Outcome::Failed;
        }
    };
    match text {
        Ok(text) => write_text(arguments.output.as_deref(), &text, output),
        Err(error) => no_figure(&arguments.input, &error, output),
    }
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
        vertex: arguments.vertex,
        apart: arguments.apart.clone(),
        width: f64::from(arguments.width),
    }
}
