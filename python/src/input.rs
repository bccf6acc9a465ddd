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
    Ok(Mesh {
        points: rows(points),
        nodes: Numbering::consecutive(0, nodes),
        tetrahedra: rows(cells),
        elements: Numbering::consecutive(0, elements),
        ..Mesh::default()
    })
}

/// The rows of an array with N columns; a contiguous one is copied as a whole.
fn rows<T: Copy, const N: usize>(array: ArrayView2<T>) -> Vec<[T; N]> {
    match array.as_slice() {
        Some(entries) => entries.as_chunks().0.to_vec(),
        None => {
            let row = |row: ArrayView1<T>| std::array::from_fn(|k| row[k]);
            array.rows().into_iter().map(row).collect()
        }
    }
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
