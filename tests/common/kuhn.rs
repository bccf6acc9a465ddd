//! The Kuhn cube, a tiling file written by hand.

use serde_json::{Value, json};

/// The cube [0, 1]^3 cut into the six tetrahedra of the paths from (0,0,0) to
/// (1,1,1) along edges, one for each order of the axes (Kuhn). One vertex.
/// Written by hand: the shifts along the path x, y, z are 000, 100, 110, 111;
/// odd orders have two corners exchanged.
pub fn kuhn() -> Value {
    json!({
        "format": "acutile-tiling",
        "version": 1,
        "dimension": 3,
        "lattice": { "gram": [[1, 0, 0], [0, 1, 0], [0, 0, 1]] },
        "vertices": [[0, 0, 0]],
        "simplices": [
            [0, [0, 1, 0, 0], [0, 1, 1, 0], [0, 1, 1, 1]],
            [0, [0, 0, 1, 0], [0, 0, 1, 1], [0, 1, 1, 1]],
            [0, [0, 0, 0, 1], [0, 1, 0, 1], [0, 1, 1, 1]],
            [0, [0, 1, 0, 0], [0, 1, 1, 1], [0, 1, 0, 1]],
            [0, [0, 0, 1, 0], [0, 1, 1, 1], [0, 1, 1, 0]],
            [0, [0, 0, 0, 1], [0, 1, 1, 1], [0, 0, 1, 1]],
        ],
    })
}
