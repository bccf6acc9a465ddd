//! `acutile completions` and `acutile man`, generated from the arguments.

use super::args::{Arguments, CompletionsArguments, ManArguments};
use super::files::{check_directory, is_standard};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_replaceable;
use super::record::Record;
use super::words::printable;
use clap::builder::Resettable;
use clap::{Arg, Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::roff::{Roff, roman};
use std::path::Path;

/// Prints the completion script for a shell.
pub fn completions(arguments: &CompletionsArguments, output: &mut Output) -> Outcome {
    let mut script = Vec::new();
    let mut program = Arguments::command();
    clap_complete::generate(arguments.shell, &mut program, "acutile", &mut script);
    let script = String::from_utf8_lossy(&script).into_owned();
    let script = match arguments.shell {
        Shell::Fish => script + &values_for_fish(&program),
        Shell::Elvish => with_values(
            script,
            &program,
            |command| format!("&'acutile;{command}'= {{\n"),
            |name| format!("            cand {name} ''\n"),
        ),
        Shell::PowerShell => with_values(
            script,
            &program,
            |command| format!("'acutile;{command}' {{\n"),
            |name| {
                let kind = "[CompletionResultType]::ParameterValue";
                format!(
                    "            [CompletionResult]::new('{name}', '{name}', {kind}, '{name}')\n"
                )
            },
        ),
        _ => script,
    };
    output.document_goes_to(None);
    write(None, script.as_bytes(), output)
}

/// The values of the arguments without an option, such as names of the catalogue. clap leaves them out of
/// the scripts for fish, Elvish and PowerShell.
fn values(command: &Command) -> Vec<String> {
    let values = command.get_positionals().flat_map(Arg::get_possible_values);
    values.map(|value| value.get_name().to_owned()).collect()
}

/// The script with a line for each value, after the line that begins the part of its command.
fn with_values(
    mut script: String,
    program: &Command,
    begin: fn(&str) -> String,
    line: fn(String) -> String,
) -> String {
    for command in program.get_subcommands() {
        let begin = begin(command.get_name());
        let lines: String = values(command).into_iter().map(line).collect();
        script = script.replacen(&begin, &(begin.clone() + &lines), 1);
    }
    script
}

/// Lines at the end of the script for fish.
fn values_for_fish(program: &Command) -> String {
    let line = |command: &Command| {
        let names = values(command);
        let condition = format!("__fish_acutile_using_subcommand {}", command.get_name());
        (!names.is_empty()).then(|| {
            format!(
                "complete -c acutile -n \"{condition}\" -a \"{}\"\n",
                names.join(" ")
            )
        })
    };
    program.get_subcommands().filter_map(line).collect()
}

/// Writes a page for the program and one for each command into a folder, or prints the former.
pub fn man(arguments: &ManArguments, output: &mut Output) -> Outcome {
    let mut program = Arguments::command();
    program.build();
    output.document_goes_to(arguments.folder.as_deref());
    let Some(folder) = arguments
        .folder
        .as_deref()
        .filter(|folder| !is_standard(folder))
    else {
        return write(None, &page(&program), output);
    };
    if let Err(message) = check_directory(folder) {
        return output.fail_with(None, message);
    }
    let names_command = |command: &Command| folder.as_os_str() == command.get_name();
    if !folder.exists() && program.get_subcommands().any(names_command) {
        let name = printable(folder);
        let message = format!(
            "{name}: found a command, expected a directory for the pages of all commands; \
             `acutile {name} --help` prints its help"
        );
        return output.fail_with(None, message);
    }
    // A missing folder is made, one that lies in a missing folder is not: writing fails then.
    let _ = std::fs::create_dir(folder);
    for command in std::iter::once(&program).chain(program.get_subcommands()) {
        let name = command.get_display_name().unwrap_or(command.get_name());
        let path = folder.join(format!("{name}.1"));
        let written = check_replaceable(&path, is_own, arguments.force)
            .map_err(InputError::from)
            .and_then(|()| write_bytes(Some(&path), &page(command), output));
        if let Err(error) = written {
            return output.fail(None, &error);
        }
    }
    output.done(Record::of(None))
}

/// Whether a page is one that this command wrote.
fn is_own(page: &[u8]) -> bool {
    page.split(|byte| *byte == b'\n')
        .any(|line| line.starts_with(b".TH acutile"))
}

fn write(path: Option<&Path>, bytes: &[u8], output: &mut Output) -> Outcome {
    match write_bytes(path, bytes, output) {
        Ok(()) => output.done(Record::of(None)),
        Err(error) => output.fail(None, &error),
    }
}

/// A manual page. The end of the long help becomes the sections EXAMPLES and EXIT STATUS.
fn page(command: &Command) -> Vec<u8> {
    let help = command.get_after_long_help().or(command.get_after_help());
    let help = help.map(ToString::to_string).unwrap_or_default();
    let (examples, codes) = help.split_once("Exit codes: ").unwrap_or((&help, ""));
    let plain = command.clone().after_help(Resettable::Reset);
    let plain = plain.after_long_help(Resettable::Reset);
    let mut end = Roff::default();
    let examples = examples.trim().trim_start_matches("Examples:").lines();
    let examples: Vec<&str> = examples.filter(|line| !line.is_empty()).collect();
    if !examples.is_empty() {
        end.control("SH", ["EXAMPLES"]).control("nf", []);
        for line in examples {
            end.text([roman(line.trim())]);
        }
        end.control("fi", []);
    }
    end.control("SH", ["EXIT STATUS"]).text([roman(codes)]);
    let mut page = Vec::new();
    // Writing into a vector cannot fail.
    let _ = clap_mangen::Man::new(plain).render(&mut page);
    let _ = end.to_writer(&mut page);
    page
}
