//! `acutile bundle`: the content of an archive, and that it depends on nothing but its input. A referee's
//! three programs accept its certificates, and refuse changed ones.
//!
//! A test that needs Python 3, Node 20, make or TeX is ignored, so that `cargo test` needs Rust
//! alone; `cargo test -- --ignored` runs it.

use crate::common::{acutile, acutile_verify, code, kuhn, stderr, stdout, verifier};
use std::ffi::OsStr;
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

/// Runs a program that must be there.
fn run(program: &str, directory: &Path, arguments: &[&str]) -> Output {
    Command::new(program)
        .args(arguments)
        .current_dir(directory)
        .output()
        .unwrap_or_else(|error| panic!("{program} does not run: {error}"))
}

/// An archive taken apart by Python's zipfile.
fn unpacked(arguments: &[&str]) -> tempfile::TempDir {
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
    let output = run("python3", directory.path(), &["-c", script]);
    assert!(output.status.success(), "{}", stderr(&output));
    directory
}

#[test]
#[ignore = "needs python3 and node 20"]
fn three_verifiers_confirm_what_is_in_it_and_refuse_what_was_changed() {
    let tilings = ["a15", "square-14", "slab"];
    let theorems = ["goldberg-1-all", "square-triangle-all"];
    let names = [&tilings[..], &theorems].concat();
    let directory = unpacked(&[&names[..], &["--no-pdf"]].concat());
    let certificates = directory.path().join("certificates");
    for name in names {
        let found = std::fs::read(certificates.join(format!("{name}.json"))).expect(name);
        let expected = std::fs::read(format!("certificates/{name}.json")).expect(name);
        assert_eq!(found, expected, "{name}");
        assert_eq!(verdicts(directory.path(), name), [Some(0); 4], "{name}");
        let shown = acutile(["convert", path(&certificates, name, "cbor").as_str(), "-"]);
        assert_eq!(shown.stdout, found, "{name}");
    }
    for (names, are_there) in [(tilings.as_slice(), true), (&theorems, false)] {
        for name in names {
            let tiling = directory.path().join(format!("tilings/{name}.json"));
            assert_eq!(tiling.exists(), are_there, "{name}");
        }
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
#[ignore = "needs python3 and node 20"]
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
        let output = run(program, here, &[verifier, cbor]);
        assert_eq!(code(&output), expected, "{program}");
        let line = stdout(&output);
        assert!(line.contains(words), "{line}");
    }
}

