//! The extension of an output file promises a format; a contradiction is an error.

use super::files::is_standard;
use super::output::Output;
use super::words::printable;
use std::path::Path;

/// A format with the words for it and the extensions of its files.
pub type Format<F> = (F, &'static str, &'static [&'static str]);

/// Extensions of pages.
pub const PAGE: &[&str] = &["html", "htm"];

/// Extensions of plain text.
pub const TEXT: &[&str] = &["txt", "log", "out"];

/// The format that is asked for, or that the name of the file says; the first one where neither
/// says anything.
///
/// # Errors
/// The two disagree, or the name says a format that is not written.
pub fn format<F: Copy + PartialEq>(
    path: Option<&Path>,
    asked: Option<F>,
    formats: &[Format<F>],
) -> Result<F, String> {
    let is_candidate = |format: &&Format<F>| asked.is_none_or(|asked| format.0 == asked);
    let candidates: Vec<&Format<F>> = formats.iter().filter(is_candidate).collect();
    let fitting = |(_, words, names): &&&Format<F>| check(path, words, names).is_ok();
    if let Some((format, ..)) = candidates.iter().find(fitting) {
        return Ok(*format);
    }
    let words: Vec<&str> = candidates.iter().map(|(_, words, _)| *words).collect();
    let names: Vec<&str> = candidates
        .iter()
        .flat_map(|format| format.2)
        .copied()
        .collect();
    Err(refusal(path, &one_of(&words), &names))
}

/// The format of --format, or `json` where --json is given.
///
/// # Errors
/// Both are given.
pub fn asked<F: Copy + PartialEq>(
    format: Option<F>,
    json: F,
    output: &Output,
) -> Result<Option<F>, String> {
    match (format, output.is_json()) {
        (Some(format), true) if format != json => {
            Err("--json and --format: expected one of them".to_owned())
        }
        (_, true) => Ok(Some(json)),
        (format, false) => Ok(format),
    }
}

/// Checks that a file's name agrees with what is written; a name without an extension promises
/// nothing, and neither do standard output, devices and pipes.
///
/// # Errors
/// The extension is none of `expected`, or the name promises compression.
pub fn check(path: Option<&Path>, written: &str, expected: &[&str]) -> Result<(), String> {
    let is_device = |path: &&Path| path.starts_with("/dev") || path.starts_with("/proc");
    let Some(path) = path.filter(|path| !is_standard(path) && !is_device(path)) else {
        return Ok(());
    };
    let Some(extension) = path.extension() else {
        return Ok(());
    };
    if expected
        .iter()
        .any(|known| extension.eq_ignore_ascii_case(known))
    {
        return Ok(());
    }
    Err(refusal(Some(path), written, expected))
}

fn refusal(path: Option<&Path>, written: &str, expected: &[&str]) -> String {
    let path = path.unwrap_or(Path::new("-"));
    let found = path.extension().unwrap_or_default();
    let names: Vec<String> = expected.iter().map(|name| format!(".{name}")).collect();
    format!(
        "{}: found the extension .{}, but {written} is written, expected the extension {}",
        printable(path),
        printable(found),
        one_of(&names)
    )
}

/// `a, b or c`
fn one_of(names: &[impl AsRef<str>]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => names.concat(),
    }
}
