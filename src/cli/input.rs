//! A name of the catalogue or a file, turned into a tiling.

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

/// The tiling of a catalogue name, for a parameter if one is given, or of a file.
///
/// # Errors
/// A message that names the input.
pub fn tiling(input: &str, parameter: Option<&str>) -> Result<Named, String> {
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
        return Err(format!(
            "{input}: neither a name of the catalogue (acutile list) nor a file"
        ));
    }
    if parameter.is_some() {
        return Err(format!("{input}: a file takes no parameter (--param)"));
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
        )),
    }
}

/// The points of a point-set file.
///
/// # Errors
/// A message that names the file.
pub fn points(path: &Path) -> Result<AnyPointSet, String> {
    match read(path)?.content {
        Content::Points(points) => Ok(points),
        Content::Tiling(_) => Err(format!(
            "{}: is a tiling file, expected a point-set file",
            path.display()
        )),
    }
}

fn read(path: &Path) -> Result<NativeFile, String> {
    read_text(path)
        .and_then(|text| read_native(&text))
        .map_err(|error| format!("{}: {error}", path.display()))
}
