//! `acutile-verify` as a person or a script meets it.

use std::fs;
use std::io::Write;
use std::process::{Command, Output, Stdio};

fn run(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_acutile-verify"));
    let folder = concat!(
        concat!(env!("CARGO_MANIFEST_DIR"), "/../.."),
        "/tests/certificates"
    );
    command.args(arguments).current_dir(folder);
    command
}

fn code(arguments: &[&str]) -> i32 {
    run(arguments).status.code().unwrap()
}

fn stdout(arguments: &[&str]) -> String {
    String::from_utf8(run(arguments).stdout).unwrap()
}

const VALID: &str = "valid/space-bcc.json";
const FALSE: &str = "false/not-acute--cube-6.json";
const MALFORMED: &str = "malformed/json--empty.json";
const DECLINED: &str = "declined/version--2.json";

#[test]
fn exit_codes_of_one_file() {
    assert_eq!(
        [VALID, FALSE, MALFORMED, DECLINED].map(|file| code(&[file])),
        [0, 1, 2, 3]
    );
}

#[test]
fn the_exit_code_of_several_files_is_the_first_of_1_2_3() {
    assert_eq!(code(&[VALID, VALID]), 0);
    assert_eq!(code(&[DECLINED, VALID]), 3);
    assert_eq!(code(&[DECLINED, MALFORMED, VALID]), 2);
    assert_eq!(code(&[VALID, DECLINED, MALFORMED, FALSE]), 1);
    assert_eq!(code(&[FALSE, VALID]), 1);
}

#[test]
fn one_line_for_each_file() {
    let text = stdout(&[VALID, FALSE, MALFORMED, DECLINED]);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 4);
    assert!(lines[0].starts_with("valid/space-bcc.json: verified: three-space is tiled"));
    assert!(lines[1].starts_with("false/not-acute--cube-6.json: rejected [not-acute] "));
    assert!(lines[2].starts_with("malformed/json--empty.json: malformed [json] "));
    assert_eq!(
        lines[3],
        "declined/version--2.json: declined [version] version 2 is unknown; this program knows 1"
    );
}

#[test]
fn the_claim_is_said_in_words() {
    let text = stdout(&[VALID]);
    let words = "three-space is tiled face to face by 6 tetrahedra and their translates under the \
        lattice whose basis has the Gram matrix [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]]; no \
        dihedral angle is obtuse; all dihedral angles are below 90.5 degrees; ";
    assert!(text.contains(words), "{text}");
    assert!(text.contains("(1 vertex, 6 simplices, sha256 "), "{text}");
}

/// The hash is that of coreutils.
#[test]
fn the_hash_is_sha_256_of_the_bytes() {
    let folder = concat!(
        concat!(env!("CARGO_MANIFEST_DIR"), "/../.."),
        "/tests/certificates"
    );
    let Ok(output) = Command::new("sha256sum")
        .arg(VALID)
        .current_dir(folder)
        .output()
    else {
        return;
    };
    let expected = String::from_utf8(output.stdout).unwrap();
    let expected = expected.split_whitespace().next().unwrap();
    assert!(stdout(&[VALID]).contains(&format!("sha256 {expected})")));
}

#[test]
fn json_is_one_object_a_line() {
    let text = stdout(&["--json", VALID, FALSE, "missing.json"]);
    let objects: Vec<serde_json::Value> = text
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(objects.len(), 3);
    assert_eq!(objects[0]["verdict"], "verified");
    assert_eq!(objects[0]["claim"]["dimension"], 3);
    assert_eq!(objects[0]["simplices"], 6);
    assert_eq!(objects[1]["code"], "not-acute");
    assert_eq!(objects[1]["verdict"], "rejected");
    assert_eq!(objects[2]["verdict"], "unreadable");
}

#[test]
fn standard_input() {
    let bytes = fs::read(format!(
        "{}/tests/certificates/{VALID}",
        concat!(env!("CARGO_MANIFEST_DIR"), "/../..")
    ));
    let mut child = command(&["-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(&bytes.unwrap())
        .unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stdout.starts_with(b"-: verified: "));
}

#[test]
fn directory_and_missing_file() {
    for file in ["valid", "missing.json"] {
        let output = run(&[file]);
        assert_eq!(output.status.code(), Some(2));
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.starts_with(&format!("{file}: unreadable: ")), "{text}");
    }
}

