//! `acutile-verify FILE…`: the kernel, and words for its verdicts.

#![forbid(unsafe_code)]

mod text;

use acutile_kernel::{Code, Kind, Limits, Refusal, Verified, verify};
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::process::ExitCode;

const HELP: &str = "\
Checks certificates of tilings in exact arithmetic, from their bytes alone.

Usage: acutile-verify [OPTIONS] FILE...

  FILE               a certificate in CBOR; - is standard input

  --claim FILE       succeed only if each certificate proves the claim in FILE
  --print-claim      print the claims that are proved; verdicts go to standard error
  --json             one JSON object for each file
  --max-bytes N      bytes of a certificate                         [4294967296]
  --max-simplices N  simplices of a certificate                     [268435456]
  --max-bits N       bits of an integer                             [4096]
  --max-degree N     degree of the field, at most 8                 [8]
  --max-work N       units of work, about nanoseconds, for a
                     certificate and again for each MiB of it       [3000000000]
  -h, --help         print this and stop
  -V, --version      print the version and stop

Each file gets one line, FILE: VERDICT..., where FILE is a JSON string if it holds
more than ASCII letters, digits and ._/-+=@%~, with one of the verdicts
  verified     everything that the certificate claims is proved
  rejected     something that it states is false
  malformed    it is no certificate, or not in canonical form
  unreadable   the file cannot be read
  declined     neither: a limit, an undecided sign, an unknown version
Exit code: 0 if every file is verified; else 1 if one is rejected; else 2 if one is
malformed or unreadable, or if the command line is wrong; else 3.
";

#[derive(Default)]
struct Options {
    files: Vec<OsString>,
    limits: Limits,
    claim: Option<String>,
    json: bool,
    print_claim: bool,
}

/// The reasons for which a file is not verified.
enum Failure {
    Refused(Box<Refusal>),
    Unreadable(String),
    /// The file begins like JSON.
    Json,
    OtherClaim,
}

fn main() -> ExitCode {
    match run() {
        Ok(code) => ExitCode::from(code),
        Err(message) => {
            // Nobody reads the message if standard error is closed.
            let _ = writeln!(io::stderr(), "acutile-verify: {message}");
            ExitCode::from(2)
        }
    }
}

/// The exit code, or a message where the command line is wrong or the output is not written.
fn run() -> Result<u8, String> {
    let Some(options) = parse()? else {
        return Ok(0);
    };
    let mut codes = Vec::new();
    for file in &options.files {
        let found = check(file, &options);
        let line = line(file, &found, &options);
        if options.print_claim {
            let claim = found
                .as_ref()
                .map_or(String::new(), |found| found.claim().print());
            print(&claim)?;
            writeln!(io::stderr(), "{line}").map_err(|error| error.to_string())?;
        } else {
            print(&(line + "\n"))?;
        }
        codes.push(found.err().map_or(0, |failure| failure.exit_code()));
    }
    let worst = [1, 2, 3].into_iter().find(|code| codes.contains(code));
    Ok(worst.unwrap_or(0))
}

fn print(text: &str) -> Result<(), String> {
    let mut out = io::stdout();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.map_err(|error| format!("standard output: {error}"))
}

/// The options; nothing where the command line asks for a text only.
fn parse() -> Result<Option<Options>, String> {
    let mut options = Options::default();
    let mut words = std::env::args_os().skip(1);
    let mut is_file = false;
    while let Some(word) = words.next() {
        let text = word.to_string_lossy().into_owned();
        if is_file || text == "-" || !text.starts_with('-') {
            options.files.push(word);
            continue;
        }
        let mut value = || {
            words
                .next()
                .ok_or(format!("{text} needs a value; try --help"))
        };
        match text.as_str() {
            "--" => is_file = true,
            "--json" => options.json = true,
            "--print-claim" => options.print_claim = true,
            "--claim" => {
                let file = value()?;
                let claim = fs::read_to_string(&file);
                options.claim = Some(claim.map_err(|error| {
                    format!("{}: {error}", text::name(&file.to_string_lossy()))
                })?);
            }
            "--max-bytes" => options.limits.bytes = number(&value()?)?,
            "--max-simplices" => options.limits.simplices = number(&value()?)?,
            "--max-bits" => options.limits.bits = number(&value()?)?,
            "--max-work" => options.limits.work = number(&value()?)?,
            "--max-degree" => {
                let degree = number(&value()?)?;
                options.limits.degree = usize::try_from(degree).unwrap_or(usize::MAX);
            }
            "-h" | "--help" => return print(HELP).map(|()| None),
            "-V" | "--version" => {
                return print(concat!("acutile-verify ", env!("CARGO_PKG_VERSION"), "\n"))
                    .map(|()| None);
            }
            _ => return Err(format!("unknown option {}; try --help", text::name(&text))),
        }
    }
    if options.files.is_empty() {
        return Err("no file; try --help".into());
    }
    Ok(Some(options))
}

