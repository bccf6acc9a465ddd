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
    let place = tempfile::tempdir().expect("a directory");
    let wrong = place.path().join("wrong.cbor");
    let json = "tests/certificates/false/not-acute--cube-6.json";
    assert_eq!(code(&acutile(["convert", json, text(&wrong)])), 0);
    let of_folder = |name: &str| format!("tests/certificates/cbor/{name}.cbor");
    let cases = [
        (of_folder("cbor--byte-after-the-end"), 2),
        (of_folder("canonical--shift-zero-in-an-array"), 2),
        (text(&wrong).to_owned(), 1),
        (of_folder("version--3"), 3),
    ];
    for (path, expected) in cases {
        let answer = acutile_verify([&path]);
        assert_eq!(code(&answer), expected, "{path}: {}", stdout(&answer));
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
    assert_eq!(code(&shown), 0, "{}", stderr(&shown));
    assert!(stdout(&shown).contains("8 vertices and 46 simplices"));
    let bad = "tests/certificates/cbor/cbor--byte-after-the-end.cbor";
    for command in ["report", "show"] {
        let refused = acutile([command, bad]);
        assert_eq!(code(&refused), 2, "{command}");
        assert!(stderr(&refused).contains(bad), "{}", stderr(&refused));
    }
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
    assert_eq!(cbor[0], 0x85, "an array of five, by RFC 8949, section 3");
    fs::remove_file(at("z.CBOR")).expect("removed");
    let refused: [(&[&str], &str, &str); 5] = [
        (&["certify", "z", "-o"], "q.cbor.gz", "not compressed"),
        (&["certify", "z", "-o"], "q.JSON.GZ", "not compressed"),
        (&["certify", "z", "a15", "-o"], "two.cbor", "a directory"),
        (&["certify", "z", "a15", "-o"], "two.Json", "a directory"),
        (
            &["convert", "certificates/z.json"],
            "q.cbor.gz",
            "not compressed",
        ),
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

/// Sparse files of 40 GB that begin like a certificate: a message, and no attempt to read them.
#[test]
fn convert_reads_no_more_than_its_limit() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name);
    let json = fs::read("certificates/z.json").expect("z");
    let cbor = fs::read("tests/certificates/cbor/valid--slab-bcc.cbor").expect("a file");
    for (name, begin) in [("huge.json", &json[..200]), ("huge.cbor", &cbor[..])] {
        fs::write(at(name), begin).expect("written");
        let file = fs::File::options().write(true).open(at(name));
        file.expect("opened").set_len(40 << 30).expect("sparse");
        let output = acutile(["convert", text(&at(name)), text(&at("out.cbor"))]);
        assert_eq!(code(&output), 3, "{}", stderr(&output));
        assert!(
            stderr(&output).contains("--max-bytes 42949672960"),
            "{}",
            stderr(&output)
        );
        assert!(!at("out.cbor").exists());
    }
    let small = acutile(["convert", "--max-bytes", "100", "certificates/z.json", "-"]);
    assert_eq!(code(&small), 3);
    assert_eq!(stdout(&small), "");
}
