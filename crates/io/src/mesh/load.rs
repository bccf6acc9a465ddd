//! Meshes from files, with the limits of their bytes; and the two files of TetGen.

use super::{Family, Mesh, MeshError, tetgen, unknown};
use crate::import::{ImportError, is_gzip, read_bytes, uncompressed_name};
use std::path::{Path, PathBuf};

/// No mesh file may be longer: 1 GiB, and 512 MiB after decompression.
pub const BYTE_LIMIT: u64 = 1 << 30;
/// The largest size of a file after decompression, in bytes.
pub const UNPACKED_LIMIT: u64 = 1 << 29;

/// A mesh with the family of formats that it came from.
pub struct Loaded {
    /// The mesh.
    pub mesh: Mesh,
    /// The family.
    pub family: Family,
}

/// Reads the mesh of a file. For TetGen, `path` is either file, and the other is beside it.
///
/// # Errors
/// The message names the second file of TetGen, where it is about that.
pub fn load(path: &Path, family: Family) -> Result<Loaded, MeshError> {
    if family == Family::TetGen {
        let mesh = load_pair(path)?;
        return Ok(Loaded { mesh, family });
    }
    let mesh = family.read(&bytes(path)?)?;
    Ok(Loaded { mesh, family })
}

/// Reads a mesh whose family the extension tells, or the first bytes where they know better: `.mesh`
/// is an extension of MEDIT and of MFEM.
///
/// # Errors
/// As for [`load`].
pub fn load_by_name(path: &Path, family: Family) -> Result<Loaded, MeshError> {
    if family == Family::TetGen {
        return load(path, family);
    }
    let bytes = bytes(path)?;
    if bytes.trim_ascii().is_empty() {
        return Err(MeshError::of_file(ImportError::Empty.to_string()));
    }
    if let Some(family) = Family::of_content(&bytes) {
        let mesh = family.read(&bytes)?;
        return Ok(Loaded { mesh, family });
    }
    match (family, unknown::name(Path::new(""), &bytes)) {
        (_, Some(_)) => Err(MeshError::of_file(unknown::message(path, &bytes))),
        _ => Ok(Loaded {
            mesh: family.read(&bytes)?,
            family,
        }),
    }
}

/// The `.node` and `.ele` file to the name of either, `.gz` kept.
pub fn tetgen_paths(path: &Path) -> Option<(PathBuf, PathBuf)> {
    let plain = uncompressed_name(path);
    let extension = plain.extension()?;
    let (node, ele) = match extension.to_str()? {
        "node" | "ele" => ("node", "ele"),
        "NODE" | "ELE" => ("NODE", "ELE"),
        _ => return None,
    };
    let with = |extension: &str| {
        let mut file = plain.with_extension(extension).into_os_string();
        if let Some(packed) = path.extension().filter(|_| is_gzip(path)) {
            file.push(".");
            file.push(packed);
        }
        PathBuf::from(file)
    };
    Some((with(node), with(ele)))
}

fn load_pair(path: &Path) -> Result<Mesh, MeshError> {
    let (nodes, elements) = tetgen_paths(path).ok_or_else(|| {
        MeshError::of_file("a TetGen mesh has a name that ends in .node or .ele, with .gz or not")
    })?;
    // The caller names the file that the user gave.
    let named = |file: &Path, error: MeshError| {
        if file == path {
            error
        } else {
            MeshError {
                problem: format!("{}: {error}", file.display()),
                place: super::Place::File,
                ..error
            }
        }
    };
    let read = |file: &Path| {
        bytes(file).map_err(|error| {
            if file == path {
                error
            } else {
                MeshError {
                    problem: format!("its partner {}: {error}", file.display()),
                    ..error
                }
            }
        })
    };
    let (nodes_bytes, elements_bytes) = (read(&nodes)?, read(&elements)?);
    let (draft, index) = tetgen::read_nodes(&nodes_bytes).map_err(|error| named(&nodes, error))?;
    tetgen::read_elements(&elements_bytes, draft, &index).map_err(|error| named(&elements, error))
}

/// The bytes of a file, unpacked where its name ends in `.gz`.
pub fn bytes(path: &Path) -> Result<Vec<u8>, MeshError> {
    let is_packed = path.extension().is_some_and(|extension| extension == "gz");
    let limit = if is_packed {
        UNPACKED_LIMIT
    } else {
        BYTE_LIMIT
    };
    read_bytes(path, limit).map_err(|error| {
        if error.is_limit() {
            MeshError::limit(error.to_string())
        } else {
            MeshError::of_file(error.to_string())
        }
    })
}
