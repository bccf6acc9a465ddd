//! Arguments of Python: arrays of numpy as a mesh, and options for files.

use super::error::failed;
use acutile::ReadOptions;
use acutile_io::mesh::{Mesh, Numbering};
use numpy::ndarray::{ArrayView1, ArrayView2};
use pyo3::PyResult;

/// A mesh whose nodes and elements are numbered from 0.
pub fn mesh(points: ArrayView2<f64>, cells: ArrayView2<u32>) -> PyResult<Mesh> {
    let (nodes, width) = points.dim();
    let (elements, corners) = cells.dim();
    if (width, corners) != (3, 4) {
        return Err(failed(format!(
            "found points with {width} coordinates and cells with {corners} corners, expected 3 and 4"
        )));
    }
    let row = |row: ArrayView1<f64>| [row[0], row[1], row[2]];
    let cell = |row: ArrayView1<u32>| [row[0], row[1], row[2], row[3]];
    Ok(Mesh {
        points: points.rows().into_iter().map(row).collect(),
        nodes: Numbering::consecutive(0, nodes),
        tetrahedra: cells.rows().into_iter().map(cell).collect(),
        elements: Numbering::consecutive(0, elements),
        ..Mesh::default()
    })
}

/// How a name or a file is read.
pub fn options(
    parameter: Option<String>,
    lattice: Option<String>,
    tolerance: Option<f64>,
    must_cut: bool,
) -> ReadOptions {
    let mut options = ReadOptions::default();
    if let Some(value) = parameter {
        options = options.parameter(value);
    }
    if let Some(vectors) = lattice {
        options = options.lattice(vectors);
    }
    if let Some(distance) = tolerance {
        options = options.tolerance(distance);
    }
    if must_cut {
        options.triangulate()
    } else {
        options
    }
}
