//! docs/certificate.schema.json accepts what has the shape, and refuses what
//! has not, as far as a schema can tell.

use jsonschema::Validator;
use serde_json::Value;
use std::fs;
use std::path::Path;

fn schema() -> Validator {
    let path = concat!(
        concat!(env!("CARGO_MANIFEST_DIR"), "/../.."),
        "/docs/certificate.schema.json"
    );
    let schema: Value = serde_json::from_slice(&fs::read(path).unwrap()).unwrap();
    assert!(jsonschema::meta::is_valid(&schema));
    jsonschema::validator_for(&schema).unwrap()
}

/// The files of a folder that are JSON at all: name and value.
fn values(folder: &str) -> Vec<(String, Value)> {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("tests/certificates")
        .join(folder);
    let paths = fs::read_dir(path)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let value = |path: &Path| serde_json::from_slice(&fs::read(path).unwrap()).ok();
    let named = |path: &Path| path.file_stem().unwrap().to_str().unwrap().to_owned();
    paths
        .filter_map(|path| value(&path).map(|value| (named(&path), value)))
        .collect()
}

/// What a schema over parsed JSON cannot express: bytes, arithmetic, and
/// references from one member to another.
const BEYOND_A_SCHEMA: &[&str] = &[
    "angle-range--",
    "canonical--",
    "coefficients--more-than-degree",
    "coefficients--trailing-zero",
    "coefficients--two-over-the-rationals",
    "face-repeated--side-reversed",
    "face-repeated--two-opposite-faces-doubled",
    "face-vertices--huge",
    "face-vertices--range",
    "gram-asymmetric",
    "json--duplicate",
    "json--vertex-as-float",
    "mate-range--",
    "mates-length--",
    "number--not-lowest-terms",
    "polynomial--not-monic",
    "ratio-range--",
    "polynomial--leading-zero",
    "root-derivative--",
    "root-order--",
    "statements--order",
    "statements--above-before-below",
    "statements--tcp-before-delaunay",
    "statements--two-angle-bounds",
    "statements--two-ratios",
    "unused-domain-vertex",
    "unused-vertex",
    "vertex-range--",
];

#[test]
fn every_certificate_of_the_right_shape_is_accepted() {
    let schema = schema();
    for folder in ["valid", "false"] {
        let files = values(folder);
        assert!(files.len() >= 12);
        for (name, value) in files {
            let errors: Vec<String> = schema.iter_errors(&value).map(|e| e.to_string()).collect();
            assert!(errors.is_empty(), "{folder}/{name}: {errors:?}");
        }
    }
}

#[test]
fn malformed_shapes_are_refused() {
    let schema = schema();
    let mut refused = 0;
    for (name, value) in values("malformed") {
        if BEYOND_A_SCHEMA
            .iter()
            .any(|prefix| name.starts_with(prefix))
        {
            continue;
        }
        assert!(
            !schema.is_valid(&value),
            "{name} has the shape of the schema"
        );
        refused += 1;
    }
    assert!(refused >= 80, "{refused}");
}

#[test]
fn another_version_is_refused() {
    let schema = schema();
    for (name, value) in values("declined") {
        assert!(
            !name.starts_with("version") || !schema.is_valid(&value),
            "{name}"
        );
    }
}
