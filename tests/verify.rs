//! `acutile verify` as a person or a script meets it: both encodings, words, limits, names.

use crate::common::{acutile, acutile_verify, code, stdout};
use acutile_kernel::Limits;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Output, Stdio};

const VALID: &str = "valid/space-bcc.json";
const FALSE: &str = "false/not-acute--cube-6.json";
const MALFORMED: &str = "malformed/json--claim-as-array.json";
const DECLINED: &str = "declined/version--3.json";

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_acutile"));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/certificates");
    command.arg("verify").args(arguments).current_dir(folder);
    command
}

fn run(arguments: &[&str]) -> Output {
    command(arguments).output().expect("acutile runs")
}

fn exit_code(arguments: &[&str]) -> i32 {
    code(&run(arguments))
}

fn lines(arguments: &[&str]) -> Vec<String> {
    stdout(&run(arguments)).lines().map(str::to_owned).collect()
}

/// The certificates of a folder of tests/certificates, by name.
fn files(folder: &str) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/certificates");
    let entries = fs::read_dir(path.join(folder)).expect(folder);
    let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("ASCII");
    let mut names: Vec<String> = entries
        .map(|entry| name(entry.expect("an entry")))
        .collect();
    names.sort();
    names.into_iter().map(|n| format!("{folder}/{n}")).collect()
}

/// The option and the value that the end of a name demands: `…--limit-bits-5`, `…--max-bits-5`.
fn limit(file: &str) -> Option<String> {
    let stem = file.rsplit_once('.').expect("an extension").0;
    let (_, limit) = stem
        .rsplit_once("--limit-")
        .or(stem.rsplit_once("--max-"))?;
    let (name, value) = limit.rsplit_once('-').expect("a value");
    Some(format!("--max-{name}={value}"))
}

/// The code that a name demands; none of a valid certificate.
fn expected(file: &str) -> Option<&str> {
    let (folder, name) = file.split_once('/').expect("a folder");
    let code = name.split("--").next().expect("a code");
    (folder != "valid" && code != "valid").then_some(code)
}

/// `cbor` is called `json` in JSON, whether the transcription or the kernel finds it.
fn is_code(found: &Value, expected: &str) -> bool {
    found == expected || (found == "cbor" && expected == "json")
}

