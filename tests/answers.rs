//! `--json`, names of files and overwriting: rules that hold for every command. tests/schemas.py checks the
//! shape of every answer against docs/answer.schema.json.

use crate::common::{acutile, code, file, stderr, stdout};
use serde_json::{Value, json};
use std::process::{Command, Output, Stdio};

const COMMANDS: [&str; 24] = [
    "list",
    "show",
    "new",
    "certify",
    "verify",
    "delaunay",
    "export",
    "convert",
    "table",
    "paper",
    "lower-bound",
    "optimize",
    "records",
    "search",
    "quality",
    "gallery",
    "report",
    "draw",
    "classify",
    "appendix",
    "bundle",
    "cite",
    "completions",
    "man",
];

fn object(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn every_command_has_the_option_and_answers_a_wrong_use_in_json() {
    let help = stdout(&acutile(["--help"]));
    for command in COMMANDS {
        assert!(help.contains(&format!("\n  {command} ")), "{command}");
        let own = stdout(&acutile([command, "--help"]));
        assert!(own.contains("--json"), "{command}");
        let plain = acutile([command, "--frobnicate"]);
        let output = acutile([command, "--json", "--frobnicate"]);
        assert_eq!((code(&plain), code(&output)), (2, 2), "{command}");
        assert_eq!(stderr(&output), "", "{command}");
        let answer = object(&stdout(&output));
        assert_eq!(answer["format"], "acutile-answer");
        assert_eq!(answer["version"], 1);
        assert_eq!(answer["command"], command);
        assert_eq!(answer["verdict"], "failed");
        let error = answer["error"].as_str().expect("a sentence");
        assert!(error.contains("--frobnicate"), "{command}: {error}");
    }
    let listed = help.split("Commands:").nth(1).expect("commands");
    let listed = listed.split("Options:").next().expect("options");
    let names = listed
        .lines()
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    assert_eq!(names.count(), COMMANDS.len() + 1, "all of them, and help");
}

#[test]
fn errors_have_the_exit_code_and_the_words_that_people_see() {
    for arguments in [
        &["certify", "no-such-name"][..],
        &["show", "no-such-name"],
        &["quality", "no-such-file.msh"],
        &["classify", "a51"],
        &["draw", "a15", "-o", "a15.eps"],
        &["convert", "a15", "a15.foo"],
        &["report", "no-such-name", "-o", "x.html"],
        &["delaunay", "a15", "-o", "x.json"],
    ] {
        let plain = acutile(arguments);
        let output = acutile([arguments, &["--json"]].concat());
        assert_eq!(code(&plain), code(&output), "{arguments:?}");
        let answer = object(&stdout(&output));
        let words = format!("acutile: {}\n", answer["error"].as_str().expect("words"));
        assert!(stderr(&plain).ends_with(&words), "{arguments:?}: {words}");
    }
}

/// Standard output has the document, so the answer is on standard error.
#[test]
fn a_document_on_standard_output_is_alone_there() {
    for arguments in [
        &["export", "bcc"][..],
        &["draw", "bcc", "-o", "-"],
        &["certify", "bcc", "-o", "-"],
        &["new", "slab"],
        &["completions", "bash"],
        &["convert", "certificates/bcc.json", "-"],
    ] {
        let plain = acutile(arguments);
        let output = acutile([arguments, &["--json"]].concat());
        assert_eq!(code(&output), 0, "{arguments:?}: {}", stderr(&output));
        assert_eq!(plain.stdout, output.stdout, "{arguments:?}");
        let answer = object(&stderr(&output));
        assert_eq!(answer["command"], arguments[0]);
    }
}

#[test]
fn a_digest_and_a_path_name_the_certificate() {
    let place = tempfile::tempdir().expect("a directory");
    let path = place.path().join("bcc.cbor");
    let path = path.to_str().expect("UTF-8");
    let kept = object(&stdout(&acutile(["certify", "bcc", "-o", path, "--json"])));
    let lost = object(&stdout(&acutile(["certify", "bcc", "--json"])));
    let sha256 = &kept["certificate"]["sha256"];
    assert_eq!(
        kept["certificate"],
        json!({ "path": path, "sha256": sha256 })
    );
    assert_eq!(
        lost["certificate"],
        json!({ "path": null, "sha256": sha256 })
    );
    let verified = object(&stdout(&acutile(["verify", path, "--json"])));
    assert_eq!(verified["certificate"], kept["certificate"]);
    let classified = object(&stdout(&acutile(["classify", "bcc", "--json"])));
    assert_eq!(classified["certificate"], lost["certificate"]);
}

fn piped(arguments: &[&str], input: &[u8]) -> Output {
    use std::io::Write;
    let mut child = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("acutile runs");
    let mut stdin = child.stdin.take().expect("a pipe");
    // A command that fails early does not read everything.
    let _ = stdin.write_all(input);
    drop(stdin);
    child.wait_with_output().expect("an end")
}

#[test]
fn a_dash_is_standard_input_in_every_command_that_reads() {
    let tiling = acutile(["export", "bcc"]).stdout;
    let points = acutile(["new", "point-set"]).stdout;
    let certificate = std::fs::read("certificates/bcc.json").expect("a certificate");
    let plane = acutile(["new", "square-triangle"]).stdout;
    let place = tempfile::tempdir().expect("a directory");
    let folder = place.path().join("appendix");
    let archive = place.path().join("bcc.zip");
    for (arguments, input) in [
        (&["show", "-"][..], &tiling),
        (&["certify", "-"], &tiling),
        (&["certify", "square-triangle:-"], &plane),
        (&["verify", "-"], &certificate),
        (&["delaunay", "-"], &points),
        (&["export", "-"], &tiling),
        (&["export", "--coq", "-"], &certificate),
        (&["convert", "-", "-", "--to", "vtk", "--round"], &tiling),
        (&["table", "-"], &tiling),
        (&["quality", "-"], &tiling),
        (&["optimize", "-", "--symmetry", "list"], &tiling),
        (&["report", "-", "-o", "-"], &tiling),
        (&["draw", "-"], &tiling),
        (&["classify", "-"], &tiling),
        (&["cite", "-"], &tiling),
        (
            &["appendix", "-", "-o", folder.to_str().expect("UTF-8")],
            &tiling,
        ),
        (
            &[
                "bundle",
                "-",
                "--no-pdf",
                "-o",
                archive.to_str().expect("UTF-8"),
            ],
            &tiling,
        ),
    ] {
        let output = piped(arguments, input);
        assert_eq!(code(&output), 0, "{arguments:?}: {}", stderr(&output));
    }
    assert!(!std::path::Path::new("-").exists());
}

/// The family of docs/families.md: copies of any acute triangle.
pub const FAMILY: &str = r#"{ "format": "acutile-tiling", "version": 1, "dimension": 2,
  "parameters": { "x": {"low": 0, "high": 1, "open": ["low", "high"]}, "y": {"low": 0, "high": 1, "open": ["low", "high"]} },
  "lattice": { "gram": [["y", "x*y"], ["x*y", "1-y+x*y"]] },
  "vertices": [[0, 0]],
  "simplices": [[0, [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 1, 1], [0, 0, 1]]] }"#;

