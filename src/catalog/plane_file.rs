//! A square/triangle tiling by name or from a file (docs/format.md, the plane-tiling file).

use super::CatalogError;
use super::plane_tiling::{Cyclotomic, PlaneTiling, named};
use crate::import::{read_text, without_comments};
use serde::Deserialize;
use std::path::Path;

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

/// The tiling that is built in under this name, else the one of this file; whether it is
/// a tiling is not looked at.
///
/// # Errors
/// Where the file cannot be read, in words.
pub fn plane_tiling(name: &str) -> Result<PlaneTiling, CatalogError> {
    if let Some(plane) = named(name) {
        return Ok(plane);
    }
    if name.is_empty() {
        return Err(CatalogError::File(
            "expected a plane-tiling file after the colon, or a name like 3464".to_owned(),
        ));
    }
    if !Path::new(name).exists() && !name.contains(['/', '.']) {
        return Err(CatalogError::File(format!(
            "{name} is neither a file nor built in; built in are 3, 4, 33344, 32434, 3464 and \
             inflated-NAME of these"
        )));
    }
    read_text(Path::new(name))
        .map_err(|error| error.to_string())
        .and_then(|text| parse(&text))
        .map_err(CatalogError::File)
}

/// Reads the text of a file.
fn parse(text: &str) -> Result<PlaneTiling, String> {
    let document: Document =
        serde_json::from_str(&without_comments(text)).map_err(|error| error.to_string())?;
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
