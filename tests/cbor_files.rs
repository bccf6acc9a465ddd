//! Certificates in CBOR as a user meets them: written, verified, turned into JSON, shown.

use crate::common::{acutile, acutile_verify, code, stderr, stdout, verifier};
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
    let answer = Command::new(verifier())
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

#[test]
fn the_name_keeps_its_promise() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name);
    let proved = acutile(["certify", "z", "-o", text(&at("z.CBOR"))]);
    assert_eq!(code(&proved), 0, "{}", stderr(&proved));
    let cbor = fs::read(at("z.CBOR")).expect("written");
    assert_eq!(cbor[0] >> 5, 5, "a map, by RFC 8949, section 3.1");
    fs::remove_file(at("z.CBOR")).expect("removed");
    let refused: [(&[&str], &str, &str); 6] = [
        (&["certify", "z", "-o"], "q.cbor.gz", "not compressed"),
        (&["certify", "z", "-o"], "q.JSON.GZ", "not compressed"),
        (&["certify", "z", "a15", "-o"], "two.cbor", "a directory"),
        (&["certify", "z", "a15", "-o"], "two.Json", "a directory"),
        (
            &["convert", "certificates/z.json"],
            "q.cbor.gz",
            "not compressed",
        ),
        (&["convert", "certificates/z.json"], "q.msh", "written as"),
    ];
    for (arguments, name, expected) in refused {
        let target = at(name);
        let arguments = arguments.iter().copied().chain([text(&target)]);
        let output = acutile(arguments);
        assert_eq!(code(&output), 2, "{name}");
        let message = stderr(&output);
        assert!(
            message.contains(expected) && message.contains(name),
            "{message}"
        );
        assert_eq!(
            fs::read_dir(place.path()).expect("read").count(),
            0,
            "{name}"
        );
    }
    // A directory that is there may have any name.
    fs::create_dir(at("two.cbor")).expect("made");
    let proved = acutile(["certify", "z", "bcc", "-o", text(&at("two.cbor"))]);
    assert_eq!(code(&proved), 0, "{}", stderr(&proved));
    assert_eq!(fs::read_dir(at("two.cbor")).expect("read").count(), 2);
}

#[test]
fn convert_knows_a_certificate_where_it_meets_one() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name);
    let original = fs::read("certificates/z.json").expect("z");
    let with_input = |name: &str, target: &Path| {
        Command::new(env!("CARGO_BIN_EXE_acutile"))
            .args(["convert", "-", text(target)])
            .stdin(Stdio::from(fs::File::open(name).expect("a file")))
            .output()
            .expect("acutile runs")
    };
    let cbor = with_input("certificates/z.json", &at("s.cbor"));
    assert_eq!(code(&cbor), 0, "{}", stderr(&cbor));
    let json = with_input(text(&at("s.cbor")), &at("s.json"));
    assert_eq!(code(&json), 0, "{}", stderr(&json));
    assert_eq!(fs::read(at("s.json")).expect("written"), original);
    let copy = acutile(["convert", "certificates/z.json", text(&at("copy.json"))]);
    assert_eq!(code(&copy), 0, "{}", stderr(&copy));
    assert_eq!(fs::read(at("copy.json")).expect("written"), original);

    let tiling = crate::common::file(
        place.path(),
        "kuhn.json",
        &crate::common::kuhn().to_string(),
    );
    for input in ["a15", text(&tiling)] {
        let target = at("no.cbor");
        let output = acutile(["convert", input, text(&target)]);
        assert_eq!(code(&output), 2, "{input}");
        let way = format!("`acutile certify {input} -o {}`", text(&target));
        assert!(stderr(&output).contains(&way), "{}", stderr(&output));
        assert!(!target.exists(), "{input}");
    }
}

/// From a pipe with a name no byte may be taken to look at it.
#[cfg(unix)]
#[test]
fn convert_reads_a_named_pipe_from_its_first_byte() {
    let place = tempfile::tempdir().expect("a directory");
    let [pipe, target] = ["pipe", "mesh.msh"].map(|name| place.path().join(name));
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo runs").success());
    let writer = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::write(pipe, crate::common::kuhn().to_string())
    });
    let output = acutile(["convert", text(&pipe), text(&target)]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    writer.join().expect("no panic").expect("written");
}

/// Twenty numbers of 1.6 MiB, about: together within the limit in CBOR and not in JSON, whose notation is longer.
#[test]
fn a_page_names_the_size_of_the_json() {
    const LIMIT: usize = 32 << 20;
    let place = tempfile::tempdir().expect("a directory");
    let [json, cbor] = ["long.json", "long.cbor"].map(|name| place.path().join(name));
    let small = fs::read_to_string("certificates/c36.json").expect("c36");
    let digits = "7".repeat((LIMIT + 100 - small.len()) / 20 + 20);
    let (claim, witness) = small.split_at(small.find("\"vertices\"").expect("a witness"));
    let long = format!(
        "{claim}{}",
        witness.replacen("\n[\"", &format!("\n[\"{digits}"), 20)
    );
    assert!(long.len() > LIMIT);
    fs::write(&json, &long).expect("written");
    let converted = acutile(["convert", text(&json), text(&cbor)]);
    assert_eq!(code(&converted), 0, "{}", stderr(&converted));
    assert!(fs::read(&cbor).expect("written").len() < LIMIT);
    let page = acutile(["report", text(&cbor)]);
    assert_eq!(code(&page), 3);
    let expected = format!("{} bytes in JSON", long.len());
    assert!(stderr(&page).contains(&expected), "{}", stderr(&page));
}