/// The names of the files demand verdict and code. tests/certificates/make.py, which shares no code with
/// the program, has computed them.
#[test]
fn every_file_gets_the_verdict_of_its_name() {
    let mut wrong = Vec::new();
    let mut codes = BTreeSet::new();
    for (folder, verdict, least) in [
        ("valid", "verified", 100),
        ("false", "rejected", 250),
        ("malformed", "malformed", 250),
        ("declined", "declined", 40),
        ("cbor", "", 130),
    ] {
        let files = files(folder);
        assert!(files.len() >= least, "{folder}: {}", files.len());
        let (limited, plain): (Vec<String>, Vec<String>) =
            files.into_iter().partition(|file| limit(file).is_some());
        let mut answers = answers(&plain, None);
        for file in &limited {
            answers.extend(self::answers(std::slice::from_ref(file), limit(file)));
        }
        for (file, answer) in plain.iter().chain(&limited).zip(answers) {
            let is_right = match expected(file) {
                None => answer["verdict"] == "verified",
                Some(code) => {
                    codes.insert(code.to_owned());
                    is_code(&answer["code"], code)
                        && (verdict.is_empty() || answer["verdict"] == verdict)
                }
            };
            if !is_right {
                wrong.push(format!("{file}: {answer}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(codes.len() > 50, "{codes:?}");
}

fn answers(files: &[String], limit: Option<String>) -> Vec<Value> {
    let mut arguments = vec!["--json"];
    arguments.extend(limit.as_deref());
    arguments.extend(files.iter().map(String::as_str));
    let answers: Vec<Value> = lines(&arguments)
        .iter()
        .map(|line| serde_json::from_str(line).expect("an object"))
        .collect();
    assert_eq!(answers.len(), files.len());
    answers
}

#[test]
fn exit_codes_of_one_file() {
    assert_eq!(
        [VALID, FALSE, MALFORMED, DECLINED].map(|file| exit_code(&[file])),
        [0, 1, 2, 3]
    );
}

#[test]
fn the_exit_code_of_several_files_is_the_first_of_1_2_3() {
    assert_eq!(exit_code(&[VALID, VALID]), 0);
    assert_eq!(exit_code(&[DECLINED, VALID]), 3);
    assert_eq!(exit_code(&[DECLINED, MALFORMED, VALID]), 2);
    assert_eq!(exit_code(&[VALID, DECLINED, MALFORMED, FALSE]), 1);
    assert_eq!(exit_code(&[FALSE, VALID]), 1);
}

#[test]
fn one_line_for_each_file() {
    let lines = lines(&[VALID, FALSE, MALFORMED, DECLINED]);
    assert_eq!(lines.len(), 4);
    assert!(lines[0].starts_with("valid/space-bcc.json: verified: three-space is tiled"));
    assert!(lines[1].starts_with("false/not-acute--cube-6.json: rejected [not-acute] "));
    assert!(lines[2].starts_with("malformed/json--claim-as-array.json: malformed [json] "));
    assert!(lines[3].starts_with("declined/version--3.json: declined [version] "));
}

/// Sommerville's tetrahedron of bcc has angles of 60 and 90 degrees, and R² / l² = 5/12 (docs/soundness.md).
#[test]
fn the_claim_is_said_in_words() {
    let line = lines(&[VALID]).concat();
    let words = "three-space is tiled face to face by 6 tetrahedra and their translates under the \
        lattice whose basis has the Gram matrix [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]]; no \
        dihedral angle is obtuse; all dihedral angles are at most 90 degrees, attained; \
        all dihedral angles are at least 60 degrees, attained; ";
    assert!(line.contains(words), "{line}");
    assert!(line.contains("(1 vertex, 6 simplices, sha256 "), "{line}");
}

/// The hash is that of coreutils, of the CBOR, for both encodings.
#[test]
#[ignore = "needs sha256sum"]
fn the_hash_is_sha_256_of_the_cbor() {
    let folder = tempfile::tempdir().expect("a directory");
    let json = "tests/certificates/valid/space-bcc.json";
    let cbor = folder.path().join("bcc.cbor");
    let cbor = cbor.to_str().expect("UTF-8");
    assert_eq!(code(&acutile(["convert", json, cbor])), 0);
    let output = Command::new("sha256sum").arg(cbor).output();
    let output = output.expect("sha256sum runs");
    let expected = stdout(&output)[..64].to_owned();
    for line in [
        stdout(&acutile(["verify", json])),
        stdout(&acutile(["verify", cbor])),
        stdout(&acutile_verify([cbor])),
    ] {
        assert!(line.contains(&format!("sha256 {expected}")), "{line}");
    }
}

#[test]
fn json_is_one_object_a_line() {
    let objects: Vec<Value> = lines(&["--json", VALID, FALSE, "missing.json"])
        .iter()
        .map(|line| serde_json::from_str(line).expect("an object"))
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
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/certificates");
    for file in [VALID, "cbor/valid--slab-bcc.cbor"] {
        let input = File::open(folder.join(file)).expect(file);
        let output = command(&["-"]).stdin(Stdio::from(input)).output();
        let output = output.expect("acutile runs");
        assert_eq!(code(&output), 0, "{file}");
        assert!(output.stdout.starts_with(b"-: verified: "));
    }
}

#[test]
fn directory_and_missing_file() {
    for file in ["valid", "missing.json"] {
        let output = run(&[file]);
        assert_eq!(code(&output), 2);
        let text = stdout(&output);
        assert!(text.starts_with(&format!("{file}: unreadable: ")), "{text}");
    }
}

/// Sparse files of 40 GB, which are larger than the limit: nothing is read but the beginning.
#[test]
fn huge_files_are_declined() {
    let folder = tempfile::tempdir().expect("a directory");
    for begin in ["{\"format\":\"acutile-certificate\"", "\u{0}", " "] {
        let path = folder.path().join("huge");
        fs::write(&path, begin).expect("written");
        let file = File::options().write(true).open(&path).expect("opened");
        file.set_len(40 << 30).expect("a sparse file");
        let output = run(&[path.to_str().expect("UTF-8")]);
        let text = stdout(&output);
        if begin == "\u{0}" {
            assert_eq!(code(&output), 2, "no array begins so: {text}");
        } else {
            assert_eq!(code(&output), 3, "{text}");
            assert!(text.contains("declined [too-many-bytes]"), "{text}");
            assert!(text.contains("--max-bytes 42949672960"), "{text}");
        }
    }
}

/// A refusal by a limit names the option, and a value that suffices.
#[test]
fn limits_are_options() {
    assert_eq!(exit_code(&["--max-simplices=6", VALID]), 0);
    let field = "valid/plane-square-triangle.json";
    for (option, file, enough) in [
        ("--max-simplices=0", VALID, Some(6)),
        (
            "--max-bits=64",
            "valid/region-integers-at-limits.json",
            None,
        ),
        ("--max-bytes=0", VALID, None),
        ("--max-work=0", VALID, None),
        ("--max-degree=0", field, Some(2)),
    ] {
        let line = lines(&[option, file]).concat();
        let option = option.split('=').next().expect("a name");
        assert!(line.contains(": declined ["), "{line}");
        assert!(line.contains(option), "{line}");
        let value = line.split(&format!("{option} ")).nth(1);
        let value: Option<u64> = value.and_then(|rest| rest.split(' ').next()?.parse().ok());
        if let Some(enough) = enough {
            assert_eq!(value, Some(enough), "{line}");
        }
        // The value suffices for the check that refused.
        if let Some(value) = value {
            let next = lines(&[&format!("{option}={value}"), file]).concat();
            assert!(next != line, "{line}");
        }
    }
    // The length of the JSON is enough for both encodings: the CBOR is shorter.
    let line = lines(&["--max-bytes=10", VALID]).concat();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/certificates");
    let length = fs::metadata(folder.join(VALID)).expect("a file").len();
    assert!(line.contains(&format!("--max-bytes {length}")), "{line}");
}

/// A wrong certificate in JSON is named by line and column, and not by a byte of its CBOR. The columns are
/// those of the items in the lines here, counted by hand.
#[test]
fn lines_of_json() {
    let place = tempfile::tempdir().expect("a directory");
    let whole = place.path().join("a15.json");
    let whole = whole.to_str().expect("UTF-8");
    assert_eq!(code(&acutile(["certify", "a15", "-o", whole])), 0);
    let text = fs::read_to_string(whole).expect("written");
    let wrong = place.path().join("wrong.json");
    let page = place.path().join("page.html");
    let page = page.to_str().expect("UTF-8");
    for (right, other, words) in [
        (
            "\"dimension\":3",
            "\"dimension\":4",
            "[dimension] line 6, column 13 (\"dimension\":4): expected the dimension 2 or 3",
        ),
        (
            "\"acute\"",
            "\"cute\"",
            "[statements] line 16, column 1 (\"cute\"): ",
        ),
        (
            "\"maximum\",1,[1,25]",
            "\"maximun\",1,[1,25]",
            "line 17, column 27 ([\"largest dihedral angle\",\"maximun\",1,[1,25]]): ",
        ),
        (
            "\"boundary\":[]",
            "\"boundary\":7",
            "[cbor] line 39, column 12 (\"boundary\":7): expected an item that the format allows here",
        ),
        (
            "\"boundary\"",
            "\"bundary\"",
            "[json] line 27, column 11 (\"witness\":{): the members are not those",
        ),
    ] {
        let changed = text.replacen(right, other, 1);
        let at = changed.find(other).expect("the text is changed");
        let line = changed[..at].lines().count();
        fs::write(&wrong, &changed).expect("written");
        let answer = stdout(&run(&[wrong.to_str().expect("UTF-8")]));
        assert!(answer.contains(words), "line {line}: {answer}");
        // Commands that show certificates say the same.
        let report = acutile(["report", wrong.to_str().expect("UTF-8"), "-o", page]);
        let report = String::from_utf8_lossy(&report.stderr).into_owned();
        assert!(report.contains(words), "line {line}: {report}");
    }
}

/// Files of the project that are no certificates, and none that are no claims.
#[test]
fn other_files_of_the_project() {
    let place = tempfile::tempdir().expect("a directory");
    let tiling = place.path().join("z.json");
    let tiling = tiling.to_str().expect("UTF-8");
    assert_eq!(code(&acutile(["export", "z", "-o", tiling])), 0);
    let answer = stdout(&run(&[tiling]));
    assert!(
        answer.contains("found the format acutile-tiling, expected a certificate"),
        "{answer}"
    );
    for (claim, found) in [
        (VALID, "the format \"acutile-certificate\""),
        ("/dev/null", "no claim"),
    ] {
        let output = run(&[VALID, "--claim", claim]);
        let words = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(code(&output), 2, "{words}");
        let expected = format!("--claim: {claim}: found {found}, expected a claim file");
        assert!(words.contains(&expected), "{words}");
    }
}

#[test]
fn wrong_command_lines() {
    for arguments in [
        &[][..],
        &["--sabotage", VALID],
        &["--max-bytes", "x", VALID],
        &["--max-work"],
        &["--claim", "no-such-file", VALID],
    ] {
        let output = run(arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(output.stdout.is_empty());
        assert!(!output.stderr.is_empty());
    }
}

/// The defaults in the help are those of the kernel.
#[test]
fn the_help_tells_the_limits() {
    let limits = Limits::DEFAULT;
    let text = stdout(&run(&["--help"]));
    for number in [
        limits.bytes,
        limits.work,
        limits.simplices,
        limits.bits,
        limits.degree as u64,
    ] {
        assert!(text.contains(&format!("[default: {number}]")), "{number}");
    }
}

/// Nobody reads: no panic, and no success either.
#[test]
fn a_broken_pipe() {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let output = command(&[FALSE])
        .stdout(writer)
        .stderr(Stdio::piped())
        .output()
        .expect("acutile runs");
    assert_eq!(code(&output), 1, "the verdict stays");
    assert!(!String::from_utf8_lossy(&output.stderr).contains("panicked"));
}

/// Neither a file's name nor a text in it can forge a line or reach the terminal.
#[test]
#[cfg(unix)]
fn nothing_forges_a_line() {
    let folder = tempfile::tempdir().expect("a directory");
    let path = folder.path().join("x\nvalid.json: verified: \x1b[2J");
    let text = "{\n\"format\":\"a\\nb.json: verified: \\u001b[2J\"}";
    fs::write(&path, text).expect("written");
    let text = stdout(&run(&[path.to_str().expect("UTF-8")]));
    assert_eq!(text.lines().count(), 1);
    assert!(!text.contains('\x1b'));
    assert!(text.contains("malformed [json]"), "{text}");
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
        let text = stdout(&run(&[file]));
        assert!(
            text.starts_with(&format!("{printed}: unreadable: ")),
            "{text}"
        );
        if printed.starts_with('"') {
            let name: String = serde_json::from_str(printed).expect("a string");
            assert_eq!(name, file);
        }
    }
}

/// A certificate proves the claim of the file that the kernel prints for it, and no other.
#[test]
fn claims_are_compared() {
    let folder = tempfile::tempdir().expect("a directory");
    let claim = folder.path().join("claim.json");
    let cbor = "tests/certificates/cbor/valid--slab-bcc.cbor";
    let printed = acutile_verify(["--print-claim", cbor]);
    assert_eq!(code(&printed), 0);
    fs::write(&claim, &printed.stdout).expect("written");
    let claim = claim.to_str().expect("UTF-8");
    let json = "tests/certificates/valid/slab-bcc.json";
    for file in [cbor, json] {
        let proved = acutile(["verify", "--claim", claim, file]);
        assert_eq!(code(&proved), 0, "{}", stdout(&proved));
    }
    assert_eq!(code(&acutile_verify(["--claim", claim, cbor])), 0);
    let other = "tests/certificates/valid/space-bcc.json";
    let refused = acutile(["verify", "--claim", claim, other]);
    assert_eq!(code(&refused), 1);
    let line = stdout(&refused);
    assert!(line.contains(": rejected [other-claim] "), "{line}");
}
