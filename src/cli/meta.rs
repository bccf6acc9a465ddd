//! `acutile completions` and `acutile man`, generated from the arguments.

use super::args::{Arguments, CompletionsArguments};
use super::outcome::Outcome;
use super::output::Output;
use clap::CommandFactory;

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

/// Prints the manual page and those of all commands.
pub fn man(output: &mut Output) -> Outcome {
    let mut page = Vec::new();
    // Writing into a vector cannot fail.
    let _ = clap_mangen::Man::new(Arguments::command()).render(&mut page);
    for command in Arguments::command().get_subcommands() {
        let _ = clap_mangen::Man::new(command.clone().flatten_help(true)).render(&mut page);
    }
    output.bytes(&page);
    Outcome::Done
}
