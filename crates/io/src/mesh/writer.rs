//! Writes meshes, and says what a format cannot hold.

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

/// The labels, if there are any and all have 32 bits.
pub fn labels(mesh: &Mesh) -> Option<&[i64]> {
    let fit = mesh
        .labels
        .iter()
        .all(|&label| i32::try_from(label).is_ok());
    (fit && !mesh.labels.is_empty()).then_some(&mesh.labels)
}

/// Writes numbers in text or in binary.
pub struct Sink {
    /// What has been written.
    pub bytes: Vec<u8>,
    encoding: Encoding,
}

impl Sink {
    /// Nothing written yet.
    pub fn new(encoding: Encoding) -> Self {
        Sink {
            bytes: Vec::new(),
            encoding,
        }
    }

    /// Text, in a binary file, too.
    pub fn text(&mut self, text: impl std::fmt::Display) {
        self.bytes.extend_from_slice(text.to_string().as_bytes());
    }

    /// Ends a line, in text.
    pub fn end(&mut self) {
        if self.encoding == Encoding::Text {
            match self.bytes.last_mut() {
                Some(last) if *last == b' ' => *last = b'\n',
                _ => self.bytes.push(b'\n'),
            }
        }
    }

    fn put<const N: usize>(&mut self, mut little: [u8; N]) {
        if self.encoding == Encoding::Big {
            little.reverse();
        }
        self.bytes.extend_from_slice(&little);
    }

    /// An integer of 32 bits; larger ones do not occur.
    pub fn int(&mut self, value: i64) {
        match self.encoding {
            Encoding::Text => self.decimal(value),
            _ => self.put((value as i32).to_le_bytes()),
        }
    }

    /// An integer of 64 bits.
    pub fn long(&mut self, value: i64) {
        match self.encoding {
            Encoding::Text => self.decimal(value),
            _ => self.put(value.to_le_bytes()),
        }
    }

    /// A double; in text the shortest decimal that is nearest to it.
    pub fn double(&mut self, value: f64) {
        match self.encoding {
            Encoding::Text => {
                self.text(Shortest(value));
                self.bytes.push(b' ');
            }
            _ => self.put(value.to_le_bytes()),
        }
    }

    fn decimal(&mut self, value: i64) {
        let mut digits = [0u8; 20];
        let mut at = digits.len();
        let mut rest = value.unsigned_abs();
        loop {
            at -= 1;
            digits[at] = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        if value < 0 {
            self.bytes.push(b'-');
        }
        self.bytes.extend_from_slice(&digits[at..]);
        self.bytes.push(b' ');
    }

    /// Coordinates of a point.
    pub fn point(&mut self, point: &[f64; 3]) {
        point.iter().for_each(|&x| self.double(x));
    }
}

/// The shortest decimal that is read as this double.
pub struct Shortest(pub f64);

impl std::fmt::Display for Shortest {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self.0.abs() {
            0.0 | 1e-5..1e16 => write!(f, "{}", self.0),
            _ => write!(f, "{:e}", self.0),
        }
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

/// The label of each tetrahedron, or `default` for all of them.
pub fn labels_or(mesh: &Mesh, default: i64) -> impl Iterator<Item = i64> {
    let labels = labels(mesh);
    (0..mesh.tetrahedra.len()).map(move |index| labels.map_or(default, |labels| labels[index]))
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
