//! `acutile draw`: files are written whole, or a message says why not.

use crate::common::well_formed::well_formed;
use std::process::Command;

fn acutile(arguments: &[&str]) -> (Option<i32>, String, String) {
    let run = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(arguments)
        .output()
        .unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (run.status.code(), text(run.stdout), text(run.stderr))
}

#[test]
fn the_command_writes_whole_files_or_says_why_not() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cell.svg");
    let file = path.to_str().unwrap();
    let (code, out, error) = acutile(&["draw", "bcc", "-o", file]);
    assert_eq!((code, out.as_str(), error.as_str()), (Some(0), "", ""));
    let written = std::fs::read_to_string(&path).unwrap();
    well_formed(&written);
    assert_eq!(acutile(&["draw", "bcc"]).1, written);
    let (code, _, error) = acutile(&["draw", "a15", "--figure", "steps", "-o", file]);
    assert_eq!(code, Some(2));
    assert!(error.contains("only the slab"), "{error}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), written);
    for wrong in [
        ["--view", "0,0,0"],
        ["--view", "1,2"],
        ["--view", "a,b,c"],
        ["--width", "5"],
        ["--vertex", "99999999999999999999999"],
        ["--format", "eps"],
    ] {
        let (code, out, _) = acutile(&["draw", "a15", wrong[0], wrong[1]]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{wrong:?}");
    }
    let (code, _, error) = acutile(&["draw", "a15", "--standalone"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("--format tikz"), "{error}");
}

/// PDF and PNG have the size of the figure, the same bytes each time, and a name of another format is an error.
#[test]
fn pdf_and_png_have_the_size_of_the_figure() {
    let folder = tempfile::tempdir().unwrap();
    let written = |name: &str, more: &[&str]| {
        let path = folder.path().join(name);
        let file = path.to_str().unwrap();
        let run = acutile(&[&["draw", "a15", "--figure", "classes", "-o", file], more].concat());
        (run.0, run.2, std::fs::read(&path).ok())
    };
    let (code, error, pdf) = written("a.pdf", &[]);
    assert_eq!((code, error.as_str()), (Some(0), ""));
    let pdf = pdf.unwrap();
    assert!(pdf.starts_with(b"%PDF-") && pdf.ends_with(b"%%EOF"));
    // 84 mm are 238.11 points.
    let text = String::from_utf8_lossy(&pdf);
    assert!(text.contains("/MediaBox [0 0 238.11"), "{text}");
    assert_eq!(written("b.PDF", &["--format", "pdf"]).2.unwrap(), pdf);
    let png = written("a.png", &[]).2.unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
    // 84 mm with 300 dots per inch are 992.1 dots.
    assert_eq!(png[16..20], 993u32.to_be_bytes());
    assert_eq!(
        written("b.png", &["--width", "42"]).2.unwrap()[16..20],
        497u32.to_be_bytes()
    );
    let (code, error, file) = written("c.png", &["--format", "pdf"]);
    assert_eq!((code, file), (Some(2), None));
    assert!(
        error.contains("PDF is written, expected the extension .pdf"),
        "{error}"
    );
    let (code, error, file) = written("c.pdf", &["--standalone"]);
    assert_eq!((code, file), (Some(2), None));
    assert!(
        error.contains("--standalone is for --format tikz"),
        "{error}"
    );
}

/// Other programs read the files. The words of a PDF are those of the SVG, and its fonts are embedded. The
/// colours in the middles of dots and faces are those of the drawing.
#[test]
#[ignore = "needs poppler, and Python with Pillow"]
fn other_programs_read_pdf_and_png() {
    let run = Command::new(std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned()))
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/figures.py"))
        .arg(env!("CARGO_BIN_EXE_acutile"))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&run.stdout) + String::from_utf8_lossy(&run.stderr);
    assert!(
        run.status.success() && said.contains("figures agree"),
        "{said}"
    );
}

/// The picture in README.md is drawn by this program.
#[test]
fn the_picture_of_the_documents() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/images/a15.svg");
    let drawn = acutile(&["draw", "a15"]);
    assert_eq!(drawn.1, std::fs::read_to_string(file).expect(file));
}
