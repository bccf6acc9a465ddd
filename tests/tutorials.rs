//! The tutorials and README.md say what the programs do: each console block is run, and its output compared.
//!
//! In a block a line that begins with `$ ` is a command; lines that begin with `> ` continue it. The
//! other lines are what it prints, both streams together, where `…` stands for anything, and a line
//! `…` for any lines. `[exit code N]` is the last line where N is not 0.

use std::fs;
use std::path::Path;
use std::process::Command;

/// A command with the lines that it should print.
#[derive(Default)]
struct Step {
    command: String,
    expected: Vec<String>,
}

fn steps(document: &str) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    let mut is_inside = false;
    for line in document.lines() {
        if line.starts_with("```") {
            is_inside = line == "```console";
        } else if is_inside {
            add(&mut steps, line);
        }
    }
    steps
}

fn add(steps: &mut Vec<Step>, line: &str) {
    if let Some(command) = line.strip_prefix("$ ") {
        steps.push(Step {
            command: command.to_owned(),
            expected: Vec::new(),
        });
        return;
    }
    let step = steps.last_mut().expect("a block begins with a command");
    match line.strip_prefix("> ") {
        Some(more) if step.expected.is_empty() => step.command += &format!("\n{more}"),
        _ => step.expected.push(line.to_owned()),
    }
}

/// Runs a command with the programs of this build, and returns what it prints.
fn output(command: &str, folder: &Path) -> Vec<String> {
    let programs = Path::new(env!("CARGO_BIN_EXE_acutile"))
        .parent()
        .expect("a folder");
    assert!(
        programs.join("acutile-verify").exists(),
        "the kernel's program is not built: cargo build --package acutile-kernel"
    );
    let path = std::env::var("PATH").unwrap_or_default();
    let run = Command::new("sh")
        .args(["-c", &format!("exec 2>&1\n{command}")])
        .current_dir(folder)
        .env("PATH", format!("{}:{path}", programs.display()))
        .output()
        .expect("a shell");
    let text = String::from_utf8(run.stdout).expect("text");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    match run.status.code() {
        Some(0) => {}
        code => lines.push(format!("[exit code {}]", code.expect("a code"))),
    }
    lines
}

/// Whether a text has the parts of a pattern between its `…`, in this order.
fn fits(pattern: &str, text: &str) -> bool {
    let parts: Vec<&str> = pattern.split('…').collect();
    let [first, middle @ .., last] = &parts[..] else {
        return pattern == text;
    };
    let Some(mut rest) = text.strip_prefix(first) else {
        return false;
    };
    for part in middle {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
    }
    rest.ends_with(last)
}

/// Whether lines fit patterns, where the pattern `…` stands for any number of lines.
fn all_fit(patterns: &[String], lines: &[String]) -> bool {
    match patterns {
        [] => lines.is_empty(),
        [any, rest @ ..] if any == "…" => {
            (0..=lines.len()).any(|skipped| all_fit(rest, &lines[skipped..]))
        }
        [pattern, rest @ ..] => {
            let first = lines.first();
            first.is_some_and(|line| fits(pattern, line)) && all_fit(rest, &lines[1..])
        }
    }
}

fn check(name: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let document = fs::read_to_string(root.join(name)).expect(name);
    let steps = steps(&document);
    assert!(steps.len() >= 4, "{name} has console blocks");
    let folder = tempfile::tempdir().expect("a folder");
    for step in steps {
        let lines = output(&step.command, folder.path());
        assert!(
            all_fit(&step.expected, &lines),
            "{name}: `{}` is to print\n{}\nand prints\n{}",
            step.command,
            step.expected.join("\n"),
            lines.join("\n")
        );
    }
}

#[test]
fn the_readme() {
    check("README.md");
}

#[test]
fn a_theorem() {
    check("docs/tutorials/theorem.md");
}

#[test]
fn a_mesh() {
    check("docs/tutorials/mesh.md");
}

#[test]
fn a_paper() {
    check("docs/tutorials/paper.md");
}

#[test]
fn patterns_are_not_too_generous() {
    assert!(fits("a … c", "a b c") && fits("…", "anything") && fits("a", "a"));
    assert!(!fits("a … c", "a b d") && !fits("a", "ab") && !fits("a…", "ba"));
    let lines = |text: &[&str]| text.iter().map(|s| (*s).to_owned()).collect::<Vec<_>>();
    assert!(all_fit(
        &lines(&["a", "…", "c"]),
        &lines(&["a", "b", "b", "c"])
    ));
    assert!(!all_fit(&lines(&["a", "…", "c"]), &lines(&["a", "b"])));
    assert!(!all_fit(&lines(&["a"]), &lines(&["a", "b"])));
}
