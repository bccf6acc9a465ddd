//! Reads the project's own tiling and point-set files.

use super::ImportError;
use super::document::{CornerEntry, Document, Header, Text};
use super::frame::{Change, read_frame};
use super::numbers::{Entry, Numbers};
use super::text::without_comments;
use acutile_core::family::{AnyFamily, Family};
use acutile_core::tiling::{
    AnyPointSet, AnyTiling, Corner, Domain, Frame, PointSet, SHIFT_LIMIT, Tiling, VertexId,
};
use acutile_exact::number::Number;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::borrow::Cow;

/// A file of ours.
pub struct NativeFile {
    /// Its name.
    pub name: Option<String>,
    /// Its description.
    pub description: Option<String>,
    /// For each vertex or point the label of its site; empty if the file has none.
    pub labels: Vec<String>,
    /// Its content.
    pub content: Content,
}

/// The content of a file.
pub enum Content {
    /// A tiling file.
    Tiling(AnyTiling),
    /// A tiling file with parameters.
    Family(AnyFamily),
    /// A point-set file.
    Points(AnyPointSet),
}

/// The formats of our own files.
const TILING: &str = "acutile-tiling";
const POINTS: &str = "acutile-points";

/// Reads the text of a tiling or point-set file.
///
/// # Errors
/// [`ImportError`], naming line and column for JSON and the entry otherwise.
pub fn read_native(text: &str) -> Result<NativeFile, ImportError> {
    let text = plain(text)?;
    let header = header(&text, &[TILING, POINTS])?;
    let document: Document = shaped(&text)?;
    let numbers = Numbers::of(&document)?;
    let content = match document.dimension {
        2 => content(
            &header,
            &document,
            &numbers,
            (AnyTiling::Plane, AnyFamily::Plane, AnyPointSet::Plane),
        ),
        3 => content(
            &header,
            &document,
            &numbers,
            (AnyTiling::Space, AnyFamily::Space, AnyPointSet::Space),
        ),
        other => Err(ImportError::entry(
            "dimension",
            format!("found {other}, expected 2 or 3"),
        )),
    }?;
    let labels = labels(&document)?;
    Ok(NativeFile {
        labels,
        name: document.name,
        description: document.description,
        content,
    })
}

/// One label for each vertex or point, or none.
fn labels(document: &Document) -> Result<Vec<String>, ImportError> {
    let Some(labels) = &document.labels else {
        return Ok(Vec::new());
    };
    let rows = document.vertices.as_ref().or(document.points.as_ref());
    let expected = rows.map_or(0, Vec::len);
    if labels.len() != expected {
        let problem = format!("has {} entries, expected {expected}", labels.len());
        return Err(ImportError::entry("labels", problem));
    }
    Ok(labels.clone())
}

/// Reads a document of version 1 of another format of ours, whose shape is `T`.
///
/// # Errors
/// As for [`read_native`].
pub fn read_document<T: DeserializeOwned>(text: &str, format: &str) -> Result<T, ImportError> {
    let text = plain(text)?;
    header(&text, &[format])?;
    shaped(&text)
}

/// The text without a byte order mark and without comments.
fn plain(text: &str) -> Result<Cow<'_, str>, ImportError> {
    let text = text.trim_start_matches('\u{feff}');
    if text.trim().is_empty() {
        Err(ImportError::Empty)
    } else {
        Ok(without_comments(text))
    }
}

/// The header, if it is of one of these formats and of version 1.
fn header(text: &str, formats: &[&str]) -> Result<Header, ImportError> {
    let header: Header = serde_json::from_str(text).map_err(ImportError::Json)?;
    if !formats.contains(&header.format.as_str()) {
        return Err(ImportError::Format {
            found: header.format,
            expected: formats.iter().map(|&format| format.to_owned()).collect(),
        });
    }
    match header.version {
        1 => Ok(header),
        found => Err(ImportError::Version { found }),
    }
}

fn shaped<'t, T: Deserialize<'t>>(text: &'t str) -> Result<T, ImportError> {
    serde_json::from_str(text).map_err(|error| with_place::<T>(text, error))
}

/// Where in the document the shape is wrong, if JSON it is: read once more, slowly.
fn with_place<'t, T: Deserialize<'t>>(text: &'t str, error: serde_json::Error) -> ImportError {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    match serde_path_to_error::deserialize::<_, T>(&mut deserializer) {
        Err(traced) if error.is_data() && traced.path().iter().len() > 0 => ImportError::Shape {
            place: traced.path().to_string(),
            error,
        },
        _ => ImportError::Json(error),
    }
}

/// The variants of one dimension.
type Variants<const D: usize> = (
    fn(Tiling<D>) -> AnyTiling,
    fn(Family<D>) -> AnyFamily,
    fn(PointSet<D>) -> AnyPointSet,
);

fn content<const D: usize>(
    header: &Header,
    document: &Document,
    numbers: &Numbers,
    (any_tiling, any_family, any_points): Variants<D>,
) -> Result<Content, ImportError> {
    match (header.format == TILING, document.parameters.0.is_empty()) {
        (true, true) => {
            let (frame, vertices, corners) = parts(document, numbers)?;
            let vertices: Vec<[Number; D]> = vertices;
            Ok(Content::Tiling(any_tiling(Tiling {
                frame,
                vertices: vertices.into(),
                corners,
            })))
        }
        (true, false) => family(document, numbers)
            .map(any_family)
            .map(Content::Family),
        (false, _) => points(document, numbers)
            .map(any_points)
            .map(Content::Points),
    }
}

