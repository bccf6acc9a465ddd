//! The documents say what the code does: names exist, codes are complete.

use acutile_kernel::{Code, Kind};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path)
}

fn sources(folder: &str) -> String {
    let mut folders = vec![PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(folder)];
    let mut text = String::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                text.push_str(&fs::read_to_string(path).expect("a source file"));
            }
        }
    }
    text
}

/// The names in backticks in a cell.
fn names(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// The rows of the tables of docs/soundness.md that name functions of the prover and codes of the
/// kernel: the last two cells.
fn hypotheses(document: &str) -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let mut is_inside = false;
    for line in document.lines() {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        match cells[..] {
            _ if !line.starts_with('|') => is_inside = false,
            [.., "prover", "kernel: refusal code"] => is_inside = true,
            [.., prover, kernel] if is_inside && !prover.starts_with("---") => {
                rows.push((prover.to_owned(), kernel.to_owned()));
            }
            _ => {}
        }
    }
    rows
}

/// The codes of checks that the kernel alone makes, from the table of what each excludes.
fn excluded(document: &str) -> Vec<&str> {
    let table = document.split("| without | this would be accepted |");
    let rows = table.skip(1).flat_map(|rest| {
        let rows = rest.trim_start().lines();
        rows.take_while(|line| line.starts_with('|'))
    });
    rows.filter_map(|row| row.split('|').nth(1))
        .flat_map(names)
        .collect()
}

#[test]
fn every_hypothesis_names_functions_and_codes_that_exist() {
    let prover = sources("crates/core/src") + &sources("crates/exact/src");
    let rows = hypotheses(&read("docs/soundness.md"));
    assert_eq!(
        rows.len(),
        12 + 4 + 1 + 4 + 3,
        "one for each hypothesis and statement"
    );
    for (functions, codes) in &rows {
        assert!(!names(functions).is_empty() && !names(codes).is_empty());
        for path in names(functions) {
            let name = path.rsplit("::").next().expect("a name");
            let exists =
                prover.contains(&format!("fn {name}(")) || prover.contains(&format!("fn {name}<"));
            assert!(exists, "docs/soundness.md names {path}, which is not there");
        }
        for name in names(codes) {
            let exists = Code::ALL.iter().any(|code| code.text() == name);
            assert!(exists, "docs/soundness.md names {name}, which is no code");
        }
    }
}

/// The polytope's denominator divides that of the witness in every valid tiling. So the kernel may refuse
/// where it does not, and no theorem needs that.
const NO_HYPOTHESIS: [&str; 1] = ["denominator-domain"];

#[test]
fn every_rejection_is_a_hypothesis() {
    let document = read("docs/soundness.md");
    let rows = hypotheses(&document);
    let of_kernel = excluded(&document);
    let named = rows.iter().flat_map(|(_, codes)| names(codes));
    let named: Vec<&str> = named.chain(of_kernel).collect();
    for code in Code::ALL {
        let is_needed = code.kind() == Kind::Rejected && !NO_HYPOTHESIS.contains(&code.text());
        assert!(
            !is_needed || named.contains(&code.text()),
            "docs/soundness.md lacks {}",
            code.text()
        );
    }
}

/// The tables of docs/format.md have the codes of the kernel, each with its kind, and no other.
#[test]
fn the_refusal_codes_are_those_of_the_document() {
    let format = read("docs/format.md");
    let tables = format.split("| code | kind | condition |").skip(1);
    let rows = tables.flat_map(|table| {
        let rows = table.trim_start().lines().skip(1);
        rows.take_while(|line| line.starts_with('|'))
    });
    let documented: BTreeSet<(String, String)> = rows
        .map(|row| {
            let cells: Vec<&str> = row.split('|').map(str::trim).collect();
            (names(cells[1])[0].to_owned(), cells[2].to_owned())
        })
        .collect();
    let kernel: BTreeSet<(String, String)> = Code::ALL
        .iter()
        .map(|code| {
            let kind = match code.kind() {
                // A file that cannot be read ends with the exit code of malformed ones.
                _ if *code == Code::Unreadable => "malformed",
                Kind::Rejected => "rejected",
                Kind::Malformed => "malformed",
                Kind::Declined => "declined",
            };
            (code.text().to_owned(), kind.to_owned())
        })
        .collect();
    assert_eq!(documented, kernel);
}

