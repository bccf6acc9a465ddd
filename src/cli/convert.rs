//! `acutile convert`: meshes and tilings written in other formats; certificates are for [`transcribe`].

use super::export::{copies, supercell_sizes};
use super::files::unwritten;
use super::input::{self, FileArguments, TextOrMesh};
use super::name::InputName;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_output;
use super::progress::Progress;
use super::record::Record;
use super::{mesh, transcribe};
use acutile_catalog as catalog;
use acutile_core::tiling::{AnyTiling, Tiling, supercell};
use acutile_core::with_dimension;
use acutile_exact::number::Number;
use acutile_io::export::tiling_text;
use acutile_io::import::is_gzip;
use acutile_io::mesh::lattice::Basis;
use acutile_io::mesh::load::{Loaded, tetgen_paths};
use acutile_io::mesh::sink::Shortest;
use acutile_io::mesh::writer::{changes, losses};
use acutile_io::mesh::{Family, File, Flat, Format, Mesh, flatten, patch, write};
use clap::Args;
use flate2::Compression;
use flate2::write::GzEncoder;
use malachite::Rational;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct ConvertArguments {
    /// A name of the catalogue, a tiling file, a mesh file or a certificate (`-` for standard input)
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub input: InputName,
    /// The file to write (`-` for standard output). Its extension is the format: msh, vtk, vtu, mesh, meshb,
    /// node or ele, or json for a tiling file. With .gz after it the file is compressed. For a certificate json
    /// and cbor are its two encodings
    #[arg(value_name = "FILE")]
    pub output: PathBuf,
    /// The parameter of a construction (see acutile show --help)
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// The format to write: msh2, msh2-binary, msh4, msh4-binary, vtk, vtk-binary, vtu-text,
    /// vtu-base64, vtu-raw, vtu (compressed), medit, meshb, tetgen
    #[arg(long, value_name = "FORMAT", value_parser = Format::parse)]
    pub to: Option<Format>,
    /// Repeat the cell N times in each direction of the lattice
    #[arg(long, value_name = "N,N,N", value_delimiter = ',', value_parser = copies)]
    pub supercell: Vec<u16>,
    /// Write a bounded mesh of all tetrahedra that lie in the ball of this radius around the origin
    #[arg(long, value_name = "RADIUS", value_parser = radius)]
    pub patch: Option<Rational>,
    /// Round coordinates that are no 64-bit floating-point numbers, and print their number and the largest
    /// change
    #[arg(long)]
    pub round: bool,
    /// The largest size of a certificate in bytes; larger ones are declined
    #[arg(long, value_name = "N", default_value_t = transcribe::BYTES)]
    pub max_bytes: u64,
    #[command(flatten)]
    pub file: FileArguments,
}

impl ConvertArguments {
    /// Whether an option says how a mesh or a tiling is converted.
    fn has_options(&self) -> bool {
        self.param.is_some()
            || self.to.is_some()
            || !self.supercell.is_empty()
            || self.patch.is_some()
            || self.round
    }
}

fn radius(text: &str) -> Result<Rational, String> {
    match acutile_exact::number::parse_rational(text) {
        Ok(value) if value > 0 => Ok(value),
        Ok(_) => Err(format!("found {text}, expected a positive number")),
        Err(error) => Err(error.to_string()),
    }
}

/// Reads, converts, writes.
pub fn run(arguments: &ConvertArguments, output: &mut Output) -> Outcome {
    let (input, path) = (&arguments.input, arguments.output.as_path());
    output.document_goes_to(Some(path));
    match write_output(arguments, output) {
        Ok(()) => output.done(Record::of(Some(input))),
        Err(error) => output.fail(Some(input), &error),
    }
}

fn write_output(arguments: &ConvertArguments, output: &mut Output) -> Result<(), InputError> {
    let (input, path) = (&arguments.input, arguments.output.as_path());
    let inputs = std::slice::from_ref(input);
    for path in outputs(path) {
        check_output(Some(&path), "to", inputs)?;
    }
    let is_to_mesh = arguments.to.is_some() || Family::of_path(path).is_some();
    if transcribe::is_of_certificate(input, path, is_to_mesh) {
        let limit = arguments.max_bytes;
        return transcribe::convert(input, path, arguments.has_options(), limit, output);
    }
    let target = target(arguments)?;
    let progress = Progress::of(input);
    let mut notes = Vec::new();
    let files = convert(arguments, target, &progress, &mut notes, output);
    drop(progress);
    for note in notes {
        output.note(input, &note);
    }
    write_all(path, files?, output)
}