fn family<const D: usize>(
    document: &Document,
    numbers: &Numbers,
) -> Result<Family<D>, ImportError> {
    let (frame, vertices, corners) = parts(document, numbers)?;
    let family = Family {
        parameters: numbers.parameters(document)?,
        frame,
        vertices,
        corners,
    };
    match family.check() {
        Ok(()) => Ok(family),
        Err(error) => Err(ImportError::entry("parameters", error)),
    }
}

fn points<const D: usize>(
    document: &Document,
    numbers: &Numbers,
) -> Result<PointSet<D>, ImportError> {
    let (frame, change) = read_frame::<Number, D>(document, numbers)?;
    forbid("parameters", !document.parameters.0.is_empty(), POINTS)?;
    forbid("vertices", document.vertices.is_some(), POINTS)?;
    forbid("simplices", document.simplices.is_some(), POINTS)?;
    if frame.domain != Domain::Space {
        let problem =
            "a point set has no domain but \"space\", its Delaunay triangulation fills it";
        return Err(ImportError::entry("domain", problem));
    }
    let rows = require("points", document.points.as_ref(), POINTS)?;
    Ok(PointSet {
        points: positions("points", rows, numbers, &change)?,
        frame,
    })
}

/// Frame, vertices and corners.
type PartsOf<S, const D: usize> = (Frame<D, S>, Vec<[S; D]>, Vec<Corner<D>>);

fn parts<S: Entry, const D: usize>(
    document: &Document,
    numbers: &Numbers,
) -> Result<PartsOf<S, D>, ImportError> {
    let (frame, change) = read_frame(document, numbers)?;
    forbid("points", document.points.is_some(), TILING)?;
    let rows = require("vertices", document.vertices.as_ref(), TILING)?;
    let simplices = require("simplices", document.simplices.as_ref(), TILING)?;
    let vertices = positions("vertices", rows, numbers, &change)?;
    let corners = corners(simplices, vertices.len(), &frame)?;
    Ok((frame, vertices, corners))
}

fn require<'d, T>(
    member: &str,
    value: Option<&'d Vec<T>>,
    format: &str,
) -> Result<&'d Vec<T>, ImportError> {
    value.ok_or_else(|| ImportError::entry(member, format!("is missing, {format} needs it")))
}

fn forbid(member: &str, present: bool, format: &str) -> Result<(), ImportError> {
    if present {
        Err(ImportError::entry(
            member,
            format!("has no place in {format}"),
        ))
    } else {
        Ok(())
    }
}

fn positions<S: Entry, const D: usize>(
    place: &str,
    rows: &[Vec<Text>],
    numbers: &Numbers,
    change: &Change<D, S>,
) -> Result<Vec<[S; D]>, ImportError> {
    (0..)
        .zip(rows)
        .map(|(i, row)| Ok(change.apply(numbers.row(row, || format!("{place}[{i}]"))?)))
        .collect()
}

fn corners<S, const D: usize>(
    simplices: &[Vec<CornerEntry>],
    vertices: usize,
    frame: &Frame<D, S>,
) -> Result<Vec<Corner<D>>, ImportError> {
    let mut corners = Vec::with_capacity(simplices.len() * (D + 1));
    for (s, entries) in simplices.iter().enumerate() {
        if entries.len() != D + 1 {
            let problem = format!("has {} corners, expected {}", entries.len(), D + 1);
            return Err(ImportError::entry(format!("simplices[{s}]"), problem));
        }
        for (i, entry) in entries.iter().enumerate() {
            corners.push(
                corner(entry, vertices, frame.rank()).map_err(|problem| {
                    ImportError::entry(format!("simplices[{s}][{i}]"), problem)
                })?,
            );
        }
    }
    Ok(corners)
}

fn corner<const D: usize>(
    entry: &CornerEntry,
    vertices: usize,
    rank: usize,
) -> Result<Corner<D>, String> {
    let vertex = u32::try_from(entry.vertex)
        .ok()
        .filter(|&v| (v as usize) < vertices)
        .ok_or_else(|| {
            format!(
                "vertex {} is out of range, expected 0 to {}",
                entry.vertex,
                vertices as i64 - 1
            )
        })?;
    if !entry.shift.is_empty() && entry.shift.len() != rank {
        return Err(format!(
            "the shift has {} entries, expected {rank}",
            entry.shift.len()
        ));
    }
    let mut shift = [0; D];
    for (slot, &step) in shift.iter_mut().zip(&entry.shift) {
        *slot = i32::try_from(step)
            .ok()
            .filter(|s| s.unsigned_abs() <= SHIFT_LIMIT.unsigned_abs())
            .ok_or_else(|| {
                format!("the shift {step} is out of range, expected at most {SHIFT_LIMIT} in size")
            })?;
    }
    let vertex = VertexId::new(vertex);
    Ok(Corner { vertex, shift })
}
