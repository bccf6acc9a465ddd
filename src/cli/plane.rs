//! Files of plane tilings, as in `square-triangle:FILE`.

use super::name::InputName;
use super::named::InputError;
use acutile_catalog as catalog;
use acutile_catalog::plane_file::{FORMAT, PlaneDocument};
use acutile_catalog::plane_tiling::PlaneTiling;
use acutile_io::import::{read_document, read_text};
use std::path::{Path, PathBuf};

/// The plane tiling of the file that an input names after its family; `None` where it names no file.
///
/// # Errors
/// A message that names the file, its line and column.
pub fn of_file(input: &InputName) -> Result<Option<PlaneTiling>, InputError> {
    let Some((path, word)) = path(input) else {
        return Ok(None);
    };
    if word != "-" && !path.exists() && !word.contains(['/', '.']) {
        return Ok(None);
    }
    read(&path).map(Some)
}

/// The plane tiling of a file.
///
/// # Errors
/// A message that names the file, its line and column.
pub fn read(path: &Path) -> Result<PlaneTiling, InputError> {
    let text = read_text(path).map_err(|error| InputError::of_file(path, &error))?;
    let document: PlaneDocument =
        read_document(&text, FORMAT).map_err(|error| InputError::of_text(path, &text, &error))?;
    PlaneTiling::try_from(document).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// The path that may stand after the colon, also as text.
pub fn path(input: &InputName) -> Option<(PathBuf, &str)> {
    let word = catalog::plane_file(input)?;
    let prefix = &input[..input.len() - word.len()];
    Some((input.path_after(prefix), word))
}
