//! Proves a file or a construction of the catalogue, and writes the certificate:
//! `cargo run --example certify --no-default-features -- slab acute`.

use acutile::{Options, ReadOptions, Tiling, Verdict, certify};
use std::error::Error;
use std::process::ExitCode;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let source = arguments
        .next()
        .ok_or("usage: certify FILE-OR-NAME [STATEMENT]...")?;
    let tiling = Tiling::read(&source, &ReadOptions::default())?;
    let mut options = Options::default();
    for statement in arguments {
        options = options.require(statement.parse()?);
    }
    match certify(&tiling, &options)? {
        Verdict::Proved(certificate) => {
            let target = "certificate.cbor";
            std::fs::write(target, certificate.as_bytes())?;
            println!("{source}: proved; see {target}");
            Ok(ExitCode::SUCCESS)
        }
        Verdict::Refuted(findings) => {
            for finding in findings {
                println!("{source}: {finding}");
            }
            Ok(ExitCode::from(1))
        }
        answer => {
            println!("{source}: not decided: {answer:?}");
            Ok(ExitCode::from(3))
        }
    }
}
