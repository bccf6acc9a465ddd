//! The text of a plane-tiling file (docs/format.md). Files are read elsewhere.

use super::CatalogError;
use super::plane_tiling::{Cyclotomic, PlaneTiling};
use serde::Deserialize;

const FORMAT: &str = "acutile-plane-tiling";

/// A plane-tiling file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    format: String,
    version: u64,
    #[serde(default, rename = "name")]
    _name: Option<String>,
    lattice: [Cyclotomic; 2],
    vertices: Vec<Cyclotomic>,
}

/// Reads the text of a plane-tiling file, without comment lines. Whether it describes a tiling
/// is checked later, where a structure is built over it.
///
/// # Errors
/// The text is no plane-tiling file.
pub fn parse(text: &str) -> Result<PlaneTiling, CatalogError> {
    document(text).map_err(CatalogError::File)
}

fn document(text: &str) -> Result<PlaneTiling, String> {
    let document: Document = serde_json::from_str(text).map_err(|error| error.to_string())?;
    if document.format != FORMAT || document.version != 1 {
        return Err(format!(
            "found {:?}, version {}, expected {FORMAT:?}, version 1",
            document.format, document.version
        ));
    }
    if document.vertices.is_empty() {
        return Err("found no vertices".to_owned());
    }
    Ok(PlaneTiling {
        lattice: document.lattice,
        vertices: document.vertices,
    })
}
