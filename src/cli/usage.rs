//! From the process's arguments to a command, and what is said of arguments that are wrong.

use super::args::{Arguments, Command};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::{
    appendix, bundle, certify, cite, classify, convert, delaunay, draw, export, gallery, list,
    lower_bound, meta, new, optimize, paper, quality, records, report, search, show, table, verify,
};
use acutile_catalog as catalog;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Error, FromArgMatches};
use std::ffi::OsString;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// The arguments of the process; otherwise help or an error is printed.
///
/// # Errors
/// The exit code.
pub fn parse() -> Result<Arguments, ExitCode> {
    let given: Vec<OsString> = std::env::args_os().collect();
    let parsed = with_negative_values(Arguments::command())
        .try_get_matches_from(&given)
        .and_then(|matches| Arguments::from_arg_matches(&matches));
    parsed.map_err(|mut error| {
        // The tip says how an option becomes an input, and `-o` never is one.
        if is_about_output(&error) {
            error.remove(ContextKind::Suggested);
        }
        ended(&given, &error)
    })
}

/// `-1` after an option is its value, so that the message is about the number and not about an option `-1`.
fn with_negative_values(command: clap::Command) -> clap::Command {
    let command = command.mut_args(|argument| {
        let is_option = argument.get_action().takes_values() && !argument.is_positional();
        argument.allow_negative_numbers(is_option)
    });
    command.mut_subcommands(with_negative_values)
}

/// Prints why there are no arguments: with --json as an answer, else as clap has it.
fn ended(given: &[OsString], error: &Error) -> ExitCode {
    let before_dashes = || given.iter().take_while(|argument| *argument != "--");
    if error.use_stderr() && before_dashes().any(|argument| argument == "--json") {
        let command = command_of(given);
        let name = command.as_ref().map_or("", |command| command.get_name());
        let mut output = Output::of_command(name, true);
        let message = in_plain_words(error.render().to_string());
        let error = InputError::from(message.trim().trim_start_matches("error: ").to_owned());
        output.fail(None, &error);
        return ExitCode::from(Outcome::Failed.and(output.finish()).code());
    }
    // Nothing is left to do where printing fails.
    let _ = if error.use_stderr() {
        let text = in_plain_words(error.render().ansi().to_string());
        let advice = command_missing(error).or_else(|| argument_advice(given, error));
        let advice = advice.unwrap_or_default();
        write!(anstream::stderr(), "{text}{advice}")
    } else {
        error.print()
    };
    ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
}

/// The command that is given, as clap knows it.
fn command_of(given: &[OsString]) -> Option<clap::Command> {
    let program = Arguments::command();
    let words = given.iter().take_while(|argument| *argument != "--");
    let mut words = words.filter_map(|argument| argument.to_str());
    words.find_map(|word| program.find_subcommand(word).cloned())
}

/// Advice where a construction or a file stands in the place of a command, or a name that is nearly a command.
fn command_missing(error: &Error) -> Option<String> {
    let is_command = error.kind() == ErrorKind::InvalidSubcommand;
    let found = error.get(ContextKind::InvalidSubcommand);
    let Some(ContextValue::String(name)) = found.filter(|_| is_command) else {
        return None;
    };
    let is_input = catalog::find(name).is_some() || Path::new(name).exists();
    if is_input {
        return Some(format!(
            "\nThe command comes first, like `acutile certify {name}`.\n"
        ));
    }
    let suggested = |error: &Error| match error.get(ContextKind::SuggestedSubcommand) {
        // The best one is the last.
        Some(ContextValue::Strings(names)) => names.last().cloned(),
        _ => None,
    };
    if suggested(error).is_some() {
        return None;
    }
    // After `acutile help` clap suggests nothing. The same name as a command has its suggestion.
    let again = Arguments::command().try_get_matches_from(["acutile", name]);
    let command = again.as_ref().err().and_then(suggested)?;
    Some(format!("\nDid you mean `acutile help {command}`?\n"))
}

/// Advice where an argument is missing, and where a command without -o gets it.
fn argument_advice(given: &[OsString], error: &Error) -> Option<String> {
    match (error.kind(), error.get(ContextKind::InvalidArg)?) {
        (ErrorKind::MissingRequiredArgument, ContextValue::Strings(missing)) => {
            Some(missing_advice(&command_of(given)?, missing))
        }
        _ if is_about_output(error) => Some(
            "\nThis command writes to standard output, and a shell writes that to a file: > FILE\n"
                .to_owned(),
        ),
        _ => None,
    }
}

