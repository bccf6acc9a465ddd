//! Values of options that are wrong, and places that cannot be read from or written to.

use crate::common::{acutile, code};
use crate::messages::refusal;

#[test]
fn numbers_and_statements_in_options() {
    for (arguments, words) in [
        (
            &["export", "a15", "--supercell", "x"][..],
            "found \"x\", expected an integer from 1 to 65535",
        ),
        (
            &["export", "a15", "--supercell", "0,1,1"],
            "expected an integer from 1 to 65535",
        ),
        (
            &["export", "a15", "--supercell", "1,2"],
            "found 2 numbers, expected 3",
        ),
        (
            &["certify", "a15", "--max-defects", "many"],
            "expected an integer of at least 0",
        ),
        (
            &["certify", "a15", "--max-defects", "-1"],
            "'-1' for '--max-defects <N>': expected an integer of at least 0",
        ),
        (
            &["draw", "a15", "--width", "0"],
            "0 is out of range, expected an integer from 20 to 1000",
        ),
        (
            &["draw", "a15", "--width", "-1"],
            "-1 is out of range, expected an integer from 20 to 1000",
        ),
        (
            &["draw", "a15", "--width", "1e3"],
            "'1e3' for '--width <MM>': expected an integer from 20 to 1000",
        ),
        (
            &["optimize", "c14", "--denominator", "0"],
            "0 is out of range, expected an integer from 1 to 1152921504606846976",
        ),
        (
            &["search", "balls", "--steps", "-1"],
            "'-1' for '--steps <N>'",
        ),
        (
            &["certify", "goldberg-1", "--param", "x"],
            "found 'x', expected a number like 3/7 or sqrt(2)/4",
        ),
        (
            &["certify", "part.mesh", "--lattice", "x,y,z"],
            "found 'x', expected a number like 3/7 or sqrt(2)/4",
        ),
        (
            &["certify", "part.mesh", "--lattice", "1"],
            "the vector \"1\" has 1 entry, expected 3",
        ),
        (
            &["certify", "square-triangle-all", "--lattice", "1,2,3"],
            "--lattice is for a mesh file, which this is not",
        ),
        (
            &["certify", "square-triangle-all", "--param", "3"],
            "a theorem takes no parameter",
        ),
        (
            &["quality", "a15", "--from", "vtk"],
            "--from is for a mesh file, which this is not",
        ),
        (
            &["certify", "a15", "--strict"],
            "a15: --strict is for a mesh file, which this is not",
        ),
        (
            &["certify", "a15-all", "--strict"],
            "a15-all: --strict is for a mesh file, which this is not",
        ),
        (
            &["certify", "slab-stretch-all", "--allow-contact"],
            "--allow-contact is for a mesh with a boundary, which this is not",
        ),
        (
            &["certify", "cube-6", "--fills", "part.stl"],
            "cube-6: --fills is for a bounded mesh, which this is not",
        ),
        (
            &["certify", "kagome:1", "--cite", "--reorient"],
            "kagome:1: --reorient is for a tiling or mesh file, which this is not",
        ),
        (
            &["certify", "tests/cif/a15.cif", "--reorient"],
            "a15.cif: --reorient is for a tiling or mesh file, which this is not",
        ),
        (
            &["optimize", "a15", "--reorient"],
            "a15: --reorient is for a tiling or mesh file, which this is not",
        ),
        (
            &["verify", "a15"],
            "found a name of the catalogue, expected a certificate; `acutile certify a15 -o a15.cbor` writes one",
        ),
        (
            &["certify", "a15", "-o", "a15.pdf"],
            "found the extension .pdf, but a certificate in JSON or a certificate in CBOR is written, expected the extension .json or .cbor",
        ),
        (
            &["certify", "a15", "--max-bytes", "99999999999999999999999"],
            "the number is too large",
        ),
        (&["certify", "a15", "--max-defects", ""], "expected"),
        (
            &["certify", "a15", "--require", "dihedral<x"],
            "found \"x\", expected a number like 90, 78.5 or 157/2",
        ),
        (
            &["certify", "a15", "--require", "dihedral<-3"],
            "expected more than 0",
        ),
        (
            &["certify", "a15", "--require", "blunt"],
            "dihedral-below=DEGREES",
        ),
        (
            &["certify", "a15", "--require", "delaunay,not-delaunay"],
            "no tiling is both delaunay and not-delaunay, expected requirements that agree",
        ),
        (
            &[
                "certify",
                "a15",
                "--require",
                "not-delaunay,weakly-delaunay",
            ],
            "no tiling is both weakly-delaunay and not-delaunay",
        ),
        (
            &["certify", "a15", "--require", "acute,dihedral>90"],
            "no tiling is both acute and dihedral>90",
        ),
        (
            &["certify", "a15", "--require", "dihedral<70,dihedral>70"],
            "no tiling is both dihedral<70 and dihedral>70",
        ),
        (
            &["a15", "certify"],
            "The command comes first, like `acutile certify a15`",
        ),
        (
            &["certify", "a15", "--require", "acute", "delaunay"],
            "a comma joins statements: --require STATEMENT,delaunay",
        ),
        (
            &["quality", "a15", "--bin", "7"],
            "expected a divisor of 180",
        ),
        (
            &["draw", "a15", "--vertex", "9"],
            "--vertex is for --figure star",
        ),
        (
            &["verify", "certificates/z.json", "--max-degree", "9"],
            "9 is out of range, expected an integer from 0 to 8",
        ),
        (
            &["certify", "a15", "-o", "a", "--report", "./a"],
            "./a: -o and --report name one file, expected different files",
        ),
        (
            &["certify", "a15", "-o", "-", "--report", "-"],
            "-: -o and --report name one file, expected different files",
        ),
        (
            &["verify", "-", "-"],
            "-: standard input is named 2 times, expected once",
        ),
        (
            &["verify", "-", "--claim", "-"],
            "-: standard input is named 2 times, expected once",
        ),
        (
            &["report", "-", "-"],
            "-: standard input is named 2 times, expected once",
        ),
        (
            &["table", "a15", "-", "-", "-"],
            "-: standard input is named 3 times, expected once",
        ),
        (
            &["bundle", "-", "-", "-o", "two.zip"],
            "-: standard input is named 2 times, expected once",
        ),
        (
            &["certify", "a15", "--cite"],
            "--cite is for a member of a theorem, expected square-triangle:WORD or kagome:WORD",
        ),
        (
            &["certify", "a15", "--param", "1"],
            "`a15` takes no parameter; goldberg-1, goldberg-2, goldberg-3 and two-corners take one",
        ),
        (
            &["convert", "a15", "a.vtu", "--patch", "1/100"],
            "a15: no whole simplex lies within 1/100 of the origin, expected a larger radius",
        ),
        (
            &["certify", "square-triangle:"],
            "found nothing after the colon",
        ),
        (
            &["convert", "a15", "a15.foo"],
            "expected .msh, .vtk, .vtu, .mesh, .meshb, .node or .ele",
        ),
        (
            &["convert", "bcc", "b.vtu"],
            "have no exact 64-bit floating-point number",
        ),
    ] {
        let text = refusal(arguments);
        assert!(text.contains(words), "{arguments:?}: {text}");
        for jargon in [
            "digit found",
            "target type",
            "no doubles",
            "..=",
            "no generator",
        ] {
            assert!(!text.contains(jargon), "{arguments:?}: {text}");
        }
    }
}

