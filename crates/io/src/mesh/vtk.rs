//! VTK's legacy format, versions 1 to 5.1, text and binary ("VTK File Formats", section
//! "Simple Legacy Formats"). Keywords and names of types are read in any case.

use super::Mesh;
use super::draft::Draft;
use super::error::{MeshError, Place};
use super::source::{Encoding, Source, shown};
use super::unknown::READ;
use super::vtk_cells::Cells;
use super::vtk_data;
use super::vtk_data::in_text;

/// Reads an unstructured grid. Points and cells are numbered from 0.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut source = Source::new(bytes);
    let version = head(&mut source)?;
    let mut draft = Draft::default();
    let mut cells = Cells::default();
    let mut has_points = false;
    while let Some(word) = source.try_word() {
        match word.to_ascii_uppercase().as_slice() {
            b"POINTS" => {
                if std::mem::replace(&mut has_points, true) {
                    return Err(source.error("found POINTS a second time"));
                }
                points(&mut source, &mut draft)?;
            }
            b"CELLS" if version >= 5 => split_cells(&mut source, &mut cells)?,
            b"CELLS" => listed_cells(&mut source, &mut cells)?,
            b"CELL_TYPES" => cell_types(&mut source, &mut cells)?,
            b"METADATA" => vtk_data::skip_metadata(&mut source),
            b"FIELD" => vtk_data::skip_field(&mut source, &mut draft)?,
            b"CELL_DATA" | b"POINT_DATA" => {
                vtk_data::data(&mut source, word, &mut cells, &mut draft)?;
                break;
            }
            _ => return Err(source.unexpected(word, "POINTS, CELLS or CELL_TYPES")),
        }
    }
    let index = draft.node_index()?;
    cells.store(&mut draft, &index, 0)?;
    draft.finish()
}

/// `# vtk DataFile Version 3.0`, a title, `ASCII` or `BINARY`, `DATASET UNSTRUCTURED_GRID`.
/// Gives the major version.
fn head(source: &mut Source) -> Result<u32, MeshError> {
    let first = source.rest_of_line();
    let version = strip_prefix(first, b"# vtk DataFile Version ").and_then(|version| {
        let major = version.split(|&byte| byte == b'.').next()?;
        std::str::from_utf8(major).ok()?.trim().parse::<u32>().ok()
    });
    let version = version
        .filter(|version| (1..=5).contains(version))
        .ok_or_else(|| {
            let found = shown(first);
            let expected = "\"# vtk DataFile Version\" and a version from 1 to 5";
            MeshError::at(
                Place::Line(1),
                format!("found {found}, expected {expected}"),
            )
        })?;
    source.rest_of_line();
    let word = source.word("ASCII or BINARY")?;
    let encoding = match word.to_ascii_uppercase().as_slice() {
        b"ASCII" => Encoding::Text,
        b"BINARY" => Encoding::Big,
        _ => return Err(source.unexpected(word, "ASCII or BINARY")),
    };
    let word = source.word("DATASET")?;
    if !word.eq_ignore_ascii_case(b"DATASET") {
        return Err(source.unexpected(word, "DATASET"));
    }
    let word = source.word("UNSTRUCTURED_GRID")?;
    if !word.eq_ignore_ascii_case(b"UNSTRUCTURED_GRID") {
        let found = format!("a VTK dataset of type {}", shown(word));
        let expected = "expected UNSTRUCTURED_GRID";
        return Err(source.error(format!("{found} is not read, {expected}; {READ}")));
    }
    source.encoding = encoding;
    Ok(version)
}

/// The bytes after a prefix in any case.
fn strip_prefix<'b>(bytes: &'b [u8], prefix: &[u8]) -> Option<&'b [u8]> {
    let (start, rest) = bytes.split_at_checked(prefix.len())?;
    start.eq_ignore_ascii_case(prefix).then_some(rest)
}

fn points(source: &mut Source, draft: &mut Draft) -> Result<(), MeshError> {
    let (place, count, kind) = in_text(source, |source| {
        let count = source.int("the number of points")?;
        Ok((source.place(), count, vtk_data::kind(source)?))
    })?;
    let least = source.least_bytes(3, kind.bytes());
    let count = source.count(count, least, "points");
    let count = count.map_err(|error| MeshError { place, ..error })?;
    draft.mesh.points.reserve(count);
    for tag in 0..count as i64 {
        let point = [
            kind.coordinate(source)?,
            kind.coordinate(source)?,
            kind.coordinate(source)?,
        ];
        draft.add_node(tag, point, source.place())?;
    }
    Ok(())
}

/// `CELLS cells numbers`, then `k point_1 … point_k` for each cell.
fn listed_cells(source: &mut Source, cells: &mut Cells) -> Result<(), MeshError> {
    let (count, size) = in_text(source, |source| {
        let count = source.int("the number of cells")?;
        Ok((count, source.int("the number of numbers")?))
    })?;
    let size = source.count(size, source.least_bytes(1, 4), "numbers of cells")?;
    let count = source.count(count, source.least_bytes(1, 4), "cells")?;
    let mut left = size;
    for _ in 0..count {
        let nodes = source.int("the number of points of a cell")?;
        let nodes = match usize::try_from(nodes) {
            Ok(nodes) if nodes < left => nodes,
            _ => {
                let problem = format!(
                    "found a cell of {nodes} points, but {left} of the {size} numbers are left"
                );
                return Err(source.error(problem));
            }
        };
        left -= nodes + 1;
        if let Place::Line(line) = source.place() {
            cells.lines.push(line);
        }
        for _ in 0..nodes {
            cells.connectivity.push(source.int("a point")?);
        }
        cells.ends.push(cells.connectivity.len() as i64);
    }
    match left {
        0 => Ok(()),
        _ => Err(source.error(format!(
            "the cells have {} numbers, expected {size}",
            size - left
        ))),
    }
}

/// `CELLS offsets numbers`, then `OFFSETS type` and `CONNECTIVITY type`: cell i has the points
/// from offset i to offset i + 1 of the list.
fn split_cells(source: &mut Source, cells: &mut Cells) -> Result<(), MeshError> {
    let (offsets, size) = in_text(source, |source| {
        let offsets = source.int("the number of offsets")?;
        Ok((offsets, source.int("the number of points of all cells")?))
    })?;
    let offsets = integers(source, "OFFSETS", offsets)?;
    cells.connectivity = integers(source, "CONNECTIVITY", size)?;
    match offsets.split_first() {
        None => Ok(()),
        Some((0, ends)) => {
            cells.ends = ends.to_vec();
            Ok(())
        }
        Some((first, _)) => Err(source.error(format!("the first offset is {first}, expected 0"))),
    }
}

fn integers(source: &mut Source, name: &str, count: i64) -> Result<Vec<i64>, MeshError> {
    let kind = in_text(source, |source| {
        let word = source.word(name)?;
        if !word.eq_ignore_ascii_case(name.as_bytes()) {
            return Err(source.unexpected(word, name));
        }
        vtk_data::kind(source)
    })?;
    let count = source.count(count, source.least_bytes(1, kind.bytes()), name)?;
    let mut list = Vec::with_capacity(count);
    for _ in 0..count {
        list.push(kind.integer(source)?);
    }
    Ok(list)
}

fn cell_types(source: &mut Source, cells: &mut Cells) -> Result<(), MeshError> {
    let count = in_text(source, |source| source.int("the number of cell types"))?;
    let count = source.count(count, source.least_bytes(1, 4), "cell types")?;
    cells.types.reserve(count);
    for _ in 0..count {
        cells.types.push(source.int("a cell type")?);
    }
    Ok(())
}
