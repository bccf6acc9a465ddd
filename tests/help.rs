//! The help, the manual pages, and what is said of a slip of the pen.

use crate::common::{acutile, code, stderr, stdout};
use std::fs;

/// The commands that the help of the program lists.
fn commands() -> Vec<String> {
    let help = stdout(&acutile(["--help"]));
    let list = help.split("Commands:").nth(1).expect("a list of commands");
    let list = list.split("Options:").next().expect("a list of commands");
    let is_command = |line: &&str| line.starts_with("  ") && !line.starts_with("   ");
    let names = list.lines().filter(is_command);
    let names = names.filter_map(|line| line.split_whitespace().next());
    names
        .filter(|name| *name != "help")
        .map(str::to_owned)
        .collect()
}

#[test]
fn every_command_has_examples_that_its_own_arguments_allow() {
    assert!(commands().len() >= 18);
    for command in commands() {
        let help = stdout(&acutile([command.as_str(), "--help"]));
        assert!(help.contains("Exit codes: 0 proved"), "{command}");
        let examples = help.split("Examples:").nth(1).expect(&command);
        let examples: Vec<&str> = examples
            .lines()
            .filter(|l| l.starts_with("  acutile"))
            .collect();
        assert!(!examples.is_empty(), "{command} has no example");
        for example in examples {
            let words: Vec<&str> = example.split_whitespace().collect();
            let end = words.iter().position(|word| matches!(*word, ">" | "|"));
            let words = &words[1..end.unwrap_or(words.len())];
            assert_eq!(words[0], command, "{example}");
            for option in words.iter().filter(|word| word.starts_with("--")) {
                assert!(help.contains(*option), "{example}: {option}");
            }
        }
    }
}

#[test]
fn a_manual_page_for_each_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().to_str().expect("UTF-8");
    let run = acutile(["man", path]);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    for command in commands() {
        let page = folder.path().join(format!("acutile-{command}.1"));
        let page = fs::read_to_string(page).expect(&command);
        assert!(
            page.contains(&format!(".TH acutile-{command} 1")),
            "{command}"
        );
        assert!(page.contains(".SH EXAMPLES\n.nf\nacutile "), "{command}");
        assert!(page.contains(".SH \"EXIT STATUS\"\n0 proved"), "{command}");
    }
    let program = fs::read_to_string(folder.path().join("acutile.1")).expect("a page");
    assert!(program.contains(".TH acutile 1"));
    let missing = folder.path().join("man1");
    assert_eq!(code(&acutile(["man", missing.to_str().expect("UTF-8")])), 0);
    assert!(missing.join("acutile-certify.1").exists());
    let nowhere = folder.path().join("none").join("deeper");
    let run = acutile(["man", nowhere.to_str().expect("UTF-8")]);
    assert_eq!(code(&run), 2);
    assert!(stderr(&run).contains("cannot be written"));
}

#[test]
fn names_in_upper_case_and_near_misses() {
    let run = acutile(["certify", "A15"]);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    for (wrong, right) in [
        ("a51", "a15"),
        ("sommervile-2", "sommerville-2"),
        ("slap", "slab"),
    ] {
        let run = acutile(["certify", wrong]);
        assert_eq!(code(&run), 2);
        let message = format!("did you mean {right}?");
        assert!(stderr(&run).contains(&message), "{}", stderr(&run));
    }
    let run = acutile(["certify", "qqq"]);
    assert!(!stderr(&run).contains("did you mean"), "{}", stderr(&run));
}

#[test]
fn requirements_without_signs_that_shells_take() {
    for (below, expected) in [("78.5", 0), ("78", 1)] {
        for statement in [
            format!("dihedral-below={below}"),
            format!("dihedral<{below}"),
        ] {
            let run = acutile(["certify", "a15", "--require", &statement]);
            assert_eq!(code(&run), expected, "{statement}: {}", stderr(&run));
        }
    }
    let list = "acute,dihedral-above=53,radius-edge-below=0.7072,tcp";
    assert_eq!(code(&acutile(["certify", "a15", "--require", list])), 0);
    let run = acutile(["certify", "a15", "--require", "acute,blunt"]);
    assert_eq!(code(&run), 2);
    assert!(
        stderr(&run).contains("dihedral-below=DEGREES"),
        "{}",
        stderr(&run)
    );
}