/// A certificate is cut off within an item, and at the end of one.
#[test]
fn a_certificate_that_ends_early() {
    let place = tempfile::tempdir().expect("a directory");
    let whole = place.path().join("z.cbor");
    let whole = whole.to_str().expect("UTF-8");
    assert_eq!(code(&acutile(["certify", "z", "-o", whole])), 0);
    let bytes = std::fs::read(whole).expect("written");
    let cut = place.path().join("cut.cbor");
    for length in [1, 21, 200, bytes.len() - 1] {
        std::fs::write(&cut, &bytes[..length]).expect("written");
        let text = refusal(&["verify", cut.to_str().expect("UTF-8")]);
        let words =
            format!("malformed [cbor] the file ends after {length} bytes, expected the rest");
        assert!(text.contains(&words), "{text}");
    }
}

/// Neither depends on permissions, so that root gets the same answers: a file stands where a directory
/// belongs, and a directory where a file belongs.
#[test]
fn a_file_for_a_directory_and_a_directory_for_a_file() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name).to_str().expect("UTF-8").to_owned();
    let (file, folder) = (at("notes.txt"), at("folder.json"));
    std::fs::write(&file, "mine").expect("written");
    std::fs::create_dir(&folder).expect("made");
    let below = format!("{file}/x.json");
    for (arguments, words) in [
        (&["appendix", "z", "-o", &file][..], "expected a directory"),
        (&["gallery", "-o", &file], "expected a directory"),
        (&["man", &file], "expected a directory"),
        (
            &["certify", "z", "a15", "-o", &file],
            "expected a directory",
        ),
        (
            &["certify", "z", "-o", &below],
            "cannot be written: a part of its path is not a directory",
        ),
        (
            &["export", "z", "-o", &below],
            "cannot be written: a part of its path is not a directory",
        ),
        (
            &["export", "z", "-o", &folder],
            "is a directory, expected a file",
        ),
        (
            &["new", "tiling", "-o", &folder],
            "is a directory, expected a file",
        ),
        (&["certify", &below], "not a directory"),
        (&["verify", &below], "not a directory"),
    ] {
        let text = refusal(arguments);
        assert!(text.contains(words), "{arguments:?}: {text}");
        assert!(!text.contains("os error"), "{arguments:?}: {text}");
    }
    assert_eq!(std::fs::read(&file).expect("still there"), b"mine");
    assert!(!std::path::Path::new(&folder).join("x").exists());
}

