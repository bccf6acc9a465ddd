//! A name of the catalogue or a file, turned into a tiling.

use super::Outcome;
use crate::catalog;
use crate::import::{Content, NativeFile, read_native, read_text};
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

/// The tiling of a catalogue name, for a parameter if one is given, or of a file.
///
/// # Errors
/// A message that names the input.
pub fn tiling(input: &str, parameter: Option<&str>) -> Result<Named, InputError> {
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
    let file = read(path)?;
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
        .map_err(|error| InputError {
            message: format!("{}: {error}", path.display()),
            outcome: if error.is_limit() {
                Outcome::Declined
            } else {
                Outcome::Failed
            },
        })
}
