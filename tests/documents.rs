//! The documents say what the code does: names exist, codes are complete.

use acutile_format1::verifier::Refusal;
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
            } else {
                text.push_str(&fs::read_to_string(path).expect("a source file"));
            }
        }
    }
    text
}

/// The `check_…` and `judge_…` names in the column of a table row, counted from the left.
fn checks(row: &str, column: usize) -> Vec<String> {
    let cells: Vec<&str> = row.trim_matches('|').split('|').collect();
    let cell = cells
        .len()
        .checked_sub(column)
        .map_or("", |index| cells[index]);
    let names = cell.split('`').skip(1).step_by(2);
    names
        .filter(|name| name.starts_with("check_") || name.starts_with("judge_"))
        .map(str::to_owned)
        .collect()
}

#[test]
fn every_hypothesis_names_functions_that_exist() {
    let (prover, kernel) = (
        sources("crates/core/src/checker"),
        sources("crates/format1/src/verifier"),
    );
    let mut count = 0;
    for row in read("docs/soundness.md")
        .lines()
        .filter(|line| line.starts_with('|'))
    {
        for (column, code) in [(2, &prover), (1, &kernel)] {
            for name in checks(row, column) {
                let exists =
                    code.contains(&format!("fn {name}(")) || code.contains(&format!("fn {name}<"));
                assert!(exists, "docs/soundness.md names {name}, which is not there");
                count += 1;
            }
        }
    }
    assert!(
        count > 30,
        "only {count} names found: was the table changed?"
    );
}

#[test]
fn every_refusal_code_is_documented() {
    let format = read("docs/format.md");
    for (code, _) in Refusal::CODES {
        assert!(
            format.contains(&format!("`{code}`")),
            "docs/format.md lacks {code}"
        );
    }
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
