//! `acutile-verify FILE…`: the kernel and nothing else.
//!
//! One line for each file, beginning with its name and a verdict: `verified`,
//! `rejected [code]`, `malformed [code]`, `declined [code]` or `unreadable`.
//! The exit code is 0 if all are verified, else the first that occurs of 1 (one
//! is rejected), 2 (one is malformed or unreadable), 3 (one is declined).

use acutile_format1::front::{one_line, verify_files};
use acutile_format1::verifier::Limits;
use lexopt::{Arg, ValueExt};
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

const HELP: &str = "\
Re-checks certificates of tilings in exact arithmetic, from their bytes alone.

Usage: acutile-verify [OPTIONS] FILE...

  FILE                  a certificate, in JSON or CBOR; - is standard input

  --json                one JSON object for each file
  --limit-bytes N       bytes of a file                          [33554432]
  --limit-simplices N   simplices of a certificate               [1000000]
  --limit-digits N      decimal digits of a number               [1000]
  --limit-degree N      degree of the field                      [32]
  --limit-bisections N  halvings of the root's interval          [512]
  --limit-work N        word products for one product of numbers
                        in every simplex; 64 N for all signs     [30000000]
  -h, --help            print this and stop
  -V, --version         print the version and stop

Each file gets one line, FILE: VERDICT..., where FILE is a JSON string if it holds
more than ASCII letters, digits and ._/-+=@%~, with one of the verdicts
  verified     what the certificate claims is proved
  rejected     something that it states is false
  malformed    it is not a certificate, or not in canonical form
  unreadable   the file cannot be read
  declined     neither: a limit, an undecided sign, an unknown version
Exit code: 0 if every file is verified; else 1 if one is rejected; else 2 if one
is malformed or unreadable, or if the command line is wrong; else 3.
";

fn main() -> ExitCode {
    let invocation = match parse(lexopt::Parser::from_env()) {
        Ok(invocation) => invocation,
        Err(error) => {
            complain(&format!("acutile-verify: {error}; try --help"));
            return ExitCode::from(2);
        }
    };
    match run(&invocation, &mut io::stdout().lock()) {
        Ok(code) => ExitCode::from(code),
        // Whoever reads the verdicts has not got them all, so this is no success.
        Err(error) => {
            complain(&format!("acutile-verify: standard output: {error}"));
            ExitCode::from(2)
        }
    }
}

/// Standard error may be closed; there is nobody left to tell.
fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "{}", one_line(message));
}

enum Invocation {
    Say(String),
    Verify {
        files: Vec<OsString>,
        limits: Limits,
        json: bool,
    },
}

fn parse(mut arguments: lexopt::Parser) -> Result<Invocation, lexopt::Error> {
    let (mut files, mut limits, mut json) = (Vec::new(), Limits::DEFAULT, false);
    while let Some(argument) = arguments.next()? {
        match argument {
            Arg::Short('h') | Arg::Long("help") => return Ok(Invocation::Say(HELP.to_owned())),
            Arg::Short('V') | Arg::Long("version") => {
                let version = concat!("acutile-verify ", env!("CARGO_PKG_VERSION"), "\n");
                return Ok(Invocation::Say(version.to_owned()));
            }
            Arg::Long("json") => json = true,
            Arg::Long("limit-bytes") => limits.bytes = arguments.value()?.parse()?,
            Arg::Long("limit-simplices") => limits.simplices = arguments.value()?.parse()?,
            Arg::Long("limit-digits") => limits.digits = arguments.value()?.parse()?,
            Arg::Long("limit-degree") => limits.degree = arguments.value()?.parse()?,
            Arg::Long("limit-bisections") => limits.bisections = arguments.value()?.parse()?,
            Arg::Long("limit-work") => limits.work = arguments.value()?.parse()?,
            Arg::Value(file) => files.push(file),
            _ => return Err(argument.unexpected()),
        }
    }
    match files.is_empty() {
        true => Err("no file is given".into()),
        false => Ok(Invocation::Verify {
            files,
            limits,
            json,
        }),
    }
}

/// Prints the lines and gives the exit code.
fn run(invocation: &Invocation, out: &mut impl Write) -> io::Result<u8> {
    match invocation {
        Invocation::Say(text) => out.write_all(text.as_bytes()).map(|()| 0),
        Invocation::Verify {
            files,
            limits,
            json,
        } => verify_files(files, limits, *json, out),
    }
}
