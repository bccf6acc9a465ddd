//! A name of the catalogue or a file, turned into a tiling; a point set becomes its
//! Delaunay triangulation.

use super::document::{self, PointDocument};
use super::mesh::{self, MeshArguments};
use super::name::InputName;
use super::named::{InputError, Named, NamedFamily};
use super::output::Output;
use super::plane;
use super::points::{self, PointArguments};
use super::transcribe;
use super::words::printable;
use acutile_catalog as catalog;
use acutile_core::format;
use acutile_core::statement::Requirement;
use acutile_core::tiling::AnyTiling;
use acutile_io::import::crystal::text_of;
use acutile_io::import::{BYTE_LIMIT, Content, ImportError, read_bytes, uncompressed_name};
use acutile_io::mesh::{Family, load, unknown};
use clap::Args;
use std::path::Path;

/// How a file becomes a tiling.
#[derive(Clone, Debug, Default, Args)]
pub struct FileArguments {
    #[command(flatten)]
    pub points: PointArguments,
    #[command(flatten)]
    pub mesh: MeshArguments,
}

/// The tiling of a catalogue name, for a parameter if one is given, or of a file. What is to
/// be said of a file is said.
///
/// # Errors
/// A message that names the input.
pub fn tiling(
    input: &InputName,
    parameter: Option<&str>,
    options: &FileArguments,
    output: &mut Output,
) -> Result<Named, InputError> {
    open(input, parameter, options, output)?.tiling(input, options, output)
}

/// A tiling, the points of a file that are not triangulated yet, or a tiling for each point of a box.
pub enum Loaded {
    Tiling(Named),
    Points(PointDocument),
    Family(NamedFamily),
}

impl Loaded {
    /// The tiling, for commands that take nothing else.
    ///
    /// # Errors
    /// A message that names the input.
    pub fn tiling(
        self,
        input: &InputName,
        options: &FileArguments,
        output: &mut Output,
    ) -> Result<Named, InputError> {
        match self {
            Loaded::Tiling(named) => Ok(named),
            Loaded::Points(points) => of_points(input, points, &options.points, output),
            Loaded::Family(named) => Err(named.is_no_tiling()),
        }
    }
}

/// As [`tiling`], but points stay points.
///
/// # Errors
/// A message that names the input.
pub fn open(
    input: &InputName,
    parameter: Option<&str>,
    options: &FileArguments,
    output: &mut Output,
) -> Result<Loaded, InputError> {
    read(input, parameter, options, output)?.loaded(input)
}

/// An input, of which a certificate is not opened yet.
pub enum Read {
    /// In either encoding.
    Certificate(Vec<u8>),
    Loaded(Loaded),
}

impl Read {
    /// The tiling or family in it; a certificate is not judged here.
    ///
    /// # Errors
    /// A message that names the input.
    pub fn loaded(self, input: &InputName) -> Result<Loaded, InputError> {
        match self {
            Read::Certificate(bytes) => of_certificate(input, &bytes),
            Read::Loaded(loaded) => Ok(loaded),
        }
    }
}

