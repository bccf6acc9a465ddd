//! Writes VTU files.

use super::sink::{Sink, cell_arrays};
use super::source::Encoding;
use super::{Format, Mesh};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::Write;

/// The bytes before compression of a block.
const BLOCK: usize = 1 << 20;

/// A VTU file with one piece, arrays written as the format says.
pub fn vtu(mesh: &Mesh, format: Format) -> Vec<u8> {
    let mut file = File {
        format,
        xml: String::new(),
        appended: Vec::new(),
    };
    let compressor = match format {
        Format::Vtu => " compressor=\"vtkZLibDataCompressor\"",
        _ => "",
    };
    file.xml.push_str(&format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
         byte_order=\"LittleEndian\" header_type=\"UInt64\"{compressor}>\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
        mesh.points.len(),
        mesh.cell_count()
    ));
    let encoding = match format {
        Format::VtuText => Encoding::Text,
        _ => Encoding::Little,
    };
    let mut points = Sink::new(encoding);
    for point in &mesh.points {
        points.point(point);
        points.end();
    }
    file.array("Float64\" NumberOfComponents=\"3", "Points", &points.bytes);
    file.xml.push_str("</Points>\n<Cells>\n");
    let mut connectivity = Sink::new(encoding);
    for corners in mesh.cells() {
        corners
            .iter()
            .for_each(|&corner| connectivity.long(i64::from(corner)));
        connectivity.end();
    }
    file.array("Int64", "connectivity", &connectivity.bytes);
    let mut offsets = Sink::new(encoding);
    let width = mesh.dimension() as i64 + 1;
    for cell in 1..=mesh.cell_count() as i64 {
        offsets.long(width * cell);
    }
    offsets.end();
    file.array("Int64", "offsets", &offsets.bytes);
    let kind = if width == 3 { 5u8 } else { 10 };
    let mut types = vec![kind; mesh.cell_count()];
    if encoding == Encoding::Text {
        types = format!("{kind} ").repeat(mesh.cell_count()).into_bytes();
    }
    file.array("UInt8", "types", &types);
    file.xml.push_str("</Cells>\n");
    let arrays = cell_arrays(mesh);
    if !arrays.is_empty() {
        file.xml.push_str("<CellData>\n");
        for (name, values) in arrays {
            let mut sink = Sink::new(encoding);
            values.iter().for_each(|&value| sink.int(value));
            sink.end();
            file.array("Int32", name, &sink.bytes);
        }
        file.xml.push_str("</CellData>\n");
    }
    file.xml.push_str("</Piece>\n</UnstructuredGrid>\n");
    file.finish()
}

struct File {
    format: Format,
    xml: String,
    appended: Vec<u8>,
}

impl File {
    fn array(&mut self, kind: &str, name: &str, bytes: &[u8]) {
        let head = (bytes.len() as u64).to_le_bytes();
        let tag = format!("<DataArray type=\"{kind}\" Name=\"{name}\" format=");
        match self.format {
            Format::VtuText => {
                let text = String::from_utf8_lossy(bytes);
                self.xml
                    .push_str(&format!("{tag}\"ascii\">\n{text}\n</DataArray>\n"));
            }
            Format::VtuBase64 => {
                let text = STANDARD.encode([&head, bytes].concat());
                self.xml
                    .push_str(&format!("{tag}\"binary\">\n{text}\n</DataArray>\n"));
            }
            _ => {
                let offset = self.appended.len();
                self.xml
                    .push_str(&format!("{tag}\"appended\" offset=\"{offset}\"/>\n"));
                match self.format {
                    Format::VtuRaw => self.appended.extend([&head, bytes].concat()),
                    _ => self.appended.extend(compressed(bytes)),
                }
            }
        }
    }

    fn finish(self) -> Vec<u8> {
        let mut bytes = self.xml.into_bytes();
        if matches!(self.format, Format::VtuRaw | Format::Vtu) {
            bytes.extend_from_slice(b"<AppendedData encoding=\"raw\">\n_");
            bytes.extend(self.appended);
            bytes.extend_from_slice(b"\n</AppendedData>\n");
        }
        bytes.extend_from_slice(b"</VTKFile>\n");
        bytes
    }
}

/// The number of blocks, the size of a block and of the last one, the sizes after
/// compression, and the blocks.
fn compressed(bytes: &[u8]) -> Vec<u8> {
    let blocks: Vec<Vec<u8>> = bytes.chunks(BLOCK).map(deflated).collect();
    let mut head = vec![blocks.len(), BLOCK, bytes.len() % BLOCK];
    head.extend(blocks.iter().map(Vec::len));
    let head = head
        .iter()
        .flat_map(|&number| (number as u64).to_le_bytes());
    head.chain(blocks.iter().flatten().copied()).collect()
}

/// Writing to memory does not fail.
fn deflated(block: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    let _ = encoder.write_all(block);
    encoder.finish().unwrap_or_default()
}
