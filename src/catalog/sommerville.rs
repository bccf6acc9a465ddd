//! Tilings by congruent tetrahedra (paper, section 2.2).

use super::CatalogError;
use super::points::delaunay;
use crate::tiling::AnyTiling;

/// One point of the body-centred cubic lattice with the basis (-1,1,1), (1,-1,1),
/// (1,1,-1).
pub fn bcc() -> Result<AnyTiling, CatalogError> {
    let gram = [["3", "-1", "-1"], ["-1", "3", "-1"], ["-1", "-1", "3"]];
    Ok(AnyTiling::Space(delaunay(gram, &[["0", "0", "0"]])?))
}
