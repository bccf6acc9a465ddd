//! Answers on a terminal, seen through `script`, which gives the program one.

use std::process::Command;

/// The output of a command on a terminal 60 columns wide.
fn on_a_terminal(command: &str, variables: &[(&str, &str)]) -> String {
    let program = env!("CARGO_BIN_EXE_acutile");
    let line = format!("stty rows 24 cols 60 </dev/tty; {program} {command} 2>/dev/null");
    let output = Command::new("script")
        .args(["-qec", &line, "/dev/null"])
        .env("TERM", "xterm")
        .env_remove("NO_COLOR")
        .envs(variables.iter().copied())
        .output()
        .expect("script of util-linux runs");
    String::from_utf8_lossy(&output.stdout).replace('\r', "")
}

#[test]
#[ignore = "needs the program script of util-linux; CI runs it"]
fn a_terminal_gets_a_sign_a_colour_and_a_statement_a_line() {
    let coloured = on_a_terminal("certify a15 --require acute", &[]);
    assert!(
        coloured.contains("\u{1b}[32m✓ proved\u{1b}[0m a15\n"),
        "{coloured}"
    );
    let plain = on_a_terminal("certify a15 --require acute", &[("NO_COLOR", "1")]);
    assert!(plain.contains("✓ proved a15\n"), "{plain}");
    assert!(
        plain.contains("\n    all dihedral angles are acute\n"),
        "{plain}"
    );
    assert!(!plain.contains('\u{1b}'), "{plain}");
    // A digest has 64 digits, and is not broken.
    let short = plain
        .lines()
        .filter(|line| !line.contains("sha256") && line.split_whitespace().count() > 1);
    assert!(
        short.clone().all(|line| line.chars().count() <= 60),
        "{plain}"
    );
}

#[test]
#[ignore = "needs the program script of util-linux; CI runs it"]
fn a_terminal_gets_five_examples_and_a_summary() {
    let text = on_a_terminal("certify cube-6 a15 --require acute", &[("NO_COLOR", "1")]);
    assert!(text.contains("✗ refuted cube-6\n    18 right"), "{text}");
    assert!(text.contains("18, the first 5:"), "{text}");
    assert!(
        text.contains("and 13 more; --max-defects N shows N of each"),
        "{text}"
    );
    assert!(text.ends_with("2 inputs: 1 proved, 1 refuted\n"), "{text}");
    let json = on_a_terminal("certify cube-6 --require acute --json", &[]);
    assert_eq!(json.lines().count(), 1, "JSON is not broken into lines");
}