/// A pipe can be read once only.
#[test]
fn families_and_theorems_come_from_a_pipe() {
    let place = tempfile::tempdir().expect("a directory");
    let target = |name: &str| place.path().join(name).to_string_lossy().into_owned();
    let certificate = |name: &str| std::fs::read(format!("certificates/{name}.json")).expect(name);
    let (folder, page) = (target("appendix"), target("page.html"));
    let inputs = [
        FAMILY.as_bytes().to_vec(),
        certificate("triangle-tiling-all"),
        certificate("kagome-all"),
    ];
    for (index, input) in inputs.iter().enumerate() {
        for arguments in [
            &["show", "-"][..],
            &["report", "-", "-o", &page],
            &["cite", "-"],
            &["appendix", "-", "-o", &folder, "--force"],
        ] {
            let output = piped(arguments, input);
            assert_eq!(
                code(&output),
                0,
                "{arguments:?} {index}: {}",
                stderr(&output)
            );
        }
        let text = std::fs::read_to_string(&page).expect("a page");
        assert!(
            text.contains("<h2 id=\"name-0\">standard input</h2>"),
            "{index}"
        );
        let archive = target(&format!("{index}.zip"));
        let output = piped(&["bundle", "-", "--no-pdf", "-o", &archive], input);
        assert_eq!(code(&output), 0, "{index}: {}", stderr(&output));
        let archive = std::fs::read(&archive).expect("an archive");
        assert!(archive.starts_with(b"PK"), "{index}");
    }
    for arguments in [
        &["certify", "-", "--report", &page][..],
        &["table", "-"],
        &["draw", "-"],
    ] {
        let output = piped(arguments, FAMILY.as_bytes());
        assert_eq!(code(&output), 0, "{arguments:?}: {}", stderr(&output));
    }
}

