//! `acutile export --coq`: what the theorem says, and what has none. That Coq proves it
//! is tested by proofs/certificates.sh.

use acutile_format1::certificate::{Certificate, Domain, Number};
use acutile_io::export::{NotATheorem, coq_theorem};
use std::path::Path;

fn valid(name: &str) -> Certificate {
    let folder =
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/certificates/valid");
    let bytes = std::fs::read(folder.join(name)).unwrap();
    serde_json::from_slice(&bytes).unwrap()
}

#[test]
fn the_theorem_has_the_numbers_of_the_claim() {
    let text = coq_theorem(&valid("space-bcc.json")).unwrap();
    for part in [
        "Definition G : gram := Gram 3 3 3 (-1) (-1) (-1).",
        "face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 W) 6 (tetrahedra l1 l2 l3)",
        "nonobtuse l1 l2 l3 3 6 (tetrahedra l1 l2 l3)",
        "dihedral_below l1 l2 l3 3 6 (tetrahedra l1 l2 l3) (181 / 2)",
        "delaunay l1 l2 l3 3 6 (tetrahedra l1 l2 l3)",
        "weakly_delaunay l1 l2 l3 3 6 (tetrahedra l1 l2 l3)",
    ] {
        assert!(text.contains(part), "{part}");
    }
    assert!(!text.contains(" acute l1"));
    assert!(text.ends_with("Qed.\nPrint Assumptions claim.\n"));
}

/// The statements and the domain are those of the claim, whatever they are.
#[test]
fn a_solid_has_its_vertices_in_the_theorem() {
    let text = coq_theorem(&valid("solid-tetrahedron.json")).unwrap();
    for part in [
        "Definition W : list point := [Point 0 0 0; Point 1 0 0; Point 0 1 0; Point 0 0 1].",
        "face_to_face_tiling l1 l2 l3 0 (domain l1 l2 l3 0 W) 1 (tetrahedra l1 l2 l3)",
        " None None None None",
    ] {
        assert!(text.contains(part), "{part}");
    }
}

#[test]
fn the_plane_has_its_own_words() {
    let text = coq_theorem(&valid("plane-square.json")).unwrap();
    for part in [
        "Definition G : gram2 := Gram2 1 1 0.",
        "edge_to_edge_tiling l1 l2 2 (domain2 l1 l2 2 W) 2 (triangles l1 l2)",
        "nonobtuse2 l1 l2 2 2 (triangles l1 l2)",
        "weakly_delaunay2 l1 l2 2 2 (triangles l1 l2)",
        "destruct (z_theorem2 c statements checked)",
    ] {
        assert!(text.contains(part), "{part}");
    }
}

/// (0,0), (1,0), (0,1) of docs/format.md, and (1,0), (1,1), (0,1): ascending by shift, the
/// first by an odd permutation, the second by an even one, (0,1), (1,0), (1,1).
#[test]
fn triangles_of_the_plane_have_ascending_corners() {
    let text = coq_theorem(&valid("plane-equilateral-acute.json")).unwrap();
    for part in [
        "CTri (0%N,(0,0)) (0%N,(0,1)) (0%N,(1,0)) (Some (1%N,2%N,(0,0)))",
        "CTri (0%N,(0,1)) (0%N,(1,0)) (0%N,(1,1))",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

#[test]
fn other_dimensions_have_no_theorem() {
    let mut bad = valid("space-bcc.json");
    bad.claim.dimension = 4;
    assert_eq!(coq_theorem(&bad), Err(NotATheorem::Dimension(4)));
}

#[test]
fn a_region_has_no_theorem() {
    let mut region = valid("solid-tetrahedron.json");
    region.claim.domain = Domain::Region;
    assert_eq!(coq_theorem(&region), Err(NotATheorem::Region));
}

#[test]
fn bad_numbers_and_lengths_are_errors() {
    let good = valid("space-bcc.json");
    for text in ["1/0", "x", "", "1/", "0/00"] {
        let mut bad = good.clone();
        bad.witness.vertices[0][0] = Number(vec![text.to_owned()]);
        assert!(
            matches!(coq_theorem(&bad), Err(NotATheorem::Malformed(_))),
            "{text:?}"
        );
    }
    let cuts: [fn(&mut Certificate); 5] = [
        |c| c.claim.gram.truncate(2),
        |c| c.claim.gram[1].truncate(1),
        |c| c.witness.mates.truncate(5),
        |c| c.witness.simplices[0].truncate(3),
        |c| c.witness.simplices[0][0].0.truncate(2),
    ];
    for cut in cuts {
        let mut bad = good.clone();
        cut(&mut bad);
        assert!(matches!(coq_theorem(&bad), Err(NotATheorem::Malformed(_))));
    }
}