/// A sparse file of 200 MB is refused after limit + 1 bytes.
#[test]
fn a_huge_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("huge.json");
    fs::File::create(&path).unwrap().set_len(200 << 20).unwrap();
    let output = run(&[path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(3));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("declined [too-many-bytes] at least 33554433 bytes"),
        "{text}"
    );
}

#[test]
fn limits_are_options() {
    assert_eq!(code(&["--limit-simplices", "5", VALID]), 3);
    assert_eq!(code(&["--limit-simplices=6", VALID]), 0);
    for limit in ["bytes", "digits", "work", "simplices"] {
        assert_eq!(code(&[&format!("--limit-{limit}=0"), VALID]), 3, "{limit}");
    }
    for limit in ["degree", "bisections"] {
        let file = "valid/plane-square-triangle.json";
        assert_eq!(code(&[&format!("--limit-{limit}=0"), file]), 3, "{limit}");
    }
    assert_eq!(
        code(&[
            "--limit-digits=1001",
            "declined/too-many-digits--numerator.json"
        ]),
        0
    );
}

#[test]
fn wrong_command_lines() {
    for arguments in [
        &[][..],
        &["--sabotage", VALID],
        &["--limit-bytes", "x", VALID],
        &["--limit-work"],
    ] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty());
        assert!(output.stderr.starts_with(b"acutile-verify: "));
    }
}

#[test]
fn help_and_version() {
    assert!(stdout(&["--help"]).contains("Usage: acutile-verify"));
    assert_eq!(code(&["--help"]), 0);
    let version = format!("acutile-verify {}\n", env!("CARGO_PKG_VERSION"));
    assert_eq!(stdout(&["--version"]), version);
}

/// The defaults in the help are those of the kernel.
#[test]
fn the_help_tells_the_limits() {
    let limits = acutile_format1::verifier::Limits::DEFAULT;
    let text = stdout(&["--help"]);
    let numbers = [
        limits.bytes,
        limits.work,
        limits.simplices as u64,
        limits.digits as u64,
    ];
    for number in numbers
        .into_iter()
        .chain([limits.degree as u64, limits.bisections as u64])
    {
        assert!(text.contains(&format!("[{number}]")), "{number}");
    }
}

/// Nobody reads: no panic, and no success either.
#[test]
fn a_broken_pipe() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let output = command(&[VALID])
        .stdout(writer)
        .stderr(Stdio::piped())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(
        !String::from_utf8(output.stderr)
            .unwrap()
            .contains("panicked")
    );
}

/// Neither a file's name nor a text in it can forge a line or reach the terminal.
#[test]
#[cfg(unix)]
fn nothing_forges_a_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x\nvalid.json: verified: \x1b[2J");
    let source = format!(
        "{}/tests/certificates/malformed/",
        concat!(env!("CARGO_MANIFEST_DIR"), "/../..")
    );
    fs::copy(source + "format--control-characters.json", &path).unwrap();
    let text = stdout(&[path.to_str().unwrap()]);
    assert_eq!(text.lines().count(), 1);
    assert!(!text.contains('\x1b'));
    assert!(text.contains("malformed [format]"), "{text}");
}

/// A name cannot pass for a name and a verdict: what is unusual is a JSON string.
#[test]
fn unusual_names_are_json_strings() {
    let cases = [
        ("x: verified: y.json", r#""x: verified: y.json""#),
        ("a\"b\\c", r#""a\"b\\c""#),
        (
            "\u{e9}\n\u{202e}\u{1d54f}\x7f",
            r#""\u00e9\u000a\u202e\ud835\udd4f\u007f""#,
        ),
        ("", r#""""#),
        ("\"", r#""\"""#),
        ("a/B-0_+=@%~.json", "a/B-0_+=@%~.json"),
    ];
    for (file, printed) in cases {
        let text = stdout(&[file]);
        assert!(
            text.starts_with(&format!("{printed}: unreadable: ")),
            "{text}"
        );
        if printed.starts_with('"') {
            assert_eq!(serde_json::from_str::<String>(printed).unwrap(), file);
        }
    }
}
