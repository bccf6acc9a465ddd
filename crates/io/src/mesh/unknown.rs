//! Names of formats that are not read, by extension or first bytes, and the formats that are.

use std::path::Path;

/// The formats that are read, for messages.
pub const READ: &str = "acutile reads tiling, point-set and certificate files of its own; the meshes \
                        Gmsh .msh, VTK .vtk and .vtu, MEDIT .mesh and .meshb, TetGen and Triangle \
                        .node and .ele, Abaqus .inp, Nastran .bdf, .nas and .fem, MFEM .mesh; the \
                        crystal structures CIF, POSCAR, extended XYZ and pymatgen JSON; and STL and \
                        OBJ surfaces with certify --fills; meshio converts many other meshes (meshio \
                        convert IN OUT.vtu)";

/// Extensions of formats that are not read.
const EXTENSIONS: [(&str, &str); 47] = [
    ("xdmf", "XDMF"),
    ("xmf", "XDMF"),
    ("h5", "HDF5"),
    ("hdf5", "HDF5"),
    ("med", "Salome MED"),
    ("cgns", "CGNS"),
    ("e", "Exodus II"),
    ("ex2", "Exodus II"),
    ("exo", "Exodus II"),
    ("unv", "I-DEAS universal"),
    ("f3grid", "FLAC3D"),
    ("ply", "PLY"),
    ("off", "OFF"),
    ("su2", "SU2"),
    ("ugrid", "AFLR3 UGRID"),
    ("vol", "Netgen"),
    ("avs", "AVS-UCD"),
    ("pvtu", "parallel VTU (read its pieces)"),
    ("pvd", "ParaView collection (read its pieces)"),
    ("vtp", "VTK polygonal data"),
    ("vts", "VTK structured grid"),
    ("vtr", "VTK rectilinear grid"),
    ("vti", "VTK image"),
    ("vtm", "VTK multiblock (read its pieces)"),
    ("stp", "STEP"),
    ("step", "STEP"),
    ("igs", "IGES"),
    ("iges", "IGES"),
    ("brep", "Open CASCADE BRep"),
    ("geo", "Gmsh geometry (gmsh -3 makes a mesh of it)"),
    ("pos", "Gmsh post-processing view"),
    ("cas", "Fluent case"),
    ("k", "LS-DYNA keyword"),
    ("key", "LS-DYNA keyword"),
    ("cdb", "Ansys CDB"),
    ("neu", "neutral (Netgen or Gambit)"),
    ("tec", "Tecplot"),
    ("poly", "TetGen input (tetgen makes a mesh of it)"),
    ("smesh", "TetGen input (tetgen makes a mesh of it)"),
    ("mphtxt", "COMSOL"),
    ("mdpa", "Kratos model part"),
    ("ply2", "PLY2"),
    ("wkt", "well-known text"),
    ("traj", "ASE trajectory"),
    ("rad", "Radioss"),
    ("wrl", "VRML"),
    ("x3d", "X3D"),
];

