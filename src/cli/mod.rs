//! The command line: arguments, progress, printing, exit codes.
//!
//! | exit code | meaning |
//! |---|---|
//! | 0 | proved or verified |
//! | 1 | refuted or rejected |
//! | 2 | usage, unreadable input, or output that could not be written |
//! | 3 | declined: a limit, an undecided sign, an unknown version |
//! | 130 | interrupted |

mod answer;
mod appendix;
mod args;
mod article;
mod bundle;
mod certify;
mod certify_arguments;
mod cite;
mod claim;
mod classify;
mod convert;
mod counts;
mod defects;
mod delaunay;
mod document;
mod draw;
mod encoding;
mod export;
mod extension;
mod family;
mod files;
mod gallery;
mod input;
mod integer;
mod interrupt;
mod limits;
mod list;
mod look;
mod lower_bound;
mod mesh;
mod meta;
mod name;
mod named;
mod new;
mod optimize;
mod optimize_arguments;
mod optimized;
mod outcome;
mod output;
mod overwriting;
mod paper;
mod plane;
mod points;
mod progress;
mod prove;
mod proved;
mod quality;
mod record;
mod records;
mod refutation;
mod refuted_page;
mod region;
mod report;
mod requirement;
mod search;
mod search_balls;
mod second;
mod shape;
mod show;
mod show_theorem;
mod sites;
mod table;
mod target;
mod theorem;
mod transcribe;
mod usage;
mod verify;
mod words;

use output::Output;
use std::process::ExitCode;

/// Runs the program with the process's arguments.
pub fn main() -> ExitCode {
    let arguments = match usage::parse() {
        Ok(arguments) => arguments,
        Err(code) => return code,
    };
    interrupt::listen();
    let mut output = Output::of_command(arguments.command.name(), arguments.json);
    let outcome = arguments.command.run(&mut output);
    ExitCode::from(outcome.and(output.finish()).code())
}
