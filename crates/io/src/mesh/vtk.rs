//! VTK's legacy format, versions 1 to 5.1, text and binary ("VTK File Formats", section
//! "Simple Legacy Formats"); and cells as VTK has them, for `vtu`, too.

use super::Mesh;
use super::element::{VTK_TETRAHEDRON, vtk_cell};
use super::error::{MeshError, Place};
use super::numbering::{Index, Numbering};
use super::source::{Encoding, Source, shown};

/// Reads an unstructured grid. Points and cells are numbered from 0.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut source = Source::new(bytes);
    let version = head(&mut source)?;
    let mut mesh = Mesh::default();
    let mut cells = Cells::default();
    let mut has_points = false;
    while let Some(word) = source.try_word() {
        match word.to_ascii_uppercase().as_slice() {
            b"POINTS" => {
                if std::mem::replace(&mut has_points, true) {
                    return Err(source.error("found POINTS a second time"));
                }
                points(&mut source, &mut mesh)?;
            }
            b"CELLS" if version >= 5 => split_cells(&mut source, &mut cells)?,
            b"CELLS" => listed_cells(&mut source, &mut cells)?,
            b"CELL_TYPES" => cell_types(&mut source, &mut cells)?,
            b"METADATA" => skip_metadata(&mut source),
            b"FIELD" => field(&mut source, &mut mesh)?,
            b"CELL_DATA" | b"POINT_DATA" => {
                let name = String::from_utf8_lossy(word).into_owned();
                mesh.unread.push(format!("what {name} begins"));
                break;
            }
            _ => return Err(source.unexpected(word, "POINTS, CELLS or CELL_TYPES")),
        }
    }
    let index = mesh.node_index()?;
    cells.store(&mut mesh, &index, 0)?;
    mesh.checked()
}

