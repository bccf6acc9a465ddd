//! The shape of a plane-tiling file (docs/format.md). Files are read elsewhere.

use super::CatalogError;
use super::plane_tiling::{Cyclotomic, PlaneTiling};
use serde::Deserialize;

/// The format of such a file.
pub const FORMAT: &str = "acutile-plane-tiling";

/// A plane-tiling file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneDocument {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u64,
    /// For editors; it has no meaning here.
    #[serde(rename = "$schema", default)]
    _schema: Option<String>,
    #[serde(default, rename = "name")]
    _name: Option<String>,
    lattice: [Cyclotomic; 2],
    vertices: Vec<Cyclotomic>,
}

/// Whether a document describes a tiling is checked later, where a structure is built over it.
impl TryFrom<PlaneDocument> for PlaneTiling {
    type Error = CatalogError;

    fn try_from(document: PlaneDocument) -> Result<Self, CatalogError> {
        if document.vertices.is_empty() {
            let problem = "vertices: found none, expected at least one";
            return Err(CatalogError::File(problem.to_owned()));
        }
        Ok(PlaneTiling {
            lattice: document.lattice,
            vertices: document.vertices,
        })
    }
}
