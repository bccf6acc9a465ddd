//! Messages about input files: the place, the line with a caret, and words of those who write
//! such files; and names of output files that promise another format.

use crate::common::{acutile, code, stderr, stdout};
use std::path::Path;

/// What `certify` says of a file with this content.
fn complaint(place: &Path, content: &str) -> String {
    let file = place.join("t.json");
    std::fs::write(&file, content).expect("written");
    let output = acutile(["certify", file.to_str().expect("UTF-8")]);
    assert_eq!(code(&output), 2, "{content}: {}", stderr(&output));
    let text = stdout(&output) + &stderr(&output);
    text.replace(&format!("{}/", place.display()), "")
}

/// The start of a tiling file on one line, of 54 characters with the blank.
const START: &str = r#"{"format":"acutile-tiling","version":1,"dimension":3, "#;

/// Each with line and column, counted by hand, the words, and the column of the caret.
#[test]
fn errors_name_the_place_and_show_it() {
    let place = tempfile::tempdir().expect("a directory");
    for (rest, at, words) in [
        (
            "\n\"domain\": \"slab\"}",
            "2:",
            "a slab has bounds, expected an object like",
        ),
        (
            "\n\"domain\": \"prism\"}",
            "2:",
            "a prism has corners, expected an object",
        ),
        (
            "\n  generators: {}}",
            "2:3",
            "expected the name of a member in double quotes",
        ),
        (
            "\n  \"generators\": {},}",
            "2:",
            "a comma before a closing bracket; remove the comma",
        ),
        (
            "\n\"generators\": []}",
            "2:",
            "found an array, expected an object of generators by name",
        ),
        (
            "\n\"vertices\": {}}",
            "2:",
            "found an object, expected an array",
        ),
        (
            "\n\"vertices\": [\n [\"s\", 0, 0]], \"simplices\": []}",
            "3:3",
            "s",
        ),
        (
            "\n\"vertices\": []} {}",
            "2:",
            "text after the end of the object; a file holds one object",
        ),
        (
            "\n\"vertices\": [",
            "2:",
            "the file ends within an array; a closing ] is missing",
        ),
        (
            "\n\"colour\": 1}",
            "2:",
            "the member \"colour\" is not known here, expected",
        ),
        (
            "\n\"name\": 1, \"name\": 2}",
            "2:",
            "found the number 1, expected a text in double quotes",
        ),
    ] {
        let text = complaint(place.path(), &format!("{START}{rest}"));
        assert!(text.contains(&format!("t.json:{at}")), "{rest}: {text}");
        assert!(text.contains(words), "{rest}: {text}");
        let lines: Vec<&str> = text.lines().collect();
        let caret = lines.iter().position(|line| line.trim_end().ends_with('^'));
        let caret = caret.unwrap_or_else(|| panic!("no caret for {rest}: {text}"));
        assert!(lines[caret - 1].contains(" | "), "{text}");
        for jargon in [
            "variant", "sequence", "newtype", "EOF", "struct", "a map", "at line",
        ] {
            assert!(!text.contains(jargon), "{rest}: {text}");
        }
    }
}

#[test]
fn a_member_of_the_header_that_is_missing_or_wrong_is_named_with_what_is_expected() {
    let place = tempfile::tempdir().expect("a directory");
    let text = complaint(place.path(), "{\"version\": 1}");
    assert!(
        text.contains("the member \"format\" is missing; expected \"format\": \"acutile-tiling\""),
        "{text}"
    );
    let text = complaint(place.path(), "{\n \"format\": \"a\",\n \"version\": 1}");
    assert!(
        text.contains("t.json:2:12: format is \"a\", expected"),
        "{text}"
    );
    assert!(complaint(place.path(), " \n").contains("is empty"));
}

/// Comment lines are not part of the JSON, but lines count as in the file.
#[test]
fn comments_and_a_byte_order_mark_keep_the_places() {
    let place = tempfile::tempdir().expect("a directory");
    let text = format!(
        "\u{feff}// a comment\n{START}\n // another\n \"vertices\": [[0,\"x\",0]], \"simplices\": []}}"
    );
    let text = complaint(place.path(), &text);
    assert!(text.contains("t.json:4:18: vertices[0][1]:"), "{text}");
}

/// `"$schema"` tells editors where the schema is.
#[test]
fn a_schema_may_be_named() {
    let place = tempfile::tempdir().expect("a directory");
    let file = place.path().join("t.json");
    let example = stdout(&acutile(["new", "solid"]));
    let named = example.replacen(
        "\"format\"",
        "\"$schema\": \"tiling.schema.json\", \"format\"",
        1,
    );
    assert_ne!(example, named);
    std::fs::write(&file, named).expect("written");
    let output = acutile(["certify", file.to_str().expect("UTF-8")]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
}

#[test]
fn a_name_that_promises_another_format_is_refused_and_nothing_is_written() {
    let place = tempfile::tempdir().expect("a directory");
    for (arguments, name, words) in [
        (
            &["draw", "bcc"][..],
            "x.pdf",
            "expected the extension .svg or .tex",
        ),
        (
            &["draw", "bcc", "--format", "svg"],
            "x.tex",
            "SVG is written",
        ),
        (
            &["draw", "bcc", "--format", "tikz"],
            "x.svg",
            "TikZ is written",
        ),
        (&["quality", "bcc"], "q.pdf", "or .csv or .svg or .json"),
        (
            &["quality", "bcc", "--format", "csv"],
            "q.svg",
            "CSV is written",
        ),
        (&["export", "bcc"], "y.vtu", "acutile convert writes meshes"),
    ] {
        let path = place.path().join(name);
        let output = acutile([arguments, &["-o", path.to_str().expect("UTF-8")]].concat());
        assert_eq!(code(&output), 2, "{arguments:?} {name}");
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
        assert!(!path.exists(), "{name}");
    }
}

#[test]
fn a_name_chooses_the_format_where_nothing_else_does() {
    let place = tempfile::tempdir().expect("a directory");
    for (command, name, start) in [
        ("draw", "x.tex", "%"),
        ("draw", "x.svg", "<svg"),
        ("quality", "q.json", "{"),
        ("quality", "q.svg", "<svg"),
    ] {
        let path = place.path().join(name);
        let output = acutile([command, "bcc", "-o", path.to_str().expect("UTF-8")]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        let text = std::fs::read_to_string(&path).expect("written");
        assert!(
            text.starts_with(start) || text.contains(start),
            "{name}: {text:.40}"
        );
    }
    let (plain, dash) = (
        acutile(["export", "bcc"]),
        acutile(["export", "bcc", "-o", "-"]),
    );
    assert_eq!(stdout(&plain), stdout(&dash));
    assert!(!stdout(&dash).is_empty());
}

#[test]
fn delaunay_of_a_name_says_that_it_is_a_tiling() {
    let output = acutile(["delaunay", "a15"]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("a15: a tiling of the catalogue, expected a file of points"));
}
