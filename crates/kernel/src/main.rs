//! `acutile-verify FILE…`: the kernel, and words for its verdicts.

#![forbid(unsafe_code)]

mod text;

use acutile_kernel::{Code, Facts, Limits, Verified, verify};
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::process::ExitCode;

struct Options {
    files: Vec<OsString>,
    limits: Limits,
    claim: Option<Vec<u8>>,
    json: bool,
    print_claim: bool,
}

/// Of a file that is not verified: the verdict, the code, and words.
type Failure = (&'static str, &'static str, String);

fn main() -> ExitCode {
    run().unwrap_or_else(|message| {
        // Nobody reads the message if standard error is closed.
        let _ = writeln!(io::stderr(), "acutile-verify: {message}");
        ExitCode::from(2)
    })
}

/// The exit code, or a message where the command line is wrong or the output is not written.
fn run() -> Result<ExitCode, String> {
    let options = match parse()? {
        Ok(options) => options,
        Err(text) => return write(&mut io::stdout(), text).map(|()| ExitCode::SUCCESS),
    };
    let mut verdicts = Vec::new();
    for file in &options.files {
        let found = check(file, &options);
        let line = line(&file.to_string_lossy(), &found, options.json);
        if options.print_claim {
            write(&mut io::stderr(), &line)?;
            let claim = found.as_ref().map(|found| found.claim.print());
            write(&mut io::stdout(), claim.unwrap_or_default())?;
        } else {
            write(&mut io::stdout(), &line)?;
        }
        verdicts.push(found.map_or_else(|(verdict, ..)| verdict, |_| "verified"));
    }
    let order = ["rejected", "malformed", "declined"];
    let worst = order.iter().zip(1..).find(|(verdict, _)| verdicts.contains(verdict));
    Ok(ExitCode::from(worst.map_or(0, |(_, code)| code)))
}

fn write(out: &mut dyn Write, text: &str) -> Result<(), String> {
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.map_err(|error| format!("output: {error}"))
}

/// The options, or a text that the command line asks for.
fn parse() -> Result<Result<Options, &'static str>, String> {
    let limits = Limits::DEFAULT;
    let mut options = Options { files: Vec::new(), limits, claim: None, json: false, print_claim: false };
    let mut words = std::env::args_os().skip(1);
    let mut is_file = false;
    while let Some(word) = words.next() {
        let option = word.to_string_lossy().into_owned();
        if is_file || option == "-" || !option.starts_with('-') {
            options.files.push(word);
            continue;
        }
        let mut value = || words.next().ok_or(format!("{option}: found no value, expected one; try --help"));
        let limits = &mut options.limits;
        match option.as_str() {
            "--" => is_file = true,
            "--json" => options.json = true,
            "--print-claim" => options.print_claim = true,
            "--claim" => {
                let file = value()?;
                let name = text::name(&file.to_string_lossy());
                let claim = fs::read(file).map_err(|error| format!("{name}: {error}"))?;
                options.claim = Some(claim);
            }
            "--max-bytes" => limits.bytes = number(&option, value()?, u64::MAX)?,
            "--max-simplices" => limits.simplices = number(&option, value()?, u64::MAX)?,
            "--max-bits" => limits.bits = number(&option, value()?, u64::MAX)?,
            "--max-degree" => limits.degree = number(&option, value()?, 8)?.try_into().unwrap_or(8),
            "--max-work" => limits.work = number(&option, value()?, u64::MAX)?,
            "-h" | "--help" => return Ok(Err(include_str!("help.txt"))),
            "-V" | "--version" => {
                return Ok(Err(concat!("acutile-verify ", env!("CARGO_PKG_VERSION"), "\n")));
            }
            _ => return Err(format!("unknown option {}; try --help", text::name(&option))),
        }
    }
    if options.files.is_empty() {
        return Err("found no file, expected a certificate; try --help".into());
    }
    Ok(Ok(options))
}

fn number(option: &str, word: OsString, most: u64) -> Result<u64, String> {
    let word = word.to_string_lossy();
    let number = word.parse().ok().filter(|number| !word.starts_with('+') && *number <= most);
    number.ok_or(format!("{option}: found {}, expected an integer from 0 to {most}", text::name(&word)))
}

fn check(file: &OsString, options: &Options) -> Result<Verified, Failure> {
    let malformed = |code, words| ("malformed", code, words);
    let unreadable = |error: io::Error| malformed("unreadable", error.to_string());
    let mut length = None;
    let mut input: Box<dyn Read> = if file == "-" {
        Box::new(io::stdin())
    } else {
        let file = File::open(file).map_err(unreadable)?;
        length = file.metadata().ok().filter(|data| data.is_file()).map(|data| data.len());
        Box::new(file)
    };
    let mut first = Vec::new();
    input.by_ref().take(1).read_to_end(&mut first).map_err(unreadable)?;
    if matches!(first.as_slice(), [b'{' | b' ' | b'\t' | b'\n' | b'\r']) {
        let hint = "this is JSON: `acutile convert F.json F.cbor` writes the certificate itself, \
                    and `acutile verify F.json` reads JSON";
        return Err(malformed(Code::Cbor.text(), hint.into()));
    }
    let found = verify(&mut first.chain(input), &options.limits);
    let words = |refusal| text::refusal(&refusal, length);
    let found = found.map_err(|refusal| (refusal.code.kind().text(), refusal.code.text(), words(refusal)))?;
    match &options.claim {
        Some(claim) if claim != found.claim.print().as_bytes() => {
            Err(("rejected", "other-claim", "it proves another claim; --print-claim prints it".into()))
        }
        _ => Ok(found),
    }
}

fn line(file: &str, found: &Result<Verified, Failure>, is_json: bool) -> String {
    let name = if is_json { text::json(file) } else { text::name(file) };
    match (found, is_json) {
        (Ok(found), _) => {
            let Facts { simplices, vertices, bytes, boundary_facets, peak_facets, peak_edges, sha256, .. } = &**found;
            let sha256: String = sha256.iter().map(|byte| format!("{byte:02x}")).collect();
            if !is_json {
                let counts = format!("{simplices} simplices, {vertices} vertices");
                return format!("{name}: verified: {counts}, sha256 {sha256}\n");
            }
            format!(
                "{{\"file\":{name},\"verdict\":\"verified\",\"simplices\":{simplices},\
                 \"vertices\":{vertices},\"boundary_facets\":{boundary_facets},\
                 \"peak_open_facets\":{peak_facets},\"peak_open_edges\":{peak_edges},\
                 \"bytes\":{bytes},\"sha256\":\"{sha256}\"}}\n"
            )
        }
        (Err((verdict, code, words)), false) => {
            format!("{name}: {verdict} [{code}] {words}\n")
        }
        (Err((verdict, code, words)), true) => format!(
            "{{\"file\":{name},\"verdict\":\"{verdict}\",\"code\":\"{code}\",\"message\":{}}}\n",
            text::json(words)
        ),
    }
}
