//! `acutile export --coq`: the bytes and the claim in the file, and certificates that have none.
//! proofs/certificates.sh tests that Coq proves the theorems.

use acutile_core::format;
use acutile_io::export::{coq_family_theorem, coq_file, coq_theorem};
use std::path::Path;

/// The file of a valid certificate of the tests.
fn theorem_of(name: &str) -> String {
    let cbor = cbor_of(name);
    let claim = format::read::certificate(&cbor).unwrap().claim;
    coq_theorem(&cbor, &claim)
}

/// The certificate in CBOR of a valid file of the tests.
fn cbor_of(name: &str) -> Vec<u8> {
    let folder =
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/certificates/valid");
    let json = std::fs::read(folder.join(name)).unwrap();
    format::to_cbor(&json).unwrap().into_owned()
}

fn check_parts(name: &str, parts: &[&str]) {
    let text = theorem_of(name);
    for part in parts {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

/// The 136 bytes of the certificate that docs/format.md checks by hand.
#[test]
fn the_file_has_the_bytes_of_the_certificate() {
    let page = include_str!("../../../docs/format.md");
    let start = page
        .find("The same certificate in CBOR, 136 bytes:")
        .unwrap();
    let block = page[start..].split("```").nth(1).unwrap();
    let bytes: Vec<u8> = block
        .split_whitespace()
        .map(|b| u8::from_str_radix(b, 16).unwrap())
        .collect();
    assert_eq!(bytes.len(), 136);
    let claim = format::read::certificate(&bytes).unwrap().claim;
    let text = coq_theorem(&bytes, &claim);
    let listed = text.split("concat [\n").nth(1).unwrap();
    let listed = listed.split("].\n").next().unwrap();
    let written: Vec<u8> = listed
        .split(['[', ']', ';', '\n'])
        .filter_map(|byte| byte.strip_prefix('x'))
        .map(|byte| u8::from_str_radix(byte, 16).unwrap())
        .collect();
    assert_eq!(written, bytes);
    assert!(text.contains(
        "OfTiling (TilingClaim 2\n  Rationals\n  [[Plain [2];Plain [1]];[Plain [2]]]\n  Space\n  \
         [FaceToFaceTiling;IsAcute;LargestAngle Maximum 1 (Plain [1]) 4])."
    ));
    assert!(text.ends_with("Qed.\nPrint Assumptions claim.\n"));
}

/// `sha256sum` of GNU coreutils wrote the pinned digests; check.sh compares them.
#[test]
fn the_file_names_the_statement_files() {
    let text = theorem_of("space-bcc.json");
    for name in [
        "Statement.v",
        "PlaneStatement.v",
        "RegionStatement.v",
        "PlaneRegionStatement.v",
        "Denote.v",
    ] {
        let line = text
            .lines()
            .find(|l| l.ends_with(&format!("  {name}")))
            .unwrap();
        assert_eq!(line.split_whitespace().next().unwrap().len(), 64, "{line}");
    }
}

#[test]
fn a_solid_has_its_polytope() {
    check_parts(
        "solid-tetrahedron.json",
        &[
            "(Solid (Polytope 1 [[Plain [0];Plain [0];Plain [0]];[Plain [1];Plain [0];Plain [0]];",
            "%N;",
        ],
    );
}

/// All six relations of each quantity, over Q(√3); bounds of zero, negative ones, in the field.
#[test]
fn every_relation_has_its_word() {
    check_parts(
        "plane-every-relation.json",
        &[
            "(Root [(-3);0;1] 1 2 1)",
            "[[Plain [2;0];Plain [1;0]];[Plain [4;2]]]",
            "LargestAngle LessThan (-1) (Plain [1;0]) 4",
            "LargestAngle AtMost 0 (Plain [0;0]) 1",
            "LargestAngle AtLeast 1 (Plain [1;0]) 4",
            "SmallestAngle LessThan 1 (Plain [2;(-1)]) 4",
            "SmallestAngle MoreThan 1 (Plain [3;0]) 4",
            "SquaredRatio Minimum (Plain [1;0]) 3",
        ],
    );
}

#[test]
fn a_region_has_its_rank_and_its_local_statements() {
    check_parts(
        "region-rank-2-two-slabs.json",
        &["OfTiling (TilingClaim 3\n", "\n  (Region 2)\n"],
    );
    check_parts(
        "region-locally-delaunay-cube.json",
        &[
            "\n  (Region 0)\n",
            "[FaceToFaceTiling;IsLocallyWeaklyDelaunay]",
        ],
    );
}

/// The family of docs/format.md, checked by hand there: x between 0 and 1, both ends open.
#[test]
fn a_family_has_its_parameters_and_polynomials() {
    let page = include_str!("../../../docs/format.md");
    let start = page.find("### A family checked by hand").unwrap();
    let json = page[start..].split("```json\n").nth(1).unwrap();
    let json = json.split("```").next().unwrap();
    let cbor = format::to_cbor(json.as_bytes()).unwrap();
    let claim = format::family::certificate(&cbor).unwrap().claim;
    let text = coq_family_theorem(&cbor, &claim);
    assert!(text.contains(
        "OfFamily [Range \"x\"%string (Limit false [0] 1) (Limit false [1] 1)]\n  (TilingClaim 2\n  Rationals\n  \
         [[Polynomial [([1],[0]%N)];Polynomial [([1],[1]%N)]];[Polynomial [([1],[0]%N)]]]\n  Space\n  \
         [FaceToFaceTiling;IsAcute])."
    ));
}

#[test]
fn a_region_that_is_not_delaunay_says_so() {
    check_parts(
        "region-not-delaunay.json",
        &["\n  (Region 0)\n  [FaceToFaceTiling;IsNotDelaunay])."],
    );
}

/// tests/certificates/source/valid.py has the three planes.
#[test]
fn planes_have_their_coefficients() {
    check_parts(
        "slab-cube-6-uncrossed.json",
        &["UncrossedPlane [0;0;1] 0 1;UncrossedPlane [0;1;(-1)] 3 1;UncrossedPlane [0;1;0] (-1) 1"],
    );
}

/// tests/certificates/source/patch_systems.py has the slab: it is one high, and both ends have the class 0.
#[test]
fn a_system_of_patches_has_its_tiles_and_its_statements() {
    let text = coq_file(&cbor_of("patches-kuhn-slab.json")).unwrap();
    let (_, claim) = text.split_once("OfPatches (PatchesClaim\n").unwrap();
    assert!(claim.contains(
        "\n  2\n  [(Polygon 1 [[Plain [0]];[Plain [1]]] [0;0])]\n  [FaceToFaceTiling;IsNonobtuse;"
    ));
    let text = coq_file(&cbor_of("patches-square-triangle.json")).unwrap();
    let (_, claim) = text.split_once("OfPatches (PatchesClaim\n").unwrap();
    assert!(claim.contains(";IsDelaunay;IsTCP]).\n"), "{claim}");
}
