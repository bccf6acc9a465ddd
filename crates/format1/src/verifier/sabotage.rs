//! What would happen without each check: every one of them carries weight.

use super::{Kind, Limits, Refusal, Verified, geometry, shape, verify, verify_by};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// The files of the folders whose certificates are to be refused.
fn files(folders: &[&str]) -> Vec<(String, Vec<u8>)> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/certificates");
    let entries = folders
        .iter()
        .flat_map(|folder| fs::read_dir(root.join(folder)).unwrap());
    let read = |path: &Path| (path.display().to_string(), fs::read(path).unwrap());
    entries.map(|entry| read(&entry.unwrap().path())).collect()
}

fn without<C: Copy>(checks: &[(&'static str, C)], name: &str) -> Vec<(&'static str, C)> {
    let rest: Vec<_> = checks
        .iter()
        .copied()
        .filter(|(check, _)| *check != name)
        .collect();
    assert_eq!(rest.len() + 1, checks.len(), "{name} is in the table once");
    rest
}

fn answers(
    shape: &[(&str, shape::Check)],
    geometry: &[(&str, geometry::Check)],
    bytes: &[u8],
) -> Result<Verified, Refusal> {
    verify_by(bytes, &Limits::DEFAULT, shape, geometry)
}

#[test]
fn without_any_one_geometric_check_something_false_is_accepted() {
    let refused = files(&["false"]);
    for (name, _) in geometry::CHECKS {
        // Two that the volume sum makes superfluous, and that make the proof
        // shorter. Mutual mates: where each facet has some facet on its other
        // side, the covering number N never falls to zero. Closed faces: the
        // computed volume is at most that of P, and P is at most what the
        // half-spaces leave, which N >= 1 covers evenly.
        if ["mates_mutual", "closed"].contains(name) {
            continue;
        }
        let rest = without(geometry::CHECKS, name);
        let accepts = |bytes: &[u8]| answers(shape::CHECKS, &rest, bytes).is_ok();
        assert!(
            refused.iter().any(|(_, bytes)| accepts(bytes)),
            "{name} refuses nothing alone"
        );
    }
}

#[test]
fn without_any_one_check_some_file_gets_another_answer() {
    let refused = files(&["false", "malformed"]);
    let differs = |shape: &[_], geometry: &[_]| {
        refused.iter().any(|(_, bytes)| {
            let sabotaged = catch_unwind(AssertUnwindSafe(|| answers(shape, geometry, bytes)));
            // A check on which a later one relies may leave it to panic.
            sabotaged.map_or(true, |answer| answer != verify(bytes, &Limits::DEFAULT))
        })
    };
    for (name, _) in shape::CHECKS {
        assert!(
            differs(&without(shape::CHECKS, name), geometry::CHECKS),
            "{name}"
        );
    }
    for (name, _) in geometry::CHECKS {
        assert!(
            differs(shape::CHECKS, &without(geometry::CHECKS, name)),
            "{name}"
        );
    }
}

#[test]
fn every_false_file_is_refused_as_false() {
    for (path, bytes) in files(&["false"]) {
        let refusal = verify(&bytes, &Limits::DEFAULT).unwrap_err();
        assert_eq!(refusal.kind(), Kind::False, "{path}: {refusal}");
    }
}
