//! The one rule for files that are there: acutile replaces what it can make again.
//!
//! The file that an option names is output, and the same command makes it again, so it is replaced. An input
//! never is. Other files are replaced only if acutile wrote what is there, or with --force. These are files
//! whose names acutile chooses, in the directory of -o, and starting files, which people edit.

use super::files::check_writable;
use super::name::InputName;
use super::plane;
use super::words::printable;
use acutile_catalog as catalog;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Checks that the file that an option names is none of the inputs.
///
/// # Errors
/// A message that names the file and the input.
pub fn check_not_an_input(
    target: Option<&Path>,
    option: &str,
    inputs: &[InputName],
) -> Result<(), String> {
    let same = |target: &Path| {
        let target = target.canonicalize().ok().filter(|path| path.is_file())?;
        let is_target = |path: &PathBuf| path.canonicalize().is_ok_and(|path| path == target);
        inputs
            .iter()
            .find(|input| files(input).iter().any(is_target))
    };
    match target.and_then(|target| same(target).map(|input| (target, input))) {
        None => Ok(()),
        Some((target, input)) => Err(format!(
            "{option} {}: would overwrite the input {input}",
            printable(target)
        )),
    }
}

/// Checks before the work that the file that an option names can be written, and is none of the inputs.
///
/// # Errors
/// A message that names the file.
pub fn check_output(
    target: Option<&Path>,
    option: &str,
    inputs: &[InputName],
) -> Result<(), String> {
    check_not_an_input(target, option, inputs)?;
    target.map_or(Ok(()), check_writable)
}

/// The files that an input is read from.
fn files(input: &InputName) -> Vec<PathBuf> {
    if let Some((path, _)) = plane::path(input) {
        return vec![path];
    }
    if catalog::find(input).is_some() {
        return Vec::new();
    }
    let path = input.path();
    match acutile_io::mesh::load::tetgen_paths(path) {
        Some((nodes, elements)) => vec![nodes, elements],
        None => vec![path.to_path_buf()],
    }
}

/// Checks that acutile may replace a file with a name that it has chosen, or that people edit. `is_own`
/// says whether acutile can make these bytes again.
///
/// # Errors
/// The file is another one and `force` is not set, or it is no ordinary file.
pub fn check_replaceable(
    path: &Path,
    is_own: impl Fn(&[u8]) -> bool,
    force: bool,
) -> Result<(), String> {
    let Ok(metadata) = path.symlink_metadata() else {
        return Ok(());
    };
    let name = printable(path);
    if !metadata.is_file() {
        return Err(format!(
            "{name}: exists and is no ordinary file, expected a file or a new name"
        ));
    }
    if force || is_own(&std::fs::read(path).unwrap_or_default()) {
        return Ok(());
    }
    Err(format!(
        "{name}: the file exists and is not as acutile wrote it; --force replaces it"
    ))
}

/// No two options name one file, of which the second would replace the first.
///
/// # Errors
/// Names the file and both options.
pub fn check_different(outputs: &[(&str, Option<&Path>)]) -> Result<(), String> {
    // The directory decides, by whatever name: the files need not exist yet.
    let place = |path: &Path| {
        let parent = path.parent().unwrap_or(Path::new(""));
        let parent = Path::new(".").join(parent).canonicalize().ok();
        (parent, path.file_name().map(OsStr::to_owned))
    };
    // A device takes any number of files.
    let is_file = |path: &Path| path.is_file() || !path.exists();
    let given = outputs
        .iter()
        .filter_map(|&(option, path)| Some((option, path?)));
    let given: Vec<(&str, &Path)> = given.filter(|(_, path)| is_file(path)).collect();
    for (k, (second, path)) in given.iter().enumerate() {
        let is_same = |(_, other): &&(&str, &Path)| place(other) == place(path);
        if let Some((first, _)) = given[..k].iter().find(is_same) {
            return Err(format!(
                "{}: {first} and {second} name one file, expected different files",
                printable(path)
            ));
        }
    }
    Ok(())
}
