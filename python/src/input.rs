//! What a user has, turned into a tiling: arrays, a tiling file's text, a file, or a name.

use super::error::failed;
use acutile_catalog as catalog;
use acutile_core::checker::{Names, Sides};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::format;
use acutile_core::tiling::{AnyPointSet, AnyTiling, Tiling};
use acutile_core::transcribe;
use acutile_core::with_dimension;
use acutile_io::import::cif::CifOptions;
use acutile_io::import::crystal::{self, text_of};
use acutile_io::import::{BYTE_LIMIT, Content, read_bytes, read_native, uncompressed_name};
use acutile_io::mesh::{
    Family, Lattice, Mesh, Numbering, Origin, load, periodic_tiling, region_tiling,
};
use numpy::ndarray::ArrayView2;
use pyo3::PyResult;
use std::fmt::Display;
use std::path::Path;

/// A tiling with the numbers of the mesh that it was made from.
pub struct Input {
    pub tiling: AnyTiling,
    /// The numbers of a mesh; nothing for other inputs.
    pub origin: Option<Origin>,
    /// Facets on the sides of a periodic mesh that have no mate.
    pub sides: Sides,
    pub notes: Vec<String>,
}

impl Input {
    /// A tiling that comes from no mesh.
    pub fn of(tiling: AnyTiling) -> Input {
        Input {
            tiling,
            origin: None,
            sides: Sides::default(),
            notes: Vec::new(),
        }
    }

    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        match self.tiling {
            AnyTiling::Plane(_) => 2,
            AnyTiling::Space(_) => 3,
        }
    }

    /// The words for simplices and vertices: as the mesh numbers them, else by index.
    pub fn names<'a, const D: usize>(&'a self, tiling: &'a Tiling<D>) -> Names<'a> {
        match &self.origin {
            None => Names::of(tiling),
            Some(origin) => Names::new(
                |simplex| format!("element {}", origin.tetrahedron(simplex).tag),
                |simplex, corner| origin.corner(simplex, corner).to_string(),
                |vertex| format!("node {}", origin.vertex(vertex)),
            ),
        }
    }
}

/// How a name or a file is read.
pub struct Options {
    /// The number that a construction of the catalogue depends on.
    pub parameter: Option<String>,
    /// `a1,a2,a3;b1,b2,b3;c1,c2,c3`
    pub lattice: Option<String>,
    /// The distance within which nodes of a mesh become one vertex.
    pub tolerance: Option<f64>,
    /// Whether Delaunay cells with cospherical vertices are cut.
    pub triangulate: bool,
}

/// A mesh whose nodes and elements are numbered from 0.
pub fn mesh(points: ArrayView2<f64>, cells: ArrayView2<u32>) -> PyResult<Mesh> {
    let (nodes, width) = points.dim();
    let (elements, corners) = cells.dim();
    if (width, corners) != (3, 4) {
        return Err(failed(format!(
            "found points with {width} coordinates and cells with {corners} corners, expected 3 and 4"
        )));
    }
    if let Some(((row, column), value)) = points.indexed_iter().find(|(_, x)| !x.is_finite()) {
        return Err(failed(format!(
            "points[{row}, {column}] is {value}, expected a finite number"
        )));
    }
    if let Some(((row, column), value)) = cells.indexed_iter().find(|(_, v)| **v as usize >= nodes)
    {
        return Err(failed(format!(
            "cells[{row}, {column}] is {value}, expected an index below {nodes}, the number of points"
        )));
    }
    let row = |row: numpy::ndarray::ArrayView1<f64>| [row[0], row[1], row[2]];
    let cell = |row: numpy::ndarray::ArrayView1<u32>| [row[0], row[1], row[2], row[3]];
    Ok(Mesh {
        points: points.rows().into_iter().map(row).collect(),
        nodes: Numbering::consecutive(0, nodes),
        tetrahedra: cells.rows().into_iter().map(cell).collect(),
        elements: Numbering::consecutive(0, elements),
        ..Mesh::default()
    })
}