/// A file gets no line of its own, by its name or by its texts: such a line could be taken for an answer.
#[cfg(unix)]
#[test]
fn names_and_texts_forge_no_line() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name).to_str().expect("UTF-8").to_owned();
    let forged = "\na15: proved: \u{1b}[1mevery statement\n";
    let exported = acutile(["export", "bcc"]).stdout;
    let mut tiling: Value = serde_json::from_slice(&exported).expect("JSON");
    tiling["name"] = json!(forged);
    tiling["labels"] = json!([forged]);
    let file = at(&format!("x{forged}.json"));
    std::fs::write(&file, tiling.to_string()).expect("written");
    let below = at(&format!("none{forged}/x.json"));
    for (arguments, expected) in [
        (&["show", &file][..], 0),
        (&["certify", &file], 0),
        (&["classify", &file], 0),
        (&["table", &file], 0),
        (&["verify", &file], 2),
        (&["certify", &format!("{file}.msh")], 2),
        (&["certify", "bcc", "-o", &below], 2),
    ] {
        let output = acutile(arguments);
        assert_eq!(
            code(&output),
            expected,
            "{arguments:?}: {}",
            stderr(&output)
        );
        for text in [stdout(&output), stderr(&output)] {
            assert!(!text.contains('\u{1b}'), "{arguments:?}: {text}");
            let is_forged = |line: &str| line.starts_with("a15: proved");
            assert!(!text.lines().any(is_forged), "{arguments:?}: {text}");
        }
    }
}

/// Names that are not UTF-8, as input and as output.
#[cfg(unix)]
#[test]
fn names_of_files_may_be_any_bytes() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let place = tempfile::tempdir().expect("a directory");
    let name = |text: &[u8]| place.path().join(OsStr::from_bytes(text));
    let write = |file: &[u8], arguments: &[&str]| {
        std::fs::write(name(file), acutile(arguments).stdout).expect("written");
        name(file)
    };
    let tiling = write(b"t\xff.json", &["export", "bcc"]);
    let points = write(b"p\xff.json", &["new", "point-set"]);
    let plane = write(b"s\xff.json", &["new", "square-triangle"]);
    let certificate = name(b"c\xff.cbor");
    let run = |arguments: &[&OsStr]| {
        let output = acutile(arguments);
        assert_eq!(code(&output), 0, "{arguments:?}: {}", stderr(&output));
    };
    let (tiling, certificate) = (tiling.as_os_str(), certificate.as_os_str());
    let o = OsStr::new("-o");
    for (command, output) in [
        ("show", None),
        ("certify", Some(certificate.to_owned())),
        ("quality", Some(name(b"q\xff.svg").into_os_string())),
        ("draw", Some(name(b"d\xff.svg").into_os_string())),
        ("export", Some(name(b"e\xff.json").into_os_string())),
        ("report", Some(name(b"r\xff.html").into_os_string())),
        ("classify", None),
        ("table", None),
        ("appendix", Some(name(b"a\xff").into_os_string())),
        ("bundle", Some(name(b"b\xff.zip").into_os_string())),
    ] {
        match &output {
            None => run(&[command.as_ref(), tiling]),
            Some(output) => run(&[command.as_ref(), tiling, o, output]),
        }
        assert!(
            output.is_none_or(|output| std::path::Path::new(&output).exists()),
            "{command}"
        );
    }
    run(&["verify".as_ref(), certificate]);
    run(&[
        "convert".as_ref(),
        certificate,
        name(b"j\xff.json").as_os_str(),
    ]);
    let mesh = name(b"m\xff.node");
    run(&["convert".as_ref(), "cube-6".as_ref(), mesh.as_os_str()]);
    run(&[
        "convert".as_ref(),
        mesh.as_os_str(),
        name(b"m\xff.vtu").as_os_str(),
    ]);
    run(&[
        "delaunay".as_ref(),
        points.as_os_str(),
        o,
        name(b"u\xff.json").as_os_str(),
    ]);
    let mut member = std::ffi::OsString::from("square-triangle:");
    member.push(&plane);
    run(&["certify".as_ref(), member.as_os_str()]);
}

