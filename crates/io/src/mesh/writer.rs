//! Writes meshes, and says what a format cannot hold.

use super::sink::{Sink, labels, labels_or};
use super::source::Encoding;
use super::{Format, Mesh, msh_write, vtu_write};

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

/// What a mesh, or the file that it came from, has and the format does not hold.
pub fn losses(mesh: &Mesh, format: Format) -> Vec<String> {
    let mut losses = Vec::new();
    if !mesh.others.is_empty() {
        losses.push(mesh.other_counts());
    }
    losses.extend(mesh.unread.iter().cloned());
    let keeps_numbers = matches!(
        format,
        Format::Msh2 | Format::Msh2Binary | Format::Msh4 | Format::Msh4Binary | Format::TetGen
    );
    let is_plain = |numbering: &super::Numbering| {
        numbering.is_empty() || (numbering.is_consecutive() && numbering.get(0) <= 1)
    };
    if !keeps_numbers {
        for (what, numbering) in [("nodes", &mesh.nodes), ("elements", &mesh.elements)] {
            if !is_plain(numbering) {
                losses.push(format!("the numbers of {what}"));
            }
        }
    }
    let holds_labels =
        format.family() != super::Family::Vtk && format.family() != super::Family::Vtu;
    let keeps_labels = holds_labels && labels(mesh).is_some();
    if !mesh.labels.is_empty() && !keeps_labels {
        losses.push("the labels of tetrahedra".to_owned());
    }
    if !mesh.periodic.is_empty() && format.family() != super::Family::Msh {
        losses.push(format!("{} periodic links", mesh.periodic.len()));
    }
    losses
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
    let count = mesh.tetrahedra.len();
    sink.text(format!("\nCELLS {count} {}\n", 5 * count));
    for corners in &mesh.tetrahedra {
        sink.int(4);
        corners
            .iter()
            .for_each(|&corner| sink.int(i64::from(corner)));
        sink.end();
    }
    sink.text(format!("\nCELL_TYPES {count}\n"));
    for _ in 0..count {
        sink.int(super::element::VTK_TETRAHEDRON);
        sink.end();
    }
    sink.bytes
}

fn medit_text(mesh: &Mesh) -> Vec<u8> {
    let mut sink = Sink::new(Encoding::Text);
    sink.text("MeshVersionFormatted 2\nDimension 3\n");
    sink.text(format!("Vertices\n{}\n", mesh.points.len()));
    medit_vertices(mesh, &mut sink);
    sink.text(format!("Tetrahedra\n{}\n", mesh.tetrahedra.len()));
    medit_tetrahedra(mesh, &mut sink);
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

fn medit_tetrahedra(mesh: &Mesh, sink: &mut Sink) {
    for (corners, label) in mesh.tetrahedra.iter().zip(labels_or(mesh, 0)) {
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
    let tetrahedra_end = vertices_end + 4 + 8 + 4 + 20 * mesh.tetrahedra.len();
    sink.int(8);
    sink.long(tetrahedra_end as i64);
    sink.int(mesh.tetrahedra.len() as i64);
    medit_tetrahedra(mesh, &mut sink);
    sink.int(54);
    sink.long(0);
    sink.bytes
}

fn tetgen_nodes(mesh: &Mesh) -> Vec<u8> {
    let mut sink = Sink::new(Encoding::Text);
    sink.text(format!("{} 3 0 0\n", mesh.points.len()));
    for (index, point) in mesh.points.iter().enumerate() {
        sink.long(mesh.nodes.get(index) as i64);
        sink.point(point);
        sink.end();
    }
    sink.bytes
}

fn tetgen_elements(mesh: &Mesh) -> Vec<u8> {
    let mut sink = Sink::new(Encoding::Text);
    let has_labels = labels(mesh).is_some();
    sink.text(format!(
        "{} 4 {}\n",
        mesh.tetrahedra.len(),
        u8::from(has_labels)
    ));
    let labels = labels_or(mesh, 0);
    for ((index, corners), label) in mesh.tetrahedra.iter().enumerate().zip(labels) {
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