fn number(word: &OsString) -> Result<u64, String> {
    let text = word.to_string_lossy();
    let found = text
        .parse()
        .ok()
        .filter(|_| text.bytes().all(|byte| byte.is_ascii_digit()));
    found.ok_or(format!("{} is no number; try --help", text::name(&text)))
}

fn check(file: &OsString, options: &Options) -> Result<Verified, Failure> {
    let unreadable = |error: io::Error| Failure::Unreadable(error.to_string());
    let mut input: Box<dyn Read> = if file == "-" {
        Box::new(io::stdin())
    } else {
        Box::new(File::open(file).map_err(unreadable)?)
    };
    let mut first = Vec::new();
    input
        .by_ref()
        .take(1)
        .read_to_end(&mut first)
        .map_err(unreadable)?;
    if matches!(first.as_slice(), [b'{' | b' ' | b'\t' | b'\n' | b'\r']) {
        return Err(Failure::Json);
    }
    let found = verify(&mut first.chain(input), &options.limits).map_err(Failure::Refused)?;
    match &options.claim {
        Some(claim) if *claim != found.claim().print() => Err(Failure::OtherClaim),
        _ => Ok(found),
    }
}

impl Failure {
    fn exit_code(&self) -> u8 {
        match self {
            Failure::Refused(refusal) => match refusal.code.kind() {
                _ if refusal.code == Code::Unreadable => 2,
                Kind::Rejected => 1,
                Kind::Malformed => 2,
                Kind::Declined => 3,
            },
            Failure::OtherClaim => 1,
            Failure::Unreadable(_) | Failure::Json => 2,
        }
    }

    /// The verdict, the code, and words.
    fn words(&self, file: &OsString) -> (&'static str, &'static str, String) {
        match self {
            Failure::Unreadable(error) => ("unreadable", "unreadable", error.clone()),
            Failure::OtherClaim => (
                "rejected",
                "other-claim",
                "the certificate proves another claim".into(),
            ),
            Failure::Json => {
                let hint = "this is JSON: `acutile verify FILE` reads it, and \
                            `acutile convert FILE F.cbor` writes the certificate itself";
                ("malformed", "cbor", hint.into())
            }
            Failure::Refused(refusal) if refusal.code == Code::Unreadable => {
                ("unreadable", "unreadable", text::place(refusal.place))
            }
            Failure::Refused(refusal) => {
                let code = refusal.code;
                (
                    text::verdict(code.kind()),
                    code.text(),
                    explain(refusal, file),
                )
            }
        }
    }
}

/// The place, the value, and the option that accepts more.
fn explain(refusal: &Refusal, file: &OsString) -> String {
    let length = fs::metadata(file)
        .ok()
        .filter(|found| found.is_file())
        .map(|found| found.len());
    let mut words = text::place(refusal.place);
    if let Some(value) = text::value(refusal) {
        words += &format!(": found {value}");
    }
    match text::option(refusal, length) {
        Some((option, Some(value))) => words += &format!(": {option} {value} suffices here"),
        Some((option, None)) => words += &format!(": {option} takes a larger limit"),
        None => {}
    }
    words
}

fn line(file: &OsString, found: &Result<Verified, Failure>, options: &Options) -> String {
    let name = file.to_string_lossy();
    match (found, options.json) {
        (Ok(found), false) => {
            let (simplices, vertices) = (found.simplices(), found.vertices());
            let (name, sha256) = (text::name(&name), hexadecimal(found.sha256()));
            format!("{name}: verified: {simplices} simplices, {vertices} vertices, sha256 {sha256}")
        }
        (Ok(found), true) => {
            let members = [
                format!("\"file\":{}", text::json(&name)),
                "\"verdict\":\"verified\"".into(),
                format!("\"simplices\":{}", found.simplices()),
                format!("\"vertices\":{}", found.vertices()),
                format!("\"boundary_facets\":{}", found.boundary_facets()),
                format!("\"peak_open_facets\":{}", found.peak_facets()),
                format!("\"peak_open_edges\":{}", found.peak_edges()),
                format!("\"bytes\":{}", found.bytes()),
                format!("\"sha256\":\"{}\"", hexadecimal(found.sha256())),
            ];
            format!("{{{}}}", members.join(","))
        }
        (Err(failure), false) => {
            let (verdict, code, words) = failure.words(file);
            let name = text::name(&name);
            if verdict == code {
                format!("{name}: {verdict}: {words}")
            } else {
                format!("{name}: {verdict} [{code}] {words}")
            }
        }
        (Err(failure), true) => {
            let (verdict, code, words) = failure.words(file);
            let (name, words) = (text::json(&name), text::json(&words));
            format!(
                "{{\"file\":{name},\"verdict\":\"{verdict}\",\"code\":\"{code}\",\
                 \"text\":{words}}}"
            )
        }
    }
}

fn hexadecimal(bytes: &[u8; 32]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
