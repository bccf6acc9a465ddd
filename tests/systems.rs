//! `acutile export --format`: other systems load the files and decide the assertions in them.
//!
//! Tests that need a program are ignored by default; `.ci/ignored-tests` installs the programs and runs them.

use crate::common::{acutile, code, file, stderr, stdout};
use std::path::Path;
use std::process::{Command, Output};

/// Over Q, over Q(√3), over Q(∛2): the input with its numbers of simplices and classes, which follow by hand. Eight cubes
/// have five tetrahedra each, of two shapes; A15 has 46 of three; a square in two halves and equilateral triangles.
const CUBES: (&str, &str) = ("cube-5", "checked: simplices 40, classes 2");
const A15: (&str, &str) = ("a15", "checked: simplices 46, classes 3");
const SQUARE_TRIANGLE: (&str, &str) = (
    "tests/certificates/valid/plane-square-triangle.json",
    "checked: simplices 4, classes 2",
);
const CUBIC: (&str, &str) = (
    "tests/systems/cubic.json",
    "checked: simplices 2, classes 1",
);

fn exported(input: &str, format: &str) -> String {
    let run = acutile(["export", input, "--format", format]);
    assert_eq!(code(&run), 0, "{input}: {}", stderr(&run));
    stdout(&run)
}

/// Each file is accepted, and refused after a change of its volume and of a squared edge.
fn decided(
    format: &str,
    inputs: &[(&str, &str)],
    changes: [[&str; 2]; 2],
    run: impl Fn(&Path) -> Output,
) {
    let folder = tempfile::tempdir().expect("a folder");
    let name = format!("tiling.{format}");
    for (input, expected) in inputs {
        let answer = run(&file(folder.path(), &name, &exported(input, format)));
        let said = stdout(&answer);
        assert!(
            said.contains(expected),
            "{input}: {said}{}",
            stderr(&answer)
        );
    }
    let cubes = exported(CUBES.0, format);
    for [from, to] in changes {
        assert_eq!(cubes.matches(from).count(), 1, "{from}");
        let answer = run(&file(folder.path(), &name, &cubes.replace(from, to)));
        let said = stdout(&answer) + &stderr(&answer);
        assert!(!said.contains("checked:"), "{to}: {said}");
        assert!(
            said.contains("the volume is another one")
                || said.contains("squared edges are others")
                || said.contains("not as acutile wrote it"),
            "{to}: {said}"
        );
    }
}

fn program(variable: &str, otherwise: &str) -> String {
    std::env::var(variable).unwrap_or_else(|_| otherwise.to_owned())
}

fn run(command: &mut Command) -> Output {
    let words = format!("{command:?}");
    command
        .stdin(std::process::Stdio::null())
        .output()
        .unwrap_or_else(|error| panic!("{words}: {error}"))
}

#[test]
#[ignore = "needs GAP"]
fn gap_decides_the_assertions() {
    let changes = [
        ["total := (6) *", "total := (7) *"],
        [
            "[[1, 1, 1, 2, 2, 2], [3, 3, 0]]",
            "[[1, 1, 1, 2, 2, 3], [3, 3, 0]]",
        ],
    ];
    decided(
        "gap",
        &[CUBES, A15, SQUARE_TRIANGLE, CUBIC],
        changes,
        |path| {
            run(Command::new(program("GAP", "gap"))
                .args(["-q", "--quitonbreak"])
                .arg(path))
        },
    );
}

#[test]
#[ignore = "needs Sage"]
fn sage_decides_the_assertions() {
    let changes = [
        ["total = K(6)", "total = K(7)"],
        [
            "[[1, 1, 1, 2, 2, 2], [3, 3, 0]]",
            "[[1, 1, 1, 2, 2, 3], [3, 3, 0]]",
        ],
    ];
    decided(
        "sage",
        &[CUBES, A15, SQUARE_TRIANGLE, CUBIC],
        changes,
        |path| {
            run(Command::new(program("SAGE_PYTHON", "python3"))
                .arg("tests/systems/load_sage.py")
                .arg(path))
        },
    );
}

