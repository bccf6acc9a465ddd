//! A region keeps its boundary.

use crate::periodic::catalogue;
use acutile_core::tiling::{Domain, Polytope, Tiling};
use acutile_exact::number::Number;
use acutile_optimize::{Keep, Options, optimize};

/// Six times the volume.
fn volume(tiling: &Tiling<3>) -> Number {
    let volumes = tiling.indices().map(|s| tiling.shape(s).determinant);
    volumes.fold(Number::zero(), |sum, volume| sum + volume)
}

/// For each face the vertices in its plane.
fn in_faces(tiling: &Tiling<3>, solid: &Polytope) -> Vec<Vec<usize>> {
    let planes = (0..solid.faces.len()).map(|face| solid.plane(face).expect("a plane"));
    let in_plane = |plane: acutile_core::tiling::Plane| {
        let points = tiling.vertices.iter().enumerate();
        let inside = points.filter(|(_, point)| plane.value(point).is_zero());
        inside.map(|(vertex, _)| vertex).collect()
    };
    planes.map(in_plane).collect()
}

/// The regular tetrahedron as a bounded mesh.
#[test]
fn the_boundary_of_a_region_stays() {
    let mut tiling = catalogue("tetrahedron-543");
    let solid = tiling.frame.domain.polytope().expect("a solid").clone();
    tiling.frame.domain = Domain::Region(0);
    let options = Options {
        keep: Keep::Lattice,
        steps: 2,
        ..Options::default()
    };
    let outcome = optimize(&tiling, &options, &mut |_| true).expect("a start");
    assert!(outcome.is_better);
    assert_ne!(outcome.tiling.vertices, tiling.vertices);
    assert_eq!(volume(&outcome.tiling), volume(&tiling));
    assert_eq!(in_faces(&outcome.tiling, &solid), in_faces(&tiling, &solid));
}
