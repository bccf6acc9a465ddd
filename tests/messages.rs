//! Messages about input files: the place, the line with a caret, and the words of people who write such
//! files. Also names of output files that promise another format.

use crate::common::{acutile, code, stderr, stdout};
use std::path::Path;

/// The message of `certify` about a file with this content.
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
            "x.eps",
            "expected the extension .svg, .tex, .tikz",
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
        (&["quality", "bcc"], "q.pdf", ".csv, .svg or .json"),
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

/// The message of the program about these arguments, which must be wrong.
pub fn refusal(arguments: &[&str]) -> String {
    let output = acutile(arguments);
    assert_eq!(code(&output), 2, "{arguments:?}: {}", stderr(&output));
    stdout(&output) + &stderr(&output)
}

/// Files that are something else, by their first bytes or their names.
#[test]
fn files_that_are_something_else() {
    let place = tempfile::tempdir().expect("a directory");
    for (name, content, words) in [
        (
            "a",
            &b"\x7fELF\x02\x01\x01\x00\xff"[..],
            "ELF, a program for Linux",
        ),
        ("a.json", b"\x89PNG\r\n\x1a\n", "PNG image"),
        (
            "a.json",
            b"",
            "is empty, expected an input file; acutile new writes examples",
        ),
        (
            "a.json",
            b"[1, 2]",
            "begins with '[', expected an object in braces",
        ),
        (
            "a.json",
            b"hello",
            "begins with 'h', expected an object in braces",
        ),
        ("a.txt", b"hello", "the format is not known; acutile reads"),
        (
            "a.xyzzy",
            b"\x01\xff\xfe",
            "neither text nor a binary format",
        ),
        ("a.step", b"ISO-10303-21;", "STEP"),
        (
            "ase.json",
            br#"{"1": {"cell": {"__ase_objtype__": "cell"}}, "ids": [1]}"#,
            "JSON of ASE (ase convert IN OUT.xyz writes extended XYZ)",
        ),
        // As gemmi 0.7 writes them.
        (
            "cif.json",
            br#"{"x": {"_cell_length_a": 1.0, "_atom_site_label": ["Si"]}}"#,
            "a CIF as JSON (the CIF itself is read, and gemmi json2cif writes one)",
        ),
        (
            "mm.json",
            br#"{"data_m": {"cell": {"length_a": [1]}, "atom_site": {"id": [1]}}}"#,
            "a CIF as JSON",
        ),
        (
            "other.json",
            br#"{"a": 1}"#,
            "or a Structure of pymatgen with \"lattice\" and \"sites\"",
        ),
    ] {
        let path = place.path().join(name);
        std::fs::write(&path, content).expect("written");
        let text = refusal(&["certify", path.to_str().expect("UTF-8")]);
        assert!(text.contains(words), "{name}: {text}");
        assert!(text.len() < 700 && !text.contains("\\x"), "{name}: {text}");
    }
    for (content, words) in [
        (
            &b""[..],
            "malformed [cbor] is empty, expected a certificate",
        ),
        (
            b"\x7fELF\x02",
            "malformed [cbor] found ELF, a program for Linux, expected a certificate",
        ),
        (
            b"hello",
            "malformed [cbor] begins with 'h', expected a certificate",
        ),
    ] {
        let path = place.path().join("c.json");
        std::fs::write(&path, content).expect("written");
        let text = refusal(&["verify", path.to_str().expect("UTF-8")]);
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn files_that_cannot_be_read_or_written() {
    let place = tempfile::tempdir().expect("a directory");
    let folder = place.path().to_str().expect("UTF-8");
    let nowhere = format!("{folder}/none/x.json");
    for (arguments, words) in [
        (
            &["certify", folder][..],
            "cannot be read: is a directory, expected a file",
        ),
        (
            &["certify", &nowhere],
            "cannot be read: there is no such file",
        ),
        (&["verify", &nowhere], "unreadable: there is no such file"),
        (&["verify", "--claim", &nowhere, &nowhere], "--claim: "),
        (
            &["export", "bcc", "-o", &nowhere],
            "cannot be written: there is no such directory",
        ),
        (
            &["certify", "bcc", "-o", &nowhere],
            "cannot be written: there is no such directory",
        ),
        (
            &["draw", "bcc", "-o", folder],
            "is a directory, expected a file",
        ),
        (
            &["gallery", "-o", "-"],
            "several files are written, expected a directory",
        ),
        (
            &["appendix", "bcc", "-o", "-"],
            "several files are written, expected a directory",
        ),
        (
            &["certify", "square-triangle:none.json"],
            "none.json: cannot be read: there is no such file",
        ),
    ] {
        let text = refusal(arguments);
        assert!(text.contains(words), "{arguments:?}: {text}");
        assert!(!text.contains("os error"), "{arguments:?}: {text}");
    }
}

/// Nothing that is printed is lost in silence: a full disk is an error, a reader that has enough is not.
#[cfg(target_os = "linux")]
#[test]
fn full_disks_and_closed_pipes() {
    use std::process::{Command, Stdio};
    let program = env!("CARGO_BIN_EXE_acutile");
    for arguments in [
        &["list"][..],
        &["export", "bcc"],
        &["certify", "bcc", "--json"],
    ] {
        let full = std::fs::OpenOptions::new()
            .write(true)
            .open("/dev/full")
            .expect("a device");
        let mut command = Command::new(program);
        let output = command
            .args(arguments)
            .stdout(full)
            .output()
            .expect("acutile runs");
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(
            stderr(&output).contains("standard output: "),
            "{}",
            stderr(&output)
        );
        assert!(!stderr(&output).contains("os error"), "{}", stderr(&output));
    }
    let mut child = Command::new(program)
        .args(["export", "a15", "--supercell", "6,6,6"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("acutile runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("an end");
    assert_eq!((code(&output), stderr(&output)), (0, String::new()));
}

/// The file that the user gave stands first.
#[test]
fn half_of_a_tetgen_mesh() {
    let place = tempfile::tempdir().expect("a directory");
    let path = place.path().join("foo.node");
    std::fs::write(&path, "0 3 0 0\n").expect("written");
    let text = refusal(&["certify", path.to_str().expect("UTF-8")]);
    assert!(text.contains("foo.node: its partner "), "{text}");
    assert!(
        text.contains("foo.ele: cannot be read: there is no such file"),
        "{text}"
    );
    let gone = place.path().join("bar.ele");
    let text = refusal(&["certify", gone.to_str().expect("UTF-8")]);
    assert_eq!(text.matches("bar.").count(), 2, "{text}");
}

/// Plane-tiling files have the same words and carets as tiling files, and may name their schema.
#[test]
fn plane_tiling_files() {
    let place = tempfile::tempdir().expect("a directory");
    let path = place.path().join("p.json");
    let good = "{\"$schema\": \"plane-tiling.schema.json\", \"format\": \"acutile-plane-tiling\", \"version\": 1,\n\
                \"lattice\": [[1,0,0,0],[0,0,0,1]],\n\"vertices\": [[0,0,0,0]]}";
    let name = format!("square-triangle:{}", path.display());
    std::fs::write(&path, good).expect("written");
    assert_eq!(code(&acutile(["certify", &name])), 0);
    for (from, to, words) in [
        ("[0,0,0,1]", "[0,0,0,\"x\"]", "p.json:2:"),
        (
            "[0,0,0,1]",
            "[0,0,0,\"x\"]",
            "found the text \"x\", expected an integer",
        ),
        (",[0,0,0,1]]", "]", "lattice: found 1 entry, expected 2"),
        (
            "\"vertices\"",
            "\"vertizes\"",
            "the member \"vertizes\" is not known here",
        ),
        ("]]}", "]],}", "a comma before a closing bracket"),
        (
            "acutile-plane-tiling",
            "acutile-tiling",
            "expected \"acutile-plane-tiling\"; acutile takes this file by its name alone",
        ),
        ("[[0,0,0,0]]", "[]", "vertices: found none"),
    ] {
        let text = good.replace(from, to);
        assert_ne!(text, good, "{from}");
        std::fs::write(&path, text).expect("written");
        for arguments in [&["certify", &name][..], &["certify", "--cite", &name]] {
            let text = refusal(arguments);
            assert!(text.contains(words), "{arguments:?} {to}: {text}");
            assert!(!text.contains("at line"), "{text}");
        }
    }
    for (content, found) in [
        (&b"\x89PNG\r\n\x1a\n\xff"[..], "PNG image"),
        (b"hello", "'h' at the beginning"),
    ] {
        std::fs::write(&path, content).expect("written");
        let words = format!(
            "p.json: found {found}, expected a plane-tiling file; `acutile new square-triangle` writes one"
        );
        let text = refusal(&["certify", &name]);
        assert!(text.contains(&words), "{text}");
    }
    std::fs::write(&path, good).expect("written");
    let text = refusal(&["certify", path.to_str().expect("UTF-8")]);
    assert!(text.contains("is taken as square-triangle:FILE"), "{text}");
}

/// Hostile JSON comes to an end, and shows little of itself.
#[test]
fn nested_and_huge_json() {
    let place = tempfile::tempdir().expect("a directory");
    let deep = format!(
        "{START}\"vertices\": {}{}}}",
        "[".repeat(100_000),
        "]".repeat(100_000)
    );
    let text = complaint(place.path(), &deep);
    assert!(text.contains("found [[[[") && text.len() < 700, "{text}");
    let text = complaint(
        place.path(),
        "{\"format\": \"acutile-tiling\", \"version\": 1e400}",
    );
    assert!(text.contains("the number is too large"), "{text}");
    let text = complaint(place.path(), &format!("{START}\n\"vertices\": ["));
    assert!(
        text.contains("2 | \"vertices\": ["),
        "the last line is shown: {text}"
    );
}

/// A mesh of one tetrahedron, with the third point's second coordinate and the last node as given.
fn vtk(coordinate: &str, node: &str) -> String {
    format!(
        "# vtk DataFile Version 3.0\na\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n\
         0 0 0  1 0 0  1 {coordinate} 0  0 1 1\nCELLS 1 5\n4 0 1 2 {node}\nCELL_TYPES 1\n10\n"
    )
}

/// The line is that of the fault, and the numbers that the file has are named.
#[test]
fn faults_of_meshes_have_their_line_and_what_is_expected() {
    let place = tempfile::tempdir().expect("a directory");
    let good = vtk("1", "3");
    let many = good.replace("POINTS 4", "POINTS 99999999999");
    let no_types = good.split("CELL_TYPES").next().expect("a start").to_owned();
    for (name, content, words) in [
        (
            "node.vtk",
            vtk("1", "7"),
            "line 8: found the node 7 in the element 0; the nodes of the file are 0 to 3",
        ),
        (
            "many.vtk",
            many,
            "line 5: found 99999999999 as the number of points",
        ),
        (
            "types.vtk",
            no_types,
            "has 1 cell and 0 cell types, expected one type for each cell",
        ),
        ("nan.vtk", vtk("nan", "3"), "line 6: found \"nan\""),
        (
            "none.msh",
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n".to_owned(),
            "has no section $Nodes, expected a mesh that Gmsh saved whole",
        ),
    ] {
        let path = place.path().join(name);
        std::fs::write(&path, content).expect("written");
        let text = refusal(&["certify", path.to_str().expect("UTF-8")]);
        assert!(text.contains(words), "{name}: {text}");
    }
}

/// Whatever the name promises, an empty file is named as such.
#[test]
fn empty_files() {
    let place = tempfile::tempdir().expect("a directory");
    for name in [
        "a", "a.json", "a.cbor", "a.cif", "a.vtk", "a.msh", "a.vtu", "a.mesh",
    ] {
        let path = place.path().join(name);
        std::fs::write(&path, "\n").expect("written");
        let text = refusal(&["certify", path.to_str().expect("UTF-8")]);
        let words = "is empty, expected an input file; acutile new writes examples";
        assert!(text.contains(words), "{name}: {text}");
    }
}

/// A certificate that is cut off is named as such by every command that takes one, in both encodings.
#[test]
fn certificates_that_end_early() {
    let place = tempfile::tempdir().expect("a directory");
    for name in ["cut.cbor", "cut.json"] {
        let whole = place.path().join(format!("whole-{name}"));
        let whole = whole.to_str().expect("UTF-8");
        assert_eq!(code(&acutile(["certify", "z", "-o", whole])), 0);
        let bytes = std::fs::read(whole).expect("written");
        let cut = place.path().join(name);
        std::fs::write(&cut, &bytes[..300]).expect("written");
        let cut = cut.to_str().expect("UTF-8");
        for command in ["show", "table", "cite", "report", "verify", "certify"] {
            let text = refusal(&[command, cut]);
            assert!(text.contains("the file ends"), "{command}: {text}");
            assert!(
                text.contains("expected the rest of a certificate"),
                "{command}: {text}"
            );
        }
        let text = refusal(&["delaunay", whole]);
        let words = "a certificate, expected a file of points; `acutile show ";
        assert!(text.contains(words), "{text}");
    }
}

/// A page or a table in a directory that does not exist is refused before the proof.
#[test]
fn files_beside_the_answer_need_their_directory() {
    let place = tempfile::tempdir().expect("a directory");
    let nowhere = place.path().join("none");
    let at = |name: &str| nowhere.join(name).to_str().expect("UTF-8").to_owned();
    for arguments in [
        &["certify", "a15", "--report", &at("a.html")][..],
        &["certify", "a15", "--defects", &at("a.vtu")],
        &["certify", "a15", "--identify", "1", "--moves", &at("a.csv")],
    ] {
        let text = refusal(arguments);
        let words = "cannot be written: there is no such directory";
        assert!(text.contains(words), "{arguments:?}: {text}");
        assert!(!text.contains("proved"), "{arguments:?}: {text}");
    }
    assert!(!nowhere.exists());
}

/// `convert` writes the tiling of a certificate as a mesh, and the mesh is proved again.
#[test]
fn a_certificate_becomes_a_mesh() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name).to_str().expect("UTF-8").to_owned();
    for name in ["a15.cbor", "a15.json"] {
        assert_eq!(code(&acutile(["certify", "a15", "-o", &at(name)])), 0);
        let converted = acutile(["convert", &at(name), &at("a15.vtu")]);
        assert_eq!(code(&converted), 0, "{}", stderr(&converted));
        let lattice = "1,0,0;0,1,0;0,0,1";
        let proved = acutile([
            "certify",
            &at("a15.vtu"),
            "--lattice",
            lattice,
            "--require",
            "acute,tcp",
        ]);
        assert_eq!(code(&proved), 0, "{}", stderr(&proved));
        assert!(stdout(&proved).contains("by 46 tetrahedra"));
    }
    let text = refusal(&["convert", &at("a15.cbor"), &at("a15.txt")]);
    let words = "the input is a certificate, expected the extension .json or .cbor, or that of a mesh format";
    assert!(text.contains(words), "{text}");
}