/// The input is missing too. The place comes first, so that no work is lost.
#[test]
fn a_place_that_takes_no_file_is_found_before_the_work() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name).to_str().expect("UTF-8").to_owned();
    let file = at("notes.txt");
    std::fs::write(&file, "mine").expect("written");
    let below = |name: &str| format!("{file}/{name}");
    let nowhere = at("nowhere/missing.zip");
    let no_directory = "cannot be written: a part of its path is not a directory";
    for (arguments, words) in [
        (
            &["certify", "missing.msh", "--report", &below("x.html")][..],
            no_directory,
        ),
        (
            &["certify", "missing.msh", "--defects", &below("x.vtu")],
            no_directory,
        ),
        (
            &["certify", "missing.msh", "-o", &below("x.cbor")],
            no_directory,
        ),
        (
            &["report", "missing.msh", "-o", &below("x.html")],
            no_directory,
        ),
        (
            &["draw", "missing.msh", "-o", &below("x.svg")],
            no_directory,
        ),
        (
            &["search", "slab", "--over", "x", "-o", &below("x.json")],
            no_directory,
        ),
        (
            &["bundle", "missing.msh", "-o", &nowhere],
            "cannot be written: there is no such directory",
        ),
        (
            &["appendix", "missing.msh", "-o", &below("appendix")],
            "found a file, expected a directory",
        ),
        (
            &["gallery", "-o", &below("site")],
            "found a file, expected a directory",
        ),
    ] {
        let text = refusal(arguments);
        assert!(text.contains(words), "{arguments:?}: {text}");
        assert!(!text.contains("missing.msh"), "{arguments:?}: {text}");
    }
    let left = std::fs::read_dir(place.path()).expect("the directory");
    assert_eq!(left.count(), 1, "nothing but notes.txt");
}

