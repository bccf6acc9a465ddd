//! `acutile appendix` as a user meets it: which files it writes, and which it leaves alone.
//! That TeX compiles them and that their numbers are right is tested by .ci/appendix.

use crate::common::{acutile, acutile_verify, code, file, stderr, stdout};
use std::fs;
use std::path::Path;

fn write(inputs: &[&str], directory: &Path, more: &[&str]) -> std::process::Output {
    let place = directory.to_str().expect("a path in UTF-8");
    let arguments = [&["appendix"], inputs, &["-o", place], more].concat();
    acutile(arguments)
}

fn text(path: impl AsRef<Path>) -> String {
    fs::read_to_string(path).expect("a file that was written")
}

fn names(directory: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(directory)
        .expect("a directory that was made")
        .map(|entry| {
            entry
                .expect("an entry")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    names.sort();
    names
}

#[test]
fn a15_is_three_rows_and_its_certificate_is_the_one_of_the_catalogue() {
    let place = tempfile::tempdir().expect("a temporary directory");
    let done = write(&["a15"], place.path(), &[]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert_eq!(
        names(place.path()),
        [
            "acutile-macros.tex",
            "anc",
            "appendix.tex",
            "main.bbl",
            "main.tex",
            "overview.tex",
            "refs.bib",
            "soundness.tex",
            "supplement.tex",
            "tables-a15.tex",
            "tiling-a15.tex"
        ]
    );
    let section = text(place.path().join("tiling-a15.tex"));
    // 46 tetrahedra, three orbits under a point group of order 48, and 24/8 + 6/8 + 144/64 = 6.
    assert!(section.contains("has $48$ isometries up to $\\Lambda$"));
    assert!(section.contains("the images under $\\Gamma$ of the $3$ tetrahedra of"));
    assert!(section.contains("There are $46$ tetrahedra up to $\\Lambda$."));
    assert!(section.contains(r"30\cdot \frac{1}{8}+16\cdot \frac{9}{64}=6"));
    // The largest angle is arccos(1/5) (the paper's Table 1: 78.46 degrees).
    assert!(section.contains(r"$\cos\theta=1/5$"));
    let of_catalogue = Path::new(env!("CARGO_MANIFEST_DIR")).join("certificates/a15.json");
    assert_eq!(text(place.path().join("anc/a15.json")), text(of_catalogue));
    // The section names the certificate by its digest, which the kernel prints, too.
    let verified = stdout(&acutile_verify([place.path().join("anc/a15.cbor")]));
    let digest = verified.split("sha256 ").nth(1).expect("a digest").trim();
    assert_eq!(digest.len(), 64);
    assert!(section.contains(&format!("% acutile:sha256 a15 {digest}\n")));
}

#[test]
fn a_certificate_gives_the_appendix_of_its_construction() {
    let place = tempfile::tempdir().expect("a temporary directory");
    let (a, b) = (place.path().join("a"), place.path().join("b"));
    let certificate = Path::new(env!("CARGO_MANIFEST_DIR")).join("certificates/square-14.json");
    let path = certificate.to_str().expect("a path in UTF-8");
    assert_eq!(code(&write(&["square-14"], &a, &[])), 0);
    assert_eq!(code(&write(&[path], &b, &[])), 0);
    let theorem = |place: &Path| {
        let text = text(place.join("tiling-square-14.tex"));
        text[text.find("\\begin{acutiletheorem}").expect("a theorem")..].to_owned()
    };
    assert_eq!(theorem(&a), theorem(&b));
}

#[test]
fn a_false_certificate_writes_nothing() {
    let place = tempfile::tempdir().expect("a temporary directory");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/certificates/false");
    let first = fs::read_dir(directory)
        .expect("false certificates")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|path| path.extension().is_some_and(|e| e == "json"))
        .expect("one of them");
    let target = place.path().join("out");
    let refused = write(
        &["a15", first.to_str().expect("a path in UTF-8")],
        &target,
        &[],
    );
    assert_eq!(code(&refused), 1, "{}", stderr(&refused));
    assert!(stderr(&refused).contains("rejected ["));
    assert!(!target.exists());
}

#[test]
fn foreign_and_edited_files_stay_without_force() {
    let place = tempfile::tempdir().expect("a temporary directory");
    file(place.path(), "notes.txt", "mine");
    assert_eq!(code(&write(&["cube-6"], place.path(), &[])), 0);
    // A file that nobody changed is replaced, here by a document about something else.
    assert_eq!(code(&write(&["cube-5"], place.path(), &[])), 0);
    let edited = text(place.path().join("main.tex")) + "% a line of mine\n";
    file(place.path(), "main.tex", &edited);
    let before = text(place.path().join("appendix.tex"));
    let refused = write(&["cube-6"], place.path(), &[]);
    assert_eq!(code(&refused), 2);
    assert!(
        stderr(&refused).contains("main.tex: the file exists"),
        "{}",
        stderr(&refused)
    );
    assert_eq!(text(place.path().join("main.tex")), edited);
    assert_eq!(
        text(place.path().join("appendix.tex")),
        before,
        "all or nothing"
    );
    assert_eq!(code(&write(&["cube-6"], place.path(), &["--force"])), 0);
    assert!(!text(place.path().join("main.tex")).contains("mine"));
    assert_eq!(text(place.path().join("notes.txt")), "mine");
}

#[test]
fn two_tilings_of_one_name_are_refused() {
    let place = tempfile::tempdir().expect("a temporary directory");
    let certificate = Path::new(env!("CARGO_MANIFEST_DIR")).join("certificates/a15.json");
    let path = certificate.to_str().expect("a path in UTF-8");
    let target = place.path().join("out");
    let refused = write(&["a15", path], &target, &[]);
    assert_eq!(code(&refused), 2);
    assert!(
        stderr(&refused).contains("anc/a15.cbor"),
        "{}",
        stderr(&refused)
    );
    assert!(!target.exists());
}

#[test]
fn siunitx_is_used_where_it_is_asked_for() {
    let place = tempfile::tempdir().expect("a temporary directory");
    assert_eq!(code(&write(&["cube-6"], place.path(), &[])), 0);
    assert!(!text(place.path().join("main.tex")).contains("siunitx"));
    assert_eq!(code(&write(&["cube-6"], place.path(), &["--siunitx"])), 0);
    assert!(text(place.path().join("main.tex")).contains("\\usepackage{siunitx}"));
}

/// Regions have the conditions on their boundary, families their polynomials, patches their pictures.
#[test]
fn regions_families_and_patches_have_sections() {
    let place = tempfile::tempdir().expect("a temporary directory");
    let region = valid("region-cube-6");
    let inputs = [region.as_str(), "goldberg-1-all", "kagome-all"];
    let done = write(&inputs, place.path(), &[]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let section = |name: &str| text(place.path().join(format!("tiling-{name}.tex")));
    // The six tetrahedra of a cube have 12 triangles in the boundary, in one class.
    let region = section("region-cube-6");
    assert!(region.contains("$f_{11}$") && !region.contains("$f_{12}$"));
    assert!(region.contains("Theorem~\\ref{acutile:region}"));
    // det G of Goldberg's first family is a multiple of s^2 (1 - s), see docs/families.md.
    let family = section("goldberg-1-all");
    assert!(family.contains("$-s^{3}+s^{2}>0$"), "{family}");
    assert!(section("kagome-all").contains("tikzpicture"));
    let soundness = text(place.path().join("soundness.tex"));
    for label in ["sound", "region", "family", "patches"] {
        assert!(
            soundness.contains(&format!("\\label{{acutile:{label}}}")),
            "{label}"
        );
    }
}

/// In two columns the long tables stand after the text.
#[test]
fn long_tables_leave_the_text_in_two_columns() {
    let place = tempfile::tempdir().expect("a temporary directory");
    assert_eq!(code(&write(&["a15"], place.path(), &["--two-column"])), 0);
    assert!(!text(place.path().join("tiling-a15.tex")).contains("longtable"));
    assert!(text(place.path().join("wide-a15.tex")).contains("acutile:table pairing a15"));
    assert!(text(place.path().join("appendix.tex")).contains("\\acutilewide\n\\input{wide-a15}"));
}

/// A certificate of the tests that is valid.
fn valid(name: &str) -> String {
    format!(
        "{}/tests/certificates/valid/{name}.json",
        env!("CARGO_MANIFEST_DIR")
    )
}

#[test]
fn delaunay_and_weakly_delaunay_are_one_paragraph() {
    let place = tempfile::tempdir().expect("a temporary directory");
    assert_eq!(code(&write(&[&valid("space-bcc")], place.path(), &[])), 0);
    let section = text(place.path().join("tiling-space-bcc.tex"));
    assert_eq!(
        section
            .matches("\\label{acutile:space-bcc:delaunay}")
            .count(),
        1
    );
}

/// The vertex is some 2^80 cells away from the origin.
#[test]
fn coordinates_beyond_64_bits_come_to_an_end() {
    let place = tempfile::tempdir().expect("a temporary directory");
    let name = "space-cube-with-coordinates-beyond-64-bits";
    assert_eq!(code(&write(&[&valid(name)], place.path(), &[])), 0);
    let section = text(place.path().join(format!("tiling-{name}.tex")));
    assert!(section.contains("Class 0."), "{section}");
}