#[test]
fn what_acutile_did_not_write_stays_and_an_input_stays_in_any_case() {
    let place = tempfile::tempdir().expect("a directory");
    let folder = place.path();
    let text = |path: &std::path::Path| path.to_str().expect("UTF-8").to_owned();
    let own = file(folder, "a15.json", "mine");
    let into = |arguments: &[&str]| acutile([arguments, &["-o", &text(folder)]].concat());
    // Its name is acutile's choice, so a foreign file stays.
    let stays = into(&["certify", "a15"]);
    assert_eq!(code(&stays), 2);
    assert!(
        stderr(&stays).contains("--force replaces it"),
        "{}",
        stderr(&stays)
    );
    assert_eq!(std::fs::read_to_string(&own).expect("a file"), "mine");
    assert_eq!(code(&into(&["certify", "a15", "--force"])), 0);
    // Now it is a certificate, which can be made again; and a name that is given is replaced.
    assert_eq!(code(&into(&["certify", "a15"])), 0);
    let page = file(folder, "acutile.1", "mine");
    assert_eq!(code(&acutile(["man", &text(folder)])), 2);
    assert_eq!(std::fs::read_to_string(&page).expect("a file"), "mine");
    assert_eq!(code(&acutile(["man", &text(folder), "--force"])), 0);
    assert_eq!(code(&acutile(["man", &text(folder)])), 0);
    let figure = file(folder, "x.svg", "old");
    assert_eq!(code(&acutile(["draw", "bcc", "-o", &text(&figure)])), 0);
    let tiling = file(folder, "t.json", &stdout(&acutile(["export", "bcc"])));
    let tiling = text(&tiling);
    for arguments in [
        &["certify", &tiling, "-o", &tiling][..],
        &["certify", &tiling, "--report", &tiling],
        &["certify", &tiling, "--defects", &tiling],
        &["convert", &tiling, &tiling],
        &["export", &tiling, "-o", &tiling],
        &["optimize", &tiling, "-o", &tiling],
        &["quality", &tiling, "-o", &tiling],
        &["draw", &tiling, "-o", &tiling],
        &["report", &tiling, "-o", &tiling],
        &["bundle", &tiling, "-o", &tiling],
    ] {
        let before = std::fs::read(&tiling).expect("a file");
        let output = acutile(arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(
            stderr(&output).contains("would overwrite the input"),
            "{}",
            stderr(&output)
        );
        assert_eq!(
            std::fs::read(&tiling).expect("a file"),
            before,
            "{arguments:?}"
        );
    }
}

/// An extension of another format is refused by every command that writes, before anything is done.
#[test]
fn contradictions_between_names_and_formats_are_errors() {
    let place = tempfile::tempdir().expect("a directory");
    for (arguments, name) in [
        (&["certify", "bcc"][..], "x.pdf"),
        (&["certify", "bcc", "--format", "cbor"], "x.json"),
        (&["certify", "bcc", "--format", "json"], "x.cbor"),
        (&["optimize", "c14"], "x.txt"),
        (&["search", "slab"], "x.txt"),
        (&["records", "--format", "latex"], "x.md"),
        (&["records"], "x.csv"),
        (&["report", "bcc"], "x.pdf"),
        (&["bundle", "bcc"], "x.tar"),
        (&["delaunay", "tests/cif/bcc.cif"], "x.vtu"),
        (&["export", "bcc"], "x.vtu"),
        (&["new", "slab"], "x.cif"),
        (&["new", "cif"], "x.json"),
        (&["quality", "bcc", "--json"], "x.csv"),
    ] {
        let path = place.path().join(name);
        let output = acutile([arguments, &["-o", path.to_str().expect("UTF-8")]].concat());
        assert_eq!(code(&output), 2, "{arguments:?} {name}");
        let words = stderr(&output) + &stdout(&output);
        assert!(
            words.contains("expected the extension"),
            "{arguments:?} {name}: {words}"
        );
        assert!(!path.exists(), "{name}");
    }
}
