//! The extension of an output file promises a format; a contradiction is an error.

use std::path::Path;

/// Checks that a file's name agrees with what is written; a name without an extension promises
/// nothing, and neither do standard output, devices and pipes.
///
/// # Errors
/// The extension is none of `expected`, or the name promises compression.
pub fn check(path: Option<&Path>, written: &str, expected: &[&str]) -> Result<(), String> {
    let Some(path) = path.filter(|path| !path.starts_with("/dev") && !path.starts_with("/proc"))
    else {
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
    let names: Vec<String> = expected.iter().map(|name| format!(".{name}")).collect();
    Err(format!(
        "{}: {written} is written, expected the extension {}, found .{}",
        path.display(),
        names.join(" or "),
        extension.display()
    ))
}
