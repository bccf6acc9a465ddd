//! Reading text mesh formats: cells of A15 with coordinates of 16 digits, in files that this
//! program writes.

use crate::clock::on_processor;
use crate::data::{a15, doubles};
use crate::row::{Table, Target};
use acutile_io::mesh::load::load;
use acutile_io::mesh::{Family, Format, Mesh, flatten, write};
use std::path::{Path, PathBuf};

const CELLS: u16 = 16;

/// The formats with the names of their files.
const FORMATS: [(&str, Format, &str); 5] = [
    ("MSH 4.1", Format::Msh4, "a15.msh"),
    ("VTK legacy", Format::Vtk, "a15.vtk"),
    ("VTU, ascii", Format::VtuText, "a15.vtu"),
    ("MEDIT", Format::Medit, "a15.mesh"),
    ("TetGen", Format::TetGen, "a15.ele"),
];

/// The rows of reading.
pub fn measure(table: &Table) {
    table.head("reading text mesh formats, from the system's cache of files");
    let folder = tempfile::tempdir().expect("a directory");
    for (name, family, path) in write_files(folder.path(), CELLS).expect("it can be written") {
        let read = || load(&path, family).expect("it is a mesh").mesh;
        let mesh = read();
        let time = on_processor(5, read).as_secs_f64();
        let rate = mesh.tetrahedra.len() as f64 / time;
        let bytes = std::fs::metadata(&path).map_or(0, |data| data.len());
        let note = format!(
            "{} nodes, {} tetrahedra, {:.0} MB, {:.0} MB/s",
            mesh.points.len(),
            mesh.tetrahedra.len(),
            bytes as f64 / 1e6,
            bytes as f64 / 1e6 / time,
        );
        table.row(name, rate, "tetrahedra/s", Target::Least(3e6), &note);
    }
}

/// Writes the mesh of n³ cells in every format.
pub fn write_files(folder: &Path, n: u16) -> std::io::Result<Vec<(&'static str, Family, PathBuf)>> {
    let mesh = mesh(n);
    let mut paths = Vec::new();
    for (name, format, file) in FORMATS {
        let path = folder.join(file);
        for written in write(&mesh, format) {
            let path = match written.extension {
                Some(extension) => path.with_extension(extension),
                None => path.clone(),
            };
            std::fs::write(path, written.bytes)?;
        }
        paths.push((name, format.family(), path));
    }
    Ok(paths)
}

/// A bounded mesh: without links, for other programs differ in what they read of these.
pub fn mesh(n: u16) -> Mesh {
    let mut mesh = flatten(&doubles(&a15(n), 1e-4, None), None)
        .expect("a metric")
        .mesh;
    mesh.periodic.clear();
    mesh
}
