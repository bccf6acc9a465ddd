//! `acutile bundle`: what is in an archive, that it depends on nothing but its input, and that a
//! referee's three programs believe what is in it and nothing else.
//!
//! Python 3, Node and TeX need not be there, unless `REQUIRE_TOOLS` is set.

use crate::common::{acutile, acutile_verify, code, kuhn, stderr, stdout, verifier};
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, Output};

/// Writes an archive, and gives its bytes.
fn bundle(directory: &Path, arguments: &[&str]) -> Vec<u8> {
    let target = directory.join("artefact.zip");
    let arguments = arguments.iter().map(OsStr::new);
    let all = [OsStr::new("bundle")].into_iter().chain(arguments);
    let output = acutile(all.chain([OsStr::new("-o"), target.as_os_str()]));
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert_eq!(stdout(&output), "");
    std::fs::read(target).expect("the archive")
}

/// Runs a program, if it is there.
fn run(program: &str, directory: &Path, arguments: &[&str]) -> Option<Output> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(directory)
        .output();
    if output.is_err() {
        assert!(std::env::var_os("REQUIRE_TOOLS").is_none(), "{program}");
        // Not by eprintln, which is shown for failures only.
        writeln!(io::stderr(), "SKIPPED: {program} is not installed").expect("standard error");
    }
    output.ok()
}

/// An archive taken apart by Python's zipfile, if there is Python.
fn unpacked(arguments: &[&str]) -> Option<tempfile::TempDir> {
    let directory = tempfile::tempdir().expect("a directory");
    bundle(directory.path(), arguments);
    let script = "
import hashlib, zipfile
with zipfile.ZipFile('artefact.zip') as z:
    assert z.testzip() is None
    names = z.namelist()
    assert names == sorted(names) and len(set(names)) == len(names)
    for info in z.infolist():
        assert info.date_time == (1980, 1, 1, 0, 0, 0), info
        assert info.external_attr >> 16 == 0o100644, info
        assert not info.filename.startswith('/') and '..' not in info.filename.split('/'), info
    z.extractall('.')
    sums = [line.split('  ') for line in z.read('SHA256SUMS').decode().splitlines()]
    assert [name for _, name in sums] == [name for name in names if name != 'SHA256SUMS']
    for digest, name in sums:
        assert hashlib.sha256(z.read(name)).hexdigest() == digest, name
";
    let output = run("python3", directory.path(), &["-c", script])?;
    assert!(output.status.success(), "{}", stderr(&output));
    Some(directory)
}

#[test]
fn three_verifiers_confirm_what_is_in_it_and_refuse_what_was_changed() {
    let Some(directory) = unpacked(&["a15", "square-14", "slab", "--no-pdf"]) else {
        return;
    };
    let certificates = directory.path().join("certificates");
    for name in ["a15", "square-14", "slab"] {
        let found = std::fs::read(certificates.join(format!("{name}.json"))).expect(name);
        let expected = std::fs::read(format!("certificates/{name}.json")).expect(name);
        assert_eq!(found, expected, "{name}");
        assert_eq!(verdicts(directory.path(), name), [Some(0); 4], "{name}");
        let shown = acutile(["convert", path(&certificates, name, "cbor").as_str(), "-"]);
        assert_eq!(shown.stdout, found, "{name}");
    }
    // A vertex of A15 moves; it is a certificate still, of something false.
    let text = std::fs::read_to_string(certificates.join("a15.json")).expect("a15");
    let (claim, witness) = text.split_at(text.find("\"witness\"").expect("a witness"));
    let moved = format!("{claim}{}", witness.replacen("[0,0,2]", "[0,0,1]", 1));
    assert_ne!(moved, text);
    let [json, cbor] = ["json", "cbor"].map(|encoding| path(&certificates, "a15", encoding));
    std::fs::write(&json, moved).expect("written");
    std::fs::remove_file(&cbor).expect("removed");
    assert_eq!(code(&acutile(["convert", json.as_str(), cbor.as_str()])), 0);
    assert_eq!(verdicts(directory.path(), "a15"), [Some(1); 4]);
}

fn path(folder: &Path, name: &str, encoding: &str) -> String {
    let path = folder.join(format!("{name}.{encoding}"));
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn of_cbor_python_reads_and_javascript_says_what_to_do() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let cbor = "tests/certificates/cbor/valid--slab-bcc.cbor";
    for (program, verifier, expected, words) in [
        ("python3", "verifiers/python/verify.py", 0, ": verified: "),
        (
            "node",
            "verifiers/javascript/verify-cli.mjs",
            3,
            ": declined [encoding] the certificate is in CBOR; `acutile convert F.cbor F.json`",
        ),
    ] {
        let Some(output) = run(program, here, &[verifier, cbor]) else {
            continue;
        };
        assert_eq!(code(&output), expected, "{program}");
        let line = stdout(&output);
        assert!(line.contains(words), "{line}");
    }
}