#[test]
fn the_readme_is_short_and_its_files_exist() {
    let readme = read("README.md");
    assert!(readme.lines().count() < 150);
    for link in readme
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
    {
        if !link.starts_with("http") {
            assert!(
                Path::new(env!("CARGO_MANIFEST_DIR")).join(link).exists(),
                "{link}"
            );
        }
    }
}

/// A crate whose manifest switches a harness off has nothing that the harness would run.
#[test]
fn no_test_is_switched_off() {
    let crates = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("crates"));
    let names = crates.expect("crates").map(|entry| {
        let name = entry.expect("an entry").file_name();
        format!("crates/{}", name.to_string_lossy())
    });
    let mut count = 0;
    for folder in names.chain([".".to_owned()]) {
        let manifest = read(&format!("{folder}/Cargo.toml"));
        let code = sources(&format!("{folder}/src"));
        let library = manifest.split("[lib]").nth(1).expect("a section [lib]");
        let library = library.split("\n[").next().unwrap_or_default();
        if library.contains("\ntest = false") {
            assert!(!code.contains("#[test]"), "{folder} has unit tests");
            count += 1;
        }
        if library.contains("\ndoctest = false") {
            let is_example = |line: &str| {
                let line = line.trim_start();
                line == "/// ```" || line == "//! ```"
            };
            assert!(!code.lines().any(is_example), "{folder} has doctests");
            count += 1;
        }
    }
    assert!(
        count > 4,
        "only {count} harnesses are switched off: was [lib] renamed?"
    );
}

/// CONTRIBUTING.md has a row for every file with tests that `cargo test` ignores. The row names the file.
#[test]
fn every_ignored_test_has_a_row_with_its_needs() {
    let rows = read("CONTRIBUTING.md");
    let row = |start: String| rows.lines().any(|line| line.starts_with(&start));
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = fs::read_dir(root.join("crates")).expect("crates");
    let folders = crates.map(|entry| entry.expect("an entry").path());
    let mut count = 0;
    for folder in folders.chain([root.to_path_buf()]) {
        let Ok(files) = fs::read_dir(folder.join("tests")) else {
            continue;
        };
        for file in files {
            let path = file.expect("an entry").path();
            let is_ignoring = |path: &PathBuf| {
                let text = fs::read_to_string(path).unwrap_or_default();
                text.lines().any(|line| line.starts_with("#[ignore"))
            };
            if !is_ignoring(&path) {
                continue;
            }
            let name = path.file_stem().expect("a name").to_string_lossy();
            let start = if folder == *root {
                format!("| `cargo test --test main -- --ignored {name}::`")
            } else {
                let package = folder.file_name().expect("a name").to_string_lossy();
                format!(
                    "| `cargo test --package acutile-{package} --test main -- --ignored {name}::`"
                )
            };
            assert!(row(start.clone()), "CONTRIBUTING.md has no row {start}");
            count += 1;
        }
    }
    assert!(count > 5, "only {count} files have ignored tests");
}

/// The kinds of examples that documents name are those of `acutile new`.
#[test]
fn examples_that_documents_name_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut count = 0;
    for folder in ["docs", "docs/tutorials"] {
        for entry in fs::read_dir(root.join(folder)).expect("a folder") {
            let text = fs::read_to_string(entry.expect("an entry").path()).unwrap_or_default();
            let uses = text.split("`acutile new ").skip(1);
            for kind in uses.filter_map(|rest| rest.split(['`', ' ']).next()) {
                if kind != "KIND" {
                    let run = crate::common::acutile(["new", kind]);
                    assert_eq!(crate::common::code(&run), 0, "acutile new {kind}");
                    count += 1;
                }
            }
        }
    }
    assert!(count > 1, "documents name only {count} examples");
}

/// Scripts in .ci that documents name exist.
#[test]
fn scripts_that_documents_name_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let documents = fs::read_dir(root.join("docs")).expect("docs");
    let documents = documents.map(|entry| entry.expect("an entry").path());
    let others = ["README.md", "CONTRIBUTING.md", "ARCHITECTURE.md"].map(|name| root.join(name));
    let mut count = 0;
    for path in documents.chain(others) {
        let text = fs::read_to_string(&path).unwrap_or_default();
        for rest in text.split("`.ci/").skip(1) {
            let name: &str = rest.split(['`', ' ']).next().unwrap_or_default();
            let place = path.display();
            assert!(root.join(".ci").join(name).exists(), "{place}: .ci/{name}");
            count += 1;
        }
    }
    assert!(count > 8, "documents name only {count} scripts");
}