/// Nothing can be created in /proc, not even by root, and nothing fits on /dev/full.
#[test]
#[cfg(target_os = "linux")]
fn a_folder_and_a_device_that_take_nothing() {
    for (arguments, words) in [
        (
            &["certify", "z", "-o", "/proc/z.json"][..],
            "cannot be written",
        ),
        (&["draw", "z", "-o", "/proc/z.svg"], "cannot be written"),
        (&["appendix", "z", "-o", "/proc/appendix"], "/proc/appendix"),
        (&["export", "z", "-o", "/dev/full"], "cannot be written"),
        (&["report", "z", "-o", "/dev/full"], "cannot be written"),
    ] {
        let text = refusal(arguments);
        assert!(text.contains(words), "{arguments:?}: {text}");
    }
}

/// Mistakes of people who use the program for the first time: each answer names the next step.
#[test]
fn first_mistakes() {
    let place = tempfile::tempdir().expect("a directory");
    let at = |name: &str| place.path().join(name).to_str().expect("UTF-8").to_owned();
    let mesh = at("part.mesh");
    assert_eq!(code(&acutile(["convert", "cube-6", &mesh])), 0);
    for (arguments, words) in [
        (&["certify"][..], "`acutile list` names the constructions"),
        (&["draw"], "`acutile new KIND` writes an example of a file"),
        (
            &["verify"],
            "`acutile certify a15 -o a15.cbor` writes one.\n\nExample: acutile verify a15.cbor",
        ),
        (
            &["delaunay"],
            "`acutile new point-set` writes an example of one",
        ),
        (
            &["convert", "a15"],
            "Example: acutile convert part.msh part.vtu",
        ),
        (
            &["table", "a15", "-o", "t.tex"],
            "This command writes to standard output",
        ),
        (
            &["show", "a15", "-o", "t.json"],
            "This command writes to standard output",
        ),
        (
            &["certify", "kagome"],
            "neither a name of the catalogue (acutile list) nor a file; did you mean kagome:WORD?",
        ),
        (
            &["appendix", "a15", "-o", &at("app.pdf")],
            "app.pdf: found the extension .pdf, expected the name of a directory",
        ),
        (
            &["gallery", "-o", &at("site.html")],
            "site.html: found the extension .html, expected the name of a directory",
        ),
        (
            &["man", "certify"],
            "certify: found a command, expected a directory for the pages of all commands; \
             `acutile certify --help` prints its help",
        ),
        (
            &["delaunay", &mesh],
            "part.mesh: a mesh, expected a file of points; `acutile certify ",
        ),
        (
            &["export", "--coq", &mesh],
            "part.mesh: found no certificate, which --coq takes; `acutile certify ",
        ),
        (
            &["export", "--coq", "a15"],
            "a15: found no certificate, which --coq takes; `acutile certify a15 -o FILE.cbor` writes one",
        ),
        (
            &["certify", &mesh, "--special"],
            "part.mesh: --special is for a CIF, which this is not",
        ),
        (
            &["export", &mesh, "--supercell", "2,2,2"],
            "--supercell: found 3 numbers for a tiling without a lattice, expected none",
        ),
        (
            &["export", "a15", "--supercell", "2"],
            "--supercell: found 1 number, expected 3",
        ),
        (
            &["verify", &mesh],
            "`acutile certify` proves a tiling or a mesh, and writes one",
        ),
        (
            &["draw", "a15", "-o", &at("a15.jpg")],
            "but SVG, TikZ, PDF, PNG, OBJ or STL is written, expected the extension .svg, .tex, ",
        ),
    ] {
        let text = refusal(arguments);
        assert!(text.contains(words), "{arguments:?}: {text}");
        assert!(!text.contains("byte 0"), "{arguments:?}: {text}");
        assert!(!text.contains("-- -o"), "{arguments:?}: {text}");
    }
    let left = std::fs::read_dir(place.path()).expect("the directory");
    assert_eq!(left.count(), 1, "nothing is written but the mesh");
    assert!(!std::path::Path::new("certify").exists());
    // Upper and lower case are the same in statements, as in names.
    let run = acutile(["certify", "A15", "--require", "Acute,Dihedral<79,TCP"]);
    assert_eq!(code(&run), 0);
}
