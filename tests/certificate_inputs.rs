//! Commands that take a tiling take a certificate, too: in either encoding, and on standard input.

use crate::common::{acutile, code, stderr, stdout};
use std::fs::{self, File};
use std::process::{Command, Output, Stdio};

/// Runs `acutile` with a file on standard input.
fn piped(arguments: &[&str], file: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(arguments)
        .stdin(Stdio::from(File::open(file).expect(file)))
        .output()
        .expect("acutile runs")
}

/// The answer about an input, which must be a success, with `-` for the input's name.
fn answer(output: &Output, input: &str) -> String {
    assert_eq!(code(output), 0, "{input}: {}", stderr(output));
    let text = stdout(output).replace(input, "-");
    assert!(!text.is_empty(), "{input}");
    text
}

const COMMANDS: [&[&str]; 9] = [
    &["show"],
    &["quality"],
    &["quality", "--format", "csv"],
    &["classify", "--json"],
    &["draw", "--figure", "classes"],
    &["draw"],
    &["table", "--format", "csv"],
    &["export", "--supercell", "2,1,1"],
    &["certify", "--format", "json", "-o", "-"],
];

/// The four ways to give one certificate give the same answer.
#[test]
fn every_command_takes_a_certificate_in_each_way() {
    let folder = tempfile::tempdir().expect("a directory");
    let json = "certificates/a15.json";
    let cbor = folder.path().join("a15.cbor");
    let cbor = cbor.to_str().expect("UTF-8");
    assert_eq!(code(&acutile(["convert", json, cbor])), 0);
    for command in COMMANDS {
        let with = |input| [command, &[input]].concat();
        let expected = answer(&acutile(with(json)), json);
        assert_eq!(answer(&acutile(with(cbor)), cbor), expected, "{command:?}");
        for file in [json, cbor] {
            let found = answer(&piped(&with("-"), file), "-");
            assert_eq!(found, expected, "{command:?} of {file}");
        }
    }
    // The tiling of a certificate, proved again, has this certificate.
    let again = acutile(["certify", cbor, "-o", "-"]);
    assert_eq!(again.stdout, fs::read(json).expect(json));
}

/// Commands that show what is proved verify first, and say so by exit codes.
#[test]
fn certificates_are_verified_where_something_is_called_proved() {
    let folder = tempfile::tempdir().expect("a directory");
    let target = folder.path().join("out");
    let target = target.to_str().expect("UTF-8");
    for command in ["report", "appendix", "bundle"] {
        for (file, expected) in [
            ("false/not-acute--cube-6.json", 1),
            ("malformed/canonical--gram-not-primitive.json", 2),
            ("declined/version--3.json", 3),
            ("cbor/cbor--byte-after-the-end.cbor", 2),
        ] {
            let path = format!("tests/certificates/{file}");
            let output = acutile([command, &path, "-o", target]);
            assert_eq!(
                code(&output),
                expected,
                "{command} {file}: {}",
                stderr(&output)
            );
            // A page says that a false claim is not proved.
            let has_page = command == "report" && expected == 1;
            assert_eq!(
                fs::exists(target).expect("a directory"),
                has_page,
                "{command} {file}"
            );
            if has_page {
                assert!(
                    fs::read_to_string(target)
                        .expect("a page")
                        .contains("Not proved")
                );
                fs::remove_file(target).expect("removed");
            }
        }
    }
}

/// Commands that verify have the limits, and a refusal by one names its option.
#[test]
fn limits_are_options_of_every_command_that_verifies() {
    let folder = tempfile::tempdir().expect("a directory");
    let target = folder.path().join("out");
    let target = target.to_str().expect("UTF-8");
    let certificate = "certificates/a15.json";
    for (command, input) in [
        ("verify", certificate),
        ("report", certificate),
        ("report", "a15"),
        ("appendix", certificate),
        ("bundle", certificate),
        ("certify", "a15"),
        ("certify", certificate),
    ] {
        let output = |more: &'static [&str]| match command {
            "verify" => acutile([&[command, input], more].concat()),
            _ => acutile([&[command, input, "-o", target], more].concat()),
        };
        let refused = output(&["--max-simplices", "45"]);
        assert_eq!(code(&refused), 3, "{command}: {}", stderr(&refused));
        let message = stdout(&refused) + &stderr(&refused);
        assert!(
            message.contains("--max-simplices 46"),
            "{command}: {message}"
        );
        let done = output(&["--max-simplices", "46"]);
        assert_eq!(code(&done), 0, "{command}: {}", stderr(&done));
        let _ = fs::remove_file(target);
        let _ = fs::remove_dir_all(target);
    }
}