/// First bytes of formats that are not read.
const STARTS: [(&[u8], &str); 38] = [
    (
        b"\x89HDF\r\n\x1a\n",
        "HDF5 (XDMF, MED, CGNS or Exodus data)",
    ),
    (b"CDF\x01", "netCDF (perhaps Exodus II)"),
    (b"CDF\x02", "netCDF (perhaps Exodus II)"),
    (b"<Xdmf", "XDMF"),
    (b"<dolfin", "DOLFIN XML"),
    (b"ply\n", "PLY"),
    (b"ply\r\n", "PLY"),
    (b"OFF", "OFF"),
    (b"NDIME=", "SU2"),
    (b"mesh3d", "Netgen"),
    (b"ISO-10303-21", "STEP"),
    (b"View \"", "Gmsh post-processing view"),
    (b"*KEYWORD", "LS-DYNA keyword"),
    (b"(0 \"", "Fluent mesh"),
    (b"(1 \"", "Fluent mesh"),
    (b"(2 ", "Fluent mesh"),
    (b"(10 (", "Fluent mesh"),
    (b"- of Ulm", "ASE trajectory"),
    (b"#RADIOSS", "Radioss"),
    (b"Begin ModelPartData", "Kratos model part"),
    (b"!PERMAS", "PERMAS"),
    (b"TITLE = \"", "Tecplot"),
    (b"/COM,ANSYS", "Ansys CDB"),
    (
        b"solid ",
        "STL surface (certify --fills compares it with a mesh)",
    ),
    (b"PK\x03\x04", "ZIP archive"),
    (
        b"\x1f\x8b",
        "gzip (the name has to end in .gz, and the file has to be compressed once)",
    ),
    (b"\xff\xfe", "text in UTF-16 (UTF-8 is read)"),
    (b"\xfe\xff", "text in UTF-16 (UTF-8 is read)"),
    (b"BZh", "bzip2 archive"),
    (b"\xfd7zXZ", "xz archive"),
    (b"%PDF", "PDF"),
    (b"\x89PNG", "PNG image"),
    (b"\xff\xd8\xff", "JPEG image"),
    (b"\x7fELF", "ELF, a program for Linux"),
    (b"MZ", "a program for Windows"),
    (b"\xcf\xfa\xed\xfe", "a program for macOS"),
    (b"SQLite format 3", "SQLite database"),
    (b"<!DOCTYPE html", "HTML page"),
];

/// The name of a format that is not read, if the file seems to be of one.
pub fn name(path: &Path, bytes: &[u8]) -> Option<&'static str> {
    let start = super::source::without_mark(bytes).trim_ascii_start();
    let by_bytes = STARTS.iter().find(|(mark, _)| start.starts_with(mark));
    if let Some((_, name)) = by_bytes {
        return Some(name);
    }
    if start.starts_with(b"{") {
        return of_json(start);
    }
    let file = path.file_name()?.to_str()?.to_ascii_lowercase();
    let file = file.strip_suffix(".gz").unwrap_or(&file);
    let extension = file.rsplit_once('.')?.1;
    match extension {
        "stl" | "obj" => Some("a surface (certify --fills compares it with a mesh)"),
        _ => EXTENSIONS
            .iter()
            .find(|(known, _)| *known == extension)
            .map(|(_, name)| *name),
    }
}

/// JSON of another program, by a member that this program always writes.
fn of_json(json: &[u8]) -> Option<&'static str> {
    const CIF: &str = "a CIF as JSON (the CIF itself is read, and gemmi json2cif writes one)";
    const MEMBERS: [(&str, &str); 3] = [
        (
            "\"__ase_objtype__\"",
            "JSON of ASE (ase convert IN OUT.xyz writes extended XYZ)",
        ),
        ("\"_atom_site", CIF),
        ("\"atom_site", CIF),
    ];
    let begin = String::from_utf8_lossy(&json[..json.len().min(1 << 16)]);
    // The project's own files and those of pymatgen are read, whatever they contain.
    if begin.contains("\"acutile-") || begin.contains("\"@class\"") {
        return None;
    }
    let found = MEMBERS.iter().find(|(member, _)| begin.contains(member));
    found.map(|(_, name)| *name)
}

/// The message about a file that is not read.
pub fn message(path: &Path, bytes: &[u8]) -> String {
    let start = super::source::without_mark(bytes).trim_ascii_start();
    let is_json = path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
    match (name(path, bytes), start.first()) {
        (Some(name), _) => format!("the format is not read: {name}; {READ}"),
        (None, Some(first)) if is_json && first.is_ascii_graphic() => format!(
            "begins with {:?}, expected an object in braces, like {{\"format\": \"acutile-tiling\", …}}; \
             acutile new writes examples",
            char::from(*first)
        ),
        (None, _) => format!("the format is not known; {READ}"),
    }
}