/// As [`open`], but a certificate stays one. A file is read once, so that it may be a pipe.
///
/// # Errors
/// A message that names the input.
pub fn read(
    input: &InputName,
    parameter: Option<&str>,
    options: &FileArguments,
    output: &mut Output,
) -> Result<Read, InputError> {
    if let Some(theorem) = catalog::theorem(input) {
        let message = format!(
            "{input}: a theorem and no tiling; certify, show and verify take it, and {}NAME is one of its tilings",
            theorem.family
        );
        return Err(message.into());
    }
    if let Some(entry) = catalog::find(input) {
        document::check_for_crystal(input, &options.points)?;
        check_for_mesh(input, &options.mesh)?;
        if let Some(family) = entry.build_family() {
            return Ok(Read::Loaded(Loaded::Family(NamedFamily {
                name: input.to_string(),
                description: entry.description.to_owned(),
                family: family.map_err(|error| format!("{input}: {error}"))?,
            })));
        }
        let tiling = construction(input, parameter)?;
        let named = Named::of(input, entry.description.to_owned(), tiling);
        return Ok(Read::Loaded(Loaded::Tiling(named)));
    }
    let path = input.path();
    if !input.is_standard_input() && !path.exists() && !input.contains(['/', '.']) {
        let advice = match catalog::suggestion(input) {
            Some(name) => format!("; did you mean {name}?"),
            None if input.parse::<Requirement>().is_ok() => {
                format!("; a comma joins statements: --require STATEMENT,{input}")
            }
            None => String::new(),
        };
        let message =
            format!("{input}: neither a name of the catalogue (acutile list) nor a file{advice}");
        return Err(message.into());
    }
    if parameter.is_some() {
        return Err(format!(
            "{input}: --param is for a name of the catalogue, expected no --param for a file"
        )
        .into());
    }
    let content = text_or_mesh(path, &options.mesh)?;
    read_content(input, content, options, output)
}

/// The tiling of a file's content.
///
/// # Errors
/// A message that names the input.
pub fn of_content(
    input: &InputName,
    content: TextOrMesh,
    options: &FileArguments,
    output: &mut Output,
) -> Result<Named, InputError> {
    let loaded = read_content(input, content, options, output)?.loaded(input)?;
    loaded.tiling(input, options, output)
}

fn read_content(
    input: &InputName,
    content: TextOrMesh,
    options: &FileArguments,
    output: &mut Output,
) -> Result<Read, InputError> {
    let loaded = match content {
        TextOrMesh::Mesh(loaded) => {
            document::check_for_crystal(input, &options.points)?;
            mesh::tiling(input, loaded, &options.mesh, output).map(Loaded::Tiling)
        }
        TextOrMesh::Text(text) => {
            document::check_format(input.path(), &text)?;
            check_for_mesh(input, &options.mesh)?;
            of_text(input, &text, &options.points, output)
        }
        TextOrMesh::Certificate(bytes) => {
            document::check_for_crystal(input, &options.points)?;
            check_for_mesh(input, &options.mesh)?;
            return Ok(Read::Certificate(bytes));
        }
    };
    loaded.map(Read::Loaded)
}

/// The tiling or family of a certificate, which is not judged here.
fn of_certificate(input: &str, bytes: &[u8]) -> Result<Loaded, InputError> {
    let cbor = transcribe::cbor(input, bytes)?;
    if is_theorem(&cbor) {
        let message = format!(
            "{input}: a certificate of a theorem and no tiling; show and verify take it, and convert changes its encoding"
        );
        return Err(message.into());
    }
    let name = input.to_owned();
    if format::kind(&cbor) == Some(format::FAMILY) {
        let read = acutile_core::transcribe::family::of_certificate(&cbor);
        let (family, ..) = read.map_err(|error| format!("{input}: {error}"))?;
        return Ok(Loaded::Family(NamedFamily {
            name,
            description: "the family of a certificate".to_owned(),
            family,
        }));
    }
    let (tiling, _) = acutile_core::transcribe::of_certificate(&cbor)
        .map_err(|error| format!("{input}: {error}"))?;
    let description = "the tiling of a certificate".to_owned();
    Ok(Loaded::Tiling(Named::of(input, description, tiling)))
}

/// A construction of the catalogue; `square-triangle:FILE` reads its file.
fn construction(name: &InputName, parameter: Option<&str>) -> Result<AnyTiling, InputError> {
    let tiling = match (parameter, plane::of_file(name)) {
        (Some(parameter), _) => catalog::build_with(name, parameter),
        (None, Ok(Some(plane))) => catalog::build_over(name, &plane),
        (None, Ok(None)) => catalog::build(name),
        (None, Err(error)) => return Err(error),
    };
    tiling.map_err(|error| format!("{name}: {error}").into())
}