/// The exit codes of the three verifiers, of the one in Python for both encodings; that of a program that is
/// not there is what it must be.
fn verdicts(directory: &Path, name: &str) -> [Option<i32>; 4] {
    let [json, cbor] = ["json", "cbor"].map(|encoding| format!("certificates/{name}.{encoding}"));
    let rust = acutile_verify([directory.join(&cbor)]).status.code();
    let one = |program, verifier: &str, path: &str| match run(program, directory, &[verifier, path])
    {
        Some(output) => output.status.code(),
        None => rust,
    };
    [
        rust,
        one("python3", "verify/verify.py", &json),
        one("python3", "verify/verify.py", &cbor),
        one("node", "verify/verify-cli.mjs", &json),
    ]
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let (one, other) = (
        tempfile::tempdir().expect("a directory"),
        tempfile::tempdir().expect("a directory"),
    );
    let first = bundle(one.path(), &["a15", "square-8"]);
    let script = "umask 077; exec \"$0\" bundle a15 square-8 -o other-name.zip";
    let output = Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_acutile")])
        .current_dir(other.path())
        .envs([
            ("TZ", "Pacific/Kiritimati"),
            ("LC_ALL", "C"),
            ("SOURCE_DATE_EPOCH", "86400"),
        ])
        .output()
        .expect("a shell");
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let second = std::fs::read(other.path().join("other-name.zip")).expect("the archive");
    assert!(first == second);
}

#[test]
fn the_appendix_is_there_as_pdf_or_it_is_said_why_not() {
    let directory = tempfile::tempdir().expect("a directory");
    let has_tex = run("pdflatex", directory.path(), &["--version"]).is_some();
    let with = bundle(directory.path(), &["bcc"]);
    let without = bundle(directory.path(), &["bcc", "--no-pdf"]);
    let has = |bytes: &[u8], name: &str| bytes.windows(name.len()).any(|w| w == name.as_bytes());
    for name in ["appendix/main.pdf", "appendix/supplement.pdf"] {
        assert_eq!(has(&with, name), has_tex, "{name}");
        assert!(!has(&without, name), "{name}");
    }
    let output = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(["bundle", "bcc", "-o", "-"])
        .env("PATH", directory.path())
        .output()
        .expect("acutile runs");
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("pdflatex is not installed"));
    assert!(!has(&output.stdout, "appendix/main.pdf"));
}

#[test]
fn what_the_kernel_refuses_is_in_no_archive() {
    let directory = tempfile::tempdir().expect("a directory");
    let target = directory.path().join("artefact.zip");
    let mut hole = kuhn();
    hole["simplices"].as_array_mut().expect("simplices").pop();
    let hole = crate::common::file(directory.path(), "hole.json", &hole.to_string());
    let cases = [
        ("tests/certificates/false/not-acute--cube-6.json", 1),
        (
            "tests/certificates/malformed/canonical--gram-not-primitive.json",
            2,
        ),
        ("tests/certificates/declined/version--3.json", 3),
        (hole.to_str().expect("UTF-8"), 1),
        ("no-such-file.json", 2),
        // Two inputs that would have one name.
        ("certificates/a15.json", 2),
    ];
    for (input, expected) in cases {
        let inputs = [
            "bundle".as_ref(),
            "a15".as_ref(),
            input.as_ref(),
            "-o".as_ref(),
        ];
        let output = acutile(inputs.into_iter().chain([target.as_os_str()]));
        assert_eq!(code(&output), expected, "{input}: {}", stderr(&output));
        assert!(stderr(&output).starts_with("acutile: "), "{input}");
        assert!(!target.exists(), "{input}");
    }
    let own = acutile([
        "bundle".as_ref(),
        hole.as_os_str(),
        "-o".as_ref(),
        hole.as_os_str(),
    ]);
    assert_eq!(code(&own), 2);
    assert!(stderr(&own).contains("would overwrite"));
}

