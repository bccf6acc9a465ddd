//! Text files of tilings, point sets and crystal structures.

use super::named::InputError;
use super::output::Output;
use super::points::PointArguments;
use super::words::printable;
use acutile_core::tiling::AnyPointSet;
use acutile_io::import::crystal::{self, Structure, Variation, text_of};
use acutile_io::import::{
    BYTE_LIMIT, Content, ImportError, read_bytes, read_native, uncompressed_name, without_comments,
};
use acutile_io::mesh::unknown;
use std::path::Path;

/// A file that was read.
pub struct Document {
    /// Its author's words for it.
    pub description: String,
    pub content: Content,
    /// For each point or vertex the label of its site; empty if there are none.
    pub labels: Vec<String>,
    /// For each point its element, as far as that is known; empty if the file is no crystal.
    pub elements: Vec<Option<&'static str>>,
    /// Notes on a crystal structure.
    pub notes: Vec<String>,
    /// The free numbers of a CIF, if they are asked for.
    pub variation: Option<Variation>,
}

/// The points of a file.
pub struct PointDocument {
    pub description: String,
    pub set: AnyPointSet,
    pub labels: Vec<String>,
    pub elements: Vec<Option<&'static str>>,
    pub notes: Vec<String>,
    pub variation: Option<Variation>,
}

/// Reads a crystal structure or one of the program's own files, and prints the notes on it.
///
/// # Errors
/// A message that names the file.
pub fn read(
    path: &Path,
    text: &str,
    points: &PointArguments,
    output: &mut Output,
) -> Result<Document, InputError> {
    if let Some(kind) = crystal::kind(&uncompressed_name(path), text) {
        let structure = crystal::read(kind, text, &points.crystal_options()?)
            .map_err(|error| InputError::of_text(path, text, &error))?;
        for note in &structure.notes {
            output.note(&printable(path), note);
        }
        return Ok(of_structure(structure));
    }
    check_format(path, text)?;
    check_for_crystal(&printable(path), points)?;
    let in_text = |error| InputError::of_text(path, text, &error);
    let file = read_native(text).map_err(in_text)?;
    let words: Vec<String> = [file.name, file.description]
        .into_iter()
        .flatten()
        .collect();
    Ok(Document {
        description: words.join(": "),
        content: file.content,
        labels: file.labels,
        elements: Vec::new(),
        notes: Vec::new(),
        variation: None,
    })
}

/// Reads a file, and prints the notes on it.
///
/// # Errors
/// A message that names the file.
pub fn open(
    path: &Path,
    points: &PointArguments,
    output: &mut Output,
) -> Result<Document, InputError> {
    let named = |error: ImportError| InputError::of_file(path, &error);
    let bytes = read_bytes(path, BYTE_LIMIT).map_err(named)?;
    if unknown::name(path, &bytes).is_some() {
        let message = unknown::message(path, &bytes);
        return Err(format!("{}: {message}", printable(path)).into());
    }
    let text = text_of(&uncompressed_name(path), bytes).map_err(named)?;
    read(path, &text, points, output)
}

fn of_structure(structure: Structure) -> Document {
    Document {
        description: structure.name,
        content: Content::Points(AnyPointSet::Space(structure.points)),
        labels: structure.labels,
        elements: structure.elements,
        notes: structure.notes,
        variation: structure.variation,
    }
}

/// A text is a crystal structure, or begins like the project's own files.
///
/// # Errors
/// Names the format, and the formats that are read.
pub fn check_format(path: &Path, text: &str) -> Result<(), String> {
    let is_own = || without_comments(text).trim_start().starts_with('{');
    let is_crystal = crystal::kind(&uncompressed_name(path), text).is_some();
    if is_crystal || text.trim_start().is_empty() || is_own() {
        Ok(())
    } else {
        let message = unknown::message(path, text.as_bytes());
        Err(format!("{}: {message}", printable(path)))
    }
}

/// The options for a crystal structure mean nothing for `input`, which is none.
///
/// # Errors
/// One of them is given.
pub fn check_for_crystal(input: &str, points: &PointArguments) -> Result<(), String> {
    match points.given_for_crystals() {
        None => Ok(()),
        Some(option) => Err(format!("{input}: {option} is for a CIF, which this is not")),
    }
}
