//! Writes meshes, and says what a format cannot hold.

use super::element::{VTK_TETRAHEDRON, VTK_TRIANGLE};
use super::msh_groups::Numbers;
use super::sink::{Sink, cell_arrays, labels, labels_or};
use super::source::Encoding;
use super::{Family, Format, Mesh, msh_write, vtu_write};

/// What is written: one file, or for TetGen two.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// The extension that the name must have, for TetGen.
    pub extension: Option<&'static str>,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// The files of a mesh.
pub fn write(mesh: &Mesh, format: Format) -> Vec<File> {
    let one = |bytes| {
        vec![File {
            extension: None,
            bytes,
        }]
    };
    match format {
        Format::Msh2 => one(msh_write::msh2(mesh, Encoding::Text)),
        Format::Msh2Binary => one(msh_write::msh2(mesh, Encoding::Little)),
        Format::Msh4 => one(msh_write::msh4(mesh, Encoding::Text)),
        Format::Msh4Binary => one(msh_write::msh4(mesh, Encoding::Little)),
        Format::Vtk => one(vtk(mesh, Encoding::Text)),
        Format::VtkBinary => one(vtk(mesh, Encoding::Big)),
        Format::VtuText | Format::VtuBase64 | Format::VtuRaw | Format::Vtu => {
            one(vtu_write::vtu(mesh, format))
        }
        Format::Medit => one(medit_text(mesh)),
        Format::Meditb => one(medit_binary(mesh)),
        Format::TetGen => vec![
            File {
                extension: Some("node"),
                bytes: tetgen_nodes(mesh),
            },
            File {
                extension: Some("ele"),
                bytes: tetgen_elements(mesh),
            },
        ],
    }
}

/// The parts of a mesh, or of the file that it came from, that the format cannot store.
pub fn losses(mesh: &Mesh, format: Format) -> Vec<String> {
    let family = format.family();
    let mut losses = Vec::new();
    if !mesh.others.is_empty() {
        losses.push(mesh.other_counts());
    }
    losses.extend(mesh.unread.iter().cloned());
    if !mesh.curved.is_empty() {
        losses.push(format!(
            "the middle nodes of {} curved {}",
            mesh.curved.len(),
            mesh.cell_name()
        ));
    }
    let is_plain = |numbering: &super::Numbering| {
        numbering.is_empty() || (numbering.is_consecutive() && numbering.get(0) <= 1)
    };
    if !matches!(family, Family::Msh | Family::TetGen) {
        for (what, numbering) in [("nodes", &mesh.nodes), ("elements", &mesh.elements)] {
            if !is_plain(numbering) {
                losses.push(format!("the numbers of {what}"));
            }
        }
    }
    losses.extend(lost_labels(mesh, family));
    if !mesh.names.is_empty() && family != Family::Msh {
        let names = mesh
            .names
            .iter()
            .map(|(label, name)| format!("{label} \"{name}\""));
        let names = names.collect::<Vec<_>>().join(", ");
        losses.push(format!("the names of labels: {names}"));
    }
    if !mesh.periodic.is_empty() && family != Family::Msh {
        losses.push(format!("{} periodic links", mesh.periodic.len()));
    }
    losses
}

/// VTK keeps labels and entities, other formats one number for each cell. MSH changes numbers that it
/// does not hold, and says so.
fn lost_labels(mesh: &Mesh, family: Family) -> Option<String> {
    let (has_labels, has_entities) = (!mesh.labels.is_empty(), !mesh.entities.is_empty());
    match family {
        Family::Msh => None,
        Family::Vtk | Family::Vtu => {
            let expected = usize::from(has_labels) + usize::from(has_entities);
            (cell_arrays(mesh).len() < expected)
                .then(|| "labels of cells with more than 32 bits".to_owned())
        }
        _ if (has_labels || has_entities) && labels(mesh).is_none() => {
            Some("the labels of cells, which have more than 32 bits".to_owned())
        }
        _ => (has_labels && has_entities && mesh.labels != mesh.entities)
            .then(|| "the geometric entities of cells (the labels are kept)".to_owned()),
    }
}

/// The parts that have other numbers or names than in the mesh.
pub fn changes(mesh: &Mesh, format: Format) -> Vec<String> {
    match format {
        Format::Msh2 | Format::Msh2Binary => Numbers::of(mesh, msh_write::MOST_MSH2).notes,
        Format::Msh4 | Format::Msh4Binary => Numbers::of(mesh, msh_write::MOST_MSH4).notes,
        _ => Vec::new(),
    }
}

