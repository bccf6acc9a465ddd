//! `acutile export --coq`: the words of the theorem, and certificates that have none.
//! proofs/certificates.sh tests that Coq proves the theorems.

use acutile_core::format::{self, Certificate, Corner, Domain, Number, Statement};
use acutile_io::export::{NotATheorem, coq_theorem};
use std::path::Path;

fn valid(name: &str) -> Certificate {
    let folder =
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/certificates/valid");
    let bytes = std::fs::read(folder.join(name)).unwrap();
    format::read::certificate(&format::to_cbor(&bytes).unwrap()).unwrap()
}

fn check_parts(name: &str, parts: &[&str]) {
    let text = coq_theorem(&valid(name)).unwrap();
    for part in parts {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

#[test]
fn the_theorem_has_the_numbers_of_the_claim() {
    check_parts(
        "space-bcc.json",
        &[
            "Definition G : gram := Gram 3 3 3 (-1) (-1) (-1).",
            "face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 3 W) 6 (tetrahedra l1 l2 l3)",
            "nonobtuse l1 l2 l3 3 6 (tetrahedra l1 l2 l3)",
            "largest_dihedral_angle l1 l2 l3 3 6 (tetrahedra l1 l2 l3) Maximum (acos (0 * sqrt (0 / 1)))",
            "smallest_dihedral_angle l1 l2 l3 3 6 (tetrahedra l1 l2 l3) Minimum (acos (1 * sqrt (1 / 4)))",
            "squared_radius_edge_ratio l1 l2 l3 3 6 (tetrahedra l1 l2 l3) Maximum (5 / 12)",
            "delaunay l1 l2 l3 3 6 (tetrahedra l1 l2 l3)",
            "weakly_delaunay l1 l2 l3 3 6 (tetrahedra l1 l2 l3)",
        ],
    );
    let text = coq_theorem(&valid("space-bcc.json")).unwrap();
    assert!(!text.contains(" acute l1"));
    assert!(text.ends_with("Qed.\nPrint Assumptions claim.\n"));
}

/// The statements and the domain are those of the claim, whatever they are.
#[test]
fn a_solid_has_its_vertices_in_the_theorem() {
    check_parts(
        "solid-tetrahedron.json",
        &[
            "Definition W : list point := [Point 0 0 0; Point 1 0 0; Point 0 1 0; Point 0 0 1].",
            "face_to_face_tiling l1 l2 l3 0 (domain l1 l2 l3 0 W) 1 (tetrahedra l1 l2 l3)",
            " None None None None",
        ],
    );
}

/// The theorem gives the vertices of the polytope in lowest terms. For the checker they stand
/// over the denominator of the tiling's vertices.
#[test]
fn a_polytope_has_its_own_denominator() {
    let mut certificate = valid("solid-tetrahedron.json");
    certificate.witness.denominator = 6.into();
    let Domain::Solid(polytope) = &mut certificate.claim.domain else {
        panic!("a solid")
    };
    polytope.denominator = 2.into();
    polytope.vertices[1][0] = Number(vec![4.into()]);
    let text = coq_theorem(&certificate).unwrap();
    let claimed = "[Point 0 0 0; Point 2 0 0; Point 0 (1 / 2) 0; Point 0 0 (1 / 2)]";
    assert!(text.contains(claimed), "{text}");
    let checked = "[V3 _ 0 0 0; V3 _ 12 0 0; V3 _ 0 3 0; V3 _ 0 0 3]";
    assert!(text.contains(checked), "{text}");
}

#[test]
fn the_plane_has_its_own_words() {
    check_parts(
        "plane-square.json",
        &[
            "Definition G : gram2 := Gram2 1 1 0.",
            "edge_to_edge_tiling l1 l2 2 (domain2 l1 l2 2 W) 2 (triangles l1 l2)",
            "nonobtuse2 l1 l2 2 2 (triangles l1 l2)",
            "largest_angle2 l1 l2 2 2 (triangles l1 l2) Minimum (acos (0 * sqrt (0 / 1)))",
            "weakly_delaunay2 l1 l2 2 2 (triangles l1 l2)",
            "destruct (z_theorem2 c statements checked)",
        ],
    );
}

/// All six relations of each quantity, over Q(√3); bounds of zero, negative ones, in the field.
#[test]
fn every_relation_has_its_word() {
    let of = "l1 l2 2 4 (triangles a l1 l2)";
    check_parts(
        "plane-every-relation.json",
        &[
            "Definition p (x : R) : R := ((-3) + x * (0 + x * 1)).",
            "p a = 0 /\\ 1 <= a <= 2 /\\ (forall x, p x = 0 -> 1 <= x <= 2 -> x = a)",
            "Definition G (a : R) : gram2 := Gram2 2 (4 + a * 2) 1.",
            "CSmallestDihedralAngle _ LessThan 1 [2;(-1)] 4",
            &format!("largest_angle2 {of} LessThan (acos ((-1) * sqrt (1 / 4)))"),
            &format!("largest_angle2 {of} AtMost (acos (0 * sqrt (0 / 1)))"),
            &format!("largest_angle2 {of} AtLeast (acos (1 * sqrt (1 / 4)))"),
            &format!("smallest_angle2 {of} LessThan (acos (1 * sqrt ((2 + a * (-1)) / 4)))"),
            &format!("smallest_angle2 {of} MoreThan (acos (1 * sqrt (3 / 4)))"),
            &format!("squared_radius_edge_ratio2 {of} Minimum (1 / 3)"),
        ],
    );
}

/// The rows are (0,0), (1,0), (0,1) and (0,0), (1,-1), (1,0). The first is sorted by an odd
/// permutation, the second by an even one. The edge (0,0)-(1,0) is opposite to the corner (0,1)
/// of the first triangle, its second one in order, and to (1,-1) of the other, also the second.
#[test]
fn triangles_of_the_plane_have_ascending_corners() {
    check_parts(
        "plane-equilateral-acute.json",
        &[
            "CTri (0%N,(0,0)) (0%N,(0,1)) (0%N,(1,0)) (Some (1%N,2%N,(0,1))) (Some (1%N,1%N,(0,0))) (Some (1%N,0%N,(-1,1))) false",
            "CTri (0%N,(0,0)) (0%N,(1,-1)) (0%N,(1,0))",
        ],
    );
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
    region.claim.domain = Domain::Region(0);
    assert_eq!(coq_theorem(&region), Err(NotATheorem::Region));
}

#[test]
fn data_of_a_wrong_shape_are_errors() {
    let cuts: [fn(&mut Certificate); 10] = [
        |c| c.claim.gram.truncate(2),
        |c| c.claim.gram[1].truncate(1),
        |c| c.claim.statements.clear(),
        |c| c.claim.statements.push(Statement::FaceToFaceTiling),
        |c| c.claim.statements.push(Statement::LocallyDelaunay),
        |c| c.witness.simplices.truncate(23),
        |c| c.witness.vertices[0].truncate(2),
        |c| c.witness.vertices[0][0] = Number(Vec::new()),
        |c| c.witness.vertices[0][0] = Number(vec![1.into(), 1.into()]),
        |c| {
            let Statement::SquaredRatio(_, fraction) = &mut c.claim.statements[4] else {
                panic!("a ratio")
            };
            fraction.denominator = 0.into();
        },
    ];
    for (k, cut) in cuts.into_iter().enumerate() {
        let mut bad = valid("space-bcc.json");
        cut(&mut bad);
        let result = coq_theorem(&bad);
        assert!(
            matches!(result, Err(NotATheorem::Malformed(_))),
            "{k}: {result:?}"
        );
    }
    let mut bad = valid("solid-tetrahedron.json");
    bad.witness.denominator = 3.into();
    let Domain::Solid(polytope) = &mut bad.claim.domain else {
        panic!("a solid")
    };
    polytope.denominator = 2.into();
    assert!(matches!(coq_theorem(&bad), Err(NotATheorem::Malformed(_))));
}

/// A facet that occurs three times: the third one is open again.
#[test]
fn a_third_facet_has_no_mate() {
    let mut twice = valid("solid-tetrahedron.json");
    let corner = |vertex| Corner {
        vertex,
        shift: [0; 3],
    };
    for _ in 0..2 {
        twice.witness.simplices.extend([0, 1, 2, 3].map(corner));
    }
    let text = coq_theorem(&twice).unwrap();
    assert_eq!(text.matches("(Some (1%N,0%N,(0,0,0)))").count(), 1);
    assert_eq!(text.matches("(Some (0%N,0%N,(0,0,0)))").count(), 1);
    assert_eq!(text.matches(" None None None None").count(), 1);
}
