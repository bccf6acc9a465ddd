//! `acutile completions` and `acutile man`, generated from the arguments.

use super::args::{Arguments, CompletionsArguments, ManArguments};
use super::outcome::Outcome;
use super::output::{Output, write_file};
use clap::{Command, CommandFactory};

/// Prints the completion script for a shell.
pub fn completions(arguments: &CompletionsArguments, output: &mut Output) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(
        arguments.shell,
        &mut Arguments::command(),
        "acutile",
        &mut script,
    );
    output.bytes(&script);
    Outcome::Done
}

/// Writes a page for the program and one for each command into a folder, or prints the former.
pub fn man(arguments: &ManArguments, output: &mut Output) -> Outcome {
    let mut program = Arguments::command();
    program.build();
    let Some(folder) = &arguments.folder else {
        output.bytes(&page(&program));
        return Outcome::Done;
    };
    for command in std::iter::once(&program).chain(program.get_subcommands()) {
        let name = command.get_display_name().unwrap_or(command.get_name());
        let path = folder.join(format!("{name}.1"));
        if let Err(error) = write_file(&path, &page(command)) {
            let path = path.display();
            output.complain(format!("acutile: {path}: cannot be written: {error}"));
            return Outcome::Failed;
        }
    }
    Outcome::Done
}

fn page(command: &Command) -> Vec<u8> {
    let mut page = Vec::new();
    // Writing into a vector cannot fail.
    let _ = clap_mangen::Man::new(command.clone()).render(&mut page);
    page
}