/// Where the missing input comes from, and the first example of the command.
fn missing_advice(command: &clap::Command, missing: &[String]) -> String {
    const FILES: [(&str, &str); 2] = [
        (
            "verify",
            "A certificate is missing. `acutile certify a15 -o a15.cbor` writes one.",
        ),
        (
            "delaunay",
            "A file of points is missing. `acutile new point-set` writes an example of one, and a CIF is one too.",
        ),
    ];
    let of_command = |(name, _): &&(&str, &str)| *name == command.get_name();
    let source = match FILES.iter().find(of_command) {
        Some((_, words)) => format!("\n{words}\n"),
        None if missing.iter().any(|name| name.contains("NAME|FILE")) => {
            "\n`acutile list` names the constructions of the catalogue, and `acutile new KIND` \
             writes an example of a file.\n"
                .to_owned()
        }
        None => String::new(),
    };
    let help = command.get_after_long_help().map(ToString::to_string);
    let example = help.as_deref().and_then(|help| help.lines().nth(1));
    let example = example.map_or(String::new(), |line| {
        format!("\nExample: {}\n", line.trim())
    });
    format!("{source}{example}")
}

/// Whether -o is given to a command that has no such option.
fn is_about_output(error: &Error) -> bool {
    match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(name)) if error.kind() == ErrorKind::UnknownArgument => {
            name == "-o" || name == "--output"
        }
        _ => false,
    }
}

/// The messages of clap about numbers, and about arguments that are no text, in plain words.
fn in_plain_words(text: String) -> String {
    const WORDS: [(&str, &str); 5] = [
        (
            "invalid digit found in string",
            "expected an integer of at least 0",
        ),
        (
            "cannot parse integer from empty string",
            "found nothing, expected an integer",
        ),
        (
            "number too large to fit in target type",
            "the number is too large",
        ),
        (
            "invalid UTF-8 was detected in one or more arguments",
            "found an argument that is not UTF-8; only names of files may be other bytes",
        ),
        ("a value is required for", "expected a value for"),
    ];
    let replaced = |text: String, (from, to): &(&str, &str)| text.replace(from, to);
    WORDS.iter().fold(text, replaced)
}

impl Command {
    /// The name of the command.
    pub fn name(&self) -> &'static str {
        match self {
            Command::List(_) => "list",
            Command::Show(_) => "show",
            Command::New(_) => "new",
            Command::Certify(_) => "certify",
            Command::Verify(_) => "verify",
            Command::Delaunay(_) => "delaunay",
            Command::Export(_) => "export",
            Command::Convert(_) => "convert",
            Command::Table(_) => "table",
            Command::Paper(_) => "paper",
            Command::LowerBound(_) => "lower-bound",
            Command::Optimize(_) => "optimize",
            Command::Records(_) => "records",
            Command::Search(_) => "search",
            Command::Quality(_) => "quality",
            Command::Gallery(_) => "gallery",
            Command::Report(_) => "report",
            Command::Draw(_) => "draw",
            Command::Classify(_) => "classify",
            Command::Appendix(_) => "appendix",
            Command::Bundle(_) => "bundle",
            Command::Cite(_) => "cite",
            Command::Completions(_) => "completions",
            Command::Man(_) => "man",
        }
    }

    /// Runs it.
    pub fn run(&self, output: &mut Output) -> Outcome {
        match self {
            Command::List(arguments) => list::run(arguments, output),
            Command::Show(arguments) => show::run(arguments, output),
            Command::New(arguments) => new::run(arguments, output),
            Command::Certify(arguments) => certify::run(arguments, output),
            Command::Verify(arguments) => verify::run(arguments, output),
            Command::Delaunay(arguments) => delaunay::run(arguments, output),
            Command::Export(arguments) => export::run(arguments, output),
            Command::Convert(arguments) => convert::run(arguments, output),
            Command::Table(arguments) => table::run(arguments, output),
            Command::Paper(arguments) => paper::run(arguments, output),
            Command::LowerBound(arguments) => lower_bound::run(arguments, output),
            Command::Optimize(arguments) => optimize::run(arguments, output),
            Command::Records(arguments) => records::run(arguments, output),
            Command::Search(arguments) => search::run(arguments, output),
            Command::Quality(arguments) => quality::run(arguments, output),
            Command::Gallery(arguments) => gallery::run(arguments, output),
            Command::Report(arguments) => report::run(arguments, output),
            Command::Draw(arguments) => draw::run(arguments, output),
            Command::Classify(arguments) => classify::run(arguments, output),
            Command::Appendix(arguments) => appendix::run(arguments, output),
            Command::Bundle(arguments) => bundle::run(arguments, output),
            Command::Cite(arguments) => cite::run(arguments, output),
            Command::Completions(arguments) => meta::completions(arguments, output),
            Command::Man(arguments) => meta::man(arguments, output),
        }
    }
}
