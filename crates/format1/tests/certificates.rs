//! Every file of tests/certificates gets the answer that its name demands.

use acutile_format1::verifier::{Kind, Limits, Refusal, verify};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn files(folder: &str) -> Vec<PathBuf> {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("tests/certificates")
        .join(folder);
    let mut files: Vec<_> = fs::read_dir(path)
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.sort();
    files
}

fn stem(path: &Path) -> &str {
    path.file_name()
        .unwrap()
        .to_str()
        .unwrap()
        .strip_suffix(".json")
        .unwrap()
}

/// The limits, with the one that the file's name ends in: `…--limit-NAME-N`.
fn limits(stem: &str) -> Limits {
    let mut limits = Limits::DEFAULT;
    let Some((_, option)) = stem.split_once("--limit-") else {
        return limits;
    };
    let (name, value) = option.rsplit_once('-').unwrap();
    match name {
        "bytes" => limits.bytes = value.parse().unwrap(),
        "simplices" => limits.simplices = value.parse().unwrap(),
        "bisections" => limits.bisections = value.parse().unwrap(),
        "work" => limits.work = value.parse().unwrap(),
        _ => panic!("{stem}: unknown limit"),
    }
    limits
}

/// Checks each file of a folder and gives the codes seen in it.
fn codes_of(folder: &str, kind: Kind) -> BTreeSet<&'static str> {
    let codes = files(folder).into_iter().map(|path| {
        let stem = stem(&path);
        let expected = stem.split("--").next().unwrap();
        match verify(&fs::read(&path).unwrap(), &limits(stem)) {
            Ok(verified) => panic!("{folder}/{stem} was accepted: {verified}"),
            Err(refusal) => {
                let answer = (refusal.code(), refusal.kind());
                assert_eq!(answer, (expected, kind), "{folder}/{stem}: {refusal}");
                refusal.code()
            }
        }
    });
    codes.collect()
}

#[test]
fn every_code_has_a_file_and_every_file_gets_its_code() {
    let mut seen = codes_of("malformed", Kind::Malformed);
    seen.extend(codes_of("false", Kind::False));
    seen.extend(codes_of("declined", Kind::Declined));
    // tests/verifier_cbor.rs looks at the folder `cbor`; a file that changes is in crates/format1/src/verifier/source.rs.
    seen.extend(["cbor", "changed"]);
    let all: BTreeSet<&str> = Refusal::CODES.iter().map(|(code, _)| *code).collect();
    assert_eq!(all.len(), Refusal::CODES.len(), "two variants share a code");
    assert_eq!(seen, all);
}

#[test]
fn valid_certificates_are_verified() {
    for path in files("valid") {
        let bytes = fs::read(&path).unwrap();
        let verified = verify(&bytes, &Limits::DEFAULT)
            .unwrap_or_else(|refusal| panic!("{}: [{}] {refusal}", path.display(), refusal.code()));
        assert!(verified.vertices() > 0 && verified.simplices() > 0);
    }
}

/// Counted by hand from make.py; a folder that was emptied must not pass.
#[test]
fn the_folders_are_full() {
    assert_eq!(files("valid").len(), 48);
    assert!(
        files("malformed").len() >= 130,
        "{}",
        files("malformed").len()
    );
    assert!(files("false").len() >= 55, "{}", files("false").len());
    assert!(files("declined").len() >= 25, "{}", files("declined").len());
}

/// The certificate worked through in docs/format.md is the one in the folder.
#[test]
fn the_worked_example_is_in_the_documentation() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let read = |path: &str| fs::read_to_string(root.join(path)).unwrap();
    let example = read("tests/certificates/valid/plane-equilateral-acute.json");
    assert!(read("docs/format.md").contains(&example));
}

/// docs/format.md names every code in its table, with its kind.
#[test]
fn every_code_is_in_the_documentation() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let format = fs::read_to_string(root.join("docs/format.md")).unwrap();
    for (code, kind) in Refusal::CODES {
        let cell = format!("| `{code}` | {kind} |");
        assert!(format.contains(&cell), "{cell}");
    }
}

/// Exact messages: what a person reads.
#[test]
fn refusals_name_the_thing_and_the_exact_value() {
    let cases = [
        (
            "false/volume-sum--overlaid",
            "the volumes of the simplices sum to 2 times the cell",
        ),
        (
            "false/orientation--one-negative",
            "simplex 1 has the determinant -1, not a positive one",
        ),
        (
            "false/not-acute--square",
            "the angle of facets 1 and 2 of simplex 0 is not acute: \
             their scaled normals have the product 0, not a negative one",
        ),
        (
            "false/gram-not-positive--indefinite",
            "the Gram matrix is not positive definite: its leading principal minor 2 is -3",
        ),
        (
            "false/volume-sum--slab-twice",
            "the volumes of the simplices sum to 2 times the cell",
        ),
        (
            "false/volume-sum--strip-over-sqrt-3-twice",
            "the volumes of the simplices sum to 2 a times the cell; the domain has a",
        ),
        (
            "false/vertex-outside--slightly",
            "vertex 7 is outside of face 5 of the domain: the determinant is -1/1000000",
        ),
        (
            "false/boundary-facet--slab-too-high",
            "facet 0 of simplex 4 does not lie in face 1 of the domain: a corner has the determinant -1, not 0",
        ),
        (
            "false/edge-valence--bcc",
            "the edge between the vertices 0 and 0, shifted by [0, 1, 1], is in 4 tetrahedra",
        ),
        (
            "false/boundary-meets--vertex-pierces",
            "facet 3 of simplex 0 and facet 1 of simplex 1 in the boundary have no corner in common and meet elsewhere",
        ),
        (
            "false/covering--three-deep",
            "directly outside of facet 0 of simplex 1 in the boundary the covering number is 1, not 0",
        ),
        (
            "false/faces-not-closed--side-missing",
            "the ridge of the domain with the vertices [0] is in 1 faces, not in 2",
        ),
        (
            "declined/sign-undecided--gram-zero",
            "the sign of the leading principal minor 1 of the Gram matrix, -2 + a^2, \
             is not decided by the bisections allowed",
        ),
        (
            "malformed/number--not-lowest-terms",
            "gram[0][0]: \"2/4\": not in lowest terms",
        ),
        (
            "malformed/canonical--two-last-newlines",
            "not in canonical form: the first wrong byte is at offset 472",
        ),
    ];
    for (name, expected) in cases {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
            .join("tests/certificates")
            .join(name);
        let bytes = fs::read(path.with_extension("json")).unwrap();
        let refusal = verify(&bytes, &Limits::DEFAULT).unwrap_err();
        assert_eq!(refusal.to_string(), expected, "{name}");
    }
}