/// `# vtk DataFile Version 3.0`, a title, `ASCII` or `BINARY`, `DATASET UNSTRUCTURED_GRID`.
/// Gives the major version.
fn head(source: &mut Source) -> Result<u32, MeshError> {
    let first = source.rest_of_line();
    let version = first
        .strip_prefix(b"# vtk DataFile Version ")
        .and_then(|version| {
            let major = version.split(|&byte| byte == b'.').next()?;
            std::str::from_utf8(major).ok()?.parse::<u32>().ok()
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
    let encoding = match source.word("ASCII or BINARY")? {
        b"ASCII" => Encoding::Text,
        b"BINARY" => Encoding::Big,
        word => return Err(source.unexpected(word, "ASCII or BINARY")),
    };
    source.expect("DATASET")?;
    source.expect("UNSTRUCTURED_GRID")?;
    source.encoding = encoding;
    Ok(version)
}

/// Reads in text what stands in text in a binary file, too: the rest of a line of words.
fn in_text<T>(
    source: &mut Source,
    read: impl FnOnce(&mut Source) -> Result<T, MeshError>,
) -> Result<T, MeshError> {
    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
    let value = read(source)?;
    source.rest_of_line();
    source.encoding = encoding;
    Ok(value)
}

fn points(source: &mut Source, mesh: &mut Mesh) -> Result<(), MeshError> {
    let (count, single) = in_text(source, |source| {
        let count = source.int("the number of points")?;
        match source.word("float or double")? {
            b"double" => Ok((count, false)),
            b"float" => Ok((count, true)),
            word => Err(source.unexpected(word, "float or double")),
        }
    })?;
    let count = source.count(
        count,
        source.least_bytes(3, if single { 4 } else { 8 }),
        "points",
    )?;
    let number = if single {
        Source::single
    } else {
        Source::double
    };
    mesh.points.reserve(count);
    for tag in 0..count as i64 {
        let point = [
            number(source, "the coordinate x")?,
            number(source, "the coordinate y")?,
            number(source, "the coordinate z")?,
        ];
        mesh.add_node(tag, point, source.place())?;
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
    let is_long = in_text(source, |source| {
        source.expect(name)?;
        let kind = source.word("vtktypeint32 or vtktypeint64")?;
        match kind.to_ascii_lowercase().as_slice() {
            b"vtktypeint64" => Ok(true),
            b"vtktypeint32" | b"int" => Ok(false),
            _ => Err(source.unexpected(kind, "vtktypeint32 or vtktypeint64")),
        }
    })?;
    let count = source.count(
        count,
        source.least_bytes(1, if is_long { 8 } else { 4 }),
        name,
    )?;
    let number = if is_long { Source::long } else { Source::int };
    let mut list = Vec::with_capacity(count);
    for _ in 0..count {
        list.push(number(source, "an integer")?);
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

/// Until an empty line.
fn skip_metadata(source: &mut Source) {
    source.rest_of_line();
    while source.remaining() > 0 && !source.rest_of_line().is_empty() {}
}

/// `FIELD name arrays`, then `name components tuples type` and the data for each array.
fn field(source: &mut Source, mesh: &mut Mesh) -> Result<(), MeshError> {
    let arrays = in_text(source, |source| {
        source.word("a name")?;
        source.int("the number of arrays")
    })?;
    let arrays = source.count(arrays, 8, "arrays")?;
    for _ in 0..arrays {
        let (name, count, size) = in_text(source, |source| {
            let name = String::from_utf8_lossy(source.word("a name")?).into_owned();
            let components = source.int("the number of components")?;
            let tuples = source.int("the number of tuples")?;
            let kind = source.word("a type")?;
            let size = match kind {
                b"char" | b"unsigned_char" => 1,
                b"short" | b"unsigned_short" => 2,
                b"int" | b"unsigned_int" | b"float" | b"vtktypeint32" => 4,
                b"long" | b"unsigned_long" | b"double" | b"vtktypeint64" => 8,
                _ => return Err(source.unexpected(kind, "a type of numbers like double")),
            };
            Ok((name, components.saturating_mul(tuples), size))
        })?;
        let count = source.count(count, source.least_bytes(1, size), "numbers of an array")?;
        match source.encoding {
            Encoding::Text => (0..count).try_for_each(|_| source.word("a number").map(drop))?,
            _ => drop(source.take(count * size, "an array")?),
        }
        mesh.unread.push(format!("field {name}"));
    }
    Ok(())
}

/// Cells as VTK has them.
#[derive(Default)]
pub struct Cells {
    /// The points of all cells.
    pub connectivity: Vec<i64>,
    /// Where the points of each cell end.
    pub ends: Vec<i64>,
    /// The type of each cell.
    pub types: Vec<i64>,
    /// The line of each cell, or nothing.
    pub lines: Numbering,
}

impl Cells {
    /// Adds the tetrahedra to the mesh; point p of a cell is the point p + `first` of the mesh.
    pub fn store(&self, mesh: &mut Mesh, index: &Index, first: i64) -> Result<(), MeshError> {
        let (cells, types) = (self.ends.len(), self.types.len());
        if cells != types {
            return Err(MeshError::of_file(format!(
                "has {cells} cells and {types} cell types, expected as many"
            )));
        }
        // Cells of all pieces are counted together.
        let before = mesh.tetrahedra.len() + mesh.others.values().sum::<usize>();
        let mut start = 0;
        for (cell, (&end, &kind)) in self.ends.iter().zip(&self.types).enumerate() {
            let tag = (before + cell) as i64;
            let nodes = self.nodes(tag, start, end)?;
            start = end;
            if kind != VTK_TETRAHEDRON {
                mesh.count_other(&vtk_cell(kind), 1);
                continue;
            }
            let nodes: [i64; 4] = nodes.try_into().map_err(|_| {
                let found = nodes.len();
                MeshError::of_file(format!(
                    "cell {tag} is a tetrahedron with {found} points, expected 4"
                ))
            })?;
            let place = match cell < self.lines.len() {
                true => Place::Line(self.lines.get(cell)),
                false => Place::File,
            };
            let nodes = nodes.map(|node| {
                if node < 0 {
                    node
                } else {
                    node.saturating_add(first)
                }
            });
            mesh.add_tetrahedron(index, tag, nodes, place)?;
        }
        match start == self.connectivity.len() as i64 {
            true => Ok(()),
            false => Err(MeshError::of_file(format!(
                "the cells have {start} points by their offsets, but {} are listed",
                self.connectivity.len()
            ))),
        }
    }

    fn nodes(&self, tag: i64, start: i64, end: i64) -> Result<&[i64], MeshError> {
        let range = usize::try_from(start).ok().zip(usize::try_from(end).ok());
        range
            .and_then(|(start, end)| self.connectivity.get(start..end))
            .ok_or_else(|| {
                MeshError::of_file(format!(
                    "cell {tag} has the points from {start} to {end} of a list of {}",
                    self.connectivity.len()
                ))
            })
    }
}
