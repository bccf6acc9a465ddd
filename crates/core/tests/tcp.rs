//! The walk around each edge, compared with the list of all edges.

use acutile_core::classify::{Ridges, check_tcp, six_valent};
use acutile_core::format;
use acutile_core::tiling::{AnyTiling, Tiling, match_facets};
use acutile_core::transcribe;

/// The tiling of a certificate of the repository.
fn tiling(name: &str) -> Tiling<3> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../certificates");
    let json = std::fs::read(format!("{folder}/{name}.json")).expect("a certificate");
    let cbor = format::to_cbor(&json).expect("canonical JSON");
    match transcribe::of_certificate(&cbor).expect("a tiling") {
        (AnyTiling::Space(tiling), _) => tiling,
        (AnyTiling::Plane(_), _) => panic!("{name} is in the plane"),
    }
}

/// The facets that meet in the edges 01, 02, 03, 12, 13 and 23: those opposite to the other corners.
const FACETS: [(usize, usize); 6] = [(2, 3), (1, 3), (1, 2), (0, 3), (0, 2), (0, 1)];

#[test]
fn the_edges_of_valence_6_are_those_of_the_list_of_edges() {
    for name in ["a15", "z", "c15", "sigma", "mu"] {
        let tiling = tiling(name);
        let matching = match_facets(&tiling);
        let ridges = Ridges::of(&tiling, &matching);
        let found = six_valent(&tiling, &matching).expect("a TCP structure");
        assert_eq!(found.len(), tiling.len(), "{name}");
        for (simplex, bits) in tiling.indices().zip(found) {
            for (edge, (i, j)) in FACETS.into_iter().enumerate() {
                let valence = ridges.between(simplex, i, j).valence();
                assert_eq!(bits >> edge & 1 == 1, valence == 6, "{name}");
            }
        }
    }
}

#[test]
fn tilings_that_are_not_tcp() {
    for name in ["bcc", "cube-6", "sommerville-1"] {
        let tiling = tiling(name);
        let matching = match_facets(&tiling);
        let ridges = Ridges::of(&tiling, &matching);
        assert!(check_tcp(&tiling, &ridges).is_err(), "{name}");
        assert_eq!(six_valent(&tiling, &matching), None, "{name}");
    }
}