/// Mathics is another program for the Wolfram Language. It has no roots of cubic polynomials in an interval.
#[test]
#[ignore = "needs Mathics"]
fn mathics_decides_the_assertions() {
    let changes = [
        ["total = 6;", "total = 7;"],
        [
            "{{1, 1, 1, 2, 2, 2}, {3, 3, 0}}",
            "{{1, 1, 1, 2, 2, 3}, {3, 3, 0}}",
        ],
    ];
    let mathics = |path: &Path| {
        run(Command::new(program("MATHICS", "mathics"))
            .args(["--no-readline", "-f"])
            .arg(path))
    };
    decided("mathematica", &[CUBES, SQUARE_TRIANGLE], changes, mathics);

    // Mathics ends an evaluation after 4,096 steps, which is too early for the checks of 172 tetrahedra. Each file sets a limit of
    // its own; with one of 200 steps this happens to 40 tetrahedra.
    let cubes = exported(CUBES.0, "mathematica");
    let (from, to) = ("$IterationLimit = 1000000;", "$IterationLimit = 200;");
    assert_eq!(cubes.matches(from).count(), 1);
    let folder = tempfile::tempdir().expect("a folder");
    let answer = mathics(&file(folder.path(), "limited.wl", &cubes.replace(from, to)));
    assert!(stdout(&answer).contains("not decided by this program"));
}

#[test]
#[ignore = "needs Lean"]
fn lean_decides_the_assertions() {
    let folder = tempfile::tempdir().expect("a folder");
    let lean = |text: &str| {
        let path = file(folder.path(), "tiling.lean", text);
        run(Command::new(program("LEAN", "lean")).arg(path))
    };
    for (input, _) in [CUBES, A15, SQUARE_TRIANGLE, CUBIC] {
        let answer = lean(&exported(input, "lean"));
        assert!(answer.status.success(), "{input}: {}", stdout(&answer));
    }
    let cubes = exported(CUBES.0, "lean");
    let (from, to) = ("def total : Element := [48]", "def total : Element := [56]");
    assert_eq!(cubes.matches(from).count(), 1);
    let answer = lean(&cubes.replace(from, to));
    assert!(!answer.status.success() && stdout(&answer).contains("native_decide"));
}

/// Over Q(∛2): the lattice with the Gram matrix [[1, r - 1], [r - 1, r² - 1/2]], whose halves have the squared edges
/// 1, r² - 1/2 and 1 + 2(r - 1) + r² - 1/2.
#[test]
fn numbers_are_exact_in_each_language() {
    let expected = [
        (
            "sage",
            "gram = matrix(K, [[1, -1+1*a], [-1+1*a, -1/2+1*a^2]])",
        ),
        (
            "gap",
            "classes := [[[1, -1/2+1*a^2, -3/2+2*a+1*a^2], [2, 0, 1]]];;",
        ),
        ("mathematica", "vertices = {{0, 0}};"),
        (
            "lean",
            "def gram : List (List Element) := [[[2, 0, 0], [-2, 2, 0]], [[-2, 2, 0], [-1, 0, 2]]]",
        ),
    ];
    for (format, line) in expected {
        let text = exported(CUBIC.0, format);
        assert!(text.lines().any(|other| other == line), "{format}: {text}");
        // No key of a template is left.
        assert!(!text.contains('@'), "{format}");
    }
}

#[test]
fn the_name_of_the_file_says_the_system() {
    let folder = tempfile::tempdir().expect("a folder");
    for (extension, words) in [
        ("g", "for GAP"),
        ("sage", "for Sage"),
        ("wl", "for Mathematica"),
        ("lean", "for Lean"),
    ] {
        let path = folder.path().join(format!("cubes.{extension}"));
        let run = acutile([
            "export".as_ref(),
            "cube-5".as_ref(),
            "-o".as_ref(),
            path.as_os_str(),
        ]);
        assert_eq!((code(&run), stderr(&run)), (0, String::new()));
        assert!(
            std::fs::read_to_string(&path)
                .expect("a file")
                .contains(words)
        );
    }
    let path = folder.path().join("cubes.g");
    let run = acutile([
        "export".as_ref(),
        "cube-5".as_ref(),
        "--format=sage".as_ref(),
        "-o".as_ref(),
        path.as_os_str(),
    ]);
    assert_eq!(code(&run), 2);
    assert!(
        stderr(&run).contains("expected the extension .sage"),
        "{}",
        stderr(&run)
    );
}
