//! VTK's XML format for unstructured grids ("VTK File Formats", section "XML File
//! Formats"). Arrays stand in their places, in text or base64, or at the end of the file
//! after an underscore, raw or in base64.

use super::Mesh;
use super::draft::Draft;
use super::error::{MeshError, Place};
use super::numbering::Numbering;
use super::source::{Encoding, Source, shown};
use super::unknown::READ;
use super::vtk_cells::Cells;
use super::vtu_data::{Compressor, Kind, Layout, doubles, integers, unpack};
use super::vtu_parts::{Appended, Lines, SECOND, length_before, split};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::collections::BTreeMap;

/// Reads all pieces of a grid into one mesh. Points and cells are numbered from 0 on,
/// through all pieces.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let (xml, appended) = split(bytes)?;
    let mut lines = Lines::new(xml);
    let mut reading = Reading {
        layout: None,
        appended,
        draft: Draft::default(),
    };
    let mut reader = Reader::from_str(xml);
    let mut path: Vec<String> = Vec::new();
    let mut piece = None;
    loop {
        let event = reader.read_event().map_err(|error| {
            let at = reader.error_position();
            MeshError::at(lines.of(at as usize), format!("not valid XML: {error}"))
        })?;
        let at = reader.buffer_position() as usize;
        let place = lines.of(at);
        match event {
            Event::Start(tag) => {
                if path.len() >= DEPTH {
                    return Err(MeshError::at(
                        place,
                        format!("elements more than {DEPTH} deep, expected those of a VTU file"),
                    ));
                }
                let content = xml.get(at..).unwrap_or_default();
                let is_array = reading.open(&tag, (content, place), &path, &mut piece)?;
                path.push(if is_array {
                    "DataArray".to_owned()
                } else {
                    name(&tag)
                });
            }
            Event::Empty(tag) => {
                reading.open(&tag, ("", place), &path, &mut piece)?;
                if name(&tag) == "Piece" {
                    reading.close(piece.take())?;
                }
            }
            Event::End(_) => {
                let closed = path.pop();
                if closed.as_deref() == Some("Piece") {
                    reading.close(piece.take())?;
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    if reading.layout.is_none() {
        return Err(MeshError::of_file(
            "has no element VTKFile, expected a VTU file",
        ));
    }
    if piece.is_some() {
        return Err(MeshError::of_file("the file ends inside of a Piece"));
    }
    reading.draft.finish()
}

/// A VTU file has its elements at most five deep.
const DEPTH: usize = 64;

fn name(tag: &BytesStart) -> String {
    tag.name().0.to_owned()
}

/// The arrays of a piece that are wanted.
#[derive(Default)]
struct Piece {
    points: usize,
    cells: usize,
    coordinates: Option<Vec<f64>>,
    lists: BTreeMap<&'static str, Vec<i64>>,
    /// Arrays of one integer for each cell.
    arrays: Vec<(String, Vec<i64>)>,
}

struct Reading<'a> {
    layout: Option<Layout>,
    appended: Option<Appended<'a>>,
    draft: Draft,
}

impl<'a> Reading<'a> {
    /// Attends to a tag with what follows it, and the line where it ends; tells whether it
    /// is an array.
    fn open(
        &mut self,
        tag: &BytesStart,
        (content, place): (&str, Place),
        path: &[String],
        piece: &mut Option<Piece>,
    ) -> Result<bool, MeshError> {
        let attributes = attributes(tag, place)?;
        match name(tag).as_str() {
            "VTKFile" if self.layout.is_some() => return Err(MeshError::at(place, SECOND)),
            "VTKFile" => self.layout = Some(layout(&attributes, place)?),
            "Piece" => {
                *piece = Some(Piece {
                    points: number(&attributes, "NumberOfPoints", place)?,
                    cells: number(&attributes, "NumberOfCells", place)?,
                    ..Piece::default()
                });
            }
            "DataArray" => {
                self.array(&attributes, (content, place), path, piece)?;
                return Ok(true);
            }
            _ => {}
        }
        Ok(false)
    }

    fn array(
        &mut self,
        attributes: &BTreeMap<String, String>,
        (content, place): (&str, Place),
        path: &[String],
        piece: &mut Option<Piece>,
    ) -> Result<(), MeshError> {
        let array_name = attributes.get("Name").map_or("", String::as_str);
        let parent = path.last().map_or("", String::as_str);
        let kind = attributes.get("type").and_then(|kind| Kind::parse(kind));
        if let (Some(piece), "CellData", Some(kind @ Kind::Integer { .. })) =
            (piece.as_mut(), parent, kind)
            && is_single(attributes)
        {
            let count = Some(piece.cells);
            let values = self.with_source(attributes, content, place, |source| {
                integers(source, kind, count)
            })?;
            piece.arrays.push((array_name.to_owned(), values));
            return Ok(());
        }
        let (Some(piece), "Points" | "Cells") = (piece.as_mut(), parent) else {
            self.draft.pass(format!("array {array_name} of {parent}"));
            return Ok(());
        };
        let kind = kind.ok_or_else(|| {
            MeshError::at(place, format!("the array {array_name} has no known type"))
        })?;
        let list = match (parent, array_name) {
            ("Points", _) => {
                let components = attributes.get("NumberOfComponents").map(String::as_str);
                if components != Some("3") {
                    let problem = format!("points have {components:?} components, expected 3");
                    return Err(MeshError::at(place, problem));
                }
                let count = piece.points.saturating_mul(3);
                let numbers = self.with_source(attributes, content, place, |source| {
                    doubles(source, kind, count)
                })?;
                piece.coordinates = Some(numbers);
                return Ok(());
            }
            (_, "connectivity") => "connectivity",
            (_, "offsets") => "offsets",
            (_, "types") => "types",
            _ => {
                self.draft.pass(format!("array {array_name} of {parent}"));
                return Ok(());
            }
        };
        let count = (list != "connectivity").then_some(piece.cells);
        let numbers = self.with_source(attributes, content, place, |source| {
            integers(source, kind, count)
        });
        let numbers = numbers.map_err(|error| MeshError {
            problem: format!("{list}: {}", error.problem),
            ..error
        })?;
        piece.lists.insert(list, numbers);
        Ok(())
    }

    /// Runs a reader over the bytes of an array; its tag ends at this place, and `content`
    /// follows.
    fn with_source<T>(
        &self,
        attributes: &BTreeMap<String, String>,
        content: &str,
        place: Place,
        read: impl FnOnce(&mut Source) -> Result<T, MeshError>,
    ) -> Result<T, MeshError> {
        let layout = self
            .layout
            .ok_or_else(|| MeshError::at(place, "found a DataArray outside of a VTKFile"))?;
        let inside = &content.as_bytes()[..length_before(content.as_bytes(), b'<')];
        match attributes.get("format").map(String::as_str) {
            Some("ascii") | None => {
                let mut source = Source::new(inside);
                read(&mut source).map_err(|error| shifted(error, place))
            }
            Some("binary") => {
                let packed: Vec<u8> = inside
                    .iter()
                    .copied()
                    .filter(|byte| !byte.is_ascii_whitespace())
                    .collect();
                let bytes = unpack(&packed, true, layout, place)?;
                read_binary(&bytes, layout, place, read)
            }
            Some("appended") => {
                let appended = self.appended.ok_or_else(|| {
                    MeshError::at(place, "an array is appended, but there are no AppendedData")
                })?;
                let offset: usize = number(attributes, "offset", place)?;
                let data = appended.data.get(offset..).ok_or_else(|| {
                    let most = appended.data.len();
                    MeshError::at(
                        place,
                        format!("found the offset {offset}, expected at most {most}"),
                    )
                })?;
                let place = Place::Byte((appended.start + offset) as u64);
                let bytes = unpack(data, appended.is_base64, layout, place)?;
                read_binary(&bytes, layout, place, read)
            }
            Some(other) => {
                let found = shown(other.as_bytes());
                let expected = "ascii, binary or appended";
                Err(MeshError::at(
                    place,
                    format!("found format {found}, expected {expected}"),
                ))
            }
        }
    }

    /// Adds a piece to the mesh.
    fn close(&mut self, piece: Option<Piece>) -> Result<(), MeshError> {
        let Some(mut piece) = piece else {
            return Ok(());
        };
        let missing = |what| MeshError::of_file(format!("a Piece has no array of {what}"));
        let coordinates = match piece.coordinates.take() {
            Some(coordinates) => coordinates,
            None if piece.points == 0 => Vec::new(),
            None => return Err(missing("points")),
        };
        let first = self.draft.mesh.points.len() as i64;
        let (points, _) = coordinates.as_chunks::<3>();
        for (point, tag) in points.iter().zip(first..) {
            self.draft.add_node(tag, *point, Place::File)?;
        }
        let arrays = std::mem::take(&mut piece.arrays);
        let mut list = |name| match piece.lists.remove(name) {
            Some(list) => Ok(list),
            None if piece.cells == 0 => Ok(Vec::new()),
            None => Err(missing(name)),
        };
        let cells = Cells {
            connectivity: list("connectivity")?,
            ends: list("offsets")?,
            types: list("types")?,
            lines: Numbering::default(),
            arrays,
        };
        let count = coordinates.len() / 3;
        let outside = |&&point: &&i64| point < 0 || point >= count as i64;
        if let Some(point) = cells.connectivity.iter().find(outside) {
            return Err(MeshError::of_file(format!(
                "connectivity has the point {point}, but the Piece has {count} points"
            )));
        }
        let index = self.draft.node_index()?;
        cells.store(&mut self.draft, &index, first)
    }
}

/// Whether an array has one component.
fn is_single(attributes: &BTreeMap<String, String>) -> bool {
    let components = attributes.get("NumberOfComponents").map(String::as_str);
    matches!(components, None | Some("" | "0" | "1"))
}

fn read_binary<T>(
    bytes: &[u8],
    layout: Layout,
    place: Place,
    read: impl FnOnce(&mut Source) -> Result<T, MeshError>,
) -> Result<T, MeshError> {
    let mut source = Source::new(bytes);
    source.encoding = layout.encoding;
    read(&mut source).map_err(|error| MeshError { place, ..error })
}

/// A line of an array as a line of the file.
fn shifted(error: MeshError, start: Place) -> MeshError {
    let place = match (error.place, start) {
        (Place::Line(line), Place::Line(start)) => Place::Line(start + line - 1),
        (place, _) => place,
    };
    MeshError { place, ..error }
}

fn attributes(tag: &BytesStart, place: Place) -> Result<BTreeMap<String, String>, MeshError> {
    let mut map = BTreeMap::new();
    for attribute in tag.attributes() {
        let attribute =
            attribute.map_err(|error| MeshError::at(place, format!("not valid XML: {error}")))?;
        map.insert(
            attribute.key.0.to_owned(),
            attribute.value.trim().to_owned(),
        );
    }
    Ok(map)
}

fn layout(attributes: &BTreeMap<String, String>, place: Place) -> Result<Layout, MeshError> {
    let get = |name: &str, default: &'static str| {
        attributes
            .get(name)
            .map_or(default, String::as_str)
            .to_owned()
    };
    let wrong = |name: &str, found: &str, expected: &str| {
        let found = shown(found.as_bytes());
        MeshError::at(place, format!("{name} is {found}, expected {expected}"))
    };
    let kind = get("type", "nothing");
    if kind != "UnstructuredGrid" {
        let found = format!("VTK XML of type {}", shown(kind.as_bytes()));
        let expected = "expected UnstructuredGrid";
        return Err(MeshError::at(
            place,
            format!("{found} is not read, {expected}; {READ}"),
        ));
    }
    let order = get("byte_order", "LittleEndian");
    let encoding = match order.as_str() {
        "LittleEndian" => Encoding::Little,
        "BigEndian" => Encoding::Big,
        other => return Err(wrong("byte_order", other, "LittleEndian or BigEndian")),
    };
    let head = match get("header_type", "UInt32").as_str() {
        "UInt32" => 4,
        "UInt64" => 8,
        other => return Err(wrong("header_type", other, "UInt32 or UInt64")),
    };
    let compressor = match get("compressor", "").as_str() {
        "" => None,
        name => Some(Compressor::parse(name).ok_or_else(|| {
            let expected = "vtkZLibDataCompressor, vtkLZ4DataCompressor, vtkLZMADataCompressor \
                            or none";
            wrong("compressor", name, expected)
        })?),
    };
    Ok(Layout {
        encoding,
        head,
        compressor,
    })
}

fn number(
    attributes: &BTreeMap<String, String>,
    name: &str,
    place: Place,
) -> Result<usize, MeshError> {
    let text = attributes.get(name).map_or("", String::as_str);
    text.parse().map_err(|_| {
        let found = shown(text.as_bytes());
        MeshError::at(place, format!("{name} is {found}, expected a number"))
    })
}