/// The files that are written to this name.
fn outputs(path: &Path) -> Vec<PathBuf> {
    match tetgen_paths(path) {
        Some((nodes, elements)) => vec![nodes, elements],
        None => vec![path.to_path_buf()],
    }
}

/// What is written.
#[derive(Clone, Copy)]
enum Target {
    /// A tiling file.
    Native,
    Mesh(Format),
}

/// As `--to` says, or else the extension.
fn target(arguments: &ConvertArguments) -> Result<Target, String> {
    let path = &arguments.output;
    let family = Family::of_path(path);
    let name = path.to_string_lossy();
    let is_native = name.strip_suffix(".gz").unwrap_or(&name).ends_with(".json");
    match (arguments.to, family) {
        (Some(Format::TetGen), found) if found != Some(Family::TetGen) => Err(format!(
            "{name}: expected a name that ends in .node or .ele for TetGen"
        )),
        (Some(format), _) => Ok(Target::Mesh(format)),
        (None, Some(family)) if !family.is_written() => Err(format!(
            "{name}: this format is read and not written; --to FORMAT writes another one"
        )),
        (None, Some(family)) => Ok(Target::Mesh(family.format())),
        (None, None) if is_native => Ok(Target::Native),
        (None, None) => Err(format!(
            "{name}: the extension names no format that is written, expected .msh, .vtk, .vtu, .mesh, .meshb, .node or \
             .ele, .json for a tiling file, each with .gz or not, .cbor for a certificate; or --to FORMAT"
        )),
    }
}

fn convert(
    arguments: &ConvertArguments,
    target: Target,
    progress: &Progress,
    notes: &mut Vec<String>,
    output: &mut Output,
) -> Result<Vec<File>, InputError> {
    let name = &arguments.input;
    progress.step("reading");
    let stays_mesh = arguments.supercell.is_empty()
        && arguments.patch.is_none()
        && arguments.file.mesh.identify.is_none();
    let (tiling, basis) = match load(arguments, output)? {
        Source::Mesh(loaded) => match target {
            Target::Mesh(format) if stays_mesh => {
                progress.step("writing");
                if arguments.file.mesh.lattice.is_some() {
                    notes.push(UNUSED_LATTICE.to_owned());
                }
                return Ok(write_mesh(&loaded.mesh, format, notes));
            }
            _ => {
                lost_by_tiling(&loaded.mesh, notes);
                let (converted, more) = mesh::converted(name, loaded.mesh, &arguments.file.mesh)?;
                notes.extend(more);
                (converted.tiling, Some(converted.basis))
            }
        },
        Source::Tiling(tiling) => (tiling, None),
    };
    progress.step("writing");
    with_dimension!(tiling, AnyTiling, t => write_tiling(t, basis, arguments, target, notes))
}

/// A tiling, or a part of it, as a file. With a basis it stays where it was.
fn write_tiling<const D: usize>(
    mut tiling: Tiling<D>,
    mut basis: Option<Basis>,
    arguments: &ConvertArguments,
    target: Target,
    notes: &mut Vec<String>,
) -> Result<Vec<File>, InputError> {
    if !arguments.supercell.is_empty() {
        let sizes = supercell_sizes(&tiling, &arguments.supercell)?;
        tiling = supercell(&tiling, sizes);
        basis = basis.map(|basis| enlarged(basis, &sizes));
    }
    if let Some(radius) = &arguments.patch {
        tiling = patch(&tiling, radius).map_err(|error| format!("{}: {error}", arguments.input))?;
    }
    match target {
        Target::Native => Ok(vec![File {
            extension: None,
            bytes: tiling_text(&tiling, &arguments.input).into_bytes(),
        }]),
        Target::Mesh(format) => {
            let flat = flatten(&tiling, basis.as_ref())
                .map_err(|error| format!("{}: {error}", arguments.input))?;
            tell_flat(&flat, arguments, notes)?;
            Ok(write_mesh(&flat.mesh, format, notes))
        }
    }
}

