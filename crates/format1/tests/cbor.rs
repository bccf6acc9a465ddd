//! Certificates in CBOR: the same answers as in JSON, and one byte string each.

use acutile_format1::certificate::cbor::is_cbor;
use acutile_format1::verifier::{
    Kind, Limits, Refusal, Verified, to_cbor, to_json, verify, verify_file,
};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// A path of the repository.
fn repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}

fn files(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(repository(folder)).unwrap();
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

fn stem(path: &Path) -> &str {
    path.file_stem().unwrap().to_str().unwrap()
}

fn good() -> Vec<u8> {
    fs::read(repository(
        "tests/certificates/cbor/valid--plane-equilateral-acute.cbor",
    ))
    .unwrap()
}

/// Of bytes in memory; the same of a file.
fn answer(bytes: &[u8], limits: &Limits) -> Result<Verified, Refusal> {
    let in_memory = verify(bytes, limits);
    if is_cbor(bytes) {
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(file.path(), bytes).unwrap();
        let of_file = verify_file(&File::open(file.path()).unwrap(), limits);
        assert_eq!(of_file, in_memory);
    }
    in_memory
}

/// cbor.py wrote them, which shares no code with the program.
#[test]
fn every_file_gets_the_answer_of_its_name() {
    let mut seen = BTreeSet::new();
    for path in files("tests/certificates/cbor") {
        let (code, what) = stem(&path).split_once("--").unwrap();
        let bytes = fs::read(&path).unwrap();
        let found = answer(&bytes, &Limits::DEFAULT);
        if code == "valid" {
            let json =
                fs::read(repository(&format!("tests/certificates/valid/{what}.json"))).unwrap();
            assert_eq!(to_cbor(&json, &Limits::DEFAULT).unwrap(), bytes, "{what}");
            assert_eq!(to_json(&bytes, &Limits::DEFAULT).unwrap(), json, "{what}");
            assert!(found.is_ok(), "{what}");
        } else {
            let refusal = found.expect_err(what);
            assert_eq!(refusal.code(), code, "{what}: {refusal}");
        }
        seen.insert(code.to_owned());
    }
    assert!(seen.len() > 15 && files("tests/certificates/cbor").len() > 90);
}

/// The refusal names the row.
#[test]
fn the_row_is_named() {
    let bytes = fs::read(repository(
        "tests/certificates/cbor/cbor--mate-is-an-integer.cbor",
    ))
    .unwrap();
    let refusal = verify(&bytes, &Limits::DEFAULT).unwrap_err();
    // cbor.py puts the integer, one byte, at 173.
    let expected = "mates[1]: expected an array at offset 174";
    assert_eq!(refusal.to_string(), expected);
    assert_eq!(refusal.kind(), Kind::Malformed);
}

fn without_digest(answer: Result<Verified, Refusal>) -> Result<String, Refusal> {
    answer.map(|verified| {
        format!(
            "{verified} {:?} {} {} {}",
            verified.claim(),
            verified.vertices(),
            verified.simplices(),
            verified.boundary()
        )
    })
}

/// Whatever is canonical JSON of a certificate's shape, right or wrong, has a CBOR that
/// gives it back, and the same answer to the last word.
#[test]
fn both_encodings_get_the_same_answer() {
    let mut transcribed = 0;
    let folders = ["valid", "false", "malformed", "declined"];
    let of_tests = folders.map(|folder| format!("tests/certificates/{folder}"));
    for path in of_tests.iter().flat_map(|folder| files(folder)) {
        let json = fs::read(&path).unwrap();
        let Ok(cbor) = to_cbor(&json, &Limits::DEFAULT) else {
            continue;
        };
        let limits = limits(stem(&path));
        assert_eq!(to_json(&cbor, &Limits::DEFAULT).unwrap(), json, "{path:?}");
        let of_json = without_digest(verify(&json, &limits));
        let of_cbor = without_digest(answer(&cbor, &limits));
        if !stem(&path).contains("limit-bytes") {
            assert_eq!(of_cbor, of_json, "{path:?}");
        }
        transcribed += 1;
    }
    assert!(transcribed > 200, "{transcribed}");
}

/// The limit at the end of a name, `…--limit-NAME-N`.
fn limits(stem: &str) -> Limits {
    let mut limits = Limits::DEFAULT;
    if let Some((_, option)) = stem.split_once("--limit-") {
        let (name, value) = option.rsplit_once('-').unwrap();
        match name {
            "bytes" => limits.bytes = value.parse().unwrap(),
            "simplices" => limits.simplices = value.parse().unwrap(),
            "bisections" => limits.bisections = value.parse().unwrap(),
            "work" => limits.work = value.parse().unwrap(),
            _ => panic!("{stem}: unknown limit"),
        }
    }
    limits
}

#[test]
fn the_catalogue_goes_there_and_back() {
    let catalogue = files("certificates");
    assert!(catalogue.len() > 35);
    for path in catalogue {
        let json = fs::read(&path).unwrap();
        let cbor = to_cbor(&json, &Limits::DEFAULT).unwrap();
        assert!(is_cbor(&cbor) && cbor.len() < json.len());
        assert_eq!(to_json(&cbor, &Limits::DEFAULT).unwrap(), json, "{path:?}");
        assert_eq!(to_cbor(&cbor, &Limits::DEFAULT).unwrap(), cbor, "{path:?}");
    }
}

#[test]
fn no_beginning_is_a_certificate() {
    let good = good();
    for length in 0..good.len() {
        let refusal = answer(&good[..length], &Limits::DEFAULT).unwrap_err();
        assert_eq!(refusal.kind(), Kind::Malformed, "{length}: {refusal}");
    }
}

/// Every byte replaced by every other: refused, or a certificate that has just these bytes,
/// in which only a number can have changed.
#[test]
fn every_changed_byte_is_refused_or_another_certificate() {
    let good = good();
    let mut verified = 0;
    for at in 0..good.len() {
        for byte in 0..=255 {
            let mut bad = good.clone();
            bad[at] = byte;
            if byte == good[at] || verify(&bad, &Limits::DEFAULT).is_err() {
                continue;
            }
            let json = to_json(&bad, &Limits::DEFAULT).unwrap();
            assert_eq!(to_cbor(&json, &Limits::DEFAULT).unwrap(), bad);
            assert!(verify(&json, &Limits::DEFAULT).is_ok());
            verified += 1;
        }
    }
    // The vertex is anywhere, a scale of the metric is free: some digits may be others.
    assert!((1..200).contains(&verified), "{verified}");
}

#[test]
fn bytes_of_the_file() {
    let good = good();
    let limit = |bytes| Limits {
        bytes,
        ..Limits::DEFAULT
    };
    let size = good.len() as u64;
    assert!(answer(&good, &limit(size)).is_ok());
    let refusal = answer(&good, &limit(size - 1)).unwrap_err();
    assert_eq!(refusal.code(), "too-many-bytes");
}

/// What is held at once has a bound of its own, 2 MiB: a text, a row, a claim.
#[test]
fn what_is_held_is_bounded() {
    let good = good();
    let limits = Limits {
        bytes: u64::MAX,
        ..Limits::DEFAULT
    };
    let put = |at: &[u8], old: usize, new: Vec<u8>| {
        let from = good.windows(at.len()).position(|part| part == at).unwrap() + at.len();
        [&good[..from], &new[..], &good[from + old..]].concat()
    };
    let long = (2 << 20) + 1u32;
    let text = [&[0x7a][..], &long.to_be_bytes(), &vec![b'1'; long as usize]].concat();
    let row = [&[0x9a][..], &long.to_be_bytes(), &vec![0x80; long as usize]].concat();
    let cases = [
        put(b"\x68vertices\x81\x82", 2, text.clone()),
        put(b"\x69simplices\x82", 13, row),
        put(b"\x66domain", 6, text),
    ];
    for case in cases {
        let refusal = verify(&case, &limits).unwrap_err();
        assert_eq!(refusal.code(), "too-many-bytes", "{refusal}");
    }
}