/// The options that most people need stand first, and not below a heading for something else.
#[test]
fn common_options_stand_first() {
    for (command, options) in [
        ("certify", ["--output", "--require", "--json"]),
        ("quality", ["--output", "--bin", "--format"]),
        ("report", ["--output", "--help", "--help"]),
    ] {
        let help = stdout(&acutile([command, "--help"]));
        let first = help.split("\nOptions:").nth(1).expect("options");
        let heading = first.find("\nMesh files:").expect("a group for meshes");
        for option in options {
            assert!(first[..heading].contains(option), "{command} {option}");
        }
    }
}

/// A wrong name after `help` gets the suggestion that it gets as a command.
#[test]
fn help_suggests_a_command() {
    let run = acutile(["help", "certfy"]);
    assert_eq!(code(&run), 2);
    let words = stderr(&run);
    assert!(
        words.contains("Did you mean `acutile help certify`?"),
        "{words}"
    );
    let words = stderr(&acutile(["help", "qqq"]));
    assert!(!words.contains("Did you mean"), "{words}");
}

/// The scripts for Elvish and PowerShell have names of the catalogue in the part of each command that takes them.
#[test]
fn elvish_and_powershell_complete_names_of_the_catalogue() {
    for (shell, begin, name) in [
        ("elvish", "&'acutile;certify'= {", "cand sommerville-2 "),
        ("powershell", "'acutile;certify' {", "new('sommerville-2', "),
    ] {
        let script = stdout(&acutile(["completions", shell]));
        let part = script.split(begin).nth(1).expect("the part of certify");
        let part = part.split("'acutile;").next().unwrap_or_default();
        assert_eq!(part.matches(name).count(), 1, "{shell}");
        let verify = script.split("'acutile;verify'").nth(1).expect("verify");
        let verify = verify.split("'acutile;").next().unwrap_or_default();
        assert!(!verify.contains(name), "{shell}: verify takes files alone");
    }
}

/// The completions of bash, with the script that the program prints.
#[cfg(unix)]
#[test]
fn bash_completes_names_of_the_catalogue_and_statements() {
    let complete = |words: &[&str]| {
        let line = words.join(" ");
        let script = format!(
            "source <(\"$0\" completions bash); COMP_WORDS=(acutile {line}); COMP_CWORD={}; \
             _acutile acutile '{}' '{}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            words.len(),
            words.last().unwrap_or(&""),
            words.iter().rev().nth(1).unwrap_or(&"acutile"),
        );
        let program = env!("CARGO_BIN_EXE_acutile");
        let output = std::process::Command::new("bash")
            .args(["-c", &script, program])
            .output()
            .expect("bash runs");
        let text = stdout(&output);
        text.lines().map(str::to_owned).collect::<Vec<String>>()
    };
    assert_eq!(complete(&["certify", "sommerville-2"]), ["sommerville-2"]);
    assert!(complete(&["show", "square-tri"]).contains(&"square-triangle-all".to_owned()));
    assert!(complete(&["draw", "c1"]).contains(&"c14".to_owned()));
    assert_eq!(complete(&["certify", "a15", "--require", "acu"]), ["acute"]);
    let bounds = complete(&["certify", "a15", "--require", "dihedral-"]);
    assert_eq!(bounds, ["dihedral-below=", "dihedral-above="]);
    assert_eq!(complete(&["certi"]), ["certify"]);
    // Names that the catalogue does not have are left to the names of files.
    assert_eq!(complete(&["certify", "qqq"]), [""]);
    let help = stdout(&acutile(["certify", "--help"]));
    assert!(
        !help.contains("possible values: z, a15"),
        "the list is not in the help"
    );
}
