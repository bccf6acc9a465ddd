//! Certificates in CBOR as a user meets them: written, verified, turned into JSON, shown.

mod common;

use common::{acutile, acutile_verify, code, stderr, stdout};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

#[test]
fn certify_verify_convert() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name);
    let proved = acutile(["certify", "z", "-o", text(&at("z.cbor"))]);
    assert_eq!(code(&proved), 0, "{}", stderr(&proved));
    let verified = acutile_verify([at("z.cbor")]);
    assert_eq!(code(&verified), 0, "{}", stdout(&verified));
    assert_eq!(code(&acutile(["verify", text(&at("z.cbor"))])), 0);
    // Nothing but the certificate is left in the directory.
    assert_eq!(fs::read_dir(place.path()).expect("read").count(), 1);

    let to_json = acutile(["convert", text(&at("z.cbor")), text(&at("z.json"))]);
    assert_eq!(code(&to_json), 0, "{}", stderr(&to_json));
    let json = fs::read(at("z.json")).expect("written");
    assert_eq!(json, fs::read("certificates/z.json").expect("z"));
    let to_cbor = acutile(["convert", "certificates/z.json", text(&at("again.cbor"))]);
    assert_eq!(code(&to_cbor), 0, "{}", stderr(&to_cbor));
    let cbor = fs::read(at("z.cbor")).expect("written");
    assert_eq!(fs::read(at("again.cbor")).expect("written"), cbor);
    let out = acutile(["convert", text(&at("z.cbor")), "-"]);
    assert_eq!(out.stdout, json);
}

#[test]
fn the_format_can_be_said() {
    let place = tempfile::tempdir().expect("a directory");
    let folder = text(place.path());
    let proved = acutile(["certify", "bcc", "a15", "--format", "cbor", "-o", folder]);
    assert_eq!(code(&proved), 0, "{}", stderr(&proved));
    for name in ["a15.cbor", "bcc.cbor"] {
        assert_eq!(code(&acutile_verify([place.path().join(name)])), 0);
    }
    let out = acutile(["certify", "bcc", "--format", "cbor", "-o", "-"]);
    let of_file = fs::read(place.path().join("bcc.cbor")).expect("written");
    assert_eq!(out.stdout, of_file);
}

#[test]
fn standard_input_is_verified() {
    let file = fs::File::open("tests/certificates/cbor/valid--slab-bcc.cbor").expect("a file");
    let answer = Command::new(env!("CARGO_BIN_EXE_acutile-verify"))
        .arg("-")
        .stdin(Stdio::from(file))
        .output()
        .expect("acutile-verify runs");
    assert_eq!(code(&answer), 0, "{}", stdout(&answer));
}

#[test]
fn exit_codes() {
    let folder = "tests/certificates/cbor";
    let cases = [
        ("cbor--byte-behind", 2),
        ("canonical--indefinite-row", 2),
        ("mate-not-mutual--of-itself", 1),
        ("version--2", 3),
    ];
    for (name, expected) in cases {
        let answer = acutile_verify([format!("{folder}/{name}.cbor")]);
        assert_eq!(code(&answer), expected, "{name}: {}", stdout(&answer));
    }
}

#[test]
fn other_commands_take_them_or_say_why_not() {
    let cbor = "tests/certificates/cbor/valid--space-a15-tcp.cbor";
    let page = acutile(["report", cbor]);
    assert_eq!(code(&page), 0, "{}", stderr(&page));
    let json = fs::read_to_string("tests/certificates/valid/space-a15-tcp.json").expect("a file");
    assert!(json.contains("\"TCP\"") && stdout(&page).contains("TCP"));
    let theorem = acutile(["export", "--coq", cbor]);
    let of_json = acutile([
        "export",
        "--coq",
        "tests/certificates/valid/space-a15-tcp.json",
    ]);
    assert_eq!(code(&theorem), 0, "{}", stderr(&theorem));
    assert_eq!(theorem.stdout, of_json.stdout);
    let shown = acutile(["show", cbor]);
    assert_eq!(code(&shown), 2);
    assert!(stderr(&shown).contains("CBOR"), "{}", stderr(&shown));
    let bad = "tests/certificates/cbor/cbor--byte-behind.cbor";
    assert_eq!(code(&acutile(["report", bad])), 2);
    let with_options = acutile(["convert", cbor, "/dev/null", "--round"]);
    assert_eq!(code(&with_options), 2);
}
