//! The formats: names, file extensions, and how a file without one is recognised.

use super::MeshError;
use crate::import::uncompressed_name;
use std::path::Path;

/// Formats that one reader reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Gmsh MSH 1, 2, 4.0 and 4.1.
    Msh,
    /// VTK legacy.
    Vtk,
    /// VTK XML, unstructured grid.
    Vtu,
    /// MEDIT, text.
    Medit,
    /// MEDIT, binary.
    Meditb,
    /// TetGen, two files.
    TetGen,
    /// Abaqus input, read only.
    Abaqus,
    /// Nastran bulk data, read only.
    Nastran,
    /// MFEM, read only.
    Mfem,
}

/// How a mesh is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// MSH 2.2 in text.
    Msh2,
    /// MSH 2.2 in binary.
    Msh2Binary,
    /// MSH 4.1 in text.
    Msh4,
    /// MSH 4.1 in binary.
    Msh4Binary,
    /// VTK legacy in text.
    Vtk,
    /// VTK legacy in binary.
    VtkBinary,
    /// VTU with arrays in text.
    VtuText,
    /// VTU with arrays in base64, in their places.
    VtuBase64,
    /// VTU with raw arrays at the end.
    VtuRaw,
    /// VTU with arrays at the end, compressed with zlib.
    Vtu,
    /// MEDIT in text.
    Medit,
    /// MEDIT in binary.
    Meditb,
    /// TetGen's `.node` and `.ele`.
    TetGen,
}

/// Every format with its name on the command line.
pub const NAMES: [(&str, Format); 13] = [
    ("msh2", Format::Msh2),
    ("msh2-binary", Format::Msh2Binary),
    ("msh4", Format::Msh4),
    ("msh4-binary", Format::Msh4Binary),
    ("vtk", Format::Vtk),
    ("vtk-binary", Format::VtkBinary),
    ("vtu-text", Format::VtuText),
    ("vtu-base64", Format::VtuBase64),
    ("vtu-raw", Format::VtuRaw),
    ("vtu", Format::Vtu),
    ("medit", Format::Medit),
    ("meshb", Format::Meditb),
    ("tetgen", Format::TetGen),
];

impl Format {
    /// The format with this name.
    ///
    /// # Errors
    /// Lists the names.
    pub fn parse(name: &str) -> Result<Format, String> {
        let found = NAMES.iter().find(|(known, _)| *known == name);
        found.map(|(_, format)| *format).ok_or_else(|| {
            let names = NAMES.map(|(name, _)| name).join(", ");
            format!("expected one of {names}")
        })
    }

    /// Which reader reads it.
    pub fn family(self) -> Family {
        match self {
            Format::Msh2 | Format::Msh2Binary | Format::Msh4 | Format::Msh4Binary => Family::Msh,
            Format::Vtk | Format::VtkBinary => Family::Vtk,
            Format::VtuText | Format::VtuBase64 | Format::VtuRaw | Format::Vtu => Family::Vtu,
            Format::Medit => Family::Medit,
            Format::Meditb => Family::Meditb,
            Format::TetGen => Family::TetGen,
        }
    }
}

impl Family {
    /// By the extension, `.gz` left aside.
    pub fn of_path(path: &Path) -> Option<Family> {
        let name = uncompressed_name(path);
        let extension = name.extension()?.to_str()?.to_ascii_lowercase();
        Some(match extension.as_str() {
            "msh" => Family::Msh,
            "vtk" => Family::Vtk,
            "vtu" => Family::Vtu,
            "mesh" => Family::Medit,
            "meshb" => Family::Meditb,
            "node" | "ele" => Family::TetGen,
            "inp" => Family::Abaqus,
            "bdf" | "nas" | "fem" => Family::Nastran,
            _ => return None,
        })
    }

    /// By the first bytes, after a byte order mark.
    pub fn of_content(bytes: &[u8]) -> Option<Family> {
        let start = super::source::without_mark(bytes).trim_ascii_start();
        let begins = |mark: &str| {
            let head = start.get(..mark.len());
            head.is_some_and(|head| head.eq_ignore_ascii_case(mark.as_bytes()))
        };
        // Sections may stand before the one that names the format.
        let has_section = |mark: &[u8]| {
            let head = &start[..start.len().min(1 << 16)];
            begins("$") && head.windows(mark.len()).any(|window| window == mark)
        };
        match bytes {
            _ if begins("$NOD") || has_section(b"$MeshFormat") => Some(Family::Msh),
            _ if begins("# vtk DataFile") => Some(Family::Vtk),
            _ if begins("<VTKFile") => Some(Family::Vtu),
            _ if begins("<?xml") && has_tag(start, b"<VTKFile") => Some(Family::Vtu),
            _ if begins("MeshVersionFormatted") => Some(Family::Medit),
            _ if begins("MFEM ") => Some(Family::Mfem),
            _ if begins("*HEADING") || begins("*NODE") => Some(Family::Abaqus),
            _ if begins("BEGIN BULK") => Some(Family::Nastran),
            [1, 0, 0, 0, 1..=4, 0, 0, 0, ..] | [0, 0, 0, 1, 0, 0, 0, 1..=4, ..] => {
                Some(Family::Meditb)
            }
            _ => None,
        }
    }

    /// In which a mesh is written if nothing else is said.
    pub fn format(self) -> Format {
        match self {
            Family::Msh => Format::Msh4,
            Family::Vtk => Format::VtkBinary,
            Family::Vtu => Format::Vtu,
            Family::Medit => Format::Medit,
            Family::Meditb => Format::Meditb,
            Family::TetGen => Format::TetGen,
            Family::Abaqus | Family::Nastran | Family::Mfem => Format::Msh4,
        }
    }

    /// Whether meshes of this family are written.
    pub fn is_written(self) -> bool {
        !matches!(self, Family::Abaqus | Family::Nastran | Family::Mfem)
    }

    /// The family with this name on the command line, of a format that is read only.
    pub fn parse(name: &str) -> Result<Family, String> {
        match name {
            "abaqus" => Ok(Family::Abaqus),
            "nastran" => Ok(Family::Nastran),
            "mfem" => Ok(Family::Mfem),
            "msh" => Ok(Family::Msh),
            _ => Format::parse(name).map(Format::family).map_err(|_| {
                "expected one of msh, vtk, vtu, medit, meshb, tetgen, abaqus, nastran, mfem"
                    .to_owned()
            }),
        }
    }

    /// Reads a mesh of this family from the bytes of its file; TetGen has two files, see
    /// [`super::load()`].
    ///
    /// # Errors
    /// With the line or byte, what was expected and what was found.
    pub fn read(self, bytes: &[u8]) -> Result<super::Mesh, MeshError> {
        match self {
            Family::Msh => super::msh::read(bytes),
            Family::Vtk => super::vtk::read(bytes),
            Family::Vtu => super::vtu::read(bytes),
            Family::Medit => super::medit::read_text(bytes),
            Family::Meditb => super::medit::read_binary(bytes),
            Family::Abaqus => super::abaqus::read(bytes),
            Family::Nastran => super::nastran::read(bytes),
            Family::Mfem => super::mfem::read(bytes),
            Family::TetGen => Err(MeshError::of_file(
                "TetGen has two files, NAME.node and NAME.ele, expected the name of one of them",
            )),
        }
    }
}

/// Whether a tag stands near the beginning of XML.
fn has_tag(xml: &[u8], tag: &[u8]) -> bool {
    let head = &xml[..xml.len().min(1 << 16)];
    head.windows(tag.len()).any(|window| window == tag)
}