/// From mesh to mesh, labels and numbers stay; a tiling, which has links, has neither.
const UNUSED_LATTICE: &str = "--lattice is not used from a mesh file to a mesh file, which keeps its own \
                              periodic links; --supercell 1,1,1 writes those of --lattice";

/// What is converted.
enum Source {
    Mesh(Loaded),
    Tiling(AnyTiling),
}

/// The mesh of a mesh file, or the tiling of space of a name or a tiling file.
fn load(arguments: &ConvertArguments, output: &mut Output) -> Result<Source, InputError> {
    let name = &arguments.input;
    let path = name.path();
    let is_file = catalog::find(name).is_none() && (name.is_standard_input() || path.exists());
    if is_file && arguments.param.is_some() {
        return Err(format!(
            "{name}: --param is for a name of the catalogue, expected no --param for a file"
        )
        .into());
    }
    let named = if is_file {
        match input::text_or_mesh(path, &arguments.file.mesh)? {
            TextOrMesh::Mesh(loaded) => return Ok(Source::Mesh(loaded)),
            other => input::of_content(name, other, &arguments.file, output)?,
        }
    } else {
        input::tiling(name, arguments.param.as_deref(), &arguments.file, output)?
    };
    Ok(Source::Tiling(named.tiling))
}

fn enlarged(mut basis: Basis, sizes: &[u16]) -> Basis {
    for (vector, size) in basis.vectors.iter_mut().zip(sizes) {
        let factor = Number::from(Rational::from(*size));
        vector.iter_mut().for_each(|x| *x = &*x * &factor);
    }
    basis
}

/// The parts of a mesh that a tiling does not have; elements of other types are named anyway.
fn lost_by_tiling(mesh: &Mesh, notes: &mut Vec<String>) {
    let mut lost = mesh.unread.clone();
    if !mesh.materials().is_empty() {
        lost.push("the labels of cells and their names".to_owned());
    }
    if mesh.dimension() == 2 && mesh.points.iter().any(|point| point[2] != 0.0) {
        lost.push("the height of the plane, now 0".to_owned());
    }
    lost.push("the numbers of nodes and elements".to_owned());
    notes.push(format!("lost: {}", lost.join("; ")));
}

fn write_mesh(mesh: &Mesh, format: Format, notes: &mut Vec<String>) -> Vec<File> {
    let lost = losses(mesh, format);
    if !lost.is_empty() {
        notes.push(format!("lost: {}", lost.join("; ")));
    }
    notes.extend(changes(mesh, format));
    write(mesh, format)
}

/// Rounding is named if it is asked for, and refused otherwise; the lattice is given as an option.
fn tell_flat(
    flat: &Flat,
    arguments: &ConvertArguments,
    notes: &mut Vec<String>,
) -> Result<(), InputError> {
    if flat.rounded > 0 {
        let rounded = format!(
            "{} coordinates have no exact 64-bit floating-point number, which mesh files have; rounding moves them by \
             at most {:.3e}",
            flat.rounded, flat.largest_move
        );
        if arguments.round {
            notes.push(rounded)
        } else {
            let message = format!("{}: {rounded}; --round allows it", arguments.input);
            return Err(message.into());
        }
    }
    if !flat.lattice.is_empty() {
        let row = |row: &[f64; 3]| row.map(|x| Shortest(x).to_string()).join(",");
        let rows: Vec<String> = flat.lattice.iter().map(row).collect();
        let tolerance = match flat.rounded {
            0 => "",
            _ => " and --identify (the coordinates are rounded)",
        };
        notes.push(format!(
            "periodic: read it with --lattice \"{}\"{tolerance}",
            rows.join(";")
        ));
    }
    Ok(())
}

/// Every file, compressed where the name says so.
fn write_all(path: &Path, files: Vec<File>, output: &mut Output) -> Result<(), InputError> {
    let is_packed = is_gzip(path);
    for file in files {
        let path = match (file.extension, tetgen_paths(path)) {
            (Some("node"), Some((nodes, _))) => nodes,
            (Some(_), Some((_, elements))) => elements,
            _ => PathBuf::from(path),
        };
        let bytes = if is_packed {
            packed(&file.bytes).map_err(|error| unwritten(&path, &error))?
        } else {
            file.bytes
        };
        write_bytes(Some(&path), &bytes, output)?;
    }
    Ok(())
}

fn packed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    encoder.finish()
}