/// A bounded mesh, or with a lattice a periodic one.
pub fn of_mesh(mesh: Mesh, lattice: Option<&str>, tolerance: Option<f64>) -> PyResult<Input> {
    if !mesh.curved.is_empty() {
        return Err(failed(format!(
            "{} tetrahedra of second order are curved; the command `acutile certify` says whether \
             each is valid",
            mesh.curved.len()
        )));
    }
    let lattice = match lattice {
        Some(text) => Some(Lattice::parse(text).map_err(|e| failed(format!("lattice: {e}")))?),
        None if mesh.periodic.is_empty() => None,
        None => Some(Lattice::of_links(&mesh).map_err(failed)?),
    };
    let converted = match &lattice {
        Some(lattice) => periodic_tiling(mesh, lattice, tolerance),
        None => region_tiling(mesh, tolerance),
    };
    let converted = converted.map_err(failed)?;
    let counts = [
        (
            converted.unused,
            "nodes belong to no tetrahedron and are left out",
        ),
        (
            converted.coincident,
            "nodes have the coordinates of another node",
        ),
        (converted.moves.len(), "nodes are moved onto others"),
    ];
    let notes = counts.iter().filter(|(count, _)| *count > 0);
    Ok(Input {
        tiling: converted.tiling,
        origin: Some(converted.origin),
        sides: converted.sides,
        notes: notes
            .map(|(count, words)| format!("{count} {words}"))
            .collect(),
    })
}

/// A tiling file, or the Delaunay triangulation of a point-set file.
pub fn of_text(text: &str, must_cut: bool) -> PyResult<Input> {
    match read_native(text).map_err(failed)?.content {
        Content::Tiling(tiling) => Ok(Input::of(tiling)),
        Content::Points(points) => of_points(&points, must_cut),
        Content::Family(_) => Err(failed(
            "a file with parameters is a family, expected a single tiling; the command line takes it",
        )),
    }
}

fn of_points(points: &AnyPointSet, must_cut: bool) -> PyResult<Input> {
    let ties = if must_cut { Ties::Pull } else { Ties::Refuse };
    let advice = "; triangulate=True cuts cells with cospherical vertices";
    let tiling = match points {
        AnyPointSet::Plane(points) => triangulate(points, ties).map(AnyTiling::Plane),
        AnyPointSet::Space(points) => triangulate(points, ties).map(AnyTiling::Space),
    };
    let tiling = tiling.map_err(|error| match ties {
        Ties::Refuse => failed(format!("{error}{advice}")),
        Ties::Pull => failed(error),
    })?;
    let mut input = Input::of(tiling);
    let count = with_dimension!(points, AnyPointSet, p => p.points.len());
    input.notes.push(format!(
        "the tiling is the Delaunay triangulation of {count} points in a cell"
    ));
    Ok(input)
}

/// A name of the catalogue or of a file.
pub fn open(source: &str, options: &Options) -> PyResult<Input> {
    let of_source = |error: &dyn Display| failed(format!("{source}: {error}"));
    if catalog::find(source).is_some() {
        let tiling = match &options.parameter {
            Some(parameter) => catalog::build_with(source, parameter),
            None => catalog::build(source),
        };
        return tiling.map(Input::of).map_err(|error| of_source(&error));
    }
    let path = Path::new(source);
    if !path.exists() {
        return Err(failed(format!(
            "{source}: neither a name of the catalogue (acutile.names()) nor a file"
        )));
    }
    let of_mesh = |mesh| self::of_mesh(mesh, options.lattice.as_deref(), options.tolerance);
    if let Some(family) = Family::of_path(path) {
        let loaded = load(path, family).map_err(|error| of_source(&error))?;
        return of_mesh(loaded.mesh);
    }
    let bytes = read_bytes(path, BYTE_LIMIT).map_err(|error| of_source(&error))?;
    if let Some(family) = Family::of_content(&bytes) {
        return of_mesh(family.read(&bytes).map_err(|error| of_source(&error))?);
    }
    if format::recognise(&bytes).is_some() {
        let cbor = format::to_cbor(&bytes).map_err(|error| of_source(&error))?;
        let read = transcribe::of_certificate(&cbor).map_err(|error| of_source(&error))?;
        return Ok(Input::of(read.0));
    }
    let name = uncompressed_name(path);
    let text = text_of(&name, bytes).map_err(|error| of_source(&error))?;
    if let Some(kind) = crystal::kind(&name, &text) {
        let structure = crystal::read(kind, &text, &CifOptions::default());
        let structure = structure.map_err(|error| of_source(&error))?;
        let mut input = of_points(&AnyPointSet::Space(structure.points), options.triangulate)?;
        input.notes.splice(0..0, structure.notes);
        return Ok(input);
    }
    of_text(&text, options.triangulate).map_err(|error| of_source(&error))
}
