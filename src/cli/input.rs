//! A name of the catalogue or a file, turned into a tiling.

use super::Outcome;
use super::args::MeshArguments;
use super::mesh::{self, Provenance};
use crate::catalog;
use crate::import::{BYTE_LIMIT, Content, ImportError, NativeFile, read_native, read_text};
use crate::mesh::{Family, MeshError, load};
use crate::tiling::{AnyPointSet, AnyTiling};
use std::path::Path;

/// Where a tiling comes from, with its name for messages and for the file name of
/// its certificate.
pub struct Named {
    /// A name of the catalogue, or a path.
    pub name: String,
    /// What it is, in a line.
    pub description: String,
    /// The tiling.
    pub tiling: AnyTiling,
    /// For a mesh file, its own numbers and what was done to it.
    pub provenance: Option<Provenance>,
}

/// Why there is no input, in words that name it, and what that makes of the command.
pub struct InputError {
    pub message: String,
    pub outcome: Outcome,
}

impl From<String> for InputError {
    fn from(message: String) -> Self {
        InputError {
            message,
            outcome: Outcome::Failed,
        }
    }
}

impl InputError {
    /// A mesh file could not be read.
    pub fn of_mesh(input: &str, error: &MeshError) -> Self {
        InputError {
            message: format!("{input}: {error}"),
            outcome: match error.is_limit {
                true => Outcome::Declined,
                false => Outcome::Failed,
            },
        }
    }
}

/// The tiling of a catalogue name, for a parameter if one is given, or of a file.
///
/// # Errors
/// A message that names the input.
pub fn tiling(
    input: &str,
    parameter: Option<&str>,
    options: &MeshArguments,
) -> Result<Named, InputError> {
    if let Some(entry) = catalog::find(input) {
        let tiling = match parameter {
            Some(parameter) => catalog::build_with(input, parameter),
            None => catalog::build(input),
        };
        let tiling = tiling.map_err(|error| format!("{input}: {error}"))?;
        return Ok(Named {
            name: input.to_owned(),
            description: entry.description.to_owned(),
            tiling,
            provenance: None,
        });
    }
    let path = Path::new(input);
    if input != "-" && !path.exists() && !input.contains(['/', '.']) {
        let message = format!("{input}: neither a name of the catalogue (acutile list) nor a file");
        return Err(message.into());
    }
    if parameter.is_some() {
        return Err(format!("{input}: a file takes no parameter (--param)").into());
    }
    match text_or_mesh(path, options)? {
        TextOrMesh::Mesh(loaded) => mesh::tiling(input, loaded, options),
        TextOrMesh::Text(text) => native(input, &text),
    }
}

/// The tiling of a tiling file's text.
///
/// # Errors
/// A message that names the input.
pub fn native(input: &str, text: &str) -> Result<Named, InputError> {
    let file = read_native(text).map_err(|error| import_error(Path::new(input), &error))?;
    match file.content {
        Content::Tiling(tiling) => {
            let words = [file.name, file.description]
                .into_iter()
                .flatten()
                .collect::<Vec<_>>();
            Ok(Named {
                name: input.to_owned(),
                description: words.join(": "),
                tiling,
                provenance: None,
            })
        }
        Content::Points(_) => Err(format!(
            "{input}: is a point-set file, expected a tiling file (acutile delaunay makes one)"
        )
        .into()),
    }
}

/// The points of a point-set file.
///
/// # Errors
/// A message that names the file.
pub fn points(path: &Path) -> Result<AnyPointSet, InputError> {
    match read(path)?.content {
        Content::Points(points) => Ok(points),
        Content::Tiling(_) => Err(format!(
            "{}: is a tiling file, expected a point-set file",
            path.display()
        )
        .into()),
    }
}

fn read(path: &Path) -> Result<NativeFile, InputError> {
    read_text(path)
        .and_then(|text| read_native(&text))
        .map_err(|error| import_error(path, &error))
}

fn import_error(path: &Path, error: &ImportError) -> InputError {
    InputError {
        message: format!("{}: {error}", path.display()),
        outcome: if error.is_limit() {
            Outcome::Declined
        } else {
            Outcome::Failed
        },
    }
}

/// What a file holds.
pub enum TextOrMesh {
    /// A mesh.
    Mesh(load::Loaded),
    /// Text that is no mesh file.
    Text(String),
}

/// The mesh of a file of a mesh format, known by `--format`, by its extension, or by its first
/// bytes; the text of any other.
///
/// # Errors
/// A message that names the file.
pub fn text_or_mesh(path: &Path, options: &MeshArguments) -> Result<TextOrMesh, InputError> {
    let of_mesh = |error| InputError::of_mesh(&path.display().to_string(), &error);
    let family = options.mesh_format.map(|format| format.family());
    if let Some(family) = family.or_else(|| Family::of_path(path)) {
        return load::load(path, family)
            .map(TextOrMesh::Mesh)
            .map_err(of_mesh);
    }
    let bytes = load::bytes(path, BYTE_LIMIT).map_err(of_mesh)?;
    if let Some(family) = Family::of_content(&bytes) {
        let mesh = family.read(&bytes).map_err(of_mesh)?;
        return Ok(TextOrMesh::Mesh(load::Loaded { mesh, family }));
    }
    String::from_utf8(bytes)
        .map(TextOrMesh::Text)
        .map_err(|error| {
            let offset = error.utf8_error().valid_up_to();
            import_error(path, &ImportError::NotText { offset })
        })
}
