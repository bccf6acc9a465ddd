//! What `show` says of theorems about all members of a construction.

use acutile_catalog::Theorem as Entry;
use acutile_core::format::patches;
use acutile_core::limits::own_limits;
use acutile_core::patches::{in_words, prove};
use serde_json::{Value, json};

/// What is shown, in words and as data.
pub struct Shown {
    pub lines: Vec<String>,
    pub data: Value,
}

/// The subject of a theorem of the catalogue: its tiles with their patches.
///
/// # Errors
/// A message that names the theorem.
pub fn of_entry(entry: &Entry) -> Result<Shown, String> {
    let system = (entry.system)().map_err(|error| format!("{}: {error}", entry.name))?;
    let theorem = prove(&system, &own_limits()).map_err(|error| error.to_string())?;
    let mut shown = of_certificate(entry.name, theorem.certificate())?;
    let title = format!("{}: {}", entry.name, entry.description);
    // The kernel has confirmed it.
    if let Some(claim) = shown.lines.first_mut() {
        *claim = claim.replacen(UNJUDGED, "a theorem: ", 1);
    }
    shown.lines.insert(0, title);
    Ok(shown)
}

/// The words before a claim that is not judged.
const UNJUDGED: &str = "claim, not verified here: ";

/// The content of a certificate of the kind `patches`, which is not judged here.
///
/// # Errors
/// If the bytes are none.
pub fn of_certificate(name: &str, cbor: &[u8]) -> Result<Shown, String> {
    let named = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let certificate = patches::certificate(cbor).map_err(|error| named(&error))?;
    let words = in_words(&certificate.claim).map_err(|error| named(&error))?;
    let mut lines = vec![format!("{UNJUDGED}{words}")];
    let mut data = Vec::new();
    let tiles = certificate.claim.tiles.iter().zip(&certificate.witness);
    for (number, (tile, patch)) in tiles.enumerate() {
        let polygons: Vec<usize> = patch.pyramids.iter().map(|p| p.polygon.len()).collect();
        let corners: Vec<String> = polygons.iter().map(ToString::to_string).collect();
        lines.push(format!(
            "tile {number}: {} sides; {} tetrahedra, {} vertices, pyramids over polygons with {} corners",
            tile.classes.len(),
            patch.simplices.len(),
            patch.vertices.len(),
            corners.join(", ")
        ));
        data.push(json!({
            "sides": tile.classes.len(),
            "simplices": patch.simplices.len(),
            "vertices": patch.vertices.len(),
            "polygons": polygons,
        }));
    }
    Ok(Shown {
        lines,
        data: json!({ "theorem": words, "tiles": data }),
    })
}
