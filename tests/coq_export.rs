//! `acutile export --coq`: what the theorem says, and what has none. That Coq proves it
//! is tested by proofs/certificates.sh.

#![cfg(feature = "prover")]

use acutile::certificate::{Certificate, Number};
use acutile::export::{NotATheorem, coq_theorem};
use std::path::Path;

fn valid(name: &str) -> Certificate {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/certificates/valid");
    let bytes = std::fs::read(folder.join(name)).unwrap();
    serde_json::from_slice(&bytes).unwrap()
}

#[test]
fn the_theorem_has_the_numbers_of_the_claim() {
    let text = coq_theorem(&valid("space-bcc.json")).unwrap();
    for part in [
        "Definition G : gram := Gram 3 3 3 (-1) (-1) (-1).",
        "face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 []) 6 (tetrahedra l1 l2 l3)",
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

#[test]
fn dimension_two_has_no_theorem() {
    let plane = valid("plane-square.json");
    assert_eq!(coq_theorem(&plane), Err(NotATheorem::Dimension(2)));
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