/// The tiling or the points of a file's text.
fn of_text(
    input: &InputName,
    text: &str,
    points: &PointArguments,
    output: &mut Output,
) -> Result<Loaded, InputError> {
    let file = document::read(input.path(), text, points, output)?;
    Ok(match file.content {
        Content::Points(set) => Loaded::Points(PointDocument {
            description: file.description,
            set,
            labels: file.labels,
            elements: file.elements,
            notes: file.notes,
            variation: file.variation,
        }),
        Content::Family(family) => Loaded::Family(NamedFamily {
            name: input.to_string(),
            description: file.description,
            family,
        }),
        Content::Tiling(tiling) => Loaded::Tiling(Named {
            notes: file.notes,
            labels: file.labels,
            ..Named::of(input, file.description, tiling)
        }),
    })
}

/// The Delaunay triangulation of the points of a file.
fn of_points(
    input: &str,
    points: PointDocument,
    arguments: &PointArguments,
    output: &mut Output,
) -> Result<Named, InputError> {
    let tiling = points::of_points(input, &points.set, arguments, output)?;
    Ok(Named {
        notes: points.notes,
        labels: points.labels,
        ..Named::of(input, points.description, tiling)
    })
}

/// The options for a mesh mean nothing for `input`, which is none.
///
/// # Errors
/// One of them is given.
pub fn check_for_mesh(input: &str, mesh: &MeshArguments) -> Result<(), String> {
    let given = [
        ("--lattice", mesh.lattice.is_some()),
        ("--bounded", mesh.bounded),
        ("--identify", mesh.identify.is_some()),
        ("--from", mesh.mesh_format.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((option, _)) => Err(format!(
            "{input}: {option} is for a mesh file, which this is not"
        )),
    }
}

/// The content of a file.
pub enum TextOrMesh {
    /// A certificate in either encoding.
    Certificate(Vec<u8>),
    /// A mesh.
    Mesh(load::Loaded),
    /// Text that is no mesh file.
    Text(String),
}

/// The bytes after a byte order mark.
fn without_mark(mut bytes: Vec<u8>) -> Vec<u8> {
    if bytes.starts_with(b"\xef\xbb\xbf") {
        bytes.drain(..3);
    }
    bytes
}

/// The mesh of a file of a mesh format, known by `--from`, by its extension, or by its first
/// bytes; the text of any other.
///
/// # Errors
/// A message that names the file.
pub fn text_or_mesh(path: &Path, options: &MeshArguments) -> Result<TextOrMesh, InputError> {
    let of_mesh = |error| InputError::of_mesh(&printable(path), &error);
    if let Some(family) = options.mesh_format {
        let loaded = load::load(path, family);
        return loaded.map(TextOrMesh::Mesh).map_err(of_mesh);
    }
    if let Some(family) = Family::of_path(path) {
        let loaded = load::load_by_name(path, family);
        return loaded.map(TextOrMesh::Mesh).map_err(of_mesh);
    }
    let of_file = |error| InputError::of_file(path, &error);
    let bytes = without_mark(read_bytes(path, BYTE_LIMIT).map_err(of_file)?);
    if bytes.trim_ascii().is_empty() {
        return Err(of_file(ImportError::Empty));
    }
    if let Some(family) = Family::of_content(&bytes) {
        let mesh = family.read(&bytes).map_err(of_mesh)?;
        return Ok(TextOrMesh::Mesh(load::Loaded { mesh, family }));
    }
    if format::recognise(&bytes).is_some() {
        return Ok(TextOrMesh::Certificate(bytes));
    }
    if unknown::name(path, &bytes).is_some() {
        let message = unknown::message(path, &bytes);
        return Err(format!("{}: {message}", printable(path)).into());
    }
    text_of(&uncompressed_name(path), bytes)
        .map(TextOrMesh::Text)
        .map_err(of_file)
}

/// Whether a certificate in CBOR is of the kind `patches`.
pub fn is_theorem(cbor: &[u8]) -> bool {
    format::kind(cbor) == Some(format::patches::KIND)
}
