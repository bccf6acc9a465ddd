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
mod bundle;
mod certify;
mod classify;
mod convert;
mod defects;
mod delaunay;
mod document;
mod draw;
mod encoding;
mod export;
mod extension;
mod family;
mod gallery;
mod input;
mod interrupt;
mod limits;
mod list;
mod lower_bound;
mod mesh;
mod meta;
mod named;
mod new;
mod optimize;
mod optimized;
mod outcome;
mod output;
mod paper;
mod points;
mod progress;
mod proved;
mod quality;
mod records;
mod refutation;
mod refuted_page;
mod region;
mod report;
mod search;
mod second;
mod show;
mod sites;
mod table;
mod target;
mod theorem;
mod transcribe;
mod verify;
mod words;

use args::{Arguments, Command};
use clap::Parser;
use output::Output;
use std::process::ExitCode;

/// Runs the program with the process's arguments.
pub fn main() -> ExitCode {
    let arguments = Arguments::parse();
    interrupt::listen();
    let mut output = Output::standard();
    let outcome = match arguments.command {
        Command::List(list) => list::run(&list, &mut output),
        Command::Show(show) => show::run(&show, &mut output),
        Command::New(new) => new::run(&new, &mut output),
        Command::Certify(certify) => certify::run(&certify, &mut output),
        Command::Verify(verify) => verify::run(&verify, &mut output),
        Command::Delaunay(delaunay) => delaunay::run(&delaunay, &mut output),
        Command::Export(export) => export::run(&export, &mut output),
        Command::Convert(convert) => convert::run(&convert, &mut output),
        Command::Table(table) => table::run(&table, &mut output),
        Command::Paper(paper) => paper::run(&paper, &mut output),
        Command::LowerBound(bound) => lower_bound::run(&bound, &mut output),
        Command::Optimize(optimize) => optimize::run(&optimize, &mut output),
        Command::Records(records) => records::run(&records, &mut output),
        Command::Search(search) => search::run(&search, &mut output),
        Command::Quality(quality) => quality::run(&quality, &mut output),
        Command::Gallery(gallery) => gallery::run(&gallery, &mut output),
        Command::Report(report) => report::run(&report, &mut output),
        Command::Draw(draw) => draw::run(&draw, &mut output),
        Command::Classify(classify) => classify::run(&classify, &mut output),
        Command::Appendix(appendix) => appendix::run(&appendix, &mut output),
        Command::Bundle(bundle) => bundle::run(&bundle, &mut output),
        Command::Completions(completions) => meta::completions(&completions, &mut output),
        Command::Man(man) => meta::man(&man, &mut output),
    };
    ExitCode::from(outcome.and(output.finish()).code())
}
