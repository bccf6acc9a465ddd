//! Systems of patches against the Delaunay triangulations of single tilings.

use acutile_catalog::patches::{kagome_all, square_triangle_all};

#[test]
fn counts_of_pieces() {
    // 11 and 34 tetrahedra, and hexagons over 3 and 4 sides: 20 T + 46 Q = 11 T + 34 Q + 6 E.
    let system = square_triangle_all().unwrap();
    let sizes = |system: acutile_core::patches::System| -> Vec<(usize, Vec<usize>)> {
        let tiles = system.tiles.iter();
        tiles
            .map(|tile| {
                let polygons = tile.patch.pyramids.iter().map(|p| p.polygon.len());
                (tile.patch.simplices.len(), polygons.collect())
            })
            .collect()
    };
    assert_eq!(sizes(system), [(11, vec![6; 3]), (34, vec![6; 4])]);
    // Two hexagons in each layer: a block has 6 more.
    let system = kagome_all().unwrap();
    assert_eq!(
        sizes(system),
        [(34, vec![6; 2]), (28, vec![6; 2]), (28, vec![6; 2])]
    );
}
