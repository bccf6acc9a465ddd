//! Files of plane tilings, as in `square-triangle:FILE`.

use super::name::InputName;
use super::named::InputError;
use super::words::printable;
use acutile_catalog as catalog;
use acutile_catalog::plane_file::{FORMAT, PlaneDocument};
use acutile_catalog::plane_tiling::PlaneTiling;
use acutile_io::import::crystal::text_of;
use acutile_io::import::{BYTE_LIMIT, read_bytes, read_document};
use acutile_io::mesh::unknown;
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
    let of_file = |error| InputError::of_file(path, &error);
    let bytes = read_bytes(path, BYTE_LIMIT).map_err(of_file)?;
    let found = match unknown::name(path, &bytes) {
        Some(name) => Some(name.to_owned()),
        None => other_beginning(&bytes),
    };
    if let Some(found) = found {
        let message = format!(
            "{}: found {found}, expected a plane-tiling file; `acutile new square-triangle` writes one",
            printable(path)
        );
        return Err(message.into());
    }
    let text = text_of(path, bytes).map_err(of_file)?;
    let document: PlaneDocument =
        read_document(&text, FORMAT).map_err(|error| InputError::of_text(path, &text, &error))?;
    PlaneTiling::try_from(document).map_err(|error| format!("{}: {error}", printable(path)).into())
}

/// The first character of a file that is neither an object of JSON nor a comment.
fn other_beginning(bytes: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(bytes);
    let first = text
        .trim_start_matches('\u{feff}')
        .trim_start()
        .chars()
        .next()?;
    (!matches!(first, '{' | '/')).then(|| format!("{first:?} at the beginning"))
}

/// The path that may stand after the colon, also as text.
pub fn path(input: &InputName) -> Option<(PathBuf, &str)> {
    let word = catalog::plane_file(input)?;
    let prefix = &input[..input.len() - word.len()];
    Some((input.path_after(prefix), word))
}