#[test]
fn regions_come_with_an_appendix() {
    let region = "tests/certificates/valid/region-cavity.json";
    let directory = tempfile::tempdir().expect("a directory");
    let target = directory.path().join("artefact.zip");
    let output = acutile([
        "bundle".as_ref(),
        region.as_ref(),
        "-o".as_ref(),
        target.as_os_str(),
    ]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(!stderr(&output).contains("about a region"));
    let Some(directory) = unpacked(&[region]) else {
        return;
    };
    assert!(directory.path().join("appendix/main.tex").exists());
    assert!(directory.path().join("tilings/region-cavity.msh").exists());
    let readme = std::fs::read_to_string(directory.path().join("README.md")).expect("a README");
    assert!(readme.contains("appendix/"));
}

/// The meshes are those of the tiling: read again, they have its tetrahedra.
#[test]
fn meshes_and_tilings_are_read_again() {
    let Some(directory) = unpacked(&["a15", "--no-pdf"]) else {
        return;
    };
    let tilings = directory.path().join("tilings");
    let proved = acutile([
        "certify".as_ref(),
        tilings.join("a15.json").as_os_str(),
        "-o".as_ref(),
        "-".as_ref(),
    ]);
    assert_eq!(code(&proved), 0, "{}", stderr(&proved));
    assert_eq!(
        proved.stdout,
        std::fs::read("certificates/a15.json").expect("a15")
    );
    // No coordinate of A15 is rounded, so that its meshes are the tiling. Its Gram matrix is the identity.
    for extension in ["msh", "vtu", "mesh"] {
        let path = tilings.join(format!("a15.{extension}"));
        let lattice = [
            "--lattice",
            "1,0,0;0,1,0;0,0,1",
            "--identify",
            "0",
            "--require",
            "tcp",
            "-o",
            "-",
        ];
        let arguments = [OsStr::new("certify"), path.as_os_str()];
        let output = acutile(arguments.into_iter().chain(lattice.map(OsStr::new)));
        assert_eq!(code(&output), 0, "{extension}: {}", stderr(&output));
        let certificate = stdout(&output);
        let (_, rows) = certificate.split_once("\"simplices\":[\n").expect("rows");
        assert_eq!(rows.matches("\n[").count() + 1, 46, "{extension}");
    }
}

#[test]
fn the_checker_in_python_agrees() {
    let program = verifier();
    let program = program.to_str().expect("a path in UTF-8");
    let script = "tests/bundle/certificates.py";
    let Some(output) = run(
        "python3",
        Path::new(env!("CARGO_MANIFEST_DIR")),
        &[script, program],
    ) else {
        return;
    };
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(stdout(&output).contains("verify.py agrees"));
}

#[test]
fn the_citation_is_of_this_version() {
    let text = std::fs::read_to_string("CITATION.cff").expect("CITATION.cff");
    let version = format!("\nversion: {}\n", env!("CARGO_PKG_VERSION"));
    assert!(text.starts_with("cff-version: 1.2.0\n") && text.contains(&version));
}

/// The author is cited, not the program; and the same input gives the same bytes.
#[test]
fn the_archive_is_in_the_name_of_its_author() {
    let arguments = [
        "bcc",
        "--no-pdf",
        "--title",
        "A \"title\": with signs",
        "--author",
        "Carberry, Josiah <0000-0002-1825-0097>",
        "--licence",
        "CC-BY-4.0",
        "--doi",
        "10.5281/zenodo.1",
        "--paper",
        "https://doi.org/10.1000/182",
    ];
    let Some(directory) = unpacked(&arguments) else {
        return;
    };
    let text = |name: &str| std::fs::read_to_string(directory.path().join(name)).expect(name);
    let citation = text("CITATION.cff");
    for line in [
        "type: dataset",
        "title: \"A \\\"title\\\": with signs\"",
        "  - family-names: \"Carberry\"",
        "    orcid: \"https://orcid.org/0000-0002-1825-0097\"",
        "doi: \"10.5281/zenodo.1\"",
    ] {
        assert!(citation.lines().any(|other| other == line), "{line}");
    }
    let zenodo: serde_json::Value = serde_json::from_str(&text(".zenodo.json")).expect("JSON");
    assert_eq!(zenodo["creators"][0]["name"], "Carberry, Josiah");
    assert_eq!(zenodo["license"], "cc-by-4.0");
    assert_eq!(
        zenodo["related_identifiers"][0]["identifier"],
        "10.1000/182"
    );
    assert!(text("README.md").starts_with("# A \"title\": with signs\n"));
    assert!(text("CLAIMS.md").contains("## Not proved"));
    let other = tempfile::tempdir().expect("a directory");
    let (first, second) = (
        bundle(directory.path(), &arguments),
        bundle(other.path(), &arguments),
    );
    assert!(first == second);
    if let Some(output) = run("make", directory.path(), &["check"]) {
        assert!(output.status.success(), "{}", stderr(&output));
        assert!(stdout(&output).contains("certificates/bcc.json: verified"));
    }
    let wrong = acutile(["bundle", "bcc", "-o", "-", "--author", "Josiah"]);
    assert_eq!(code(&wrong), 2);
}