fn vtk(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let mut sink = Sink::new(encoding);
    let kind = if encoding == Encoding::Text {
        "ASCII"
    } else {
        "BINARY"
    };
    sink.text(format!(
        "# vtk DataFile Version 3.0\nacutile\n{kind}\nDATASET UNSTRUCTURED_GRID\n"
    ));
    sink.text(format!("POINTS {} double\n", mesh.points.len()));
    for point in &mesh.points {
        sink.point(point);
        sink.end();
    }
    let count = mesh.cell_count();
    let width = mesh.dimension() + 1;
    sink.text(format!("\nCELLS {count} {}\n", (width + 1) * count));
    for corners in mesh.cells() {
        sink.int(width as i64);
        corners
            .iter()
            .for_each(|&corner| sink.int(i64::from(corner)));
        sink.end();
    }
    sink.text(format!("\nCELL_TYPES {count}\n"));
    let kind = if width == 3 {
        VTK_TRIANGLE
    } else {
        VTK_TETRAHEDRON
    };
    for _ in 0..count {
        sink.int(kind);
        sink.end();
    }
    vtk_arrays(mesh, &mut sink);
    sink.bytes
}

fn vtk_arrays(mesh: &Mesh, sink: &mut Sink) {
    let arrays = cell_arrays(mesh);
    if arrays.is_empty() {
        return;
    }
    let count = mesh.cell_count();
    sink.text(format!(
        "\nCELL_DATA {count}\nFIELD FieldData {}\n",
        arrays.len()
    ));
    for (name, values) in arrays {
        sink.text(format!("{name} 1 {count} int\n"));
        for &value in values {
            sink.int(value);
            sink.end();
        }
        sink.text("\n");
    }
}

fn medit_text(mesh: &Mesh) -> Vec<u8> {
    let mut sink = Sink::new(Encoding::Text);
    sink.text("MeshVersionFormatted 2\nDimension 3\n");
    sink.text(format!("Vertices\n{}\n", mesh.points.len()));
    medit_vertices(mesh, &mut sink);
    let keyword = if mesh.dimension() == 2 {
        "Triangles"
    } else {
        "Tetrahedra"
    };
    sink.text(format!("{keyword}\n{}\n", mesh.cell_count()));
    medit_cells(mesh, &mut sink);
    sink.text("End\n");
    sink.bytes
}

fn medit_vertices(mesh: &Mesh, sink: &mut Sink) {
    for point in &mesh.points {
        sink.point(point);
        sink.int(0);
        sink.end();
    }
}

fn medit_cells(mesh: &Mesh, sink: &mut Sink) {
    for (corners, label) in mesh.cells().zip(labels_or(mesh, 0)) {
        corners
            .iter()
            .for_each(|&corner| sink.int(i64::from(corner) + 1));
        sink.int(label);
        sink.end();
    }
}

/// Version 3: positions of 64 bits, integers of 32.
fn medit_binary(mesh: &Mesh) -> Vec<u8> {
    let mut sink = Sink::new(Encoding::Little);
    sink.int(1);
    sink.int(3);
    let dimension_end = sink.bytes.len() + 4 + 8 + 4;
    sink.int(3);
    sink.long(dimension_end as i64);
    sink.int(3);
    let vertices_end = dimension_end + 4 + 8 + 4 + 28 * mesh.points.len();
    sink.int(4);
    sink.long(vertices_end as i64);
    sink.int(mesh.points.len() as i64);
    medit_vertices(mesh, &mut sink);
    let width = mesh.dimension() + 1;
    let cells_end = vertices_end + 4 + 8 + 4 + 4 * (width + 1) * mesh.cell_count();
    sink.int(if width == 3 { 6 } else { 8 });
    sink.long(cells_end as i64);
    sink.int(mesh.cell_count() as i64);
    medit_cells(mesh, &mut sink);
    sink.int(54);
    sink.long(0);
    sink.bytes
}

/// Triangle's files have two coordinates; so a plane mesh at another height than 0 keeps three.
fn tetgen_nodes(mesh: &Mesh) -> Vec<u8> {
    let mut sink = Sink::new(Encoding::Text);
    let is_flat = mesh.dimension() == 2 && mesh.points.iter().all(|point| point[2] == 0.0);
    let dimension = if is_flat { 2 } else { 3 };
    sink.text(format!("{} {dimension} 0 0\n", mesh.points.len()));
    for (index, point) in mesh.points.iter().enumerate() {
        sink.long(mesh.nodes.get(index) as i64);
        point[..dimension].iter().for_each(|&x| sink.double(x));
        sink.end();
    }
    sink.bytes
}

fn tetgen_elements(mesh: &Mesh) -> Vec<u8> {
    let mut sink = Sink::new(Encoding::Text);
    let has_labels = labels(mesh).is_some();
    sink.text(format!(
        "{} {} {}\n",
        mesh.cell_count(),
        mesh.dimension() + 1,
        u8::from(has_labels)
    ));
    let labels = labels_or(mesh, 0);
    for ((index, corners), label) in mesh.cells().enumerate().zip(labels) {
        sink.long(mesh.elements.get(index) as i64);
        corners
            .iter()
            .for_each(|&corner| sink.long(mesh.nodes.get(corner as usize) as i64));
        if has_labels {
            sink.int(label);
        }
        sink.end();
    }
    sink.bytes
}