/// The exit codes of the three verifiers, of the one in Python for both encodings.
fn verdicts(directory: &Path, name: &str) -> [Option<i32>; 4] {
    let [json, cbor] = ["json", "cbor"].map(|encoding| format!("certificates/{name}.{encoding}"));
    let rust = acutile_verify([directory.join(&cbor)]).status.code();
    let one = |program, verifier: &str, path: &str| {
        run(program, directory, &[verifier, path]).status.code()
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
#[ignore = "needs pdflatex"]
fn the_appendix_is_there_as_pdf() {
    let directory = tempfile::tempdir().expect("a directory");
    let with = bundle(directory.path(), &["bcc"]);
    for name in PDFS {
        assert!(has(&with, name), "{name}");
    }
}

#[test]
fn without_tex_the_archive_has_no_pdf_and_says_why() {
    let directory = tempfile::tempdir().expect("a directory");
    let without = bundle(directory.path(), &["bcc", "--no-pdf"]);
    let output = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(["bundle", "bcc", "-o", "-"])
        .env("PATH", directory.path())
        .output()
        .expect("acutile runs");
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("pdflatex is not installed"));
    for name in PDFS {
        assert!(!has(&without, name), "{name}");
        assert!(!has(&output.stdout, name), "{name}");
    }
}

const PDFS: [&str; 2] = ["appendix/main.pdf", "appendix/supplement.pdf"];

/// Whether an archive has a file. The names in it are not compressed.
fn has(archive: &[u8], name: &str) -> bool {
    archive.windows(name.len()).any(|w| w == name.as_bytes())
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
#[ignore = "needs python3"]
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
    let directory = unpacked(&[region]);
    assert!(directory.path().join("appendix/main.tex").exists());
    assert!(directory.path().join("tilings/region-cavity.msh").exists());
    let readme = std::fs::read_to_string(directory.path().join("README.md")).expect("a README");
    assert!(readme.contains("appendix/"));
}

/// The meshes are those of the tiling: read again, they have its tetrahedra.
#[test]
#[ignore = "needs python3"]
fn meshes_and_tilings_are_read_again() {
    let directory = unpacked(&["a15", "--no-pdf"]);
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
#[ignore = "needs python3"]
fn the_checker_in_python_agrees() {
    let program = verifier();
    let program = program.to_str().expect("a path in UTF-8");
    let script = "tests/bundle/certificates.py";
    let output = run(
        "python3",
        Path::new(env!("CARGO_MANIFEST_DIR")),
        &[script, program],
    );
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
#[ignore = "needs python3, node 20 and make"]
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
    let directory = unpacked(&arguments);
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
    let checked = run("make", directory.path(), &["check"]);
    assert!(checked.status.success(), "{}", stderr(&checked));
    assert!(stdout(&checked).contains("certificates/bcc.json: verified"));
    assert!(stdout(&checked).contains("as expected"));
    // A certificate that was exchanged is found.
    let other = directory.path().join("certificates/bcc.json");
    std::fs::copy("certificates/a15.json", other).expect("a certificate");
    let checked = run("make", directory.path(), &["python"]);
    assert!(!checked.status.success(), "{}", stdout(&checked));
    let wrong = acutile(["bundle", "bcc", "-o", "-", "--author", "Josiah"]);
    assert_eq!(code(&wrong), 2);
}

/// With cargo, an empty CARGO_HOME and no network the archive's own sources make a verifier, which reads its certificates and
/// refuses what was changed.
#[test]
#[ignore = "needs a minute: builds the kernel"]
fn the_kernel_is_built_without_network() {
    let directory = unpacked(&["bcc", "square-8", "--no-pdf"]);
    let (home, sources) = (
        directory.path().join("home"),
        directory.path().join("verify/rust"),
    );
    let output = Command::new(env!("CARGO"))
        .args(["build", "--offline", "--locked"])
        .current_dir(&sources)
        .env("CARGO_HOME", &home)
        .env("CARGO_NET_OFFLINE", "true")
        .env_remove("CARGO_TARGET_DIR")
        // Flags of the environment would replace those of .cargo/config.toml.
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo");
    assert!(output.status.success(), "{}", stderr(&output));
    let verified = |file: &str| {
        let output = Command::new(sources.join("target/debug/acutile-verify"))
            .arg(directory.path().join(file))
            .output()
            .expect("the verifier");
        output.status.code()
    };
    assert_eq!(verified("certificates/bcc.cbor"), Some(0));
    assert_eq!(verified("certificates/square-8.cbor"), Some(0));
    let path = directory.path().join("certificates/bcc.cbor");
    let mut bytes = std::fs::read(&path).expect("a certificate");
    bytes.pop();
    std::fs::write(&path, bytes).expect("written");
    assert_eq!(verified("certificates/bcc.cbor"), Some(2));
}

/// The claims of a tiling, of a family and of a system of patches as theorems.
#[test]
fn theorems_for_coq_come_where_they_are_asked_for() {
    let directory = unpacked(&["bcc", "goldberg-1-all", "kagome-all", "--coq", "--no-pdf"]);
    for name in ["bcc", "goldberg-1-all", "kagome-all"] {
        let certificate = directory.path().join(format!("certificates/{name}.cbor"));
        let words = ["export", "--coq"].map(OsStr::new);
        let exported = acutile(words.into_iter().chain([certificate.as_os_str()]));
        let theorem = directory.path().join(format!("coq/{name}.v"));
        assert_eq!(std::fs::read(theorem).expect(name), exported.stdout);
    }
}

/// The citation is BibTeX with the digest that the verifier prints, and a paragraph that says what was not proved.
#[test]
fn a_certificate_is_cited_with_its_digest_and_scope() {
    let run = acutile(["cite", "certificates/a15.json"]);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    let text = stdout(&run);
    let verified = stdout(&acutile(["verify", "certificates/a15.json"]));
    let (_, digest) = verified.split_once("sha256 ").expect("a digest");
    let digest = digest.trim_end().trim_end_matches(')');
    assert_eq!(text.matches(digest).count(), 2, "{text}");
    // Outside of entries there is no at sign, at which BibTeX would begin one.
    assert_eq!(text.matches('@').count(), 2, "{text}");
    for words in [
        "@misc{a15-certificate,",
        "acutile export --coq",
        "Not proved: the name",
    ] {
        assert!(text.contains(words), "{words}");
    }
    // The catalogue names section 4.1 of the paper.
    let named = stdout(&acutile(["cite", "sigma"]));
    assert!(
        named.contains("@article{EppsteinSullivanUngor2004,"),
        "{named}"
    );
    let cite = |path| stdout(&acutile(["cite", path])).replace('\n', " ");
    let family = cite("certificates/z-all.json");
    assert!(family.contains("acutile export --coq"), "{family}");
    let not_delaunay = cite("certificates/two-corners-all.json");
    assert!(
        not_delaunay.contains("acutile export --coq"),
        "{not_delaunay}"
    );
    let patches = cite("certificates/kagome-all.json");
    assert!(patches.contains("acutile export --coq"), "{patches}");
    for (input, expected) in [
        ("tests/certificates/false/not-acute--cube-6.json", 1),
        ("no-such-file", 2),
    ] {
        let run = acutile(["cite", input]);
        assert_eq!(
            (code(&run), stdout(&run).as_str()),
            (expected, ""),
            "{input}"
        );
    }
}

/// `cffconvert` reads the file as the schema of CITATION.cff says.
#[test]
#[ignore = "needs cffconvert"]
fn the_citation_file_is_valid() {
    let author = [
        "--author",
        "Carberry, Josiah <0000-0002-1825-0097>",
        "--licence",
        "CC-BY-4.0",
        "--doi",
        "10.5281/zenodo.1",
    ];
    let directory = unpacked(&[&["bcc", "--no-pdf"][..], &author].concat());
    for folder in [directory.path(), Path::new(env!("CARGO_MANIFEST_DIR"))] {
        let checked = run("cffconvert", folder, &["--validate", "-i", "CITATION.cff"]);
        assert!(checked.status.success(), "{}", stderr(&checked));
    }
}
