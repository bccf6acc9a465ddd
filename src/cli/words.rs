//! Names and messages in one line, so that none can be taken for another.

use std::ffi::OsStr;

/// The name of a file as it is, if it holds nothing but ASCII letters, digits and
/// `._/-+=@%~`; else as a JSON string in ASCII. So its end is never in doubt.
pub fn name(file: &OsStr) -> String {
    let text = file.to_string_lossy();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._/-+=@%~".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        return text.into_owned();
    }
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            ' '..='~' => quoted.push(c),
            _ => quoted.extend(
                c.encode_utf16(&mut [0; 2])
                    .iter()
                    .map(|u| format!("\\u{u:04x}")),
            ),
        }
    }
    quoted + "\""
}

/// The name of a file in a message, in one line, so that no name can forge another answer.
pub fn printable(file: impl AsRef<OsStr>) -> String {
    one_line(&file.as_ref().to_string_lossy())
}

/// A text in one line: whatever is not printable is escaped.
pub fn one_line(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '"' | '\'' | '\\' => line.push(character),
            _ => line.extend(character.escape_debug()),
        }
    }
    line
}
